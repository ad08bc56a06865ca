//! Presets: recipes for what is not given.

use endless_world::UnknownName;
use strum::VariantArray as _;

/// A set of values for the options that are not given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum Preset {
    /// Vehicles and people in all streets, as city cameras see them.
    Surveillance,
    /// Dense traffic on roads of many lanes, from bridges, gantries and masts.
    Highway,
    /// Junctions with queues, crossings and two-wheelers.
    Junction,
    /// People on squares, sidewalks and crossings.
    Crowd,
    /// Streets by night.
    Night,
}

impl Preset {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// Its values, as a recipe in TOML.
    pub fn recipe(self) -> &'static str {
        match self {
            Self::Surveillance => include_str!("preset/surveillance.toml"),
            Self::Highway => include_str!("preset/highway.toml"),
            Self::Junction => include_str!("preset/junction.toml"),
            Self::Crowd => include_str!("preset/crowd.toml"),
            Self::Night => include_str!("preset/night.toml"),
        }
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("preset", given, Self::ALL)
    }
}
