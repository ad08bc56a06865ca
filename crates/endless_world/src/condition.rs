//! The paper's conditions (its Table 1): five weathers and three times of day, set independently.

use crate::UnknownName;
use serde::{Deserialize, Serialize};
use strum::VariantArray as _;

/// State of sky and ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum Weather {
    /// Blue sky, dry ground.
    ClearSky,
    /// Overcast, rain falling, wet ground.
    Rainy,
    /// Overcast, dry.
    Cloudy,
    /// Ground fog.
    Foggy,
    /// Clearing sky, wet ground with puddles.
    AfterRain,
}

impl Weather {
    /// All of them, in the paper's order.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The paper's name.
    pub fn name(self) -> &'static str {
        self.into()
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("weather", given, Self::ALL)
    }
}

/// Time of day, by the sun's elevation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum TimeOfDay {
    /// Low warm sun in the east.
    Morning,
    /// High sun.
    Afternoon,
    /// No sun; street lamps, headlights and windows.
    Night,
}

/// What changes during each video of a recipe.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum Changing {
    /// Nothing.
    #[default]
    Nothing,
    /// The weather.
    Weather,
    /// The time of day.
    Time,
    /// Both.
    Both,
}

impl Changing {
    /// Whether the weather does.
    pub fn weather(self) -> bool {
        matches!(self, Self::Weather | Self::Both)
    }

    /// Whether the time of day does.
    pub fn time(self) -> bool {
        matches!(self, Self::Time | Self::Both)
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("change", given, Self::VARIANTS)
    }
}

/// What a video's condition becomes by its last frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct ConditionChange {
    /// The weather.
    pub weather: Weather,
    /// The time of day.
    pub time_of_day: TimeOfDay,
}

impl TimeOfDay {
    /// All of them, in the paper's order.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The paper's name.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// What follows it in the course of a day.
    pub fn next(self) -> Self {
        match self {
            Self::Morning => Self::Afternoon,
            Self::Afternoon => Self::Night,
            Self::Night => Self::Morning,
        }
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("time of day", given, Self::ALL)
    }
}
