//! Wheels.

use super::paint;
use crate::shape::Sculpt;
use endless_scene::{Material, Mesh};
use endless_world::math;
use glam::{Affine3A, Quat, Vec2, Vec3};
use std::f32::consts::{FRAC_PI_2, TAU};

/// A wheel of a vehicle.
#[derive(Debug, Clone, PartialEq)]
pub struct Wheel {
    /// Centre in the object frame.
    pub position: Vec3,
    /// Whether it turns with the steering.
    pub steered: bool,
    /// Whether the mesh is mirrored (y → −y) for this side.
    pub mirrored: bool,
}

/// What a rim looks like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Rim {
    /// Light alloy with this many spokes.
    Alloy(usize),
    /// Pressed steel with holes, as on lorries and vans.
    Steel,
    /// Many thin wires.
    Wire,
}

/// Turns something made about z so that its axis is y, its top the outer side.
fn about_y(s: Sculpt) -> Sculpt {
    s.placed(Affine3A::from_quat(Quat::from_rotation_x(-FRAC_PI_2)))
}

/// A wheel with its axis along y, outer side towards +y. `rim` is the rim's radius over the wheel's.
pub(crate) fn wheel(radius: f32, width: f32, rim: f32, style: Rim, metal: Material) -> Mesh {
    let mut s = Sculpt::new();
    let r = radius * rim;
    let h = 0.5 * width;
    let k = (0.22 * width).min(0.4 * (radius - r));
    let tyre = [
        (r, -h * 0.80),
        (r + 0.35 * (radius - r), -h),
        (radius - 1.3 * k, -h * 0.97),
        (radius - 0.35 * k, -h * 0.86),
        (radius, -h * 0.60),
        (radius, h * 0.60),
        (radius - 0.35 * k, h * 0.86),
        (radius - 1.3 * k, h * 0.97),
        (r + 0.35 * (radius - r), h),
        (r, h * 0.80),
    ];
    s.add(Sculpt::lathe(&tyre, 32, 60.0, paint::RUBBER));
    match style {
        Rim::Alloy(spokes) => alloy(&mut s, r, h, spokes, metal),
        Rim::Steel => steel(&mut s, r, h, metal),
        Rim::Wire => wire(&mut s, r, h, metal),
    }
    about_y(s).into_mesh()
}

/// The bright edge of the rim, and its dark inside.
fn flange(s: &mut Sculpt, r: f32, h: f32, metal: Material) {
    s.add(Sculpt::lathe(
        &[(r * 1.02, h * 0.78), (r * 0.985, h * 0.86), (r * 0.93, h * 0.80), (r * 0.91, h * 0.5)],
        32,
        50.0,
        metal,
    ));
    s.add(Sculpt::lathe(&[(r * 0.91, h * 0.5), (r * 0.90, h * 0.05), (0.0, h * 0.05)], 32, 30.0, paint::DARK));
    s.add(Sculpt::lathe(&[(0.0, -h * 0.6), (r, -h * 0.6), (r, -h * 0.8)], 24, 30.0, paint::DARK));
    // Brake disc behind the spokes.
    s.add(Sculpt::lathe(&[(r * 0.62, h * 0.06), (r * 0.62, h * 0.14), (0.0, h * 0.14)], 24, 30.0, paint::BRAKE));
}

fn alloy(s: &mut Sculpt, r: f32, h: f32, spokes: usize, metal: Material) {
    flange(s, r, h, metal);
    for i in 0..spokes {
        let turn = Quat::from_rotation_z(TAU * i as f32 / spokes as f32);
        let (w0, w1) = (r * 0.62 / spokes as f32 + 0.012, r * 0.8 / spokes as f32 + 0.008);
        let spoke = Sculpt::sweep(
            &[
                (Vec3::new(r * 0.08, 0.0, h * 0.52), Vec2::new(w0, h * 0.16)),
                (Vec3::new(r * 0.50, 0.0, h * 0.66), Vec2::new(w0 * 0.85, h * 0.15)),
                (Vec3::new(r * 0.95, 0.0, h * 0.68), Vec2::new(w1, h * 0.14)),
            ],
            Vec3::Y,
            6,
            2.0,
            false,
            metal,
        );
        s.add(spoke.placed(Affine3A::from_quat(turn)));
    }
    s.add(Sculpt::lathe(
        &[(r * 0.20, h * 0.3), (r * 0.19, h * 0.68), (r * 0.14, h * 0.76), (0.0, h * 0.78)],
        16,
        40.0,
        metal,
    ));
}

fn steel(s: &mut Sculpt, r: f32, h: f32, metal: Material) {
    flange(s, r, h, metal);
    let dish = [
        (r * 0.92, h * 0.30),
        (r * 0.75, h * 0.42),
        (r * 0.55, h * 0.36),
        (r * 0.40, h * 0.62),
        (r * 0.34, h * 0.72),
        (0.0, h * 0.76),
    ];
    s.add(Sculpt::lathe(&dish, 32, 40.0, metal));
    for i in 0..10 {
        let (sin, cos) = math::sin_cos(TAU * i as f32 / 10.0);
        let hole = Sculpt::ellipsoid(
            Vec3::new(r * 0.74 * cos, r * 0.74 * sin, h * 0.40),
            Vec3::new(r * 0.09, r * 0.09, h * 0.05),
            10,
            paint::DARK,
        );
        s.add(hole);
    }
}

fn wire(s: &mut Sculpt, r: f32, h: f32, metal: Material) {
    s.add(Sculpt::lathe(
        &[(r * 0.94, -h * 0.6), (r * 1.02, -h * 0.85), (r * 1.02, h * 0.85), (r * 0.94, h * 0.6), (r * 0.94, -h * 0.6)],
        32,
        40.0,
        metal,
    ));
    let hub = (h * 0.9).max(0.02);
    s.add(Sculpt::post(Vec3::new(0.0, 0.0, -hub), 2.0 * hub, r * 0.09, r * 0.09, 10, metal));
    for i in 0..18 {
        let (sin, cos) = math::sin_cos(TAU * i as f32 / 18.0);
        let z = if i % 2 == 0 { hub * 0.8 } else { -hub * 0.8 };
        let t = 0.0016 + 0.002 * r;
        s.add(Sculpt::tube(
            &[(Vec3::new(0.05 * r * cos, 0.05 * r * sin, z), t), (Vec3::new(0.96 * r * cos, 0.96 * r * sin, 0.0), t)],
            4,
            metal,
        ));
    }
}
