//! How busy the streets of a scene are.

use crate::UnknownName;
use serde::{Deserialize, Serialize};
use strum::VariantArray as _;

/// How busy streets are, at any size of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum TrafficDensity {
    /// A Sunday morning: everybody drives as fast as they like.
    Light,
    /// A working day.
    Normal,
    /// The rush hour: queues before the lights.
    Rush,
}

impl TrafficDensity {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("traffic density", given, Self::ALL)
    }
}

/// The kinds of actors whose number follows from how busy the streets are, where it is not asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct ActorDensity {
    /// Of moving vehicles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vehicles: Option<TrafficDensity>,
    /// Of people on foot.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pedestrians: Option<TrafficDensity>,
}

impl ActorDensity {
    /// Whether all numbers are asked for.
    pub fn is_nothing(&self) -> bool {
        *self == Self::default()
    }
}
