//! Which dead ends are none: the extract's edge cuts the road there.

use super::curve::hull;
use super::import_context::ImportContext;
use super::plan::StreetPlan;
use glam::DVec2;

/// A road that ends this near to the edge goes on beyond it, metres.
const NEAR_M: f64 = 25.0;

/// Opens the ends of roads at the edge: vehicles leave the map there, and others come.
pub(super) fn open_ends(plan: &mut StreetPlan, context: &ImportContext<'_>) {
    let outline = match context.bounds() {
        Some([low, high]) => vec![low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)],
        // A file that does not tell what it was cut by: what its roads span.
        None => hull(&plan.streets.iter().flat_map(ends).collect::<Vec<_>>()),
    };
    for k in 0..plan.intersections.len() {
        let [arm] = plan.intersections[k].arms[..] else { continue };
        let end = plan.arm_point(arm, 0.0, 0.0).truncate();
        plan.intersections[k].open = !plan.street(arm).roundabout && depth(&outline, end) < NEAR_M;
    }
}

/// Both ends of a street, and its middle.
fn ends(street: &super::plan::Street) -> [DVec2; 3] {
    let length = street.length();
    [0.0, 0.5 * length, length].map(|s| street.point(s, 0.0).truncate())
}

/// How far inside a convex polygon, counter-clockwise, a point lies; negative outside.
fn depth(outline: &[DVec2], p: DVec2) -> f64 {
    let edges = outline.iter().zip(outline.iter().cycle().skip(1));
    edges.map(|(a, b)| (*b - *a).normalize_or_zero().perp_dot(p - *a)).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depth_is_the_distance_to_the_nearest_edge() {
        let square = [DVec2::ZERO, DVec2::new(100.0, 0.0), DVec2::new(100.0, 100.0), DVec2::new(0.0, 100.0)];
        assert!((depth(&square, DVec2::new(50.0, 30.0)) - 30.0).abs() < 1e-9);
        assert!((depth(&square, DVec2::new(120.0, 50.0)) + 20.0).abs() < 1e-9);
        // A single road has no inside.
        assert!(depth(&square[..2], DVec2::new(50.0, 0.0)).abs() < 1e-9);
    }
}
