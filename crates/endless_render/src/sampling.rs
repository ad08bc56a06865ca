//! Deterministic sample patterns and directions.

use endless_world::math;
use glam::{Vec2, Vec3A};
use std::f32::consts::TAU;

/// Colour samples a pixel. The first is the pixel's centre: its hit also gives depth, class and instance.
pub(crate) const SAMPLES: usize = 4;

/// Places of the samples in the pixel, relative to its centre: a turned triangle around the centre, so that edges of
/// any direction cross the four at different places.
pub(crate) const SAMPLE_OFFSETS: [Vec2; SAMPLES] =
    [Vec2::new(0.0, 0.0), Vec2::new(0.367, 0.098), Vec2::new(-0.269, 0.269), Vec2::new(-0.098, -0.367)];

/// Radical inverse in base 2.
#[inline]
fn radical_inverse(i: u32) -> f32 {
    (i.reverse_bits() >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// The `i`-th point of a Hammersley set of `n`.
#[inline]
pub(crate) fn hammersley(i: u32, n: u32) -> Vec2 {
    Vec2::new((i as f32 + 0.5) / n as f32, radical_inverse(i))
}

/// A point of the unit square turned by another on the torus (Cranley and Patterson 1976).
#[inline]
pub(crate) fn rotated(p: Vec2, by: Vec2) -> Vec2 {
    let q = p + by;
    q - q.floor()
}

/// Cosine-distributed direction around a unit normal (Malley's method).
#[inline]
pub(crate) fn cosine_direction(normal: Vec3A, u: Vec2) -> Vec3A {
    let radius = u.x.sqrt();
    let (sin, cos) = math::sin_cos(TAU * u.y);
    let (a, b) = normal.any_orthonormal_pair();
    (a * (radius * cos) + b * (radius * sin) + normal * (1.0 - u.x).max(0.0).sqrt()).normalize()
}

/// Uniform direction on the sphere.
#[inline]
pub(crate) fn sphere_direction(u: Vec2) -> Vec3A {
    let z = 1.0 - 2.0 * u.x;
    let radius = (1.0 - z * z).max(0.0).sqrt();
    let (sin, cos) = math::sin_cos(TAU * u.y);
    Vec3A::new(radius * cos, radius * sin, z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cosine_directions_have_the_right_mean() {
        let n = 4096;
        let normal = Vec3A::new(0.3, -0.5, 0.8).normalize();
        let mean = (0..n).map(|i| cosine_direction(normal, hammersley(i, n))).sum::<Vec3A>() / n as f32;
        // The mean of a cosine lobe is 2/3 of its axis.
        assert!((mean - normal * (2.0 / 3.0)).length() < 0.01);
    }

    /// Pearson's chi-square of directions in a grid of equally likely cells, in standard deviations above its mean.
    fn chi_square(cells: usize, mut cell: impl FnMut(&mut endless_world::Stream) -> usize) -> f64 {
        const DRAWS: usize = 100_000;
        let mut random = endless_world::Stream::named(9, "chi square", &[]);
        let mut counts = vec![0u32; cells];
        for _ in 0..DRAWS {
            counts[cell(&mut random)] += 1;
        }
        let expected = DRAWS as f64 / cells as f64;
        let sum: f64 = counts.iter().map(|&n| (f64::from(n) - expected).powi(2) / expected).sum();
        let degrees = (cells - 1) as f64;
        (sum - degrees) / (2.0 * degrees).sqrt()
    }

    /// Cell of a direction around an axis: 16 sectors, and 10 rings by a height from 0 to 1.
    fn cell(direction: Vec3A, axis: Vec3A, height: impl Fn(f32) -> f32) -> usize {
        let (a, b) = axis.any_orthonormal_pair();
        let turn = math::atan2(direction.dot(b), direction.dot(a)) / TAU + 0.5;
        let ring = (height(direction.dot(axis)) * 10.0) as usize;
        ring.min(9) * 16 + ((turn * 16.0) as usize).min(15)
    }

    #[test]
    fn directions_follow_their_densities() {
        let axis = Vec3A::new(0.3, -0.5, 0.8).normalize();
        let point = |random: &mut endless_world::Stream| Vec2::new(random.f32(), random.f32());
        // cos / pi over the hemisphere: the squared sine is uniform. 1 / (4 pi) over the sphere: the height is.
        let lobe = chi_square(160, |r| cell(cosine_direction(axis, point(r)), axis, |c| 1.0 - c * c));
        let sphere = chi_square(160, |r| cell(sphere_direction(point(r)), axis, |c| 0.5 + 0.5 * c));
        assert!(lobe.abs() < 4.0 && sphere.abs() < 4.0, "{lobe} {sphere}");
        // Another density is told from it.
        let wrong = chi_square(160, |r| cell(cosine_direction(axis, point(r)), axis, |c| c));
        assert!(wrong > 50.0, "{wrong}");
    }

    #[test]
    fn sphere_directions_cancel() {
        let n = 4096;
        let mean = (0..n).map(|i| sphere_direction(hammersley(i, n))).sum::<Vec3A>() / n as f32;
        assert!(mean.length() < 0.01);
    }
}
