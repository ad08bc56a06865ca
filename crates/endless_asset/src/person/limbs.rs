//! Hands and shoes.

use super::body::Body;
use super::clothes::ShoeKind;
use super::palette;
use super::skeleton::{ARM, Side};
use super::skin::{Skin, one, two};
use crate::shape::{Region, Sculpt};
use endless_scene::Surface;
use endless_world::math::{self, smoothstep};
use glam::{Vec2, Vec3};

/// A hand, relaxed or around something.
pub(crate) fn hand(skin: &mut Skin, body: &Body<'_>, side: Side, holds: bool) {
    let h = body.h;
    let bone = side.arm()[2];
    let wrist = body.skeleton.joint(bone);
    let along = side.flip(ARM);
    let inward = side.flip(Vec3::new(0.0, ARM.z, -ARM.y));
    let place = |d: f32, x: f32, n: f32| wrist + (along * d + Vec3::X * x + inward * n) * h;
    let row = |d: f32, broad: f32, thick: f32| (place(d, 0.0, 0.0), Vec2::new(broad, thick) * h);
    let palm = [
        row(-0.010, 0.0150, 0.0120),
        row(0.008, 0.0165, 0.0115),
        row(0.032, 0.0225, 0.0115),
        row(0.052, 0.0225, 0.0095),
    ];
    let mut s = Sculpt::sweep(&palm, Vec3::X, 8, 2.5, true, body.appearance.skin);
    let bend = if holds { [1.15f32, 2.7] } else { [0.28, 0.85] };
    let turned = |angle: f32| {
        let (sin, cos) = math::sin_cos(angle);
        along * cos + inward * sin
    };
    for (x, length) in [(0.0165, 0.044), (0.0055, 0.049), (-0.0055, 0.046), (-0.0160, 0.036)] {
        let knuckle = place(0.050, x, 0.0);
        let middle = knuckle + turned(bend[0]) * 0.5 * length * h;
        let tip = middle + turned(bend[1]) * 0.5 * length * h;
        let r = 0.0062 * h;
        s.add(Sculpt::tube(&[(knuckle, r), (middle, 0.95 * r), (tip, 0.6 * r)], 5, body.appearance.skin));
    }
    let root = place(0.014, 0.015, 0.002);
    let thumb = [
        (root, 0.0085 * h),
        (root + (along * 0.018 + Vec3::X * 0.012 + inward * 0.008) * h, 0.0078 * h),
        (root + (along * 0.040 + Vec3::X * 0.012 + inward * if holds { 0.024 } else { 0.012 }) * h, 0.0048 * h),
    ];
    s.add(Sculpt::tube(&thumb, 6, body.appearance.skin));
    skin.add_rigid(s, bone);
}

/// A shoe; the toes bend at the ball.
pub(crate) fn shoe(skin: &mut Skin, body: &Body<'_>, side: Side) {
    let h = body.h;
    let shoes = &body.appearance.shoes;
    let [_, shin, foot, toes] = side.leg();
    let a = body.skeleton.joint(foot);
    let (toe, heel) = (body.skeleton.toe, body.skeleton.heel);
    let narrow = if body.appearance.female { 0.92 } else { 1.0 };
    let slim = if shoes.kind == ShoeKind::Heels { 0.88 } else { 1.0 } * narrow;
    let out = 0.004 * h * side.sign();
    let row = |x: f32, half: f32, top: f32| {
        let (half, top) = (half * slim * h, top * h);
        let n = 10;
        (0..n)
            .map(|j| {
                let (sin, cos) = math::sin_cos(std::f32::consts::TAU * j as f32 / n as f32);
                let bend = |c: f32, e: f32| c.signum() * math::pow(c.abs(), e);
                // Flat below, round above.
                let z =
                    if sin < 0.0 { 0.5 * top * (1.0 + bend(sin, 0.45)) } else { 0.5 * top * (1.0 + bend(sin, 0.85)) };
                Vec3::new(a.x + x, a.y + out + half * bend(cos, 0.85), z)
            })
            .collect::<Vec<_>>()
    };
    let ankle = if shoes.kind == ShoeKind::Heels || shoes.kind == ShoeKind::Sandals { 0.030 } else { 0.048 };
    let rows = [
        row(-heel, 0.0125, 0.030),
        row(-0.86 * heel, 0.0205, ankle),
        row(-0.25 * heel, 0.0235, ankle + 0.008),
        row(0.12 * toe, 0.0240, ankle + 0.004),
        row(0.36 * toe, 0.0255, 0.041),
        row(0.62 * toe, 0.0285, 0.031),
        row(0.82 * toe, 0.0260, 0.025),
        row(0.95 * toe, 0.0175, 0.020),
        row(toe, 0.0080, 0.013),
    ];
    let mut s = Sculpt::new();
    s.grid(&rows, true, shoes.material);
    s.polygon(&rows[8], shoes.material);
    s.polygon(&rows[0].iter().rev().copied().collect::<Vec<_>>(), shoes.material);
    let mut s = s.smooth(48.0);
    if shoes.kind == ShoeKind::Sandals {
        // Bare skin between straps.
        s.paint(&Region::all().beyond(Vec3::Z, 0.012 * h), body.appearance.skin);
        for x in [0.30, 0.66] {
            let strap = Region::all().beyond(Vec3::X, a.x + x * toe).within(Vec3::X, a.x + (x + 0.13) * toe);
            s.paint(&strap, shoes.material);
        }
    }
    if matches!(shoes.kind, ShoeKind::Trainers | ShoeKind::Leather | ShoeKind::Boots) {
        let thick = if shoes.kind == ShoeKind::Trainers { 0.014 } else { 0.008 };
        s.paint(&Region::all().within(Vec3::Z, thick * h), shoes.sole);
    }
    if shoes.kind == ShoeKind::Trainers {
        let laces = palette::linear(Surface::Cloth, [0.7, 0.7, 0.68]);
        let top = Region::all().beyond(Vec3::X, a.x + 0.25 * toe).within(Vec3::X, a.x + 0.55 * toe);
        s.paint(
            &top.within(Vec3::Y, a.y + out + 0.008 * h).beyond(Vec3::Y, a.y + out - 0.008 * h).facing(Vec3::Z, 0.5),
            laces,
        );
    }
    let ball = body.skeleton.joint(toes).x;
    skin.add(s, |p| {
        if p.z > 0.05 * h {
            return two(foot, shin, 0.4);
        }
        if p.x > ball - 0.02 * h {
            two(foot, toes, smoothstep(ball - 0.012 * h, ball + 0.012 * h, p.x))
        } else {
            one(foot)
        }
    });
}
