//! Names of colours: the nearest of a table of examples, in CIELAB.
//!
//! The names are the eleven basic colour terms of Berlin and Kay (1969), with beige; silver, which only vehicles are, and
//! blond, which only hair is. A name has several examples, because one in the middle of each would call navy black and
//! mustard brown. Distance is that of CIE 1976 (ΔE*ab) under D65.

use crate::math;
use serde::{Deserialize, Serialize};
use strum::VariantArray as _;

/// The name of a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[derive(strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum ColorName {
    /// From black to charcoal.
    Black,
    /// Between black and white.
    Grey,
    /// Light grey of vehicles.
    Silver,
    /// White and off-white.
    White,
    /// Up to burgundy.
    Red,
    /// Orange.
    Orange,
    /// Up to mustard, and that of high-visibility clothes.
    Yellow,
    /// From olive to teal.
    Green,
    /// From navy to pale blue.
    Blue,
    /// Purple.
    Purple,
    /// From pale pink to magenta.
    Pink,
    /// Brown.
    Brown,
    /// From cream to tan.
    Beige,
    /// Light hair.
    Blond,
}

/// What is coloured: some names belong to some things.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColoredThing {
    /// Clothes, bags, headgear.
    Fabric,
    /// The paint of a vehicle.
    Paint,
    /// Hair and coats of animals.
    Hair,
}

type Examples = &'static [(ColorName, &'static [[u8; 3]])];

use ColorName::{Beige, Black, Blond, Blue, Brown, Green, Grey, Orange, Pink, Purple, Red, Silver, White, Yellow};

/// What is grey, of fabric and of paint.
const GREYS_OF_FABRIC: Examples =
    &[(Grey, &[[68, 68, 70], [100, 100, 102], [135, 135, 137], [170, 170, 172]]), (White, &[[218, 218, 216]])];
const GREYS_OF_PAINT: Examples =
    &[(Grey, &[[72, 73, 75], [100, 101, 103], [128, 130, 132]]), (Silver, &[[174, 176, 178]]), (White, &[[212; 3]])];

/// Everything else that is no hair.
const COLORS: Examples = &[
    (Black, &[[0; 3], [24, 24, 26], [42, 42, 45]]),
    (White, &[[240, 240, 238], [255; 3]]),
    (Red, &[[255, 0, 0], [200, 30, 30], [150, 25, 28], [100, 30, 36], [176, 28, 60]]),
    (Orange, &[[255, 150, 40], [230, 110, 35], [205, 90, 28]]),
    (Yellow, &[[255, 225, 50], [212, 165, 42], [206, 215, 50], [250, 240, 150], [236, 186, 30]]),
    (Green, &[[40, 150, 60], [20, 80, 45], [62, 82, 60], [98, 108, 72], [30, 115, 100], [130, 190, 110], [68, 74, 54]]),
    (
        Blue,
        &[[0, 60, 220], [30, 45, 80], [52, 76, 114], [100, 132, 168], [170, 190, 212], [30, 76, 145], [204, 217, 234]],
    ),
    (Blue, &[[26, 34, 56], [0, 150, 200], [40, 100, 130]]),
    (Purple, &[[128, 84, 142], [112, 44, 122], [70, 30, 100], [170, 135, 195]]),
    (Pink, &[[212, 118, 132], [232, 204, 206], [240, 150, 185], [196, 60, 122]]),
    (Brown, &[[120, 92, 68], [82, 56, 38], [56, 38, 30], [112, 78, 48], [92, 80, 64]]),
    (Beige, &[[182, 160, 128], [158, 136, 106], [220, 202, 172], [240, 226, 200], [200, 170, 130]]),
];

const HAIR: Examples = &[
    (Black, &[[0; 3], [22, 18, 17], [34, 26, 22]]),
    (Brown, &[[54, 38, 28], [84, 58, 38], [112, 76, 48]]),
    (Blond, &[[160, 124, 80], [205, 170, 115]]),
    (Red, &[[120, 58, 34], [160, 75, 40]]),
    (Grey, &[[110, 109, 107], [150, 148, 145]]),
    (White, &[[205, 203, 198], [240, 238, 235]]),
];

impl ColorName {
    /// All names.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The name of an sRGB colour.
    pub fn of(thing: ColoredThing, srgb: [u8; 3]) -> Self {
        let tables: &[Examples] = match thing {
            ColoredThing::Fabric => &[COLORS, GREYS_OF_FABRIC],
            ColoredThing::Paint => &[COLORS, GREYS_OF_PAINT],
            ColoredThing::Hair => &[HAIR],
        };
        let lab = lab(srgb);
        let examples = tables.iter().copied().flatten().flat_map(|(name, list)| list.iter().map(move |e| (*name, *e)));
        let distances = examples.map(|(name, example)| (name, distance_squared(lab, self::lab(example))));
        distances.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(Grey, |(name, _)| name)
    }

