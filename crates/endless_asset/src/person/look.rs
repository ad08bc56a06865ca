//! What a person looks like: age, sex, build, skin, hair, clothes, things carried.

use crate::{Material, Surface};
use endless_world::{ClassTag, Stream};

/// Garment of the upper body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Top {
    TShirt,
    Shirt,
    Hoodie,
    Jacket,
    Coat,
    Sleeveless,
}

/// Garment of the legs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Bottom {
    Trousers,
    Shorts,
    Skirt,
    Dress,
}

/// What is on the head.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Hair {
    Bald,
    Short,
    Long,
    Bun,
    Cap,
    /// Motorcycle helmet.
    FullHelmet,
    /// Bicycle helmet.
    CycleHelmet,
}

/// What is carried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Carried {
    Nothing,
    Backpack,
    Handbag,
    ShoppingBag,
}

/// A person's looks.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Look {
    pub(crate) height: f32,
    pub(crate) female: bool,
    pub(crate) child: bool,
    /// Girth over the average's.
    pub(crate) girth: f32,
    /// Shoulder breadth over the average's.
    pub(crate) shoulder: f32,
    pub(crate) top: Top,
    pub(crate) bottom: Bottom,
    pub(crate) hair: Hair,
    pub(crate) carried: Carried,
    pub(crate) stripes: bool,
    pub(crate) skin: Material,
    pub(crate) hair_color: Material,
    pub(crate) top_color: Material,
    pub(crate) inner_color: Material,
    pub(crate) bottom_color: Material,
    pub(crate) shoe_color: Material,
    pub(crate) bag_color: Material,
}

const fn srgb(r: u8, g: u8, b: u8) -> [u8; 3] {
    [r, g, b]
}

/// The ten tones of the Monk scale, sRGB.
const SKIN: [[u8; 3]; 10] = [
    srgb(246, 237, 228),
    srgb(243, 231, 219),
    srgb(247, 234, 208),
    srgb(234, 218, 186),
    srgb(215, 189, 150),
    srgb(160, 126, 86),
    srgb(130, 92, 67),
    srgb(96, 65, 52),
    srgb(58, 49, 42),
    srgb(41, 36, 32),
];
const HAIR: [[u8; 3]; 7] = [
    srgb(20, 17, 16),
    srgb(32, 24, 20),
    srgb(52, 36, 26),
    srgb(84, 58, 38),
    srgb(150, 115, 72),
    srgb(150, 148, 145),
    srgb(110, 52, 30),
];
/// Muted for the most part, some bright.
const TOPS: [[u8; 3]; 20] = [
    srgb(235, 235, 230),
    srgb(222, 220, 212),
    srgb(28, 28, 30),
    srgb(40, 41, 45),
    srgb(90, 92, 96),
    srgb(140, 142, 145),
    srgb(33, 45, 75),
    srgb(52, 74, 112),
    srgb(108, 138, 172),
    srgb(170, 190, 208),
    srgb(92, 34, 38),
    srgb(178, 40, 38),
    srgb(62, 82, 60),
    srgb(98, 108, 72),
    srgb(180, 158, 126),
    srgb(120, 92, 68),
    srgb(206, 158, 60),
    srgb(210, 118, 130),
    srgb(36, 120, 116),
    srgb(226, 110, 40),
];
const BOTTOMS: [[u8; 3]; 10] = [
    srgb(34, 44, 66),
    srgb(52, 68, 98),
    srgb(82, 104, 138),
    srgb(25, 25, 27),
    srgb(38, 38, 41),
    srgb(76, 78, 82),
    srgb(166, 148, 116),
    srgb(110, 96, 76),
    srgb(70, 74, 58),
    srgb(150, 150, 150),
];
const SHOES: [[u8; 3]; 7] = [
    srgb(24, 23, 23),
    srgb(30, 28, 27),
    srgb(82, 56, 38),
    srgb(228, 228, 226),
    srgb(120, 122, 126),
    srgb(44, 56, 84),
    srgb(150, 40, 40),
];

fn material(surface: Surface, srgb: [u8; 3], shade: f32) -> Material {
    let linear = srgb.map(|c| (endless_world::math::pow(f32::from(c) / 255.0, 2.2) * shade).clamp(0.002, 0.85));
    Material::new(surface, linear, ClassTag::Pedestrians)
}

