//! Bags.

use super::figure::Body;
use super::look::Carried;
use super::skeleton::{Bone, Side};
use super::skin::{Blend, Skin};
use crate::shape::{Region, Sculpt};
use crate::{Material, Surface};
use endless_world::ClassTag;
use glam::Vec3;

/// What the person carries.
pub(crate) fn carried(skin: &mut Skin, body: &Body<'_>) {
    match body.look.carried {
        Carried::Nothing => {}
        Carried::Backpack => backpack(skin, body),
        Carried::Handbag => bag(skin, body, Vec3::new(0.085, 0.030, 0.065), 0.10, body.look.bag_color),
        Carried::ShoppingBag => {
            let paper = Material::new(
                Surface::Plastic,
                body.look.bag_color.base_color.map(|c| 0.35 + 0.5 * c),
                ClassTag::Pedestrians,
            );
            bag(skin, body, Vec3::new(0.085, 0.05, 0.11), 0.09, paper);
        }
    }
}

fn backpack(skin: &mut Skin, body: &Body<'_>) {
    let h = body.h;
    let chest = body.skeleton.joint(Bone::Chest);
    let back = chest.x - 0.060 * h;
    let low = Vec3::new(back - 0.085 * h, -0.080 * h, 0.605 * body.b);
    let high = Vec3::new(back + 0.012 * h, 0.080 * h, 0.80 * body.b);
    let mut pack = Sculpt::cuboid(low, high, 0.035 * h, body.look.bag_color);
    let pocket = Sculpt::cuboid(
        low + Vec3::new(-0.022 * h, 0.015 * h, 0.015 * h),
        Vec3::new(low.x + 0.03 * h, 0.065 * h, 0.70 * body.b),
        0.02 * h,
        body.look.bag_color,
    );
    pack.add(pocket);
    pack.paint(
        &Region::all().beyond(Vec3::Z, 0.775 * body.b).within(Vec3::Z, 0.78 * body.b),
        Material { base_color: [0.02; 3], ..body.look.bag_color },
    );
    skin.add(pack, |_| Blend::two(Bone::Chest, Bone::Spine, 0.3));
    let y = 0.055 * h;
    let dark = Material { base_color: [0.025; 3], ..body.look.bag_color };
    let strap = [
        (Vec3::new(back, y, 0.79 * body.b), 0.011 * h),
        (Vec3::new(chest.x, y, 0.828 * body.b), 0.012 * h),
        (Vec3::new(chest.x + 0.060 * h, y, 0.775 * body.b), 0.012 * h),
        (Vec3::new(chest.x + 0.076 * h, y * 1.1, 0.70 * body.b), 0.011 * h),
        (Vec3::new(chest.x + 0.02 * h, y * 1.7, 0.64 * body.b), 0.010 * h),
    ];
    skin.add(Sculpt::tube(&strap, 6, dark).both_sides(), |p| body.trunk_blend(p));
}

/// A bag hanging from the left hand: half sizes and length of the handles over the stature.
fn bag(skin: &mut Skin, body: &Body<'_>, half: Vec3, handle: f32, material: Material) {
    let h = body.h;
    let [_, fore, hand] = Side::Left.arm();
    let wrist = body.skeleton.joint(hand);
    let along = (wrist - body.skeleton.joint(fore)).normalize_or(-Vec3::Z);
    let grip = wrist + along * 0.06 * h;
    let top = grip - Vec3::Z * handle * h;
    let centre = top - Vec3::Z * half.z * h;
    let mut bag = Sculpt::cuboid(centre - half * h, centre + half * h, 0.012 * h, material);
    for x in [-1.0, 1.0] {
        bag.add(Sculpt::tube(
            &[(top + Vec3::X * x * 0.045 * h, 0.004 * h), (grip + Vec3::X * x * 0.012 * h, 0.004 * h)],
            5,
            material,
        ));
    }
    skin.add(bag, |_| Blend::one(hand));
}
