//! Prams and wheelchairs.

use super::appearance::Carried;
use super::body::Body;
use super::palette;
use super::skeleton::{Bone, Skeleton};
use super::skin::Skin;
use crate::shape::{Region, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::math;
use glam::{Quat, Vec2, Vec3};
use std::f32::consts::TAU;

/// Height of seats over the body's.
pub(crate) const SEAT: f32 = 0.255;

/// Middle of a pram's handle.
pub(crate) fn pram_handle(skeleton: &Skeleton) -> Vec3 {
    Vec3::new(0.25 * skeleton.height, 0.0, 0.59 * skeleton.body)
}

/// Of a wheelchair's seat and back.
pub(crate) const UPHOLSTERY: Material = palette::linear(Surface::Leather, [0.02; 3]);

const PRAM_WHEEL: f32 = 0.125;
const REAR_WHEEL: f32 = 0.30;
const CASTER: f32 = 0.085;

/// Axles and wheel radii of something with two pairs of wheels.
pub(crate) fn axles(skeleton: &Skeleton, carried: Carried) -> [(Bone, Vec3, f32); 2] {
    if carried == Carried::Pram {
        let x = pram_handle(skeleton).x;
        let at = |dx: f32| Vec3::new(x + dx, 0.0, PRAM_WHEEL);
        [(Bone::CarriedFront, at(0.92), PRAM_WHEEL), (Bone::CarriedRear, at(0.30), PRAM_WHEEL)]
    } else {
        let h = skeleton.height;
        [
            (Bone::CarriedFront, Vec3::new(0.16 * h, 0.0, CASTER), CASTER),
            (Bone::CarriedRear, Vec3::new(-0.035 * h, 0.0, REAR_WHEEL), REAR_WHEEL),
        ]
    }
}

/// A wheel with tyre and spokes, its axle along y.
fn wheel(centre: Vec3, radius: f32, half: f32, spokes: usize, rim: Material) -> Sculpt {
    let tyre = palette::linear(Surface::Rubber, [0.018; 3]);
    let n = 12;
    let at = |angle: f32, r: f32| {
        let (sin, cos) = math::sin_cos(angle);
        centre + Vec3::new(r * cos, 0.0, r * sin)
    };
    let inner = radius - 2.0 * half;
    // Rings of the tyre's section: outside, left, inside, right.
    let rows: Vec<Vec<Vec3>> = (0..=n)
        .map(|i| {
            let angle = TAU * i as f32 / n as f32;
            let y = Vec3::Y * half;
            vec![
                at(angle, radius),
                at(angle, 0.5 * (radius + inner)) + y,
                at(angle, inner),
                at(angle, 0.5 * (radius + inner)) - y,
            ]
        })
        .collect();
    let mut s = Sculpt::new();
    s.grid(&rows, true, tyre);
    let mut s = s.smooth(95.0);
    for i in 0..spokes {
        let angle = TAU * i as f32 / (2 * spokes) as f32;
        s.add(Sculpt::tube(&[(at(angle, inner), 0.004), (at(angle, -inner), 0.004)], 4, rim));
    }
    s.add(Sculpt::tube(&[(centre - Vec3::Y * 1.6 * half, 0.02), (centre + Vec3::Y * 1.6 * half, 0.02)], 6, rim));
    s
}

fn rod(points: &[Vec3], radius: f32, material: Material) -> Sculpt {
    Sculpt::tube(&points.iter().map(|&p| (p, radius)).collect::<Vec<_>>(), 6, material)
}

/// A pram ahead of who pushes it.
pub(crate) fn pram(skin: &mut Skin, body: &Body<'_>, cloth: Material) {
    let handle = pram_handle(body.skeleton);
    let lining = palette::linear(Surface::Cloth, [0.30, 0.29, 0.27]);
    let metal = palette::linear(Surface::Metal, [0.35, 0.35, 0.36]);
    let black = palette::linear(Surface::Plastic, [0.02; 3]);
    let at = |x: f32, y: f32, z: f32| Vec3::new(handle.x + x, y, z);
    // The tub: a boat of cloth.
    let row = |x: f32, z: f32, ry: f32, rz: f32| (at(x, 0.0, z), Vec2::new(ry, rz));
    let tub = [
        row(0.16, 0.66, 0.10, 0.06),
        row(0.20, 0.63, 0.17, 0.12),
        row(0.45, 0.61, 0.19, 0.15),
        row(0.75, 0.61, 0.19, 0.15),
        row(0.96, 0.63, 0.17, 0.12),
        row(1.00, 0.66, 0.10, 0.06),
    ];
    let mut tub = Sculpt::sweep(&tub, Vec3::Y, 12, 2.8, true, cloth);
    tub.remove(&Region::all().beyond(Vec3::Z, 0.70));
    let mut s = tub;
    s.add(Sculpt::ellipsoid(at(0.64, 0.0, 0.67), Vec3::new(0.30, 0.155, 0.075), 8, lining));
    // The hood over the end that is pushed.
    let mut hood = Sculpt::ellipsoid(at(0.40, 0.0, 0.68), Vec3::new(0.30, 0.205, 0.34), 12, cloth);
    hood.remove(&Region::all().within(Vec3::Z, 0.66));
    hood.remove(&Region::all().beyond(Vec3::new(1.0, 0.0, -0.35), handle.x + 0.47 - 0.35 * 0.68));
    let mut inside = hood.clone();
    for face in inside.faces_mut() {
        face.corners.swap(1, 2);
        face.normals.swap(1, 2);
        face.normals = face.normals.map(|n| -n);
        face.corners = face.corners.map(|p| p - (p - at(0.40, 0.0, 0.68)) * 0.03);
    }
    s.add(hood);
    s.add(inside);
    let mut frame = Sculpt::new();
    for y in [-0.20, 0.20] {
        frame.add(rod(&[at(0.0, y, handle.z), at(0.20, y, 0.72), at(0.92, y * 1.1, PRAM_WHEEL)], 0.012, metal));
        frame.add(rod(&[at(0.30, y * 1.1, PRAM_WHEEL), at(0.75, y, 0.52)], 0.012, metal));
    }
    frame.add(rod(&[at(0.0, -0.21, handle.z), at(0.0, 0.21, handle.z)], 0.017, black));
    s.add(frame);
    s.add(Sculpt::cuboid(at(0.34, -0.17, 0.22), at(0.80, 0.17, 0.30), 0.02, black));
    skin.add_rigid(s, Bone::Carried);
    for (bone, axle, radius) in axles(body.skeleton, Carried::Pram) {
        let mut pair = Sculpt::new();
        for y in [-0.235, 0.235] {
            pair.add(wheel(axle + Vec3::Y * y, radius, 0.018, 3, metal));
        }
        skin.add_rigid(pair, bone);
    }
}

/// A wheelchair under who sits in it.
pub(crate) fn wheelchair(skin: &mut Skin, body: &Body<'_>) {
    let (h, b) = (body.h, body.b);
    let metal = palette::linear(Surface::Metal, [0.25, 0.26, 0.28]);
    let black = UPHOLSTERY;
    let seat = SEAT * b;
    let half = 0.125 * h;
    let mut s =
        Sculpt::cuboid(Vec3::new(-0.11 * h, -half, seat - 0.04), Vec3::new(0.145 * h, half, seat), 0.015, black);
    let back = Sculpt::cuboid(Vec3::new(-0.015, -half, 0.0), Vec3::new(0.015, half, 0.26 * h), 0.012, black);
    s.add(back.placed(glam::Affine3A::from_rotation_translation(
        Quat::from_rotation_y(-0.12),
        Vec3::new(-0.112 * h, 0.0, seat + 0.02),
    )));
    for y in [-half - 0.01, half + 0.01] {
        let at = |x: f32, z: f32| Vec3::new(x * h, y, z);
        s.add(rod(&[at(-0.105, seat - 0.05), at(-0.15, seat + 0.28 * h), at(-0.20, seat + 0.285 * h)], 0.013, metal));
        s.add(rod(
            &[at(-0.11, seat - 0.03), at(0.15, seat - 0.03), at(0.20, 0.10 * h), at(0.26, 0.062 * h)],
            0.013,
            metal,
        ));
        s.add(rod(&[at(-0.10, seat + 0.13 * h), at(0.08, seat + 0.13 * h), at(0.09, seat - 0.03)], 0.014, black));
        s.add(rod(&[at(0.15, seat - 0.03), at(0.16, CASTER)], 0.012, metal));
        s.add(rod(&[at(-0.035, seat - 0.03), at(-0.035, REAR_WHEEL)], 0.014, metal));
    }
    s.add(Sculpt::cuboid(
        Vec3::new(0.20 * h, -0.09 * h, 0.058 * h),
        Vec3::new(0.32 * h, 0.09 * h, 0.069 * h),
        0.004,
        black,
    ));
    skin.add_rigid(s, Bone::Carried);
    for (bone, axle, radius) in axles(body.skeleton, Carried::Wheelchair) {
        let large = bone == Bone::CarriedRear;
        let y = half + if large { 0.055 } else { 0.0 };
        let mut pair = Sculpt::new();
        for y in [-y, y] {
            pair.add(wheel(
                axle + Vec3::Y * y,
                radius,
                if large { 0.014 } else { 0.016 },
                if large { 5 } else { 2 },
                metal,
            ));
        }
        skin.add_rigid(pair, bone);
    }
}
