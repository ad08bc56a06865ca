//! `croissant.json`: the files and their records in MLCommons' Croissant 1.1, JSON-LD.

mod distribution;
mod files;
mod record_sets;

use super::facts::{CardFacts, KEYWORDS, LIMITS};
use crate::Manifest;
use distribution::distribution;
use files::image_files;
use record_sets::record_sets;
use serde_json::{Value, json};

/// Of those that follow from the manifest.
pub(super) const MARK: &str = "Simulated and rendered by ENDLESS";

/// Its text.
pub(super) fn croissant(manifest: &Manifest, facts: &CardFacts) -> String {
    let licence = match facts.licences {
        [] => json!(facts.licence),
        licences => json!(licences.iter().map(|id| format!("https://spdx.org/licenses/{id}.html")).collect::<Vec<_>>()),
    };
    let images = image_files(&manifest.recipe);
    let context: Value = serde_json::from_str(include_str!("context.json")).expect("JSON");
    let card = json!({
        "@context": context,
        "@type": "sc:Dataset",
        "conformsTo": "http://mlcommons.org/croissant/1.1",
        "name": facts.title,
        "description": facts.description,
        "license": licence,
        "creator": {"@type": "sc:Organization", "name": "ENDLESS"},
        "keywords": KEYWORDS,
        "version": facts.version,
        "citeAs": facts.citation,
        "rai:dataCollection": format!("{MARK} from the recipe in dataset.json; README.md has it as a file"),
        "rai:dataLimitations": LIMITS,
        "distribution": distribution(&manifest.recipe, &images),
        "recordSet": record_sets(&images),
    });
    serde_json::to_string_pretty(&card).expect("plain numbers and words") + "\n"
}
