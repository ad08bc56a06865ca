//! The files of the cards.

use super::{
    croissant::{self, croissant},
    facts::CardFacts,
    hugging_face::{self, readme},
};
use crate::{DatasetError, DatasetLayout, Manifest, SharedFiles};
use std::{fs, path::Path};

/// A card: a file at the root of a dataset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Card {
    /// Its name.
    pub name: &'static str,
    /// Its text.
    pub text: String,
}

impl Card {
    const README: &'static str = "README.md";
    const CROISSANT: &'static str = "croissant.json";
    /// Names of all cards.
    pub const NAMES: [&'static str; 2] = [Self::README, Self::CROISSANT];

    /// All cards of a dataset.
    pub fn all(manifest: &Manifest) -> [Self; 2] {
        let facts = CardFacts::new(manifest);
        [
            Self { name: Self::README, text: readme(manifest, &facts) },
            Self { name: Self::CROISSANT, text: croissant(manifest, &facts) },
        ]
    }

    /// Whether what lies at this path was written by [`Card::write_all`], and nobody has taken it over since. Power failures
    /// leave empty files.
    pub fn is_ours(path: &Path) -> bool {
        let mark = match path.file_name() {
            Some(name) if name == Self::README => hugging_face::MARK,
            Some(name) if name == Self::CROISSANT => croissant::MARK,
            _ => return false,
        };
        fs::read_to_string(path).is_ok_and(|text| text.is_empty() || text.contains(mark))
    }

    /// Writes all cards of a dataset, except where its owner has taken one over.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn write_all(layout: &DatasetLayout, manifest: &Manifest, files: &SharedFiles) -> Result<(), DatasetError> {
        for card in Self::all(manifest) {
            let path = layout.root().join(card.name);
            let found = fs::read(&path).ok();
            let stale = found.as_ref().is_none_or(|found| found != card.text.as_bytes());
            if stale && (found.is_none() || Self::is_ours(&path)) {
                files.write_text(&path, &card.text)?;
            }
        }
        Ok(())
    }
}
