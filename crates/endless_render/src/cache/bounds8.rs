//! A box around points that come eight at a time.

use super::tile::Bounds3;
use crate::vec3x8::Vec3x8;
use glam::Vec3A;
use wide::f32x8;

/// A box for each of eight lanes. Least and greatest of numbers are exact: their order tells nothing.
pub(super) struct Bounds8 {
    low: Vec3x8,
    high: Vec3x8,
}

impl Bounds8 {
    pub(super) const EMPTY: Self =
        Self { low: [f32x8::new([f32::INFINITY; 8]); 3], high: [f32x8::new([f32::NEG_INFINITY; 8]); 3] };

    /// Adds the points of these lanes.
    pub(super) fn add(&mut self, points: &Vec3x8, lanes: f32x8) {
        for ((low, high), &axis) in self.low.iter_mut().zip(&mut self.high).zip(points) {
            *low = lanes.select(low.fast_min(axis), *low);
            *high = lanes.select(high.fast_max(axis), *high);
        }
    }

    /// Around all lanes.
    pub(super) fn all(&self) -> Bounds3 {
        let least = |axis: f32x8| axis.to_array().into_iter().fold(f32::INFINITY, f32::min);
        let greatest = |axis: f32x8| axis.to_array().into_iter().fold(f32::NEG_INFINITY, f32::max);
        Bounds3 { low: Vec3A::from_array(self.low.map(least)), high: Vec3A::from_array(self.high.map(greatest)) }
    }
}
