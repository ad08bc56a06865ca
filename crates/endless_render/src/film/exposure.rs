//! Automatic exposure, fixed for a whole video as the still picture needs it.

use endless_world::math;
use glam::Vec3A;

const LUMINANCE: Vec3A = Vec3A::new(0.2126, 0.7152, 0.0722);

/// Factor from kcd/m² to the tone curve's input: the log-average of the picture (Reinhard et al. 2002), without its
/// darkest and brightest tenths, becomes `key`.
pub(crate) fn exposure(pixels: &[Vec3A], key: f32) -> f32 {
    let mut logs: Vec<f32> = pixels.iter().step_by(7).map(|p| math::ln(p.dot(LUMINANCE).max(1e-7))).collect();
    if logs.is_empty() {
        return 1.0;
    }
    logs.sort_by(f32::total_cmp);
    let tenth = logs.len() / 10;
    let middle = &logs[tenth..(logs.len() - tenth).max(tenth + 1)];
    let mean = middle.iter().map(|&l| f64::from(l)).sum::<f64>() / middle.len() as f64;
    key / math::exp(mean as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grey_picture_lands_on_the_key() {
        let e = exposure(&vec![Vec3A::splat(3.0); 1000], 0.18);
        assert!((e * 3.0 - 0.18).abs() < 1e-4);
        assert!(exposure(&[], 0.18).is_finite());
    }
}
