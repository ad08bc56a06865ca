//! Colours of a video's own: hue, saturation and value shifted by chance.

use crate::color_name::linear_from_srgb;
use crate::{ColorName, ColoredThing, NamedColor, Stream, math};
use std::sync::LazyLock;

/// How far colours are shifted in a video. What is drawn depends on the colour and on whose it is, so that an object is of
/// the same colours in all frames and before all cameras.
///
/// Colours are those of 8-bit sRGB: what is drawn is what labels tell.
#[derive(Debug, Clone)]
pub struct ColorVariation {
    stream: Stream,
    strength: f32,
}

/// Linear, by 8-bit sRGB.
static LINEAR: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let c = i as f32 / 255.0;
        if c <= 0.040_45 { c / 12.92 } else { math::pow((c + 0.055) / 1.055, 2.4) }
    })
});

/// The greatest linear values that are written as each 8-bit sRGB value, by the same rounding as
/// [`srgb_from_linear`](crate::srgb_from_linear).
static ROUNDED_UP: LazyLock<[f32; 255]> =
    LazyLock::new(|| std::array::from_fn(|i| linear_from_srgb((i as f64 + 0.5) / 255.0) as f32));

/// 8-bit sRGB of a linear colour, by table.
fn srgb_of(linear: [f32; 3]) -> [u8; 3] {
    linear.map(|c| ROUNDED_UP.partition_point(|&limit| limit < c) as u8)
}

impl ColorVariation {
    /// Of a seed; at strength 0 colours stay, at 1 any colour comes out.
    pub fn new(seed: u64, strength: f32) -> Self {
        Self { stream: Stream::named(seed, "randomised colours", &[]), strength }
    }

    /// The colour in place of one (8-bit sRGB) of an owner.
    pub fn srgb(&self, owner: u64, [r, g, b]: [u8; 3]) -> [u8; 3] {
        let color = u64::from(r) << 16 | u64::from(g) << 8 | u64::from(b);
        let mut random = self.stream.fork(owner ^ color << 40);
        let strength = self.strength;
        let [hue, saturation, value] = hsv([r, g, b].map(|c| f32::from(c) / 255.0));
        // Grey has no hue that it could keep.
        let turn = random.f32() - 0.5;
        let any = random.f32();
        let hue = if saturation < 0.08 { any } else { hue + turn * strength };
        // Grey streets soon look strange: a little strength gives little colour.
        let share = strength * strength.sqrt();
        let towards = |from: f32, to: f32| from + (to - from) * share;
        let saturation = towards(saturation, random.f32());
        let value = towards(value, random.range_f32(0.06, 0.95));
        rgb([hue, saturation, value]).map(|c| (c * 255.0 + 0.5) as u8)
    }

    /// The same of linear colours.
    pub fn linear(&self, owner: u64, linear: [f32; 3]) -> [f32; 3] {
        self.srgb(owner, srgb_of(linear)).map(|c| LINEAR[usize::from(c)])
    }

    /// The colour that labels tell in place of one.
    pub fn named(&self, owner: u64, thing: ColoredThing, color: NamedColor) -> NamedColor {
        let rgb = self.srgb(owner, color.rgb);
        NamedColor { name: ColorName::of(thing, rgb), rgb }
    }
}

/// Hue, saturation and value (Smith 1978), each 0 to 1.
fn hsv([r, g, b]: [f32; 3]) -> [f32; 3] {
    let (most, least) = (r.max(g).max(b), r.min(g).min(b));
    let spread = most - least;
    if spread <= 0.0 {
        return [0.0, 0.0, most];
    }
    let sixth = if most == r {
        (g - b) / spread
    } else if most == g {
        2.0 + (b - r) / spread
    } else {
        4.0 + (r - g) / spread
    };
    [sixth / 6.0, spread / most, most]
}

/// The inverse of [`hsv`]; a hue may be any number of turns.
fn rgb([hue, saturation, value]: [f32; 3]) -> [f32; 3] {
    [0.0, 2.0 / 3.0, 1.0 / 3.0].map(|offset| {
        let turn = hue + offset;
        let away = ((turn - turn.floor()) * 6.0 - 3.0).abs() - 1.0;
        value * (1.0 - saturation * (1.0 - away.clamp(0.0, 1.0)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::srgb_from_linear;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn colors_come_back_from_hue_saturation_and_value(color: [u8; 3]) {
            let there = color.map(|c| f32::from(c) / 255.0);
            let back = rgb(hsv(there)).map(|c| (c * 255.0 + 0.5) as u8);
            prop_assert_eq!(back, color);
        }

        #[test]
        fn tables_say_what_the_encoding_says(linear in prop::array::uniform3(-0.1f32..1.1)) {
            prop_assert_eq!(srgb_of(linear), srgb_from_linear(linear));
        }

        #[test]
        fn what_is_drawn_is_what_labels_tell(seed: u64, owner: u64, strength in 0.01f32..=1.0, color: [u8; 3]) {
            let variation = ColorVariation::new(seed, strength);
            let told = variation.srgb(owner, color);
            let drawn = variation.linear(owner, color.map(|c| LINEAR[usize::from(c)]));
            prop_assert_eq!(srgb_from_linear(drawn), told);
        }

        #[test]
        fn a_little_strength_shifts_a_little(seed: u64, owner: u64, color: [u8; 3]) {
            let told = ColorVariation::new(seed, 0.02).srgb(owner, color);
            prop_assert!(told.iter().zip(color).all(|(a, b)| a.abs_diff(b) <= 22), "{color:?} {told:?}");
        }
    }

    #[test]
    fn at_full_strength_any_color_comes_out() {
        let variation = ColorVariation::new(3, 1.0);
        let drawn: Vec<[u8; 3]> = (0..2000).map(|owner| variation.srgb(owner, [40, 40, 42])).collect();
        for channel in 0..3 {
            let most = drawn.iter().filter(|c| c[channel] == c[0].max(c[1]).max(c[2])).count();
            assert!((450..900).contains(&most), "{most} of 2000");
        }
        assert!(drawn.iter().filter(|c| c.iter().all(|&x| x < 60)).count() > 50, "dark ones");
        assert!(drawn.iter().filter(|c| c.iter().any(|&x| x > 200)).count() > 300, "bright ones");
    }
}
