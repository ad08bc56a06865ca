//! What of a triangle is at the height of bumpers and legs.

use glam::{DVec3, Vec3};

/// Above the foot of a thing, metres: over kerbs and doorsteps.
const LOW_M: f64 = 0.35;
/// Below awnings, arms of masts and crowns.
const HIGH_M: f64 = 2.2;

/// The part of a triangle in the band, as a convex polygon; empty if there is none.
pub(super) fn within_band(corners: &[Vec3; 3]) -> Vec<DVec3> {
    let corners: Vec<DVec3> = corners.iter().map(|corner| corner.as_dvec3()).collect();
    let above = clipped(&corners, |corner| corner.z - LOW_M);
    clipped(&above, |corner| HIGH_M - corner.z)
}

/// The part of a polygon where a linear function is not negative (Sutherland and Hodgman).
fn clipped(polygon: &[DVec3], inside: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut left = Vec::with_capacity(polygon.len() + 1);
    for (&a, &b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (in_a, in_b) = (inside(a), inside(b));
        if in_a >= 0.0 {
            left.push(a);
        }
        if (in_a > 0.0 && in_b < 0.0) || (in_a < 0.0 && in_b > 0.0) {
            left.push(a + (b - a) * (in_a / (in_a - in_b)));
        }
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_in_the_band_is_left() {
        let upright = [Vec3::new(0.0, 0.0, -1.0), Vec3::new(4.0, 0.0, -1.0), Vec3::new(0.0, 0.0, 7.0)];
        let left = within_band(&upright);
        assert_eq!(left.len(), 4);
        assert!(left.iter().all(|corner| corner.z >= LOW_M - 1e-9 && corner.z <= HIGH_M + 1e-9));
        assert!(within_band(&upright.map(|corner| corner + 4.0 * Vec3::Z)).is_empty());
        assert!(within_band(&upright.map(|corner| Vec3::new(corner.x, corner.y, 0.2))).is_empty());
    }
}
