//! `cargo xtask crates`: dependencies point down only, and `ARCHITECTURE.md` tells of every crate.

use crate::manifests::{CrateManifest, crate_manifests};
use anyhow::{Context, Result, bail};
use std::{collections::BTreeMap, fs, path::Path};

/// The crates, lowest first: a crate may use only crates of the lines before its own.
const LAYERS: &[&[&str]] = &[
    &["endless_world"],
    &["endless_scene"],
    &["endless_road", "endless_asset", "endless_render"],
    &["endless_town", "endless_annotate", "endless_sensor"],
    &["endless_traffic", "endless_city", "endless_dataset"],
    &["endless_interchange", "endless_export", "endless_statistics", "endless_view"],
    &["endless_pipeline"],
    &["endless_carla", "endless_storage"],
    &["endless", "endless_fuzz"],
    &["endless_python"],
];

pub(crate) fn check(root: &Path) -> Result<()> {
    let architecture = fs::read_to_string(root.join("ARCHITECTURE.md")).context("ARCHITECTURE.md")?;
    let wrong = violations(LAYERS, &crate_manifests(root)?, &architecture);
    if wrong.is_empty() { Ok(()) } else { bail!("{}", wrong.join("\n       ")) }
}

/// What is wrong, a line each.
fn violations(layers: &[&[&str]], crates: &BTreeMap<String, CrateManifest>, architecture: &str) -> Vec<String> {
    let layer_of: BTreeMap<&str, usize> =
        layers.iter().enumerate().flat_map(|(i, layer)| layer.iter().map(move |name| (*name, i))).collect();
    let mut wrong = Vec::new();
    for (name, manifest) in crates {
        if !architecture.lines().any(|line| line.starts_with(&format!("| `{name}` |"))) {
            wrong.push(format!("ARCHITECTURE.md has no row for `{name}` in its table of crates"));
        }
        let Some(layer) = layer_of.get(name.as_str()) else {
            wrong.push(format!("{name} is in no layer: give it one in xtask/src/crates.rs"));
            continue;
        };
        for used in &manifest.uses {
            if layer_of.get(used.as_str()).is_none_or(|below| below >= layer) {
                wrong.push(format!("{name} must not use {used}: dependencies point down only"));
            }
        }
    }
    wrong
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(crates: &[(&str, &[&str])]) -> BTreeMap<String, CrateManifest> {
        let manifest = |uses: &[&str]| CrateManifest {
            folder: "crates".into(),
            uses: uses.iter().map(|name| (*name).to_owned()).collect(),
        };
        crates.iter().map(|(name, uses)| ((*name).to_owned(), manifest(uses))).collect()
    }

    #[test]
    fn what_points_down_and_is_told_of_passes() {
        let layers: &[&[&str]] = &[&["low"], &["left", "right"]];
        let table = "| `low` | a |\n| `left` | b |\n| `right` | c |";
        let crates = of(&[("low", &[]), ("left", &["low"]), ("right", &["low"])]);
        assert_eq!(violations(layers, &crates, table), Vec::<String>::new());
        let sideways = of(&[("left", &["right"])]);
        assert_eq!(violations(layers, &sideways, table).len(), 1);
        let upwards = of(&[("low", &["left"])]);
        assert_eq!(violations(layers, &upwards, table).len(), 1);
        let strange = of(&[("new", &[])]);
        assert_eq!(violations(layers, &strange, table).len(), 2, "neither a layer nor a row");
    }
}
