//! Maize, as it stands in a field.

use super::leaf::{Leaves, bark, shades};
use crate::shape::Sculpt;
use endless_scene::Mesh;
use endless_world::{Stream, math};
use glam::{Affine3A, Vec2, Vec3};
use std::f32::consts::TAU;

/// Side of a block, and distances between rows and between plants of a row, metres.
const SIDE_M: f32 = 4.0;
const ROWS_M: f32 = 0.8;
const PLANTS_M: f32 = 0.33;

/// A square block of maize: rows along x, 1.9 to 2.3 m high.
pub(crate) fn corn(variant: u32) -> Mesh {
    let mut s = Stream::named(u64::from(variant), "corn", &[]);
    let greens = shades([[0.070, 0.115, 0.026], [0.085, 0.120, 0.030], [0.062, 0.105, 0.030]][variant as usize % 3]);
    let stalk = bark([0.11, 0.13, 0.05]);
    let (rows, plants) = ((SIDE_M / ROWS_M) as i32, (SIDE_M / PLANTS_M) as i32);
    let mut stalks = Sculpt::new();
    let mut leaves = Leaves::default();
    for row in 0..rows {
        for plant in 0..plants {
            let x = (plant as f32 + 0.5) * SIDE_M / plants as f32 - SIDE_M / 2.0 + s.range_f32(-0.07, 0.07);
            let y = (row as f32 + 0.5) * ROWS_M - SIDE_M / 2.0 + s.range_f32(-0.05, 0.05);
            let (foot, height) = (Vec3::new(x, y, -0.05), s.range_f32(1.75, 2.15));
            stalks.add(Sculpt::tube(&[(foot, 0.016), (foot + Vec3::Z * height, 0.007)], 3, stalk));
            let turn = s.range_f32(0.0, TAU);
            for k in 0..7 {
                let z = height * (0.22 + 0.12 * k as f32);
                // Two ranks of leaves, rising and bending over.
                let (sin, cos) = math::sin_cos(turn + std::f32::consts::PI * k as f32 + s.range_f32(-0.4, 0.4));
                let out = Vec3::new(cos, sin, s.range_f32(0.25, 0.9)).normalize_or(Vec3::X);
                let length = s.range_f32(0.45, 0.7);
                let at = foot + Vec3::Z * z;
                let shade = greens[(1 + k / 3 + s.below(2)).min(4)];
                leaves.leaf(at, out, Vec3::Z, Vec2::new(length, 0.11), out + Vec3::Z, shade);
                let bent = Vec3::new(out.x, out.y, -0.5).normalize_or(Vec3::X);
                leaves.leaf(at + out * length * 0.8, bent, Vec3::Z, Vec2::new(0.32, 0.09), out + Vec3::Z * 0.6, shade);
            }
        }
    }
    let mut mesh = stalks.into_mesh();
    mesh.append(&leaves.finish(), Affine3A::IDENTITY);
    mesh
}
