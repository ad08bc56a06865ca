//! Wires that sag between utility poles.

use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::math::segment::share_along;
use endless_world::{CameraSite, ClassTag};
use glam::{DVec2, DVec3, Vec2};

const WIRE: Material = Material::new(Surface::Rubber, [0.02, 0.02, 0.02], ClassTag::Static);
const RADIUS_M: f64 = 0.014;
const SPACING_M: f64 = 30.0;
/// Sag of a full span.
const SAG_M: f64 = 0.7;
/// Straight pieces of which a span is made.
const PIECES: usize = 10;
/// Nobody puts up a camera with a wire this near before its lens, metres: it would be a black band across the picture.
const CLEAR_OF_LENS_M: f64 = 2.5;

/// Three wires between the cross-arms of two poles with their feet at two places, but those in the way of a camera.
pub(crate) fn hang(mesh: &mut MeshBuilder, sites: &[CameraSite], from: DVec3, to: DVec3) {
    let across = (to - from).truncate().normalize_or(DVec2::X).perp();
    for y in [-0.85, 0.0, 0.85] {
        let end = |foot: DVec3| foot + (across * y).extend(8.75);
        let span = Span::new(end(from), end(to));
        if !sites.iter().any(|site| span.distance(DVec3::from_array(site.position.map(f64::from))) < CLEAR_OF_LENS_M) {
            span.add(mesh);
        }
    }
}

/// A wire between two places, along a parabola.
struct Span {
    a: DVec3,
    b: DVec3,
    sag_m: f64,
}

impl Span {
    fn new(a: DVec3, b: DVec3) -> Self {
        Self { a, b, sag_m: SAG_M * (a.distance(b) / SPACING_M).powi(2) }
    }

    /// Where the `k`th piece begins.
    fn joint(&self, k: usize) -> DVec3 {
        let t = k as f64 / PIECES as f64;
        self.a.lerp(self.b, t) - DVec3::Z * (4.0 * self.sag_m * t * (1.0 - t))
    }

    /// Of a place from the wire, metres.
    fn distance(&self, place: DVec3) -> f64 {
        let to_piece = |k: usize| {
            let (from, to) = (self.joint(k), self.joint(k + 1));
            let along = to - from;
            let t = share_along(place, from, to);
            place.distance(from + along * t)
        };
        (0..PIECES).map(to_piece).fold(f64::INFINITY, f64::min)
    }

    /// A three-sided tube.
    fn add(&self, mesh: &mut MeshBuilder) {
        let side = (self.b - self.a).truncate().normalize_or(DVec2::X).perp().extend(0.0) * RADIUS_M;
        let up = DVec3::Z * RADIUS_M;
        let ring = |k: usize| {
            let p = self.joint(k);
            [p + up, p + side * 0.87 - up * 0.5, p - side * 0.87 - up * 0.5].map(DVec3::as_vec3)
        };
        for k in 0..PIECES {
            let (from, to) = (ring(k), ring(k + 1));
            for i in 0..3 {
                let j = (i + 1) % 3;
                mesh.quad([from[j], to[j], to[i], from[i]], [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y], WIRE);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{LensModel, Mount};

    #[test]
    fn no_wire_passes_close_to_a_lens() {
        let wires = |lens: [f32; 3]| {
            let site = CameraSite {
                name: "pole".to_owned(),
                position: lens,
                yaw_rad: 0.0,
                down_tilt_rad: 0.3,
                horizontal_fov_rad: 1.0,
                lens: LensModel::Pinhole,
                mount: Mount::Pole,
                roll_rad: 0.0,
            };
            let mut mesh = MeshBuilder::new();
            hang(&mut mesh, &[site], DVec3::ZERO, DVec3::new(30.0, 0.0, 0.0));
            mesh.finish().triangles.len() / (PIECES * 6)
        };
        assert_eq!(wires([15.0, 9.0, 8.0]), 3);
        assert_eq!(wires([15.0, 3.0, 8.0]), 2, "the nearest is in the way");
        assert_eq!(wires([15.0, 0.0, 8.0]), 0, "all are");
        assert_eq!(wires([15.0, 0.0, 4.0]), 3, "they pass over it");
    }

    #[test]
    fn a_span_sags_most_in_the_middle() {
        let span = Span::new(DVec3::Z * 8.75, DVec3::new(SPACING_M, 0.0, 8.75));
        let low = DVec3::new(0.5 * SPACING_M, 0.0, 8.75 - SAG_M);
        assert!(span.distance(low) < 1e-9 && (span.distance(low - DVec3::Z) - 1.0).abs() < 1e-9);
    }
}
