//! Chores of the repository: `cargo xtask rooms`.

use anyhow::{Context, Result, bail};
use std::{collections::BTreeMap, env, fs, path::Path, process::ExitCode};

/// The rooms, lowest first: a crate may use only crates that stand before it, and never one of its own shelf.
const SHELVES: &[&[&str]] = &[
    &["endless_world"],
    &["endless_road", "endless_asset"],
    &["endless_town", "endless_annotate"],
    &["endless_traffic", "endless_render", "endless_dataset"],
    &["endless_carla"],
    &["endless_pipeline"],
    &["endless"],
];

fn main() -> ExitCode {
    let result = match env::args().nth(1).as_deref() {
        Some("rooms") => rooms(Path::new(".")),
        other => Err(anyhow::anyhow!("unknown chore {other:?}: use `cargo xtask rooms`")),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

/// Dependencies point down only, and every crate is in `ARCHITECTURE.md`.
fn rooms(root: &Path) -> Result<()> {
    let shelf_of: BTreeMap<&str, usize> =
        SHELVES.iter().enumerate().flat_map(|(i, shelf)| shelf.iter().map(move |name| (*name, i))).collect();
    let architecture = fs::read_to_string(root.join("ARCHITECTURE.md")).context("ARCHITECTURE.md")?;
    let mut wrong = Vec::new();
    for (name, uses) in dependencies(&root.join("crates"))? {
        let Some(shelf) = shelf_of.get(name.as_str()) else {
            wrong.push(format!("{name} has no place among the rooms: give it one in xtask"));
            continue;
        };
        if !architecture.contains(&format!("`{name}`")) {
            wrong.push(format!("ARCHITECTURE.md does not mention `{name}`"));
        }
        for used in uses {
            if shelf_of.get(used.as_str()).is_none_or(|below| below >= shelf) {
                wrong.push(format!("{name} must not use {used}: dependencies point down only"));
            }
        }
    }
    if wrong.is_empty() { Ok(()) } else { bail!("{}", wrong.join("\n       ")) }
}

/// Which of our crates each crate uses, tests included.
fn dependencies(crates: &Path) -> Result<BTreeMap<String, Vec<String>>> {
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(crates)? {
        let path = entry?.path().join("Cargo.toml");
        if !path.is_file() {
            continue;
        }
        let text = fs::read_to_string(&path)?;
        let manifest: toml::Table = text.parse().with_context(|| path.display().to_string())?;
        let name = manifest.get("package").and_then(|p| p.get("name")).and_then(toml::Value::as_str);
        let tables = ["dependencies", "dev-dependencies", "build-dependencies"];
        let ours = tables
            .iter()
            .filter_map(|table| manifest.get(*table)?.as_table())
            .flat_map(toml::Table::keys)
            .filter(|used| used.starts_with("endless"))
            .cloned()
            .collect();
        all.insert(name.context("a crate without a name")?.to_owned(), ours);
    }
    Ok(all)
}
