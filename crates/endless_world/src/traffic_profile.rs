//! What is driven on the streets of a scene, and how.

use crate::{Outfit, Stream, UnknownName};
use serde::{Deserialize, Serialize};
use strum::VariantArray as _;

/// A part of the world, by what is driven there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum Region {
    /// Cars of middle size, some bicycles.
    #[default]
    European,
    /// Pick-ups and large cars, hardly any two-wheelers.
    NorthAmerican,
    /// Many motorcycles, taxis and buses.
    LatinAmerican,
    /// More motorcycles than all others together.
    SouthEastAsian,
}

impl Region {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// As options have it.
    pub fn name(self) -> &'static str {
        self.into()
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("region", given, Self::ALL)
    }
}

/// Whose mix of vehicles drives in the videos of a recipe.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum RegionChoice {
    /// [`Region::European`] in all.
    #[default]
    European,
    /// [`Region::NorthAmerican`] in all.
    NorthAmerican,
    /// [`Region::LatinAmerican`] in all.
    LatinAmerican,
    /// [`Region::SouthEastAsian`] in all.
    SouthEastAsian,
    /// Another in each, all as often.
    Drawn,
}

impl RegionChoice {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The region of a video, by a stream of its own.
    pub fn region(self, random: &mut Stream) -> Region {
        match self {
            Self::European => Region::European,
            Self::NorthAmerican => Region::NorthAmerican,
            Self::LatinAmerican => Region::LatinAmerican,
            Self::SouthEastAsian => Region::SouthEastAsian,
            Self::Drawn => *random.pick(Region::ALL),
        }
    }

    /// Whether it is what holds where nothing is asked for.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("region", given, Self::ALL)
    }
}

/// How signals of junctions are controlled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum SignalControl {
    /// By plans that only time decides over.
    #[default]
    Fixed,
    /// By those who come: green goes on while vehicles do, and who does not call is passed over.
    Actuated,
}

impl SignalControl {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// As options have it.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// Whether it is what holds where nothing is asked for.
    pub fn is_fixed(&self) -> bool {
        *self == Self::Fixed
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("control of signals", given, Self::ALL)
    }
}

/// What people on foot are dressed for, where it does not rain.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum Clothing {
    /// The usual weather of the region.
    #[default]
    Region,
    /// Fair weather.
    Fair,
    /// Heat.
    Hot,
    /// Cold.
    Cold,
}

impl Clothing {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// As options have it.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// Whether it is what holds where nothing is asked for.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }

    /// What is worn in a region.
    pub fn outfit(self, region: Region) -> Outfit {
        match (self, region) {
            (Self::Fair, _) | (Self::Region, Region::European | Region::NorthAmerican) => Outfit::Fair,
            (Self::Hot, _) | (Self::Region, Region::LatinAmerican | Region::SouthEastAsian) => Outfit::Hot,
            (Self::Cold, _) => Outfit::Cold,
        }
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("clothing", given, Self::ALL)
    }
}

/// What is driven on the streets of a scene, and how.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TrafficProfile {
    /// Whose mix of vehicles it is.
    pub region: Region,
    /// Share of motorcycles and bicycles among moving vehicles, 0 to 1; the region's if there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub two_wheelers: Option<f64>,
    /// Share of bicycles among moving two-wheelers, 0 to 1; the region's if there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bicycles: Option<f64>,
    /// Share of trucks and buses among moving vehicles that are no two-wheelers, 0 to 1; the region's if there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heavy_vehicles: Option<f64>,
    /// What people on foot are dressed for.
    #[serde(skip_serializing_if = "Clothing::is_usual")]
    pub clothing: Clothing,
    /// How drivers drive: 0.5 as published distributions have it, 0 all cautious, 1 all bold.
    pub aggressiveness: f64,
    /// Share of the map's parked vehicles that are there, 0 to 1.
    pub parked: f64,
    /// How signals are controlled.
    #[serde(skip_serializing_if = "SignalControl::is_fixed")]
    pub signals: SignalControl,
}

impl Default for TrafficProfile {
    fn default() -> Self {
        Self {
            region: Region::default(),
            two_wheelers: None,
            bicycles: None,
            heavy_vehicles: None,
            clothing: Clothing::default(),
            aggressiveness: 0.5,
            parked: 1.0,
            signals: SignalControl::default(),
        }
    }
}

impl TrafficProfile {
    /// Whether it is what holds where nothing is asked for.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}
