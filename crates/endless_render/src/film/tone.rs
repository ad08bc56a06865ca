//! A filmic tone curve (Hable 2010) and the sRGB transfer function, as one table.

use endless_world::math;
use glam::Vec3A;

const ENTRIES: usize = 8192;

/// Radiance to 8-bit sRGB.
pub(crate) struct ToneCurve {
    exposure: f32,
    /// By x / (1 + x).
    table: Vec<u8>,
}

fn hable(x: f32) -> f32 {
    const A: f32 = 0.22;
    const B: f32 = 0.30;
    const C: f32 = 0.10;
    const D: f32 = 0.20;
    const E: f32 = 0.01;
    const F: f32 = 0.30;
    (x * (A * x + C * B) + D * E) / (x * (A * x + B) + D * F) - E / F
}

fn srgb(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * math::pow(linear, 1.0 / 2.4) - 0.055 }
}

impl ToneCurve {
    /// The curve at an exposure (factor from kcd/m² to scene-referred units where 0.18 is middle grey).
    pub(crate) fn new(exposure: f32) -> Self {
        const WHITE: f32 = 8.0;
        // Middle grey lands where a straight curve would put it.
        let gain = 2.6;
        let table = (0..ENTRIES)
            .map(|i| {
                let t = i as f32 / (ENTRIES - 1) as f32;
                let x = if t < 1.0 { t / (1.0 - t) } else { f32::MAX.sqrt() };
                let y = hable(x * gain) / hable(WHITE * gain);
                (srgb(y.clamp(0.0, 1.0)) * 255.0 + 0.5) as u8
            })
            .collect();
        Self { exposure, table }
    }

    /// One pixel.
    #[inline]
    pub(crate) fn apply(&self, radiance: Vec3A) -> [u8; 3] {
        let x = (radiance * self.exposure).max(Vec3A::ZERO);
        // Very bright light bleaches: each channel takes a little of the brightest.
        let peak = x.max_element();
        let bleach = (peak - 1.0).max(0.0);
        let x = x + Vec3A::splat(peak * 0.12 * (bleach / (bleach + 6.0)));
        let t = x / (Vec3A::ONE + x) * (ENTRIES - 1) as f32;
        [t.x, t.y, t.z].map(|i| self.table[(i + 0.5) as usize])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_rises_from_black_to_white() {
        let curve = ToneCurve::new(1.0);
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
}
