//! CARLA's class tags and the classes of annotated objects.

use serde::{Deserialize, Serialize};
use std::fmt;

macro_rules! class_tags {
    ($($name:ident = $tag:literal, $label:literal, [$r:literal, $g:literal, $b:literal];)*) => {
        /// CARLA's `CityObjectLabel` (0.9.14 and later, 29 tags): the red channel of the instance image.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        #[repr(u8)]
        pub enum ClassTag { $(#[doc = $label] $name = $tag,)* }

        impl ClassTag {
            /// All tags in order; the position of each is its value.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// The value in the instance image.
            pub const fn value(self) -> u8 { self as u8 }

            /// CARLA's name.
            pub const fn name(self) -> &'static str { match self { $(Self::$name => $label),* } }

            /// CARLA's palette, sRGB.
            pub const fn color(self) -> [u8; 3] { match self { $(Self::$name => [$r, $g, $b]),* } }
        }
    };
}

class_tags! {
    Unlabeled = 0, "Unlabeled", [0, 0, 0];
    Roads = 1, "Roads", [128, 64, 128];
    Sidewalks = 2, "Sidewalks", [244, 35, 232];
    Buildings = 3, "Buildings", [70, 70, 70];
    Walls = 4, "Walls", [102, 102, 156];
    Fences = 5, "Fences", [190, 153, 153];
    Poles = 6, "Poles", [153, 153, 153];
    TrafficLight = 7, "TrafficLight", [250, 170, 30];
    TrafficSigns = 8, "TrafficSigns", [220, 220, 0];
    Vegetation = 9, "Vegetation", [107, 142, 35];
    Terrain = 10, "Terrain", [152, 251, 152];
    Sky = 11, "Sky", [70, 130, 180];
    Pedestrians = 12, "Pedestrians", [220, 20, 60];
    Rider = 13, "Rider", [255, 0, 0];
    Car = 14, "Car", [0, 0, 142];
    Truck = 15, "Truck", [0, 0, 70];
    Bus = 16, "Bus", [0, 60, 100];
    Train = 17, "Train", [0, 80, 100];
    Motorcycle = 18, "Motorcycle", [0, 0, 230];
    Bicycle = 19, "Bicycle", [119, 11, 32];
    Static = 20, "Static", [110, 190, 160];
    Dynamic = 21, "Dynamic", [170, 120, 50];
    Other = 22, "Other", [55, 90, 80];
    Water = 23, "Water", [45, 60, 150];
    RoadLines = 24, "RoadLines", [157, 234, 50];
    Ground = 25, "Ground", [81, 0, 81];
    Bridge = 26, "Bridge", [150, 100, 100];
    RailTrack = 27, "RailTrack", [230, 150, 140];
    GuardRail = 28, "GuardRail", [180, 165, 180];
}

impl ClassTag {
    /// The tag with this value, `None` above 28.
    pub fn from_value(value: u8) -> Option<Self> {
        Self::ALL.get(usize::from(value)).copied()
    }
}

/// The class of an annotated object, as written in `objects.jsonl`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
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
    pub const ALL: &[Self] =
        &[Self::Car, Self::Van, Self::Truck, Self::Bus, Self::Motorcycle, Self::Bicycle, Self::Rider, Self::Pedestrian];

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

    /// The name in `objects.jsonl`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Car => "car",
            Self::Van => "van",
            Self::Truck => "truck",
            Self::Bus => "bus",
            Self::Motorcycle => "motorcycle",
            Self::Bicycle => "bicycle",
            Self::Rider => "rider",
            Self::Pedestrian => "pedestrian",
        }
    }
}

impl fmt::Display for ObjectClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
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
