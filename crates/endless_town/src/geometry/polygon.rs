//! Triangles of a polygon.

use earcut::Earcut;
use glam::DVec2;

/// The triangles of an outline with holes, whichever way these turn: the corners (those of the outline, then those of
/// each hole) and three of them a triangle, counter-clockwise. Ears are cut (Held 2001), then edges are flipped until the
/// triangles are Delaunay's (Lawson 1977): thin ones are rare. Corners on a straight line may belong to no triangle.
pub(crate) fn triangulate(outline: &[DVec2], holes: &[Vec<DVec2>]) -> (Vec<DVec2>, Vec<[usize; 3]>) {
    let mut corners = outline.to_vec();
    let mut begins: Vec<u32> = Vec::new();
    for hole in holes.iter().filter(|hole| hole.len() >= 3) {
        begins.push(corners.len() as u32);
        corners.extend(hole);
    }
    let places: Vec<[f64; 2]> = corners.iter().map(DVec2::to_array).collect();
    let mut indices: Vec<u32> = Vec::new();
    Earcut::new().earcut_slice(&places, &begins, &mut indices);
    earcut::refine(&mut indices, &places);
    let counter_clockwise = |t: &[u32]| {
        let [a, b, c] = [t[0], t[1], t[2]].map(|i| i as usize);
        let turn = (corners[b] - corners[a]).perp_dot(corners[c] - corners[a]);
        if turn < 0.0 { [a, c, b] } else { [a, b, c] }
    };
    let triangles = indices.chunks_exact(3).map(counter_clockwise).collect();
    (corners, triangles)
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
        let (corners, triangles) = triangulate(&outer, std::slice::from_ref(&hole));
        let covered: f64 = triangles.iter().map(|t| area(&t.map(|i| corners[i]))).sum();
        assert!((covered - (area(&outer) + area(&hole))).abs() < 1e-9);
        assert!(triangles.iter().all(|t| area(&t.map(|i| corners[i])) > -1e-9));
    }

    #[test]
    fn what_is_no_polygon_has_no_triangles() {
        let line = [DVec2::ZERO, DVec2::X, DVec2::X * 2.0, DVec2::X];
        for outline in [&line[..0], &line[..2], &line] {
            assert!(triangulate(outline, &[]).1.is_empty());
        }
        assert!(triangulate(&[DVec2::NAN; 4], &[]).1.iter().flatten().all(|&i| i < 4));
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
            let (_, triangles) = triangulate(&outline, &[]);
            let covered: f64 = triangles.iter().map(|t| area(&t.map(|i| outline[i]))).sum();
            prop_assert_eq!(triangles.len(), outline.len() - 2);
            prop_assert!((covered - area(&outline)).abs() < 1e-6);
            prop_assert!(triangles.iter().all(|t| area(&t.map(|i| outline[i])) > -1e-9));
        }
    }
}
