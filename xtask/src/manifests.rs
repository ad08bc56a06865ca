//! The `Cargo.toml` files of the crates.

use anyhow::{Context, Result};
use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

/// One of our crates.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct CrateManifest {
    /// Where it lies.
    pub(crate) folder: PathBuf,
    /// Which of our crates it uses, in tests, too.
    pub(crate) uses: Vec<String>,
}

/// The crates in the folder `crates`, by name.
pub(crate) fn crate_manifests(root: &Path) -> Result<BTreeMap<String, CrateManifest>> {
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(root.join("crates")).context("crates")? {
        let folder = entry?.path();
        let path = folder.join("Cargo.toml");
        if !path.is_file() {
            continue;
        }
        let text = fs::read_to_string(&path)?;
        let manifest: toml::Table = text.parse().with_context(|| path.display().to_string())?;
        let name = manifest.get("package").and_then(|p| p.get("name")).and_then(toml::Value::as_str);
        let name = name.with_context(|| format!("{} names no crate", path.display()))?;
        let tables = ["dependencies", "dev-dependencies", "build-dependencies"];
        let uses = tables
            .iter()
            .filter_map(|table| manifest.get(*table)?.as_table())
            .flat_map(toml::Table::keys)
            .filter(|used| used.starts_with("endless"))
            .cloned()
            .collect();
        all.insert(name.to_owned(), CrateManifest { folder, uses });
    }
    Ok(all)
}
