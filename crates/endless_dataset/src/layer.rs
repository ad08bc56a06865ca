//! The layers of a recording and the formats they are stored in.

use endless_world::UnknownName;
use serde::{Deserialize, Serialize};
use std::{fmt, str::FromStr};

macro_rules! words {
    ($(#[$doc:meta])* $type:ident, $what:literal, $($(#[$vdoc:meta])* $variant:ident = $name:literal),* $(,)?) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        pub enum $type { $($(#[$vdoc])* #[serde(rename = $name)] $variant),* }

        impl $type {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// The word used on the command line and in files.
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

words! {
    /// One aligned image of a frame.
    Layer, "layer",
    /// What the camera sees, sRGB.
    Rgb = "rgb",
    /// Planar depth, CARLA's 24-bit encoding.
    Depth = "depth",
    /// Class tag and instance id.
    Instance = "instance",
}

words! {
    /// How the RGB layer is stored. The others are always PNG: they must be exact.
    RgbFormat, "RGB format",
    /// Lossless.
    Png = "png",
    /// A quarter of the size, lossy.
    Jpg = "jpg",
}

impl Layer {
    /// The extension of its files.
    pub const fn extension(self, rgb_format: RgbFormat) -> &'static str {
        match (self, rgb_format) {
            (Self::Rgb, RgbFormat::Jpg) => "jpg",
            _ => "png",
        }
    }
}
