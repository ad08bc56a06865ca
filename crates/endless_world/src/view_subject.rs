//! What cameras are put up for.

use crate::UnknownName;
use serde::{Deserialize, Serialize};
use strum::VariantArray as _;

/// What a drawn camera is to look at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum ViewSubject {
    /// A street, along it or across.
    Street,
    /// The mouth of a junction.
    Junction,
    /// A road without junctions on which one drives fast.
    Highway,
    /// A square, a park or a crossing: where people are.
    Square,
}

impl ViewSubject {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("view", given, Self::ALL)
    }
}
