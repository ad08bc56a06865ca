//! Triangles of a simple polygon.

use glam::DVec2;

/// Ear clipping that takes the best-shaped ear first. The outline is counter-clockwise; returns indices into it.
pub(crate) fn triangulate(outline: &[DVec2]) -> Vec<[usize; 3]> {
    let mut left: Vec<usize> = (0..outline.len()).collect();
    let mut shape: Vec<f64> = (0..left.len()).map(|k| ear_shape(outline, &left, k)).collect();
    let mut triangles = Vec::with_capacity(outline.len());
    let mut fresh = true;
    while left.len() > 3 {
        let best = (0..left.len()).max_by(|&a, &b| shape[a].total_cmp(&shape[b])).expect("three or more");
        if shape[best] <= 0.0 && !fresh {
            // Ears that were blocked may have become free.
            shape = (0..left.len()).map(|k| ear_shape(outline, &left, k)).collect();
            fresh = true;
            continue;
        }
        let n = left.len();
        triangles.push([left[(best + n - 1) % n], left[best], left[(best + 1) % n]]);
        left.remove(best);
        shape.remove(best);
        fresh = false;
        let n = left.len();
        for k in [(best + n - 1) % n, best % n] {
            shape[k] = ear_shape(outline, &left, k);
        }
    }
    triangles.push([left[0], left[1], left[2]]);
    triangles
}

/// How good an ear the corner `k` is: area over longest side squared; 0 for nearly flat ones, negative if it is none.
fn ear_shape(outline: &[DVec2], left: &[usize], k: usize) -> f64 {
    let n = left.len();
    let [a, b, c] = [left[(k + n - 1) % n], left[k], left[(k + 1) % n]].map(|i| outline[i]);
    let area = (b - a).perp_dot(c - a);
    if area <= 0.0 {
        return -1.0;
    }
    let inside =
        |p: DVec2| (b - a).perp_dot(p - a) >= 0.0 && (c - b).perp_dot(p - b) >= 0.0 && (a - c).perp_dot(p - c) >= 0.0;
    // Corners may be doubled where a hole was joined to the outline.
    let corner = |p: DVec2| p == a || p == b || p == c;
    let blocked = left.iter().any(|&i| !corner(outline[i]) && inside(outline[i]));
    if blocked {
        return -1.0;
    }
    area / a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a))
}

/// One outline around a polygon with holes (clockwise): each hole is joined to it by the shortest way in and out.
pub(crate) fn with_holes(outline: &[DVec2], holes: &[Vec<DVec2>]) -> Vec<DVec2> {
    let mut joined = outline.to_vec();
    for hole in holes.iter().filter(|h| h.len() >= 3) {
        let crosses = |a: DVec2, b: DVec2, ring: &[DVec2]| {
            (0..ring.len()).any(|k| {
                let (c, d) = (ring[k], ring[(k + 1) % ring.len()]);
                let touch = [c, d].iter().any(|p| *p == a || *p == b);
                let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
                !touch && side(a, b, c) * side(a, b, d) <= 0.0 && side(c, d, a) * side(c, d, b) <= 0.0
            })
        };
        let mut ways: Vec<(f64, usize, usize)> = (0..joined.len())
            .flat_map(|i| (0..hole.len()).map(move |j| (i, j)))
            .map(|(i, j)| (joined[i].distance_squared(hole[j]), i, j))
            .collect();
        ways.sort_by(|a, b| a.0.total_cmp(&b.0));
        let clear = |&&(_, i, j): &&(f64, usize, usize)| {
            !crosses(joined[i], hole[j], &joined) && !crosses(joined[i], hole[j], hole)
        };
        if let Some(&(_, i, j)) = ways.iter().find(clear) {
            let around = (0..=hole.len()).map(|k| hole[(j + k) % hole.len()]);
            let insert: Vec<DVec2> = around.chain([joined[i]]).collect();
            joined.splice(i + 1..i + 1, insert);
        }
    }
    joined
}

/// Signed area, positive if counter-clockwise.
pub(crate) fn area(outline: &[DVec2]) -> f64 {
    (0..outline.len()).map(|k| outline[k].perp_dot(outline[(k + 1) % outline.len()])).sum::<f64>() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::math::f64::sin_cos;
    use proptest::prelude::*;

    #[test]
    fn a_courtyard_stays_open() {
        let ring = |r: f64, n: u32, way: f64| -> Vec<DVec2> {
            (0..n)
                .map(|k| {
                    let (sin, cos) = sin_cos(way * std::f64::consts::TAU * f64::from(k) / f64::from(n));
                    DVec2::new(cos, sin) * r
                })
                .collect()
        };
        let (outer, hole) = (ring(9.0, 8, 1.0), ring(4.0, 5, -1.0));
        let joined = with_holes(&outer, std::slice::from_ref(&hole));
        let triangles = triangulate(&joined);
        let covered: f64 = triangles.iter().map(|t| area(&t.map(|i| joined[i]))).sum();
        assert!((covered - (area(&outer) + area(&hole))).abs() < 1e-9);
        assert!(triangles.iter().all(|t| area(&t.map(|i| joined[i])) > -1e-9));
    }

    proptest! {
        #[test]
        fn triangles_cover_star_shaped_outlines(radii in prop::collection::vec(2.0..9.0f64, 5..60)) {
            let n = radii.len() as f64;
            let outline: Vec<DVec2> = radii
                .iter()
                .enumerate()
                .map(|(i, r)| {
                    let (sin, cos) = sin_cos(std::f64::consts::TAU * i as f64 / n);
                    DVec2::new(cos, sin) * *r
                })
                .collect();
            let triangles = triangulate(&outline);
            let covered: f64 = triangles.iter().map(|t| area(&t.map(|i| outline[i]))).sum();
            prop_assert_eq!(triangles.len(), outline.len() - 2);
            prop_assert!((covered - area(&outline)).abs() < 1e-6);
            prop_assert!(triangles.iter().all(|t| area(&t.map(|i| outline[i])) > -1e-9));
        }
    }
}
