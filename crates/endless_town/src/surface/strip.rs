//! Quads along streets.

use crate::network::Street;
use endless_scene::{Material, MeshBuilder};
use glam::{DVec2, Vec2, Vec3};

/// One edge of a strip: how far left of the reference line, and how high, at any `s`.
pub(crate) struct Rail<'a> {
    pub(crate) t: f64,
    pub(crate) height: &'a dyn Fn(f64) -> f64,
}

/// Lifts a plan point.
pub(crate) fn at_height(p: DVec2, z: f64) -> Vec3 {
    p.extend(z).as_vec3()
}

/// A strip between two rails (`right` and `left` looking along the street), facing up, or towards the left of a wall
/// whose rails lie above one another. `v` gives the surface coordinate of each rail.
pub(crate) fn strip(
    mesh: &mut MeshBuilder,
    street: &Street,
    stations: &[f64],
    [right, left]: [&Rail<'_>; 2],
    [v_right, v_left]: [f32; 2],
    material: &dyn Fn(f64) -> Material,
) {
    let point = |rail: &Rail<'_>, s: f64| at_height(street.point(s, rail.t), (rail.height)(s));
    for pair in stations.windows(2) {
        let (s0, s1) = (pair[0], pair[1]);
        let (u0, u1) = (s0 as f32, s1 as f32);
        mesh.quad(
            [point(right, s0), point(right, s1), point(left, s1), point(left, s0)],
            [Vec2::new(u0, v_right), Vec2::new(u1, v_right), Vec2::new(u1, v_left), Vec2::new(u0, v_left)],
            material((s0 + s1) / 2.0),
        );
    }
}

/// A flat patch of paint or iron on a street, between two places along and across it.
pub(crate) fn patch(
    mesh: &mut MeshBuilder,
    street: &Street,
    (s0, s1): (f64, f64),
    (t0, t1): (f64, f64),
    z: f32,
    material: Material,
) {
    let steps = ((s1 - s0) / 3.0).ceil().max(1.0) as usize;
    let stations: Vec<f64> = (0..=steps).map(|i| s0 + (s1 - s0) * i as f64 / steps as f64).collect();
    let flat = |_: f64| f64::from(z);
    let (right, left) = (Rail { t: t0, height: &flat }, Rail { t: t1, height: &flat });
    strip(mesh, street, &stations, [&right, &left], [0.0, (t1 - t0) as f32], &|_| material);
}
