//! Automatic exposure and black level, fixed for a whole video as the still picture needs it.

use endless_world::math;
use endless_world::math::UnfusedVec3A;
use glam::Vec3A;

/// How bright the picture is that a film makes of radiance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Exposure {
    /// From kcd/m² above `black` to the tone curve's input.
    pub(crate) factor: f32,
    /// Radiance that becomes black.
    pub(crate) black: Vec3A,
}

impl Exposure {
    /// Of no picture.
    pub(crate) const NONE: Self = Self { factor: 1.0, black: Vec3A::ZERO };

    /// The mean of some pictures', on a scale of stops; itself of equal ones.
    pub(crate) fn mean(of: &[Self]) -> Option<Self> {
        let (first, count) = (of.first()?, of.len() as f32);
        if of.iter().all(|other| other == first) {
            return Some(*first);
        }
        let stops = of.iter().map(|exposure| math::ln(exposure.factor)).sum::<f32>() / count;
        let black = of.iter().map(|exposure| exposure.black).sum::<Vec3A>() / count;
        Some(Self { factor: math::exp(stops), black })
    }

    /// On its way to another, after so many seconds: the difference falls by the factor e in `1 / per_s[0]` seconds where the
    /// picture becomes brighter by it, and in `1 / per_s[1]` where it becomes darker.
    pub(crate) fn followed(&self, other: &Self, step_s: f32, per_s: [f32; 2]) -> Self {
        let brighter = other.factor > self.factor;
        let share = 1.0 - math::exp(-step_s.max(0.0) * per_s[usize::from(!brighter)]);
        let stops = math::ln(self.factor) + (math::ln(other.factor) - math::ln(self.factor)) * share;
        Self { factor: math::exp(stops), black: self.black.lerp_unfused(other.black, share) }
    }
}

const LUMINANCE: Vec3A = Vec3A::new(0.2126, 0.7152, 0.0722);

/// Factor from kcd/m² above `black` to the tone curve's input: the log-average of the picture (Reinhard et al. 2002),
/// without its darkest and brightest tenths, becomes `key`. One of `every` so many pixels is asked.
pub(crate) fn exposure(pixels: &[Vec3A], black: Vec3A, key: f32, every: usize) -> f32 {
    let above = |p: &Vec3A| (*p - black).dot(LUMINANCE).max(1e-7);
    let mut logs: Vec<f32> = pixels.iter().step_by(every).map(|p| math::ln(above(p))).collect();
    if logs.is_empty() {
        return 1.0;
    }
    logs.sort_by(f32::total_cmp);
    let tenth = logs.len() / 10;
    let middle = &logs[tenth..(logs.len() - tenth).max(tenth + 1)];
    let mean = middle.iter().map(|&l| f64::from(l)).sum::<f64>() / middle.len() as f64;
    key / math::exp(mean as f32)
}

/// Radiance that the air lays over everything, of which cameras take most away to win contrast back: the mean `veil` of
/// the darkest hundredth of the pixels, by their index. One of `every` so many is asked.
pub(crate) fn black_level(pixels: &[Vec3A], every: usize, veil: impl Fn(usize) -> Vec3A) -> Vec3A {
    const TAKEN: f32 = 0.6;
    let mut dark: Vec<usize> = (0..pixels.len()).step_by(every).collect();
    let hundredth = dark.len() / 100;
    if hundredth == 0 {
        return Vec3A::ZERO;
    }
    dark.sort_by(|&a, &b| pixels[a].dot(LUMINANCE).total_cmp(&pixels[b].dot(LUMINANCE)));
    let mean = dark[..hundredth].iter().map(|&i| veil(i).min(pixels[i])).sum::<Vec3A>() / hundredth as f32;
    Vec3A::splat(mean.min_element().max(0.0) * TAKEN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_veil_is_taken_for_black_and_nothing_else() {
        let scene: Vec<Vec3A> = (0..10_000).map(|i| Vec3A::splat((i % 100) as f32 * 0.05)).collect();
        let veiled: Vec<Vec3A> = scene.iter().map(|&p| p + 2.0).collect();
        assert!((black_level(&veiled, 7, |_| Vec3A::splat(2.0)).x - 1.2).abs() < 0.02);
        assert_eq!(black_level(&veiled, 7, |_| Vec3A::ZERO), Vec3A::ZERO, "a bright wall is no veil");
        assert_eq!(black_level(&[], 7, |_| Vec3A::ONE), Vec3A::ZERO);
    }

    #[test]
    fn a_grey_picture_lands_on_the_key() {
        let e = exposure(&vec![Vec3A::splat(3.0); 1000], Vec3A::ZERO, 0.18, 7);
        assert!((e * 3.0 - 0.18).abs() < 1e-4);
        assert!(exposure(&[], Vec3A::ZERO, 0.18, 7).is_finite());
    }

    #[test]
    fn exposure_follows_without_a_jump_and_arrives() {
        let of = |factor: f32| Exposure { factor, black: Vec3A::ZERO };
        for (from, to, per_s) in [(1.0f32, 4.0f32, 1.0f32), (4.0, 1.0, 3.0)] {
            let mut now = of(from);
            for _ in 0..20 {
                let next = now.followed(&of(to), 0.05, [1.0, 3.0]);
                assert!((next.factor / now.factor).max(now.factor / next.factor) < 1.25);
                now = next;
            }
            // After a second.
            let left = math::ln(now.factor / to) / math::ln(from / to);
            assert!((left - math::exp(-per_s)).abs() < 1e-3, "{left}");
        }
        assert!((of(2.0).followed(&of(3.0), 0.0, [1.0, 3.0]).factor - 2.0).abs() < 1e-5);
    }
}
