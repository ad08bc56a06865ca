//! A grid of irradiance probes in the air of what a camera sees: the ambient light of everything that moves.

use super::harmonics::SphericalHarmonics;
use glam::{UVec3, Vec2, Vec3, Vec3A};

const SPACING_M: f32 = 6.0;
/// Heights of the layers above the lowest ground: dense where cars and people are.
const HEIGHTS_M: [f32; 5] = [0.8, 2.2, 4.5, 9.0, 18.0];

/// Where probes are wanted.
pub(crate) struct ProbeRegion {
    /// Corners of a rectangle, seen from above.
    pub(crate) low: Vec2,
    pub(crate) high: Vec2,
    /// Height of the lowest ground in it.
    pub(crate) ground: f32,
    /// Which of many equal patterns the probes' rays follow.
    pub(crate) pattern: u32,
}

/// The probes around one camera's view.
pub(crate) struct ProbeGrid {
    low: Vec2,
    ground: f32,
    pub(super) size: UVec3,
    pub(super) probes: Vec<Probe>,
}

pub(super) struct Probe {
    pub(super) light: SphericalHarmonics,
    /// 0 inside walls, 1 in the open.
    pub(super) trust: f32,
}

impl ProbeGrid {
    /// A grid over a rectangle of ground, without its probes.
    pub(super) fn over(&ProbeRegion { low, high, ground, .. }: &ProbeRegion) -> Self {
        let columns = ((high.x - low.x) / SPACING_M).ceil().max(1.0) as u32 + 1;
        let rows = ((high.y - low.y) / SPACING_M).ceil().max(1.0) as u32 + 1;
        Self { low, ground, size: UVec3::new(columns, rows, HEIGHTS_M.len() as u32), probes: Vec::new() }
    }

    /// Where a probe is.
    pub(super) fn position(&self, x: u32, y: u32, z: u32) -> Vec3A {
        Vec3A::new(
            self.low.x + x as f32 * SPACING_M,
            self.low.y + y as f32 * SPACING_M,
            self.ground + HEIGHTS_M[z as usize],
        )
    }

    /// Illuminance of a surface with this normal, klx: trilinear between the probes in the open.
    pub(crate) fn irradiance(&self, position: Vec3A, normal: Vec3A) -> Vec3A {
        let p = Vec3::from(position);
        let last = self.size - UVec3::ONE;
        let u = ((p.x - self.low.x) / SPACING_M).clamp(0.0, last.x as f32);
        let v = ((p.y - self.low.y) / SPACING_M).clamp(0.0, last.y as f32);
        let height = p.z - self.ground;
        let layer = HEIGHTS_M.partition_point(|&h| h <= height).clamp(1, HEIGHTS_M.len() - 1) - 1;
        let w = ((height - HEIGHTS_M[layer]) / (HEIGHTS_M[layer + 1] - HEIGHTS_M[layer])).clamp(0.0, 1.0);
        let (x0, y0) = ((u as u32).min(last.x), (v as u32).min(last.y));
        let (fx, fy) = (u - x0 as f32, v - y0 as f32);
        let mut sum = SphericalHarmonics::ZERO;
        let mut total = 0.0;
        for corner in 0..8u32 {
            let (dx, dy, dz) = (corner & 1, corner >> 1 & 1, corner >> 2);
            let weight = (if dx == 1 { fx } else { 1.0 - fx })
                * (if dy == 1 { fy } else { 1.0 - fy })
                * (if dz == 1 { w } else { 1.0 - w });
            let (x, y) = ((x0 + dx).min(last.x), (y0 + dy).min(last.y));
            let probe = &self.probes[((layer as u32 + dz) * self.size.y * self.size.x + y * self.size.x + x) as usize];
            let weight = weight * probe.trust + 1e-6 * weight;
            sum.accumulate(&probe.light, weight);
            total += weight;
        }
        sum.irradiance(normal) / total.max(1e-9)
    }
}
