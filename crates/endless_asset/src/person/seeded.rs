//! Who a person is, drawn from a seed: age, sex, height, build, skin, hair; what they wear and carry is chosen in
//! `wardrobe`.

use super::appearance::{Appearance, Beard, Carried, Glasses, Hair, Hat};
use super::choice::choose;
use super::clothes::{Legs, Shoes};
use super::{palette, wardrobe};
use endless_world::{Outfit, Stream, math};

/// Median standing heights of boys and girls by age (WHO and CDC growth references), metres.
const GROWTH: [(f32, f32, f32); 11] = [
    (3.0, 0.96, 0.95),
    (4.0, 1.03, 1.02),
    (6.0, 1.16, 1.15),
    (8.0, 1.28, 1.28),
    (10.0, 1.39, 1.39),
    (12.0, 1.50, 1.52),
    (13.0, 1.57, 1.58),
    (14.0, 1.64, 1.61),
    (16.0, 1.74, 1.63),
    (18.0, 1.765, 1.635),
    (120.0, 1.765, 1.635),
];

fn median_height(age: f32, female: bool) -> f32 {
    let i = GROWTH.partition_point(|g| g.0 <= age).clamp(1, GROWTH.len() - 1);
    let (a, b) = (GROWTH[i - 1], GROWTH[i]);
    let k = ((age - a.0) / (b.0 - a.0)).clamp(0.0, 1.0);
    let height = if female { math::lerp(a.2, b.2, k) } else { math::lerp(a.1, b.1, k) };
    height - 0.04 * math::smoothstep(55.0, 85.0, age)
}

impl Appearance {
    /// The looks of a variant, dressed for the weather.
    pub(crate) fn of(variant: u64, outfit: Outfit) -> Self {
        let mut s = Stream::named(variant, "person", &[]);
        let female = s.chance(0.5);
        let age = match s.weighted(&[7.0, 8.0, 45.0, 26.0, 14.0]) {
            0 => s.range_f32(4.0, 12.5),
            1 => s.range_f32(12.5, 18.0),
            2 => s.range_f32(18.0, 40.0),
            3 => s.range_f32(40.0, 63.0),
            _ => s.range_f32(63.0, 86.0),
        };
        let median = median_height(age, female);
        let height = (median * (1.0 + 0.038 * s.normal() as f32)).clamp(0.93 * median, 1.10 * median).min(1.97);
        let girth = 1.0 + 0.11 * s.normal() as f32 + 0.05 * math::smoothstep(25.0, 55.0, age);
        let girth = girth.clamp(0.86, if age < 14.0 { 1.2 } else { 1.36 });
        let tone = s.below(10);
        let skin = palette::skin(tone);
        let hair_color = palette::hair(&mut s, tone, age);
        let hair = hair(&mut s, female, age, tone);
        let beard = if female || age < 19.0 {
            Beard::None
        } else {
            const BEARDS: [(Beard, f64); 4] =
                [(Beard::None, 60.0), (Beard::Stubble, 16.0), (Beard::Moustache, 6.0), (Beard::Full, 18.0)];
            choose(&mut s, &BEARDS)
        };
        let clear = 0.16 + if age > 45.0 { 0.2 } else { 0.0 };
        let sun = match outfit {
            Outfit::Rain => 0.0,
            _ if age < 12.0 => 0.0,
            Outfit::Hot => 0.3,
            Outfit::Fair | Outfit::Cold => 0.14,
        };
        let glasses = choose(&mut s, &[(Glasses::None, 1.0), (Glasses::Clear, clear), (Glasses::Sun, sun)]);
        let plain = palette::linear(endless_scene::Surface::Cloth, [0.5; 3]);
        let mut appearance = Self {
            age,
            female,
            height,
            girth,
            shoulder: s.range_f32(0.95, 1.06),
            folds: s.range_f32(0.0, 6.3),
            tone,
            skin,
            hair,
            hair_color,
            beard,
            glasses,
            hat: Hat::None,
            hat_color: plain,
            garments: Vec::new(),
            legs: Legs::bare(skin),
            shoes: Shoes::plain(),
            carried: Carried::Nothing,
            bag_color: plain,
            outfit: "casual",
        };
        wardrobe::dress(&mut appearance, &mut Stream::named(variant, "wardrobe", &[]), outfit);
        appearance
    }

    /// A grown-up dressed to ride, as people on two wheels are.
    pub(crate) fn riding(variant: u64, helmet: Option<Hat>, outfit: Outfit) -> Self {
        let mut appearance = (0..)
            .map(|i| Self::of(variant.wrapping_add(i * 0x9e37), outfit))
            .find(|l| l.age > 17.0 && l.age < 66.0 && l.legs.can_ride())
            .unwrap_or_else(|| Self::of(variant, outfit));
        appearance.height = appearance.height.clamp(1.56, 1.86);
        if appearance.carried != Carried::Backpack {
            appearance.carried = Carried::Nothing;
        }
        appearance.garments.retain(|g| g.hem > 0.44);
        if let Some(hat) = helmet {
            appearance.hat = hat;
            appearance.hat_color = appearance.bag_color;
        } else if matches!(appearance.hat, Hat::Brimmed | Hat::Fedora | Hat::Hood | Hat::Conical) {
            appearance.hat = Hat::None;
        }
        appearance
    }
}

/// Skin of the person of a variant, 1 to 10 on the Monk scale.
pub(crate) fn skin_tone(variant: u64) -> u8 {
    Appearance::of(variant, Outfit::Fair).tone as u8 + 1
}

fn hair(s: &mut Stream, female: bool, age: f32, tone: usize) -> Hair {
    let old = f64::from(math::smoothstep(30.0, 70.0, age));
    let afro = if tone > 5 { 10.0 } else { 1.0 };
    // Of women, of men.
    let styles = [
        (Hair::Bald, [0.0, 2.0 + 10.0 * old]),
        (Hair::Balding, [0.0, 26.0 * old]),
        (Hair::Buzz, [0.5, 12.0]),
        (Hair::Short, [6.0 + 16.0 * old, 40.0]),
        (Hair::Parted, [2.0, 22.0]),
        (Hair::Curly, [6.0 + 8.0 * old, 8.0]),
        (Hair::Afro, [0.6 * afro, 0.6 * afro]),
        (Hair::Bob, [22.0, 1.0]),
        (Hair::Long, [40.0 * (1.0 - 0.7 * old), 2.0]),
        (Hair::Ponytail, [22.0 * (1.0 - 0.6 * old), 1.0]),
        (Hair::Bun, [14.0, 1.0]),
    ];
    choose(s, &styles.map(|(style, [women, men])| (style, if female { women } else { men })))
}
