//! What is carried, pushed or led, in the rest pose.

use super::appearance::{Appearance, Carried};
use super::body::Body;
use super::hold::{CANE, TROLLEY};
use super::palette;
use super::skeleton::{ARM, Bone, Side};
use super::skin::{Skin, two};
use super::{dog, wheeled};
use crate::shape::{Region, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::math;
use glam::{Affine3A, Mat3, Vec2, Vec3};
use std::f32::consts::{PI, TAU};

const BLACK: Material = palette::linear(Surface::Plastic, [0.02, 0.02, 0.02]);

const LEATHER: Material = palette::linear(Surface::Leather, [0.035, 0.022, 0.015]);
const WOOD: Material = palette::linear(Surface::Wood, [0.10, 0.055, 0.028]);

/// What it is made of for the most part; `None` if nothing is carried.
pub(crate) fn material(appearance: &Appearance) -> Option<Material> {
    let own = appearance.bag_color;
    Some(match appearance.carried {
        Carried::Nothing => return None,
        Carried::Backpack | Carried::Pram => Material { surface: Surface::Cloth, ..own },
        Carried::Handbag | Carried::ShoulderBag | Carried::Umbrella => own,
        Carried::Suitcase => Material { surface: Surface::Plastic, ..own },
        // Of paper in a pale tone of it.
        Carried::ShoppingBag => Material { base_color: own.base_color.map(|c| 0.30 + 0.5 * c), ..BLACK },
        Carried::Briefcase => LEATHER,
        Carried::Phone | Carried::Call => BLACK,
        Carried::Cane => WOOD,
        Carried::Dog => dog::coat(appearance),
        Carried::Wheelchair => wheeled::UPHOLSTERY,
    })
}

/// Builds it.
pub(crate) fn add(skin: &mut Skin, body: &Body<'_>) {
    let Some(material) = material(body.appearance) else { return };
    match body.appearance.carried {
        Carried::Nothing => {}
        Carried::Backpack => backpack(skin, body, material),
        Carried::Handbag => bag(skin, body, Vec3::new(0.15, 0.055, 0.11), 0.13, material),
        Carried::Briefcase => bag(skin, body, Vec3::new(0.20, 0.045, 0.15), 0.035, material),
        Carried::ShoppingBag => bag(skin, body, Vec3::new(0.16, 0.085, 0.20), 0.14, material),
        Carried::ShoulderBag => shoulder_bag(skin, body, material),
        Carried::Phone | Carried::Call => phone(skin, body),
        Carried::Umbrella => umbrella(skin, body, material),
        Carried::Suitcase => suitcase(skin, body, material),
        Carried::Cane => cane(skin, body),
        Carried::Pram => wheeled::pram(skin, body, material),
        Carried::Wheelchair => wheeled::wheelchair(skin, body),
        Carried::Dog => dog::add(skin, body),
    }
}

fn backpack(skin: &mut Skin, body: &Body<'_>, color: Material) {
    let (h, b) = (body.h, body.b);
    let ease = body.appearance.garments.iter().map(|g| g.ease).fold(0.0, f32::max);
    let back = body.trunk_ring(0.72, ease)[8].x + 0.012 * h;
    // Children carry smaller ones.
    let k = h.min(1.75);
    let row = |t: f32, depth: f32, half: f32| (Vec3::new(back - depth * k, 0.0, t * b), Vec2::new(half, depth) * k);
    let pack = [
        row(0.588, 0.030, 0.060),
        row(0.600, 0.052, 0.080),
        row(0.650, 0.062, 0.088),
        row(0.720, 0.058, 0.087),
        row(0.785, 0.045, 0.078),
        row(0.812, 0.026, 0.052),
        row(0.818, 0.010, 0.022),
    ];
    let mut s = Sculpt::sweep(&pack, Vec3::Y, 14, 3.2, true, color);
    let dark = Material { base_color: color.base_color.map(|c| 0.35 * c), ..color };
    s.paint(&Region::all().beyond(Vec3::Z, 0.772 * b).within(Vec3::Z, 0.778 * b), dark);
    let pocket = [(0.605, 0.118, 0.050), (0.615, 0.140, 0.062), (0.665, 0.142, 0.062), (0.685, 0.122, 0.050)].map(
        |(t, depth, half): (f32, f32, f32)| {
            (Vec3::new(back - (depth - 0.025) * k, 0.0, t * b), Vec2::new(half, 0.025) * k)
        },
    );
    s.add(Sculpt::sweep(&pocket, Vec3::Y, 10, 3.0, true, color));
    skin.add(s, |p| body.trunk_weights(p));
    let (e, y) = ((ease + 0.006) * h, 0.052 * h);
    let rows = body.bust_rows(0.0, 0.0, &|_| 0.0);
    let front = body.trunk_ring(0.70, 0.0)[1].x;
    let strap = [
        (Vec3::new(back, y, 0.79 * b), 0.010 * h),
        (Vec3::new(-0.035 * h, y, rows[2][4].z + e), 0.011 * h),
        (Vec3::new(0.018 * h, y, rows[2][2].z + 0.006 * h + 0.6 * e), 0.011 * h),
        (Vec3::new(rows[1][1].x + e, y, 0.765 * b), 0.011 * h),
        (Vec3::new(front + e, 1.25 * y, 0.70 * b), 0.010 * h),
        (Vec3::new(0.02 * h, body.trunk_ring(0.65, ease)[4].y + 0.004 * h, 0.655 * b), 0.009 * h),
    ];
    skin.add(Sculpt::tube(&strap, 6, dark).both_sides(), |p| body.trunk_weights(p));
}

/// A bag hanging from the left hand: half sizes and length of the handles, metres.
fn bag(skin: &mut Skin, body: &Body<'_>, half: Vec3, handle: f32, material: Material) {
    let grip = body.skeleton.grip(Side::Left);
    let scale = (body.h / 1.7).min(1.05);
    let half = half * scale;
    // Clear of the leg, and of the ground for who is short.
    let drop = (handle * scale).min(grip.z - 2.0 * half.z - 0.04).max(0.02);
    let out = Vec3::Y * (half.y - 0.01);
    let centre = grip + out - Vec3::Z * (drop + half.z);
    let mut bag = Sculpt::cuboid(centre - half, centre + half, 0.3 * half.y, material);
    for y in [-0.6, 0.6] {
        let foot = |x: f32| centre + Vec3::new(x * half.x, y * half.y, 0.97 * half.z);
        let top = grip + Vec3::new(0.0, 0.3 * y * half.y, -0.004);
        let path =
            [(foot(-0.55), 0.006), (top - Vec3::X * 0.035, 0.006), (top + Vec3::X * 0.035, 0.006), (foot(0.55), 0.006)];
        bag.add(Sculpt::tube(&path, 5, material));
    }
    skin.add_rigid(bag, Bone::Carried);
}

fn shoulder_bag(skin: &mut Skin, body: &Body<'_>, color: Material) {
    let (h, b) = (body.h, body.b);
    let ease = body.appearance.garments.iter().map(|g| g.ease).fold(0.0, f32::max) + 0.006;
    let hip = body.trunk_ring(0.54, ease);
    let side = hip[12];
    let half = Vec3::new(0.075, 0.028, 0.058) * h;
    let centre = Vec3::new(0.0, side.y - 0.6 * half.y, 0.535 * b);
    skin.add(Sculpt::cuboid(centre - half, centre + half, 0.016 * h, color), |_| two(Bone::Pelvis, Bone::ThighR, 0.15));
    // From the right hip over the left shoulder.
    let rows = body.bust_rows(0.0, 0.0, &|_| ease);
    let top = Vec3::new(-0.01 * h, 0.055 * h, rows[2][4].z + 0.010 * h);
    let chest = body.trunk_ring(0.70, ease)[0] + Vec3::new(0.004 * h, 0.0, 0.0);
    let waist = body.trunk_ring(0.61, ease)[14];
    let (blade, loin) = (body.trunk_ring(0.72, ease)[8], body.trunk_ring(0.61, ease)[10]);
    let r = 0.008 * h;
    let start = centre + Vec3::Z * half.z;
    let strap = [start, waist, chest, rows[2][2] + Vec3::X * 0.004, top, blade + Vec3::Y * 0.01 * h, loin, start];
    let strap: Vec<(Vec3, f32)> = strap.iter().map(|&p| (p, r)).collect();
    skin.add(Sculpt::tube(&strap, 5, color), |p| body.trunk_weights(p));
}

fn phone(skin: &mut Skin, body: &Body<'_>) {
    let along = Side::Right.flip(ARM);
    let inward = Side::Right.flip(Vec3::new(0.0, ARM.z, -ARM.y));
    let grip = body.skeleton.grip(Side::Right) + inward * 0.022 * body.h + along * 0.02 * body.h;
    let half = Vec3::new(0.005, 0.038, 0.078);
    let mut s = Sculpt::cuboid(-half, half, 0.003, BLACK);
    let screen = palette::linear(Surface::CarGlass, [0.06, 0.08, 0.11]);
    s.paint(&Region::all().facing(Vec3::X, 0.9), screen);
    let frame = Affine3A::from_mat3_translation(Mat3::from_cols(inward, -along.cross(inward), along), grip);
    skin.add_rigid(s.placed(frame), Bone::HandR);
}

fn umbrella(skin: &mut Skin, body: &Body<'_>, color: Material) {
    let grip = body.skeleton.grip(Side::Right);
    let (radius, top) = (0.52, (0.50 * body.h + 0.06).max(0.6));
    let steel = palette::linear(Surface::Metal, [0.3; 3]);
    let mut s = Sculpt::tube(
        &[
            (grip - Vec3::Z * 0.09, 0.012),
            (grip + Vec3::Z * 0.05, 0.012),
            (grip + Vec3::Z * 0.06, 0.006),
            (grip + Vec3::Z * (top + 0.05), 0.005),
        ],
        6,
        steel,
    );
    let columns = 16;
    // Eight panels, drawn in between the ribs.
    let ring = |share: f32, sink: f32| -> Vec<Vec3> {
        (0..columns)
            .map(|j| {
                let (sin, cos) = math::sin_cos(TAU * j as f32 / columns as f32);
                let r = radius * share * if j % 2 == 1 { 1.0 - 0.085 * share } else { 1.0 };
                let z = top - 0.20 * (1.0 - math::cos(0.5 * PI * share)) / 1.0 - sink;
                grip + Vec3::new(r * cos, r * sin, z)
            })
            .collect()
    };
    let outer: Vec<Vec<Vec3>> = [1.0, 0.78, 0.5, 0.22, 0.01].map(|t| ring(t, 0.0)).to_vec();
    let inner: Vec<Vec<Vec3>> = [0.01, 0.5, 0.78, 1.0].map(|t| ring(t, 0.006)).to_vec();
    let mut canopy = Sculpt::new();
    canopy.grid(&outer, true, color);
    canopy.grid(&inner, true, color);
    s.add(canopy.smooth(35.0));
    skin.add_rigid(s, Bone::Carried);
}

fn suitcase(skin: &mut Skin, body: &Body<'_>, color: Material) {
    let grip = body.skeleton.grip(Side::Right);
    let length = TROLLEY * body.h;
    let metal = palette::linear(Surface::Metal, [0.4; 3]);
    let at = |x: f32, y: f32, z: f32| grip + Vec3::new(x, y, z);
    let (wide, deep, tall) = (0.20, 0.115, 0.55_f32.min(length - 0.30));
    // It hangs below the hand, over its wheels on the side that comes to lie above.
    let (back, low) = (-2.0 * deep, -length + 0.045);
    let mut s = Sculpt::cuboid(at(back, -wide, low), at(0.01, wide, low + tall), 0.05, color);
    let groove = Material { base_color: color.base_color.map(|c| 0.6 * c), ..color };
    for y in [-0.10, 0.0, 0.10] {
        let strip = Region::all().beyond(Vec3::Y, grip.y + y - 0.012).within(Vec3::Y, grip.y + y + 0.012);
        s.paint(&strip, groove);
    }
    for y in [-0.075, 0.075] {
        s.add(Sculpt::tube(&[(at(-0.03, y, low + tall - 0.02), 0.007), (at(-0.01, y, 0.0), 0.007)], 5, metal));
    }
    s.add(Sculpt::tube(&[(at(-0.01, -0.08, 0.0), 0.012), (at(-0.01, 0.08, 0.0), 0.012)], 6, BLACK));
    for y in [-0.15, 0.15] {
        let axle = at(0.0, y, -length + 0.030);
        s.add(Sculpt::tube(&[(axle - Vec3::Y * 0.018, 0.028), (axle + Vec3::Y * 0.018, 0.028)], 10, BLACK));
    }
    skin.add_rigid(s, Bone::Carried);
}

fn cane(skin: &mut Skin, body: &Body<'_>) {
    let grip = body.skeleton.grip(Side::Right);
    let length = CANE * body.h;
    let hook = |x: f32, z: f32| (grip + Vec3::new(x, 0.0, z), 0.011);
    let path = [
        (grip - Vec3::Z * length, 0.012),
        (grip - Vec3::Z * 0.05, 0.011),
        hook(0.0, 0.005),
        hook(-0.03, 0.022),
        hook(-0.075, 0.020),
    ];
    skin.add_rigid(Sculpt::tube(&path, 6, WOOD), Bone::Carried);
}