    /// The word in files.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

fn distance_squared(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum()
}

/// sRGB, 8 bits a channel, of a linear colour in 0 to 1 (IEC 61966-2-1).
pub fn srgb_from_linear(linear: [f32; 3]) -> [u8; 3] {
    linear.map(|c| {
        let c = f64::from(c.clamp(0.0, 1.0));
        let encoded = if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * math::f64::pow(c, 1.0 / 2.4) - 0.055 };
        (255.0 * encoded).round() as u8
    })
}

/// Linear value of an sRGB one, both 0 to 1 (IEC 61966-2-1).
pub(crate) fn linear_from_srgb(c: f64) -> f64 {
    if c <= 0.040_45 { c / 12.92 } else { math::f64::pow((c + 0.055) / 1.055, 2.4) }
}

/// CIELAB under D65 of an sRGB colour (CIE 15:2004; the matrix is that of IEC 61966-2-1).
fn lab(srgb: [u8; 3]) -> [f64; 3] {
    let [r, g, b] = srgb.map(|c| linear_from_srgb(f64::from(c) / 255.0));
    let [x, y, z] = [
        (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505,
        0.2126 * r + 0.7152 * g + 0.0722 * b,
        (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.0890,
    ]
    .map(|t| if t > 216.0 / 24389.0 { math::f64::pow(t, 1.0 / 3.0) } else { (24389.0 / 27.0 * t + 16.0) / 116.0 });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn lab_is_that_of_the_literature() {
        // Values of Lindbloom's calculator.
        let known = [
            ([255, 255, 255], [100.0, 0.0, 0.0]),
            ([255, 0, 0], [53.24, 80.09, 67.20]),
            ([0, 255, 0], [87.73, -86.18, 83.18]),
            ([0, 0, 255], [32.30, 79.19, -107.86]),
            ([128, 128, 128], [53.59, 0.0, 0.0]),
        ];
        for (srgb, expected) in known {
            let lab = lab(srgb);
            assert!(distance_squared(lab, expected) < 0.05, "{srgb:?}: {lab:?} instead of {expected:?}");
        }
    }

    #[test]
    fn colors_have_the_names_that_people_give_them() {
        use ColoredThing::{Fabric, Hair, Paint};
        for (thing, srgb, name) in [
            (Fabric, [33, 45, 75], Blue),
            (Fabric, [36, 38, 44], Black),
            (Fabric, [160, 160, 162], Grey),
            (Paint, [172, 174, 176], Silver),
            (Fabric, [232, 230, 224], White),
            (Fabric, [92, 34, 38], Red),
            (Fabric, [206, 158, 60], Yellow),
            (Fabric, [226, 110, 40], Orange),
            (Fabric, [36, 120, 116], Green),
            (Fabric, [128, 84, 140], Purple),
            (Fabric, [210, 118, 130], Pink),
            (Fabric, [120, 92, 68], Brown),
            (Fabric, [166, 148, 116], Beige),
            (Hair, [160, 124, 80], Blond),
            (Hair, [20, 17, 16], Black),
        ] {
            assert_eq!(ColorName::of(thing, srgb), name, "{thing:?} {srgb:?}");
        }
    }

    #[test]
    fn each_name_is_that_of_its_own_examples() {
        for (thing, tables) in [
            (ColoredThing::Fabric, [COLORS, GREYS_OF_FABRIC]),
            (ColoredThing::Paint, [COLORS, GREYS_OF_PAINT]),
            (ColoredThing::Hair, [HAIR, &[]]),
        ] {
            for (name, example) in
                tables.iter().copied().flatten().flat_map(|(n, list)| list.iter().map(move |e| (n, e)))
            {
                assert_eq!(ColorName::of(thing, *example), *name, "{example:?}");
            }
        }
    }

    proptest! {
        #[test]
        fn silver_is_for_paint_and_blond_for_hair(srgb in prop::array::uniform3(0u8..)) {
            prop_assert!(![Silver, Blond].contains(&ColorName::of(ColoredThing::Fabric, srgb)));
            prop_assert_ne!(ColorName::of(ColoredThing::Paint, srgb), Blond);
            prop_assert_ne!(ColorName::of(ColoredThing::Hair, srgb), Silver);
        }

        #[test]
        fn encoding_is_undone_by_decoding(srgb in prop::array::uniform3(0u8..)) {
            let linear = srgb.map(|c| {
                let c = f32::from(c) / 255.0;
                if c <= 0.04045 { c / 12.92 } else { math::pow((c + 0.055) / 1.055, 2.4) }
            });
            prop_assert_eq!(srgb_from_linear(linear), srgb);
        }
    }
}
