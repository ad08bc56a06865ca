//! What stays the same of an object for a whole video: who a person is and what they wear, which vehicle it is.
//!
//! Words are those of the catalogue, in `snake_case`. What cannot be seen because something covers it wholly is left out.

use crate::{ColorName, ColoredThing, Reid, srgb_from_linear};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// A word of the catalogue.
pub type Word = Cow<'static, str>;

/// A colour as the surface has it, before light falls on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct NamedColor {
    /// The nearest name.
    pub name: ColorName,
    /// sRGB.
    pub rgb: [u8; 3],
}

impl NamedColor {
    /// Of a linear albedo.
    pub fn of(thing: ColoredThing, linear: [f32; 3]) -> Self {
        let rgb = srgb_from_linear(linear);
        Self { name: ColorName::of(thing, rgb), rgb }
    }
}

/// Something that is worn or carried.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ColoredPiece {
    /// What it is: `t_shirt`, `jeans`, `umbrella`.
    pub piece: Word,
    /// Its colour; of patterns that of the ground.
    pub color: NamedColor,
    /// How a second colour is laid out: `stripes`, `block` (chest and sleeves), `checks`, `border`, `side_stripe`,
    /// `high_visibility` (reflecting bands).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pattern: Option<Word>,
    /// The second colour.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second_color: Option<NamedColor>,
}

impl ColoredPiece {
    /// Of one colour.
    pub fn plain(piece: &'static str, color: NamedColor) -> Self {
        Self { piece: piece.into(), color, pattern: None, second_color: None }
    }
}

/// Female or male.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Sex {
    /// Female.
    Female,
    /// Male.
    Male,
}

/// Age in four groups.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum AgeGroup {
    /// Below 13 years.
    Child,
    /// 13 to 17.
    Teenager,
    /// 18 to 64.
    Adult,
    /// 65 and older.
    Senior,
}

impl AgeGroup {
    /// The group of an age in full years.
    pub const fn of(years: u32) -> Self {
        match years {
            0..13 => Self::Child,
            13..18 => Self::Teenager,
            18..65 => Self::Adult,
            _ => Self::Senior,
        }
    }
}

/// Hair on the head.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Hairdo {
    /// `bald`, `balding`, `buzz`, `short`, `parted`, `curly`, `afro`, `bob`, `long`, `ponytail`, `bun`.
    pub style: Word,
    /// Its colour; of none where there is no hair.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub color: Option<NamedColor>,
}

/// Who a person is, what they wear and carry.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PersonAttributes {
    /// The same person, whatever they wear: equal where only clothes differ, say, for rain.
    pub identity: Reid,
    /// Full years.
    pub age_years: u32,
    /// The same in groups.
    pub age_group: AgeGroup,
    /// Female or male.
    pub sex: Sex,
    /// Standing height without hair and headgear, metres.
    pub height_m: f64,
    /// Monk Skin Tone, 1 (lightest) to 10.
    pub skin_tone: u8,
    /// Kind of outfit: `casual`, `office`, `suit`, `sports`, `high_visibility`, `uniform`, `regional`.
    pub outfit: Word,
    /// Hair; left out where headgear covers it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hair: Option<Hairdo>,
    /// `stubble`, `moustache`, `full`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub beard: Option<Word>,
    /// `glasses` or `sunglasses`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub glasses: Option<Word>,
    /// Headgear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hat: Option<ColoredPiece>,
    /// What is worn on the trunk, from the inside out, dresses, skirts, scarves and ties among them.
    pub garments: Vec<ColoredPiece>,
    /// What covers the legs one by one: trousers, shorts, stockings; left out where they are bare.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub legs: Option<ColoredPiece>,
    /// Shoes.
    pub shoes: ColoredPiece,
    /// What is carried, pushed, led or sat in.
    pub carries: Vec<ColoredPiece>,
}

/// Which vehicle it is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct VehicleAttributes {
    /// The design, e.g. `car.hatchback`, or the name of an imported model.
    pub model: Word,
    /// Which draw of the design; vehicles of one draw are of the same form and size. Left out for imported models.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub draw: Option<u64>,
    /// What it is used for, where that can be seen, else its body: `taxi`, `police`, `delivery`, `articulated`, `sedan`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub subclass: Option<Word>,
    /// The paint of body or frame; liveries, superstructures and trailers may have other colours besides. Left out where
    /// no paint is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub color: Option<NamedColor>,
    /// Length, width without mirrors, height, metres; a trailer is included, a rider is not.
    pub size: [f64; 3],
    /// Whether it draws a trailer.
    pub trailer: bool,
    /// Number of wheels that are drawn, those of the trailer included.
    pub wheels: u32,
    /// CARLA's `base_type`: `car`, `van`, `truck`, `bus`, `motorcycle`, `bicycle`.
    pub base_type: Word,
    /// CARLA's `special_type`: `emergency`, `taxi`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub special_type: Option<Word>,
}

/// Who sits in a vehicle, behind panes that show it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Occupants {
    /// Whether somebody sits at the wheel.
    pub driver: bool,
    /// How many sit on the other seats.
    pub passengers: u32,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ages_have_groups_without_gaps() {
        let group = |years| AgeGroup::of(years);
        assert_eq!([group(12), group(13)], [AgeGroup::Child, AgeGroup::Teenager]);
        assert_eq!([group(17), group(18)], [AgeGroup::Teenager, AgeGroup::Adult]);
        assert_eq!([group(64), group(65)], [AgeGroup::Adult, AgeGroup::Senior]);
        assert!((0..120).map(AgeGroup::of).is_sorted());
    }

    #[test]
    fn colors_are_named_after_their_encoding() {
        let navy = NamedColor::of(ColoredThing::Paint, [0.012, 0.035, 0.13]);
        assert_eq!((navy.name, navy.rgb), (ColorName::Blue, [29, 53, 101]));
    }
}
