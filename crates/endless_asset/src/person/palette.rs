//! Colours of skin, hair and cloth.

use endless_scene::{Material, Surface};
use endless_world::{ClassTag, Stream, fnv1a, math};

type Srgb = [u8; 3];

/// The ten tones of the Monk scale, sRGB.
const SKIN: [Srgb; 10] = [
    [246, 237, 228],
    [243, 231, 219],
    [247, 234, 208],
    [234, 218, 186],
    [215, 189, 150],
    [160, 126, 86],
    [130, 92, 67],
    [96, 65, 52],
    [58, 49, 42],
    [41, 36, 32],
];
const HAIR: [Srgb; 8] = [
    [20, 17, 16],
    [32, 24, 20],
    [52, 36, 26],
    [84, 58, 38],
    [160, 124, 80],
    [118, 58, 34],
    [150, 148, 145],
    [205, 203, 198],
];

/// Muted for the most part, some bright: shirts, dresses, bags.
pub(crate) const BRIGHT: &[Srgb] = &[
    [235, 235, 230],
    [232, 230, 224],
    [222, 220, 212],
    [28, 28, 30],
    [34, 34, 37],
    [40, 41, 45],
    [90, 92, 96],
    [140, 142, 145],
    [33, 45, 75],
    [52, 74, 112],
    [108, 138, 172],
    [170, 190, 208],
    [92, 34, 38],
    [178, 40, 38],
    [62, 82, 60],
    [98, 108, 72],
    [180, 158, 126],
    [120, 92, 68],
    [206, 158, 60],
    [210, 118, 130],
    [36, 120, 116],
    [226, 110, 40],
    [128, 84, 140],
    [232, 205, 205],
];
/// Shirts of offices.
pub(crate) const PALE: &[Srgb] =
    &[[240, 240, 238], [236, 238, 240], [206, 218, 232], [168, 190, 216], [230, 218, 214], [60, 66, 84]];
/// Suits, coats, uniforms of offices.
pub(crate) const SOBER: &[Srgb] =
    &[[24, 25, 30], [36, 38, 44], [30, 36, 54], [62, 64, 70], [84, 80, 76], [112, 92, 70], [26, 26, 26]];
/// Coats and jackets for bad weather.
pub(crate) const WEATHER: &[Srgb] = &[
    [28, 30, 34],
    [36, 44, 62],
    [70, 76, 60],
    [122, 100, 74],
    [158, 134, 104],
    [120, 36, 40],
    [212, 170, 40],
    [52, 92, 120],
    [96, 98, 102],
];
pub(crate) const DENIM: &[Srgb] =
    &[[34, 44, 66], [44, 58, 86], [58, 76, 108], [82, 104, 138], [128, 148, 172], [30, 32, 38]];
pub(crate) const CHINO: &[Srgb] = &[
    [26, 26, 28],
    [38, 38, 41],
    [76, 78, 82],
    [166, 148, 116],
    [110, 96, 76],
    [70, 74, 58],
    [150, 150, 148],
    [46, 54, 76],
];
pub(crate) const LEATHERS: &[Srgb] = &[[24, 23, 23], [30, 28, 27], [82, 56, 38], [116, 80, 52], [60, 40, 32]];
pub(crate) const TRAINERS: &[Srgb] =
    &[[232, 232, 230], [226, 226, 224], [24, 24, 26], [120, 122, 126], [44, 56, 84], [160, 44, 44], [70, 110, 90]];
/// Saturated, for saris, scarves and umbrellas.
pub(crate) const JEWEL: &[Srgb] = &[
    [168, 28, 60],
    [206, 92, 28],
    [214, 160, 44],
    [26, 110, 92],
    [30, 74, 142],
    [112, 44, 122],
    [196, 60, 122],
    [24, 24, 28],
];

/// A material of this colour, its brightness scaled.
pub(crate) fn material(surface: Surface, srgb: Srgb, shade: f32) -> Material {
    let linear = srgb.map(|c| (math::pow(f32::from(c) / 255.0, 2.2) * shade).clamp(0.002, 0.82));
    Material::new(surface, linear, ClassTag::Pedestrians)
}

/// Cloth of this colour.
pub(crate) const fn linear(surface: Surface, base_color: [f32; 3]) -> Material {
    Material::new(surface, base_color, ClassTag::Pedestrians)
}

/// A dye of a palette, a little lighter or darker than its neighbours.
pub(crate) fn dyed(s: &mut Stream, surface: Surface, palette: &[Srgb]) -> Material {
    let color = *s.pick_by_key(palette, |color| fnv1a(*color));
    let shade = s.range_f32(0.8, 1.15);
    material(surface, color, shade)
}

/// Albedo of a tone (0 to 9). The scale shows skin as photographed in full light; in albedo the light tones are darker
/// and redder.
pub(crate) fn skin(tone: usize) -> Material {
    let mut m = material(Surface::Skin, SKIN[tone], 1.0);
    let light = 1.0 - tone.min(5) as f32 / 5.0;
    let filter = [0.86 - 0.18 * light, 0.80 - 0.36 * light, 0.76 - 0.44 * light];
    for (c, f) in m.base_color.iter_mut().zip(filter) {
        *c *= f;
    }
    m
}

/// Hair: grey with age, dark with dark skin.
pub(crate) fn hair(s: &mut Stream, tone: usize, age: f32) -> Material {
    let grey = endless_world::math::smoothstep(38.0, 74.0, age);
    let index = if s.chance(f64::from(grey)) {
        6 + s.below(2)
    } else if tone > 4 {
        s.below(2)
    } else {
        s.weighted(&[26.0, 24.0, 20.0, 15.0, 10.0, 5.0])
    };
    let shade = s.range_f32(0.85, 1.2);
    material(Surface::Hair, HAIR[index], shade)
}
