//! Random patterns in two colours: flat, gradient, checker, stripes, noise; filtered by the pixel's footprint.

use crate::material::noise;
use endless_world::Stream;
use glam::{Vec2, Vec3A};

#[derive(Debug, Clone, Copy, PartialEq)]
enum PatternKind {
    Flat,
    Gradient,
    Checker,
    Stripes,
    Noise,
}

/// A pattern on a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pattern {
    kind: PatternKind,
    /// After how many metres it comes again.
    period_m: f32,
    /// Unit vector along the pattern.
    along: Vec2,
    /// Which noise it is.
    salt: u32,
}

impl Pattern {
    /// Any of them.
    pub(super) fn draw(random: &mut Stream) -> Self {
        use PatternKind::{Checker, Flat, Gradient, Noise, Stripes};
        let kind = *random.pick(&[Flat, Gradient, Checker, Stripes, Noise]);
        let coarse = if kind == Gradient { 12.0 } else { 1.0 };
        let period_m = coarse * random.range_f32(0.25, 4.0);
        // Points of the unit circle, not quite evenly: no pattern needs more.
        let t = random.range_f32(-1.0, 1.0);
        let along = Vec2::new(1.0 - t * t, 2.0 * t) / (1.0 + t * t);
        Self { kind, period_m, along, salt: random.below(1 << 16) as u32 }
    }

    /// Share of the second colour at a place of a surface, 0 to 1.
    pub(super) fn at(&self, position: Vec3A, normal: Vec3A, footprint_m: f32) -> f32 {
        let q = plane(position, normal);
        let (u, v) = (q.dot(self.along), q.dot(self.along.perp()));
        match self.kind {
            PatternKind::Flat => 0.0,
            PatternKind::Gradient => triangle(u / self.period_m),
            PatternKind::Stripes => self.band(u, footprint_m),
            PatternKind::Checker => {
                let (a, b) = (self.band(u, footprint_m), self.band(v, footprint_m));
                a + b - 2.0 * a * b
            }
            PatternKind::Noise => {
                (0.5 + 1.1 * noise::filtered_fbm2(q + self.salt as f32, self.period_m, 5, footprint_m)).clamp(0.0, 1.0)
            }
        }
    }

    /// 1 on half of each period, 0 on the other half, blurred as wide as the footprint.
    fn band(&self, along: f32, footprint_m: f32) -> f32 {
        let edge_m = (triangle(along / self.period_m) - 0.5) * 0.5 * self.period_m;
        let width_m = footprint_m.max(1e-3);
        let sharp = (0.5 + edge_m / width_m).clamp(0.0, 1.0);
        let seen = (self.period_m / width_m * 0.5 - 0.5).clamp(0.0, 1.0);
        0.5 + (sharp - 0.5) * seen
    }
}

/// From 0 up to 1 and back, once a period of 1.
fn triangle(x: f32) -> f32 {
    1.0 - (2.0 * (x - x.floor()) - 1.0).abs()
}

/// Metres along a surface: from above on what lies, along and up on what stands.
fn plane(position: Vec3A, normal: Vec3A) -> Vec2 {
    if normal.z.abs() > 0.7 {
        return Vec2::new(position.x, position.y);
    }
    let level = Vec2::new(-normal.y, normal.x).normalize_or(Vec2::X);
    Vec2::new(level.dot(Vec2::new(position.x, position.y)), position.z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn shares_are_shares_and_fade_to_grey_far_away(
            seed: u64, x in -300f32..300.0, y in -300f32..300.0, z in 0f32..30.0, footprint_m in 0.001f32..50.0,
        ) {
            let pattern = Pattern::draw(&mut Stream::new(seed, &[]));
            let normal = if seed.is_multiple_of(2) { Vec3A::Z } else { Vec3A::new(0.6, 0.8, 0.0) };
            let position = Vec3A::new(x, y, z);
            let share = pattern.at(position, normal, footprint_m);
            prop_assert!((0.0..=1.0).contains(&share));
            if matches!(pattern.kind, PatternKind::Checker | PatternKind::Stripes | PatternKind::Noise) {
                let far = pattern.at(position, normal, 100.0);
                prop_assert!((far - 0.5).abs() < 1e-4, "{far}");
            }
        }

        #[test]
        fn neighbouring_pixels_differ_little_when_they_are_wide(seed: u64, x in -50f32..50.0) {
            let pattern = Pattern::draw(&mut Stream::new(seed, &[]));
            let at = |x: f32| pattern.at(Vec3A::new(x, 3.0, 0.0), Vec3A::Z, 2.0 * pattern.period_m);
            prop_assert!((at(x) - at(x + 0.1 * pattern.period_m)).abs() < 0.25);
        }
    }
}
