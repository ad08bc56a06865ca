//! Irradiance as second-order spherical harmonics (Ramamoorthi and Hanrahan 2001).

use glam::Vec3A;
use std::f32::consts::{FRAC_PI_4, PI};
use wide::f32x8;

/// Nine coefficients of radiance, each of three colour channels, one after the other: they are added up eight at a time.
#[derive(Debug, Clone, Copy)]
pub(super) struct SphericalHarmonics([f32x8; 4]);

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
        for (c, b) in coefficients.chunks_exact_mut(3).zip(basis(direction)) {
            c.copy_from_slice(&(radiance * (b * solid_angle)).to_array());
        }
        for (own, eight) in self.0.iter_mut().zip(coefficients.as_chunks().0) {
            *own += f32x8::new(*eight);
        }
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
        let color = |k: usize| Vec3A::new(coefficients[3 * k], coefficients[3 * k + 1], coefficients[3 * k + 2]);
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
}
