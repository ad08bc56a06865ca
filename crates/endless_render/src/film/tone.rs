//! A contrasty tone curve with a toe and a shoulder (Lottes 2016) and the sRGB transfer function, as one table.

use endless_world::math;
use glam::Vec3A;
use std::sync::{Arc, LazyLock};
use wide::f32x8;

const ENTRIES: usize = 8192;
/// Luminance of linear sRGB (ITU-R BT.709).
const LUMA: [f32; 3] = [0.2126, 0.7152, 0.0722];

/// Radiance to 8-bit sRGB.
pub(crate) struct ToneCurve {
    /// Radiance that becomes black.
    black: Vec3A,
    /// Exposure by channel: white balance included.
    exposure: Vec3A,
    /// Share of the way from grey to the colour, beyond 1 for colours that are stronger than the light's.
    saturation: f32,
    table: Arc<[u8]>,
}

/// The usual curve by x / (1 + x), the same at all exposures.
static TABLE: LazyLock<Arc<[u8]>> = LazyLock::new(|| table(1.0));

/// The curve of so many times the usual contrast.
fn table(contrast: f32) -> Arc<[u8]> {
    let curve = filmic(CONTRAST * contrast);
    let entry = |i: usize| {
        let t = i as f32 / (ENTRIES - 1) as f32;
        let x = if t < 1.0 { (t / (1.0 - t)).min(WHITE) } else { WHITE };
        (srgb(curve(x).clamp(0.0, 1.0)) * 255.0 + 0.5) as u8
    };
    (0..ENTRIES).map(entry).collect()
}

/// Slope in the middle of the curve on a log scale: cameras that watch streets are set to more contrast than eyes see.
const CONTRAST: f32 = 1.2;
/// How early the shoulder bends; 1 is a plain power curve.
const SHOULDER: f32 = 0.96;
/// Input that becomes full white.
const WHITE: f32 = 7.0;
/// Input that stays as it is.
const GREY: f32 = 0.18;

/// x^a / (b x^(a d) + c), through (grey, grey) and (white, 1).
fn filmic(contrast: f32) -> impl Fn(f32) -> f32 {
    let (grey, white) = (math::pow(GREY, contrast), math::pow(WHITE, contrast));
    let (grey_bent, white_bent) = (math::pow(GREY, contrast * SHOULDER), math::pow(WHITE, contrast * SHOULDER));
    let scale = (white_bent - grey_bent) * GREY;
    let b = (white * GREY - grey) / scale;
    let c = (white_bent * grey - white * grey_bent * GREY) / scale;
    move |x| math::pow(x, contrast) / (math::pow(x, contrast * SHOULDER) * b + c)
}

pub(crate) fn srgb(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * math::pow(linear, 1.0 / 2.4) - 0.055 }
}

impl ToneCurve {
    /// The curve at an exposure (factor from kcd/m² to scene-referred units where 0.18 is middle grey) and a white balance
    /// (factors by channel), above a black level (kcd/m²).
    pub(crate) fn new(exposure: f32, white_balance: Vec3A, black: Vec3A) -> Self {
        Self { black, exposure: white_balance * exposure, saturation: 1.0, table: Arc::clone(&TABLE) }
    }

    /// The same as a recorder is set: its contrast and saturation, 1 for as they are.
    pub(crate) fn set_to(self, contrast: f32, saturation: f32) -> Self {
        let table = if contrast == 1.0 { self.table } else { table(contrast) };
        Self { saturation, table, ..self }
    }

    /// One pixel.
    #[inline]
    pub(crate) fn apply(&self, radiance: Vec3A) -> [u8; 3] {
        let x = ((radiance - self.black) * self.exposure).max(Vec3A::ZERO);
        let x = match self.saturation {
            1.0 => x,
            saturation => {
                let grey = x.x * LUMA[0] + x.y * LUMA[1] + x.z * LUMA[2];
                (Vec3A::splat(grey) + (x - Vec3A::splat(grey)) * saturation).max(Vec3A::ZERO)
            }
        };
        // Very bright light bleaches: each channel takes a little of the brightest.
        let peak = x.max_element();
        let bleach = (peak - 1.0).max(0.0);
        let x = x + Vec3A::splat(peak * 0.12 * (bleach / (bleach + 6.0)));
        let t = x / (Vec3A::ONE + x) * (ENTRIES - 1) as f32;
        [t.x, t.y, t.z].map(|i| self.table[(i + 0.5) as usize])
    }

