//! Irradiance as second-order spherical harmonics (Ramamoorthi and Hanrahan 2001).

use glam::Vec3A;
use std::f32::consts::{FRAC_PI_4, PI};

/// Nine coefficients of radiance a colour channel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Harmonics(pub(super) [Vec3A; 9]);

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

impl Harmonics {
    pub(super) const ZERO: Self = Self([Vec3A::ZERO; 9]);

    /// Adds radiance from a direction, weighted by its solid angle.
    pub(super) fn add(&mut self, direction: Vec3A, radiance: Vec3A, solid_angle: f32) {
        for (c, b) in self.0.iter_mut().zip(basis(direction)) {
            *c += radiance * (b * solid_angle);
        }
    }

    /// Weighted sum with another.
    pub(super) fn accumulate(&mut self, other: &Self, weight: f32) {
        for (c, o) in self.0.iter_mut().zip(&other.0) {
            *c += *o * weight;
        }
    }

    /// Illuminance of a surface with this normal: convolution with the clamped cosine.
    pub(super) fn irradiance(&self, normal: Vec3A) -> Vec3A {
        const BAND: [f32; 9] = {
            let (l1, l2) = (2.0 * PI / 3.0, FRAC_PI_4);
            [PI, l1, l1, l1, l2, l2, l2, l2, l2]
        };
        let mut sum = Vec3A::ZERO;
        for ((c, b), a) in self.0.iter().zip(basis(normal)).zip(BAND) {
            sum += *c * (b * a);
        }
        // Ringing must not turn light negative.
        sum.max(self.0[0] * 0.05)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::{hammersley, sphere_direction};

    #[test]
    fn uniform_light_gives_pi_and_half_a_sky_its_share() {
        let (mut uniform, mut sky) = (Harmonics::ZERO, Harmonics::ZERO);
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
