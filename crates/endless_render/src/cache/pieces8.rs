//! Small pieces of surfaces, side by side.

use crate::vec3x8::{Vec3x8, dot};
use wide::f32x8;

/// What lies around eight samples, as far as it tells whether others lie on the same surfaces.
pub(super) struct Pieces8 {
    pub(super) positions: Vec3x8,
    pub(super) geometric: Vec3x8,
    pub(super) shading: Vec3x8,
}

impl Pieces8 {
    /// Which go on, a bit each, in others of the same instances and materials.
    pub(super) fn go_on_in(&self, others: &Self) -> u8 {
        let bends_little = dot(&self.shading, &others.shading).simd_gt(f32x8::splat(0.995));
        let way = std::array::from_fn(|k| others.positions[k] - self.positions[k]);
        let is_level = dot(&way, &self.geometric).abs().simd_lt(f32x8::splat(0.02));
        (bends_little & is_level).to_bitmask() as u8
    }
}