    /// Appends a row of pixels, eight at a time: as [`Self::apply`] has them, to the bit.
    pub(crate) fn append(&self, radiance: &[Vec3A], rgb: &mut Vec<[u8; 3]>) {
        let (eights, rest) = radiance.as_chunks();
        rgb.reserve(radiance.len());
        for eight in eights {
            rgb.extend(self.apply8(eight));
        }
        rgb.extend(rest.iter().map(|&pixel| self.apply(pixel)));
    }

    #[inline]
    fn apply8(&self, radiance: &[Vec3A; 8]) -> [[u8; 3]; 8] {
        let splat = f32x8::splat;
        let axis = |k: usize| {
            let seen = f32x8::new(radiance.each_ref().map(|pixel| pixel[k]));
            ((seen - splat(self.black[k])) * splat(self.exposure[k])).fast_max(f32x8::ZERO)
        };
        let x = [axis(0), axis(1), axis(2)];
        let x = match self.saturation {
            1.0 => x,
            saturation => {
                let grey = x[0] * splat(LUMA[0]) + x[1] * splat(LUMA[1]) + x[2] * splat(LUMA[2]);
                x.map(|x| (grey + (x - grey) * splat(saturation)).fast_max(f32x8::ZERO))
            }
        };
        let peak = x[0].fast_max(x[1]).fast_max(x[2]);
        let bleach = (peak - f32x8::ONE).fast_max(f32x8::ZERO);
        let white = peak * splat(0.12) * (bleach / (bleach + splat(6.0)));
        let places = x.map(|x| {
            let x = x + white;
            (x / (f32x8::ONE + x) * splat((ENTRIES - 1) as f32) + splat(0.5)).to_array()
        });
        std::array::from_fn(|i| [0, 1, 2].map(|k| self.table[places[k][i] as usize]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_rises_from_black_to_white() {
        let curve = ToneCurve::new(1.0, Vec3A::ONE, Vec3A::ZERO);
        assert_eq!(curve.apply(Vec3A::ZERO), [0, 0, 0]);
        assert!(curve.apply(Vec3A::splat(50.0))[0] >= 250);
        let grey = curve.apply(Vec3A::splat(0.18))[0];
        assert!((95..150).contains(&grey), "{grey}");
        let mut last = 0;
        for i in 0..400 {
            let v = curve.apply(Vec3A::splat(i as f32 * 0.02))[1];
            assert!(v >= last);
            last = v;
        }
    }

    #[test]
    fn contrast_leads_dark_and_bright_apart_and_saturation_colours_from_grey() {
        let usual = || ToneCurve::new(1.0, Vec3A::ONE, Vec3A::ZERO);
        let strong = usual().set_to(1.5, 1.0);
        let grey = |curve: &ToneCurve, x: f32| i32::from(curve.apply(Vec3A::splat(x))[1]);
        assert!((grey(&strong, GREY) - grey(&usual(), GREY)).abs() <= 1);
        assert!(grey(&strong, 0.05) < grey(&usual(), 0.05) - 10);
        assert!(grey(&strong, 0.5) > grey(&usual(), 0.5) + 10);
        let range = |curve: &ToneCurve| {
            let [r, g, b] = curve.apply(Vec3A::new(0.2, 0.15, 0.1)).map(i32::from);
            r.max(g).max(b) - r.min(g).min(b)
        };
        assert!(range(&usual().set_to(1.0, 1.5)) > range(&usual()));
        assert_eq!(range(&usual().set_to(1.0, 0.0)), 0);
    }

    #[test]
    fn eight_pixels_are_as_one_by_one() {
        let curve = ToneCurve::new(0.7, Vec3A::new(1.1, 1.0, 0.8), Vec3A::splat(0.02)).set_to(1.4, 1.3);
        let light = |i: u32| (i.wrapping_mul(2_654_435_761) >> 8) as f32 * 1e-6 * ((i % 7) as f32 - 0.3);
        let row: Vec<Vec3A> = (0..4001).map(|i| Vec3A::new(light(3 * i), light(3 * i + 1), light(3 * i + 2))).collect();
        let mut together = Vec::new();
        curve.append(&row, &mut together);
        assert_eq!(together, row.iter().map(|&pixel| curve.apply(pixel)).collect::<Vec<_>>());
    }
}
