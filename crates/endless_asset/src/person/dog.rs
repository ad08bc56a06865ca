//! A dog on a lead.

use super::appearance::Appearance;
use super::body::Body;
use super::palette;
use super::skeleton::{Bone, Side};
use super::skin::{Skin, Weights, one, two};
use crate::shape::Sculpt;
use endless_scene::{Material, Surface};
use endless_world::{WalkerMotion, math};
use glam::{Affine3A, Vec2, Vec3};

/// Where it trots, left of and ahead of its keeper, metres.
const PLACE: Vec3 = Vec3::new(0.50, 0.55, 0.0);
/// Length of a cycle of its steps, metres.
const STRIDE: f32 = 0.62;

const COATS: [[u8; 3]; 5] = [[30, 26, 24], [120, 82, 48], [176, 140, 92], [220, 214, 204], [74, 56, 44]];

/// Its coat: each keeper has a dog of their own.
pub(crate) fn coat(appearance: &Appearance) -> Material {
    palette::material(Surface::Hair, COATS[(appearance.folds * 3.7) as usize % COATS.len()], 1.0)
}

/// The dog and its lead.
pub(crate) fn add(skin: &mut Skin, body: &Body<'_>) {
    let pick = body.appearance.folds;
    let s = 0.72 + 0.5 * (pick - pick.floor());
    let coat = coat(body.appearance);
    let dark = palette::linear(Surface::Leather, [0.012, 0.011, 0.011]);
    let at = |x: f32, y: f32, z: f32| PLACE + Vec3::new(x, y, z) * s;
    let row = |x: f32, z: f32, ry: f32, rz: f32| (at(x, 0.0, z), Vec2::new(ry, rz) * s);
    let trunk = [
        row(-0.34, 0.46, 0.05, 0.06),
        row(-0.27, 0.46, 0.085, 0.10),
        row(-0.08, 0.45, 0.085, 0.095),
        row(0.12, 0.44, 0.095, 0.125),
        row(0.24, 0.47, 0.08, 0.11),
        row(0.32, 0.54, 0.06, 0.075),
    ];
    skin.add_rigid(Sculpt::sweep(&trunk, Vec3::Y, 10, 2.0, true, coat), Bone::Carried);
    let mut head = Sculpt::tube(
        &[
            (at(0.26, 0.0, 0.52), 0.075 * s),
            (at(0.36, 0.0, 0.66), 0.065 * s),
            (at(0.42, 0.0, 0.70), 0.072 * s),
            (at(0.50, 0.0, 0.68), 0.048 * s),
            (at(0.58, 0.0, 0.66), 0.034 * s),
        ],
        8,
        coat,
    );
    head.add(Sculpt::ellipsoid(at(0.585, 0.0, 0.672), Vec3::splat(0.018 * s), 6, dark));
    for y in [-1.0, 1.0] {
        head.add(Sculpt::ellipsoid(at(0.38, 0.062 * y, 0.725), Vec3::new(0.022, 0.016, 0.055) * s, 6, coat));
    }
    let tail =
        [(at(-0.33, 0.0, 0.50), 0.026 * s), (at(-0.44, 0.0, 0.58), 0.022 * s), (at(-0.50, 0.0, 0.70), 0.010 * s)];
    head.add(Sculpt::tube(&tail, 5, coat));
    skin.add_rigid(head, Bone::Carried);
    for (x, y, pair) in [
        (0.20, 0.06, Bone::CarriedFront),
        (0.20, -0.06, Bone::CarriedRear),
        (-0.27, 0.06, Bone::CarriedRear),
        (-0.27, -0.06, Bone::CarriedFront),
    ] {
        leg(skin, [x, y], s, pair, coat);
    }
    lead(skin, body, at(0.30, 0.0, 0.62), dark);
}

fn leg(skin: &mut Skin, [x, y]: [f32; 2], s: f32, bone: Bone, coat: Material) {
    let at = |dx: f32, z: f32| PLACE + Vec3::new(x + dx, y, z) * s;
    let back = if x < 0.0 { -0.05 } else { 0.0 };
    let path = [
        (at(0.0, 0.46), 0.055 * s),
        (at(-0.3 * back, 0.32), 0.040 * s),
        (at(back, 0.19), 0.024 * s),
        (at(0.2 * back, 0.035), 0.021 * s),
    ];
    let mut part = Sculpt::tube(&path, 6, coat);
    part.add(Sculpt::ellipsoid(at(0.025, 0.0) + Vec3::Z * 0.021 * s, Vec3::new(0.045, 0.026, 0.021) * s, 6, coat));
    let top = 0.40 * s;
    skin.add(part, |p| two(bone, Bone::Carried, (p.z / top).clamp(0.0, 1.0)));
}

/// A line from the hand to the collar.
fn lead(skin: &mut Skin, body: &Body<'_>, collar: Vec3, material: Material) {
    let hand = body.skeleton.grip(Side::Left);
    let n = 6;
    let path: Vec<(Vec3, f32)> = (0..=n).map(|i| (hand.lerp(collar, i as f32 / n as f32), 0.006)).collect();
    let along = collar - hand;
    let weights = |p: Vec3| -> Weights {
        let t = ((p - hand).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        two(Bone::HandL, Bone::Carried, t)
    };
    skin.add(Sculpt::tube(&path, 4, material), weights);
    let ring = Sculpt::ellipsoid(collar - Vec3::X * 0.01, Vec3::new(0.03, 0.068, 0.075), 8, material);
    skin.add(ring, |_| one(Bone::Carried));
}

/// The body, one pair of legs across, the other pair.
pub(crate) fn trot(motion: &WalkerMotion) -> [Affine3A; 3] {
    let cycle = motion.walked_m / STRIDE;
    let go = math::smoothstep(0.05, 0.4, motion.speed_mps);
    let leg = |phase: f32| {
        let p = phase - phase.floor();
        // On the ground half of the time, going back as fast as the body goes ahead.
        let (x, z) = if p < 0.5 {
            (0.25 - p, 0.0)
        } else {
            let u = (p - 0.5) * 2.0;
            (-0.25 + 0.5 * u * u * (3.0 - 2.0 * u), 0.07 * math::sin(std::f32::consts::PI * u))
        };
        Affine3A::from_translation(Vec3::new(x * STRIDE, 0.0, z) * go)
    };
    let bob = Vec3::Z * 0.008 * go * math::sin(2.0 * std::f32::consts::TAU * cycle);
    [Affine3A::from_translation(bob), leg(cycle), leg(cycle + 0.5)]
}
