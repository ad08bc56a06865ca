//! The smallest rectangle around points, standing at any angle.

use glam::DVec2;

/// The corners of the rectangle of the least area that holds all these points, one after another around it; it lies along an edge
/// of the convex hull (Freeman and Shapira 1975). `None` without points.
pub(super) fn smallest_rectangle(points: &[DVec2]) -> Option<[DVec2; 4]> {
    let hull = convex_hull(points);
    let edges = hull.iter().zip(hull.iter().cycle().skip(1)).filter_map(|(a, b)| (b - a).try_normalize());
    // A point or nothing has no edges.
    let along = edges.chain([DVec2::X]);
    let rectangle = |u: DVec2| {
        let v = u.perp();
        let range = |axis: DVec2| {
            let on = hull.iter().map(|p| p.dot(axis));
            on.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)))
        };
        let ((u0, u1), (v0, v1)) = (range(u), range(v));
        ((u1 - u0) * (v1 - v0), [u * u0 + v * v0, u * u1 + v * v0, u * u1 + v * v1, u * u0 + v * v1])
    };
    if hull.is_empty() {
        return None;
    }
    along.map(rectangle).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, corners)| corners)
}

/// Andrew's monotone chain.
fn convex_hull(points: &[DVec2]) -> Vec<DVec2> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let half = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..]
                && (b - a).perp_dot(point - b) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut sorted.iter().copied());
    hull.extend(half(&mut sorted.iter().rev().copied()));
    hull
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_turned_square_is_found() {
        let points = [[2.0, 0.0], [4.0, 2.0], [2.0, 4.0], [0.0, 2.0], [2.0, 2.0]].map(DVec2::from);
        let corners = smallest_rectangle(&points).expect("points");
        assert!((corners[0].distance(corners[1]) - 8.0_f64.sqrt()).abs() < 1e-9);
        assert_eq!(smallest_rectangle(&[]), None);
    }

    proptest! {
        #[test]
        fn it_holds_all_points_and_is_no_larger_than_an_upright_one(
            points in prop::collection::vec((0.0..50.0, 0.0..50.0), 1..40)
        ) {
            let points: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
            let [a, b, c, d] = smallest_rectangle(&points).expect("points");
            let (u, v) = (b - a, d - a);
            prop_assert!((c - (b + v)).length() < 1e-6);
            for p in &points {
                for axis in [u, v] {
                    // A side of no length but rounding's has no direction.
                    if let Some(n) = axis.try_normalize().filter(|_| axis.length() > 1e-9) {
                        let at = (*p - a).dot(n);
                        prop_assert!(at > -1e-6 && at < axis.length() + 1e-6);
                    }
                }
            }
            let (low, high) = points.iter().fold((points[0], points[0]), |(l, h), p| (l.min(*p), h.max(*p)));
            prop_assert!(u.length() * v.length() <= (high.x - low.x) * (high.y - low.y) + 1e-6);
        }
    }
}
