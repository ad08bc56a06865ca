//! Broken clouds as a flat layer of fractal noise, lit from above and thinner at their edges.

use crate::material::noise;
use endless_world::math;
use endless_world::math::UnfusedVec3A;
use glam::{Vec2, Vec3A};

/// A layer of clouds.
#[derive(Debug, Clone)]
pub(crate) struct CloudLayer {
    /// Share of the sky they cover, 0 to 1.
    pub(crate) cover: f32,
    /// Radiance of a sunlit cloud, kcd/m².
    pub(crate) lit: Vec3A,
    /// Radiance of a cloud's thick, shadowed part.
    pub(crate) dark: Vec3A,
    /// Where in the noise this sky lies.
    pub(crate) seed: Vec2,
}

impl CloudLayer {
    /// The clouds in front of a clear sky's radiance.
    pub(crate) fn over(&self, clear: Vec3A, direction: Vec3A, sun: Vec3A) -> Vec3A {
        if direction.z < 0.01 {
            return clear.lerp_unfused((self.lit + self.dark) * 0.5, self.cover * 0.8);
        }
        // A layer bent down towards the horizon, so that clouds do not shrink to lines there.
        let at = Vec2::new(direction.x, direction.y) / (direction.z + 0.18) * 1.6 + self.seed;
        let billows = noise::fbm2(at, 6, 0.55);
        let threshold = 1.0 - self.cover;
        let density = math::smoothstep(threshold - 0.12, threshold + 0.22, billows * 0.5 + 0.5);
        // Lit on the side of the sun: compare with the density a step towards it.
        let towards = Vec2::new(sun.x, sun.y).normalize_or_zero() * 0.12;
        let beyond = noise::fbm2(at + towards, 4, 0.55);
        let lighting = (0.62 + (billows - beyond) * 1.6 - density * 0.25).clamp(0.0, 1.0);
        let forward = math::pow(direction.dot(sun).clamp(0.0, 1.0), 24.0) * (1.0 - density) * 1.5;
        let cloud = self.dark.lerp_unfused(self.lit, lighting) * (1.0 + forward);
        let haze = math::smoothstep(0.0, 0.12, direction.z);
        clear.lerp_unfused(cloud, density * (0.35 + 0.6 * haze))
    }
}
