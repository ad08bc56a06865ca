//! What the documents say of layers and options is what the program does: these parts are made from its declarations.
//! `UPDATE_DOCS=1 cargo test -p endless --test it docs` writes them.

use crate::program::succeed;
use endless_dataset::{Layer, RecipeDraft, RgbFormat};
use endless_export::Format;
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
    assert_between("README.md", mark, expected);
}

/// The same in any document.
fn assert_between(name: &str, mark: &str, expected: &str) {
    let text = fs::read_to_string(document(name)).expect("a document");
    let (begin, end) = (format!("<!-- {mark} -->\n"), format!("<!-- /{mark} -->"));
    let (before, rest) = text.split_once(&begin).expect("a beginning");
    let (_, after) = rest.split_once(&end).expect("an end");
    assert_document(name, &format!("{before}{begin}{expected}{end}{after}"));
}

#[test]
fn the_page_of_exports_lists_all_formats() {
    let row = |format: &Format| {
        let entry = format.entry();
        let layers: Vec<&str> = entry.layers.iter().map(|layer| layer.name()).collect();
        let needs = if layers.is_empty() { "none".to_owned() } else { layers.join(", ") };
        format!("| [`{}`](export/{}.md) | {} | {needs} |\n", format.name(), entry.page, entry.about)
    };
    let rows: String = Format::ALL.iter().map(row).collect();
    assert_between("docs/export.md", "formats", &format!("| format | | layers |\n|---|---|---|\n{rows}"));
    for format in Format::ALL {
        assert!(
            document(&format!("docs/export/{}.md", format.entry().page)).is_file(),
            "{} has no page",
            format.name()
        );
    }
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
