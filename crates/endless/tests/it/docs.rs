//! What the documents say of layers and options is what the program does: these parts are made from its declarations.
//! `UPDATE_DOCS=1 cargo test -p endless --test it docs` writes them.

use crate::program::succeed;
use endless_dataset::{Layer, RecipeDraft, RgbFormat};
use std::{env, fs, path::PathBuf};

fn document(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..").join(name)
}

/// Compares a file with what it should be, or writes it.
fn assert_document(name: &str, expected: &str) {
    let path = document(name);
    if env::var_os("UPDATE_DOCS").is_some() {
        fs::write(&path, expected).expect("writable");
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    let line = found.lines().zip(expected.lines()).position(|(a, b)| a != b).map_or(0, |line| line + 1);
    assert!(
        found == expected,
        "{name} is out of date (line {line}): UPDATE_DOCS=1 cargo test -p endless --test it docs"
    );
}

/// Compares what stands between `<!-- mark -->` and `<!-- /mark -->` in the README, or writes it.
fn assert_readme(mark: &str, expected: &str) {
    let text = fs::read_to_string(document("README.md")).expect("a README");
    let (begin, end) = (format!("<!-- {mark} -->\n"), format!("<!-- /{mark} -->"));
    let (before, rest) = text.split_once(&begin).expect("a beginning");
    let (_, after) = rest.split_once(&end).expect("an end");
    assert_document("README.md", &format!("{before}{begin}{expected}{end}{after}"));
}

#[test]
fn the_readme_lists_all_layers() {
    let rows = Layer::ALL.iter().map(|layer| {
        let mut formats: Vec<&str> = RgbFormat::ALL.iter().map(|format| layer.format(*format).name()).collect();
        formats.dedup();
        let extensions = formats.join("\\|");
        format!("| `{layer}` | `{layer}/000123.{extensions}` | {} |\n", layer.entry().summary)
    });
    assert_readme("layers", &format!("| layer | file | |\n|---|---|---|\n{}", rows.collect::<String>()));
}

#[test]
fn the_readme_lists_all_options() {
    let rows = RecipeDraft::OPTIONS.iter().map(|option| {
        let help = option.help_with_words();
        format!("| `{}` | {} | {} |\n", option.key, option.default.text(), help.trim_end_matches('.'))
    });
    assert_readme("options", &format!("| option | default | |\n|---|---|---|\n{}", rows.collect::<String>()));
}

#[test]
fn the_schema_in_the_documents_is_the_program_s() {
    let folder = tempfile::tempdir().expect("temp");
    let (schema, _) = succeed(folder.path(), "schema");
    assert_document("docs/recipe.schema.json", &schema);
}
