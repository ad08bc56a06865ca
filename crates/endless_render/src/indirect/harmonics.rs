//! Irradiance as second-order spherical harmonics (Ramamoorthi and Hanrahan 2001).

use glam::{Vec3A, Vec4};
use std::f32::consts::{FRAC_PI_4, PI};
use wide::f32x8;

/// Nine coefficients of radiance, each of three colour channels: they are added up eight numbers at a time. Each of the
/// first eight has four lanes, so that it can be taken out at once; the last has fourth lanes of others.
#[derive(Debug, Clone, Copy)]
pub(super) struct SphericalHarmonics([f32x8; 4]);

/// Where a channel of a coefficient is among all lanes.
const fn lane(k: usize, channel: usize) -> usize {
    if k < 8 { 4 * k + channel } else { 8 * channel + 3 }
}

/// A lane that nothing else needs.
const SPARE: usize = 31;

fn basis(d: Vec3A) -> [f32; 9] {
    [
        0.282_095,
        0.488_603 * d.y,
        0.488_603 * d.z,
        0.488_603 * d.x,
        1.092_548 * d.x * d.y,
        1.092_548 * d.y * d.z,
        0.315_392 * (3.0 * d.z * d.z - 1.0),
        1.092_548 * d.x * d.z,
        0.546_274 * (d.x * d.x - d.y * d.y),
    ]
}

impl SphericalHarmonics {
    pub(super) const ZERO: Self = Self([f32x8::ZERO; 4]);

    /// Adds radiance from a direction, weighted by its solid angle.
    pub(super) fn add(&mut self, direction: Vec3A, radiance: Vec3A, solid_angle: f32) {
        let mut coefficients = [0.0; 32];
        for (k, b) in basis(direction).into_iter().enumerate() {
            for (channel, c) in (radiance * (b * solid_angle)).to_array().into_iter().enumerate() {
                coefficients[lane(k, channel)] = c;
            }
        }
        for (own, eight) in self.0.iter_mut().zip(coefficients.as_chunks().0) {
            *own += f32x8::new(*eight);
        }
    }

    /// The same with a number beside the coefficients, where there is room for it.
    pub(super) fn with_spare(mut self, spare: f32) -> Self {
        self.0[SPARE / 8].as_mut_array()[SPARE % 8] = spare;
        self
    }

    /// The number beside the coefficients.
    #[inline]
    pub(super) fn spare(&self) -> f32 {
        self.0[SPARE / 8].as_array()[SPARE % 8]
    }

    /// Weighted sum with another.
    #[inline]
    pub(super) fn accumulate(&mut self, other: &Self, weight: f32) {
        let weight = f32x8::splat(weight);
        for (own, other) in self.0.iter_mut().zip(&other.0) {
            *own += *other * weight;
        }
    }

    /// Illuminance of a surface with this normal: convolution with the clamped cosine.
    #[inline]
    pub(super) fn irradiance(&self, normal: Vec3A) -> Vec3A {
        const BAND: [f32; 9] = {
            let (l1, l2) = (2.0 * PI / 3.0, FRAC_PI_4);
            [PI, l1, l1, l1, l2, l2, l2, l2, l2]
        };
        let coefficients = self.0.map(f32x8::to_array);
        let coefficients = coefficients.as_flattened();
        let color = |k: usize| {
            let [r, g, b] = [0, 1, 2].map(|channel| coefficients[lane(k, channel)]);
            // What is in the fourth lane does not matter.
            if k < 8 { Vec3A::from_vec4(Vec4::new(r, g, b, coefficients[4 * k + 3])) } else { Vec3A::new(r, g, b) }
        };
        let mut sum = Vec3A::ZERO;
        for (k, (b, a)) in basis(normal).into_iter().zip(BAND).enumerate() {
            sum += color(k) * (b * a);
        }
        // Ringing must not turn light negative.
        sum.max(color(0) * 0.05)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::{hammersley, sphere_direction};
    use proptest::prelude::*;

    #[test]
    fn uniform_light_gives_pi_and_half_a_sky_its_share() {
        let (mut uniform, mut sky) = (SphericalHarmonics::ZERO, SphericalHarmonics::ZERO);
        let n = 8192;
        for i in 0..n {
            let d = sphere_direction(hammersley(i, n));
            uniform.add(d, Vec3A::ONE, 4.0 * PI / n as f32);
            if d.z > 0.0 {
                sky.add(d, Vec3A::ONE, 4.0 * PI / n as f32);
            }
        }
        assert!((uniform.irradiance(Vec3A::X).x - PI).abs() < 0.02);
        assert!((sky.irradiance(Vec3A::Z).x - PI).abs() < 0.15);
        assert!((sky.irradiance(Vec3A::X).x - PI / 2.0).abs() < 0.1);
    }

    proptest! {
        #[test]
        fn numbers_side_by_side_are_those_of_one_after_another(
            lights in prop::collection::vec((0u32..999, 0f32..9.0, 0f32..9.0, 0f32..0.5), 1..9), facing in 0u32..999,
            weight in 0f32..1.0,
        ) {
            let mut light = SphericalHarmonics::ZERO.with_spare(7.0);
            let mut plain = [Vec3A::ZERO; 9];
            for (direction, red, blue, solid_angle) in lights {
                let (direction, radiance) = (sphere_direction(hammersley(direction, 999)), Vec3A::new(red, 1.0, blue));
                light.add(direction, radiance, solid_angle);
                for (sum, b) in plain.iter_mut().zip(basis(direction)) {
                    *sum += radiance * (b * solid_angle);
                }
            }
            prop_assert_eq!(light.spare(), 7.0);
            let mut weighted = light;
            weighted.accumulate(&light, weight);
            let normal = sphere_direction(hammersley(facing, 999));
            let mut sum = Vec3A::ZERO;
            for ((k, c), b) in plain.into_iter().enumerate().zip(basis(normal)) {
                let band = [PI, 2.0 * PI / 3.0, FRAC_PI_4][usize::from(k > 0) + usize::from(k > 3)];
                sum += (c + c * weight) * (b * band);
            }
            let expected = sum.max((plain[0] + plain[0] * weight) * 0.05);
            prop_assert_eq!(weighted.irradiance(normal).to_array().map(f32::to_bits), expected.to_array().map(f32::to_bits));
        }
    }
}
