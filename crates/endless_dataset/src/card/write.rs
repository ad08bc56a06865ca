//! The files of the cards.

use super::{croissant::croissant, facts::CardFacts, hugging_face::readme};
use crate::{DatasetError, DatasetLayout, Manifest, write_atomic};
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
    /// The second line of every `README.md` that follows from the manifest.
    pub(super) const MARK: &'static str = "# Written by endless. Without this line it stays as you change it.";

    /// All cards of a dataset.
    pub fn all(manifest: &Manifest) -> [Self; 2] {
        let facts = CardFacts::new(manifest);
        [
            Self { name: Self::README, text: readme(manifest, &facts) },
            Self { name: Self::CROISSANT, text: croissant(manifest, &facts) },
        ]
    }

    /// Whether the card at this path was changed by its owner.
    pub fn is_changed(path: &Path) -> bool {
        let readme = path.file_name().is_some_and(|name| name == Self::README);
        let text = if readme { fs::read_to_string(path).ok() } else { None };
        text.is_some_and(|text| text.lines().nth(1) != Some(Self::MARK))
    }
}

/// Writes the cards beside `dataset.json`, except one that its owner has changed.
///
/// # Errors
/// When the disk refuses.
pub fn write_cards(layout: &DatasetLayout, manifest: &Manifest) -> Result<(), DatasetError> {
    for card in Card::all(manifest) {
        let path = layout.root().join(card.name);
        let same = fs::read(&path).is_ok_and(|found| found == card.text.as_bytes());
        if !same && !Card::is_changed(&path) {
            write_atomic(&path, card.text.as_bytes())?;
        }
    }
    Ok(())
}
