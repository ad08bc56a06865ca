//! CARLA's class tags and the classes of annotated objects.

use serde::{Deserialize, Serialize};
use strum::VariantArray as _;

macro_rules! class_tags {
    ($($name:ident = $tag:literal, $color:expr;)*) => {
        /// CARLA's `CityObjectLabel` (0.9.14 and later, 29 tags): the red channel of the instance image.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        #[derive(strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
        #[repr(u8)]
        pub enum ClassTag { $(#[doc = stringify!($name)] $name = $tag,)* }

        impl ClassTag {
            /// CARLA's palette, sRGB.
            pub const fn color(self) -> [u8; 3] { match self { $(Self::$name => $color),* } }
        }
    };
}

class_tags! {
    Unlabeled = 0, [0, 0, 0];
    Roads = 1, [128, 64, 128];
    Sidewalks = 2, [244, 35, 232];
    Buildings = 3, [70, 70, 70];
    Walls = 4, [102, 102, 156];
    Fences = 5, [190, 153, 153];
    Poles = 6, [153, 153, 153];
    TrafficLight = 7, [250, 170, 30];
    TrafficSigns = 8, [220, 220, 0];
    Vegetation = 9, [107, 142, 35];
    Terrain = 10, [152, 251, 152];
    Sky = 11, [70, 130, 180];
    Pedestrians = 12, [220, 20, 60];
    Rider = 13, [255, 0, 0];
    Car = 14, [0, 0, 142];
    Truck = 15, [0, 0, 70];
    Bus = 16, [0, 60, 100];
    Train = 17, [0, 80, 100];
    Motorcycle = 18, [0, 0, 230];
    Bicycle = 19, [119, 11, 32];
    Static = 20, [110, 190, 160];
    Dynamic = 21, [170, 120, 50];
    Other = 22, [55, 90, 80];
    Water = 23, [45, 60, 150];
    RoadLines = 24, [157, 234, 50];
    Ground = 25, [81, 0, 81];
    Bridge = 26, [150, 100, 100];
    RailTrack = 27, [230, 150, 140];
    GuardRail = 28, [180, 165, 180];
}

impl ClassTag {
    /// All tags in order; the position of each is its value.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The value in the instance image.
    pub const fn value(self) -> u8 {
        self as u8
    }

    /// CARLA's name.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// The tag with this value, `None` above 28.
    pub fn from_value(value: u8) -> Option<Self> {
        Self::ALL.get(usize::from(value)).copied()
    }
}

/// The class of an annotated object, as written in `objects.jsonl`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum ObjectClass {
    /// Passenger car.
    Car,
    /// Panel van or minibus; tagged `Car`, as CARLA does.
    Van,
    /// Lorry.
    Truck,
    /// City bus or coach.
    Bus,
    /// Motorcycle or scooter, without its rider.
    Motorcycle,
    /// Bicycle, without its rider.
    Bicycle,
    /// The person on a two-wheeler: an object of its own.
    Rider,
    /// A person on foot.
    Pedestrian,
}

impl ObjectClass {
    /// All classes, in the order of the label schema.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The tag of its pixels in the instance image.
    pub const fn tag(self) -> ClassTag {
        match self {
            Self::Car | Self::Van => ClassTag::Car,
            Self::Truck => ClassTag::Truck,
            Self::Bus => ClassTag::Bus,
            Self::Motorcycle => ClassTag::Motorcycle,
            Self::Bicycle => ClassTag::Bicycle,
            Self::Rider => ClassTag::Rider,
            Self::Pedestrian => ClassTag::Pedestrians,
        }
    }

    /// Whether somebody sits on it: a motorcycle or bicycle.
    pub const fn two_wheeled(self) -> bool {
        matches!(self, Self::Motorcycle | Self::Bicycle)
    }

    /// The name in `objects.jsonl`.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_are_their_own_index() {
        for (value, tag) in ClassTag::ALL.iter().enumerate() {
            assert_eq!(usize::from(tag.value()), value);
            assert_eq!(ClassTag::from_value(tag.value()), Some(*tag));
        }
        assert_eq!(ClassTag::from_value(29), None);
    }
}
