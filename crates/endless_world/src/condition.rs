//! The paper's conditions (its Table 1): five weathers and three times of day, set independently.

use serde::{Deserialize, Serialize};
use std::{fmt, str::FromStr};

/// A name that is not in the list; its message lists the names that are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownName {
    /// The kind of name, e.g. "weather".
    pub what: &'static str,
    /// The name that was given.
    pub given: String,
    /// The names there are.
    pub known: Vec<&'static str>,
}

impl fmt::Display for UnknownName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown {} '{}': use one of {}", self.what, self.given, self.known.join(", "))
    }
}

impl std::error::Error for UnknownName {}

macro_rules! named_enum {
    ($(#[$doc:meta])* $type:ident, $what:literal, $($(#[$vdoc:meta])* $variant:ident = $name:literal),* $(,)?) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        pub enum $type { $($(#[$vdoc])* #[serde(rename = $name)] $variant),* }

        impl $type {
            /// All of them, in the paper's order.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// The paper's name.
            pub const fn name(self) -> &'static str { match self { $(Self::$variant => $name),* } }
        }

        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result { f.write_str(self.name()) }
        }

        impl FromStr for $type {
            type Err = UnknownName;
            fn from_str(given: &str) -> Result<Self, UnknownName> {
                match given {
                    $($name => Ok(Self::$variant),)*
                    _ => Err(UnknownName { what: $what, given: given.to_owned(), known: vec![$($name),*] }),
                }
            }
        }
    };
}

pub(crate) use named_enum;

named_enum! {
    /// State of sky and ground.
    Weather, "weather",
    /// Blue sky, dry ground.
    ClearSky = "clear_sky",
    /// Overcast, rain falling, wet ground.
    Rainy = "rainy",
    /// Overcast, dry.
    Cloudy = "cloudy",
    /// Ground fog.
    Foggy = "foggy",
    /// Clearing sky, wet ground with puddles.
    AfterRain = "after_rain",
}

named_enum! {
    /// Time of day, by the sun's elevation.
    TimeOfDay, "time of day",
    /// Low warm sun in the east.
    Morning = "morning",
    /// High sun.
    Afternoon = "afternoon",
    /// No sun; street lamps, headlights and windows.
    Night = "night",
}
