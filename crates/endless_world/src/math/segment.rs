//! Segments of a line.

use glam::{DVec2, DVec3};
use std::ops::Sub;

/// What a segment ends at: a place on a plane or in space.
pub trait Place: Copy + Sub<Output = Self> {
    /// The scalar product.
    fn dot(self, other: Self) -> f64;
}

impl Place for DVec2 {
    fn dot(self, other: Self) -> f64 {
        DVec2::dot(self, other)
    }
}

impl Place for DVec3 {
    fn dot(self, other: Self) -> f64 {
        DVec3::dot(self, other)
    }
}

/// Where on the segment between two ends the point is that is nearest to a place: the share of the way from the first, 0 to 1.
pub fn share_along<P: Place>(place: P, from: P, to: P) -> f64 {
    let way = to - from;
    ((place - from).dot(way) / way.dot(way).max(1e-12)).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn place() -> impl Strategy<Value = DVec3> {
        [-100.0..100.0, -100.0..100.0, -100.0..100.0].prop_map(DVec3::from_array)
    }

    proptest! {
        #[test]
        fn no_other_point_is_nearer(at in place(), from in place(), to in place(), other in 0.0..=1.0) {
            let apart = |share: f64| at.distance(from.lerp(to, share));
            prop_assert!(apart(share_along(at, from, to)) <= apart(other) + 1e-9);
        }
    }

    #[test]
    fn a_segment_without_length_is_its_end() {
        assert_eq!(share_along(DVec2::X, DVec2::ONE, DVec2::ONE), 0.0);
    }
}
