//! `cargo xtask glossary`: what the glossary's column *code* names is defined in the sources.

use anyhow::{Context, Result, bail};
use std::{collections::BTreeSet, fs, path::Path};

/// Words after which Rust defines a name.
const KEYWORDS: &[&str] = &["struct", "enum", "trait", "type", "fn", "mod"];

pub(crate) fn check(root: &Path) -> Result<()> {
    let glossary = fs::read_to_string(root.join("GLOSSARY.md")).context("GLOSSARY.md")?;
    let mut defined = BTreeSet::new();
    collect_folder(&root.join("crates"), &mut defined)?;
    let missing: Vec<&str> = code_names(&glossary).into_iter().filter(|name| !defined.contains(*name)).collect();
    if missing.is_empty() { Ok(()) } else { bail!("GLOSSARY.md names what no source defines: {}", missing.join(", ")) }
}

/// The names in backticks of each table's third column.
fn code_names(glossary: &str) -> Vec<&str> {
    let rows = glossary.lines().filter(|line| line.starts_with("| "));
    rows.filter_map(|line| line.split('|').nth(3)).flat_map(|cell| cell.split('`').skip(1).step_by(2)).collect()
}

fn collect_folder(folder: &Path, defined: &mut BTreeSet<String>) -> Result<()> {
    for entry in fs::read_dir(folder).with_context(|| folder.display().to_string())? {
        let path = entry?.path();
        if path.is_dir() {
            collect_folder(&path, defined)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
            collect_names(&text, defined);
        }
    }
    Ok(())
}

/// Adds the names that a source defines, comments left out.
fn collect_names(text: &str, defined: &mut BTreeSet<String>) {
    for line in text.lines().filter(|line| !line.trim_start().starts_with("//")) {
        let mut words = line.split(|c: char| !(c.is_alphanumeric() || c == '_')).filter(|word| !word.is_empty());
        while let Some(word) = words.next() {
            if KEYWORDS.contains(&word) {
                defined.extend(words.next().map(str::to_owned));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_code_column_is_read() {
        let table = "| term | meaning | code | as in |\n|---|---|---|---|\n| a | `no` | `Yes`, `also` | `Neither` |\n";
        assert_eq!(code_names(table), ["Yes", "also"]);
    }

    #[test]
    fn definitions_are_found_and_mentions_are_not() {
        let mut defined = BTreeSet::new();
        collect_names("/// struct Ghost\npub struct Real<'a>(u8);\n    fn act(self: Used) {}", &mut defined);
        assert_eq!(defined, ["Real", "act"].map(str::to_owned).into());
    }
}
