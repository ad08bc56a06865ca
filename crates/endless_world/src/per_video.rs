//! Whether something is the same in all videos.

use crate::UnknownName;
use serde::{Deserialize, Serialize};
use strum::VariantArray as _;

/// Whether all videos have the same of something, or each its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum PerVideo {
    /// As the map or the table of conditions has it.
    #[default]
    Fixed,
    /// Drawn for every video, by the recipe's seed.
    Drawn,
}

impl PerVideo {
    /// Both.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// Whether it is the same in all.
    pub fn is_fixed(&self) -> bool {
        *self == Self::Fixed
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("choice", given, Self::ALL)
    }
}
