//! Wires that sag between utility poles.

use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::ClassTag;
use glam::{DVec2, DVec3, Vec2};

const WIRE: Material = Material::new(Surface::Rubber, [0.02, 0.02, 0.02], ClassTag::Static);
const RADIUS_M: f64 = 0.014;
const SPACING_M: f64 = 30.0;
/// Sag of a full span.
const SAG_M: f64 = 0.7;

/// Three wires between the cross-arms of two poles with their feet at two places.
pub(crate) fn hang(mesh: &mut MeshBuilder, from: DVec3, to: DVec3) {
    let across = (to - from).truncate().normalize_or(DVec2::X).perp();
    for y in [-0.85, 0.0, 0.85] {
        let end = |foot: DVec3| foot + (across * y).extend(8.75);
        let (a, b) = (end(from), end(to));
        span(mesh, a, b, SAG_M * (a.distance(b) / SPACING_M).powi(2));
    }
}

/// A three-sided tube along a parabola.
fn span(mesh: &mut MeshBuilder, a: DVec3, b: DVec3, sag: f64) {
    const PIECES: usize = 10;
    let side = (b - a).truncate().normalize_or(DVec2::X).perp().extend(0.0) * RADIUS_M;
    let up = DVec3::Z * RADIUS_M;
    let ring = |k: usize| {
        let t = k as f64 / PIECES as f64;
        let p = a.lerp(b, t) - DVec3::Z * (4.0 * sag * t * (1.0 - t));
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
