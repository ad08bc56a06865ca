//! Three-wheelers: one wheel ahead, two behind, and a driver in the open who holds a handlebar.
//!
//! They have no class of their own. Auto-rickshaws are cars and cargo tricycles are vans: both carry the tag `Car`, as all
//! light motor vehicles on more than two wheels do here. Datasets differ: IDD has a class `autorickshaw`, nuScenes counts
//! light three-wheelers as motorcycles. Here a motorcycle leans, threads between queues and may fall over, and none of that
//! is true of a three-wheeler. Its design names it. Who drives one is a rider, as Cityscapes has it of drivers without a
//! cabin around them.

mod auto_rickshaw;
mod cargo_tricycle;

pub(crate) use auto_rickshaw::auto_rickshaw;
pub(crate) use cargo_tricycle::cargo_tricycle;

use crate::shape::Sculpt;
use endless_scene::Material;
use glam::{Vec2, Vec3};

/// A flat bar or plate.
fn block(low: Vec3, high: Vec3, material: Material) -> Sculpt {
    Sculpt::cuboid(low, high, 0.0, material)
}

/// A plate of this thickness between two points of the side view, from y0 to y1.
fn plank(a: Vec2, b: Vec2, thick: f32, [y0, y1]: [f32; 2], material: Material) -> Sculpt {
    let out = (b - a).perp().normalize_or(Vec2::Y) * 0.5 * thick;
    Sculpt::slab(&[a - out, b - out, b + out, a + out], y0, y1, 20.0, material)
}
