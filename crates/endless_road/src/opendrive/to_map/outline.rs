//! Objects' outlines in the world, and the rectangle around them.

use super::super::document::{OutlineCorner, RoadObject};
use super::super::geometry::RoadShape;
use endless_world::math::f64::sin_cos;
use glam::{DVec2, DVec3};

/// A rectangle in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rectangle {
    pub(super) middle: DVec2,
    /// Half of the longer side, as a vector.
    pub(super) long: DVec2,
    /// Half of the shorter side, as a vector.
    pub(super) short: DVec2,
}

/// Where an object stands.
pub(super) fn place(shape: &RoadShape<'_>, object: &RoadObject) -> DVec3 {
    shape.point(object.s, object.t)
}

/// The corners of an object: those of its first outline, or of its box.
pub(super) fn corners(shape: &RoadShape<'_>, object: &RoadObject) -> Vec<DVec3> {
    let origin = place(shape, object);
    let (sin, cos) = sin_cos(shape.pose(object.s).heading + object.heading);
    let local = |u: f64, v: f64| origin + DVec3::new(cos * u - sin * v, sin * u + cos * v, 0.0);
    let outline = object.outlines.iter().find(|outline| outline.len() >= 3);
    match outline {
        Some(outline) => outline
            .iter()
            .map(|corner| match *corner {
                OutlineCorner::Road([s, t, _]) => shape.point(s, t),
                OutlineCorner::Local([u, v, _]) => local(u, v),
            })
            .collect(),
        None => {
            let (u, v) = (0.5 * object.size[0], 0.5 * object.size[1]);
            [(u, v), (-u, v), (-u, -v), (u, -v)].map(|(u, v)| local(u, v)).to_vec()
        }
    }
}

/// The smallest rectangle around points, one of whose sides lies along a side of their outline.
pub(super) fn rectangle(points: &[DVec3]) -> Option<Rectangle> {
    let points: Vec<DVec2> = points.iter().map(|p| p.truncate()).filter(|p| p.is_finite()).collect();
    let mut best: Option<(f64, Rectangle)> = None;
    for i in 0..points.len() {
        let side = points[(i + 1) % points.len()] - points[i];
        if side.length() < 0.05 {
            continue;
        }
        let (u, v) = (side.normalize(), side.normalize().perp());
        let span = |axis: DVec2| {
            let at = points.iter().map(|p| p.dot(axis));
            (at.clone().fold(f64::INFINITY, f64::min), at.fold(f64::NEG_INFINITY, f64::max))
        };
        let ((u0, u1), (v0, v1)) = (span(u), span(v));
        let (a, b) = (u * (0.5 * (u1 - u0)), v * (0.5 * (v1 - v0)));
        let (long, short) = if a.length() >= b.length() { (a, b) } else { (b, a) };
        let area = (u1 - u0) * (v1 - v0);
        let middle = u * (0.5 * (u0 + u1)) + v * (0.5 * (v0 + v1));
        if best.as_ref().is_none_or(|(least, _)| area < *least) {
            best = Some((area, Rectangle { middle, long, short }));
        }
    }
    best.map(|(_, rectangle)| rectangle).filter(|r| r.long.length() > 0.02)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_box_is_its_own_rectangle() {
        let (sin, cos) = sin_cos(0.4);
        let at = |u: f64, v: f64| DVec3::new(5.0 + cos * u - sin * v, 7.0 + sin * u + cos * v, 1.0);
        let r = rectangle(&[at(4.0, 1.0), at(-4.0, 1.0), at(-4.0, -1.0), at(0.0, -1.0), at(4.0, -1.0)]).unwrap();
        assert!((r.middle - DVec2::new(5.0, 7.0)).length() < 1e-9);
        assert!((r.long.length() - 4.0).abs() < 1e-9 && (r.short.length() - 1.0).abs() < 1e-9);
        assert!(r.long.perp_dot(DVec2::new(cos, sin)).abs() < 1e-9);
        assert!(rectangle(&[DVec3::ZERO; 4]).is_none());
    }
}