/// Albedo of a tone. The scale shows skin as photographed in full light; in albedo the light tones are darker and
/// redder.
fn skin_tone(tone: usize) -> Material {
    let mut m = material(Surface::Skin, SKIN[tone], 1.0);
    let light = 1.0 - tone.min(5) as f32 / 5.0;
    let filter = [0.86 - 0.18 * light, 0.84 - 0.36 * light, 0.82 - 0.44 * light];
    for (c, f) in m.base_color.iter_mut().zip(filter) {
        *c *= f;
    }
    m
}

impl Look {
    /// The looks of a variant.
    pub(crate) fn of(variant: u64) -> Self {
        let mut s = Stream::named(variant, "person", &[]);
        let female = s.chance(0.5);
        let child = s.chance(0.07);
        let height = if child {
            s.range_f32(1.08, 1.5)
        } else {
            let (mean, sd) = if female { (1.63, 0.062) } else { (1.755, 0.068) };
            (mean + sd * s.normal() as f32).clamp(1.5, 1.95)
        };
        let girth = (1.0 + 0.11 * s.normal() as f32).clamp(0.84, 1.34);
        let tone = s.below(10);
        let old = !child && s.chance(0.14);
        let bottom = match s.weighted(if female { &[62.0, 10.0, 13.0, 15.0] } else { &[80.0, 20.0, 0.0, 0.0] }) {
            0 => Bottom::Trousers,
            1 => Bottom::Shorts,
            2 => Bottom::Skirt,
            _ => Bottom::Dress,
        };
        let top = [Top::TShirt, Top::Shirt, Top::Hoodie, Top::Jacket, Top::Coat, Top::Sleeveless]
            [s.weighted(&[38.0, 20.0, 13.0, 15.0, 7.0, if female { 7.0 } else { 2.0 }])];
        let top = if bottom == Bottom::Dress && matches!(top, Top::Hoodie | Top::Coat) { Top::TShirt } else { top };
        let top = if bottom == Bottom::Shorts && top == Top::Coat { Top::TShirt } else { top };
        let hair = [Hair::Bald, Hair::Short, Hair::Long, Hair::Bun, Hair::Cap]
            [s.weighted(if female { &[0.0, 18.0, 55.0, 22.0, 5.0] } else { &[12.0, 68.0, 4.0, 1.0, 15.0] })];
        let carried = [Carried::Nothing, Carried::Backpack, Carried::Handbag, Carried::ShoppingBag]
            [s.weighted(&[58.0, 20.0, if female { 18.0 } else { 2.0 }, 8.0])];
        let hair_index = if old {
            5
        } else if tone > 4 {
            s.below(2)
        } else {
            s.weighted(&[30.0, 25.0, 20.0, 12.0, 9.0, 0.0, 4.0])
        };
        let shade = |s: &mut Stream| s.range_f32(0.8, 1.15);
        let cloth = |s: &mut Stream, palette: &[[u8; 3]]| {
            let color = *s.pick(palette);
            let k = shade(s);
            material(Surface::Cloth, color, k)
        };
        let top_color = cloth(&mut s, &TOPS);
        let bottom_color = if matches!(bottom, Bottom::Dress) {
            top_color
        } else if bottom == Bottom::Skirt {
            cloth(&mut s, &TOPS)
        } else {
            cloth(&mut s, &BOTTOMS)
        };
        let shoe = *s.pick(&SHOES);
        Self {
            height,
            female,
            child,
            girth,
            shoulder: s.range_f32(0.95, 1.05),
            top,
            bottom,
            hair,
            carried,
            stripes: matches!(top, Top::TShirt | Top::Shirt) && s.chance(0.16),
            skin: skin_tone(tone),
            hair_color: material(Surface::Hair, HAIR[hair_index], 1.0),
            top_color,
            inner_color: cloth(&mut s, &TOPS),
            bottom_color,
            shoe_color: material(Surface::Leather, shoe, 1.0),
            bag_color: cloth(&mut s, &TOPS),
        }
    }

    /// A grown-up in trousers, as people on two wheels are.
    pub(crate) fn riding(variant: u64, hair: Option<Hair>) -> Self {
        let mut look = Self::of(variant);
        look.height = look.height.clamp(1.56, 1.86);
        look.child = false;
        if matches!(look.bottom, Bottom::Skirt | Bottom::Dress) {
            look.bottom = Bottom::Trousers;
        }
        if look.top == Top::Coat {
            look.top = Top::Jacket;
        }
        if !matches!(look.carried, Carried::Backpack) {
            look.carried = Carried::Nothing;
        }
        if let Some(hair) = hair {
            look.hair = hair;
        }
        look
    }
}
