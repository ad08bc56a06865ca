//! Contact shadows: objects darken the ground at their feet, because they hide a part of the sky from it.

use super::tile::Bounds3;
use super::tile_work::TileWork;
use crate::scene::{FrameScene, MovingVolume, ShadingPoint};
use glam::Vec2;

/// How far above its ground, metres.
const CONTACT_RISE_M: f32 = 0.4;

/// Share of the ambient light that the objects standing near leave.
pub(super) fn contact_shadow(frame: &FrameScene, work: &TileWork, facet: &ShadingPoint) -> f32 {
    work.contacts.iter().map(|&i| contact_light(&frame.objects[usize::from(i)], facet)).product()
}

/// Height of the long box that darkens as an object does, metres.
fn contact_height(object: &MovingVolume) -> f32 {
    object.height.min(1.2) * (object.half.min_element() / 0.9).min(1.0)
}

/// How far from its footprint an object darkens the ground, metres.
fn contact_reach(object: &MovingVolume) -> f32 {
    0.4 + 1.3 * contact_height(object)
}

/// All that an object may darken lies in here.
pub(super) fn contact_bounds(object: &MovingVolume) -> Bounds3 {
    let reach = object.half.length() + contact_reach(object) + 0.02;
    let rise = CONTACT_RISE_M + 0.01;
    let [low, high] = [-1.0, 1.0].map(|side| (object.centre + side * reach).extend(object.ground + side * rise).into());
    Bounds3 { low, high }
}

/// Whether an object may darken anything in a box: no wrong no.
pub(super) fn contact_may_reach(object: &MovingVolume, span: &Bounds3) -> bool {
    if span.is_empty() || span.low.z > object.ground + CONTACT_RISE_M || span.high.z < object.ground - CONTACT_RISE_M {
        return false;
    }
    let middle = (span.low + span.high) * 0.5;
    let half = Vec2::new(span.high.x - middle.x, span.high.y - middle.y);
    let offset = Vec2::new(middle.x, middle.y) - object.centre;
    // Half extents of the box along and across the object.
    let along = object.along.abs();
    let half = Vec2::new(along.dot(half), along.perp().abs().dot(half));
    let gap = Vec2::new(offset.dot(object.along), offset.perp_dot(object.along)).abs() - half - object.half;
    gap.max(Vec2::ZERO).length() < contact_reach(object) + 0.01
}

/// Share of the ambient light that an object standing near leaves to the ground: the sky that the side of a long box
/// hides, and nearly all of it beneath.
fn contact_light(object: &MovingVolume, point: &ShadingPoint) -> f32 {
    let rise = point.position.z - object.ground;
    if rise.abs() > CONTACT_RISE_M || point.geometric_normal.z < 0.5 {
        return 1.0;
    }
    let offset = Vec2::new(point.position.x, point.position.y) - object.centre;
    let local = Vec2::new(offset.dot(object.along), offset.perp_dot(object.along)).abs() - object.half;
    let outside = local.max(Vec2::ZERO).length();
    let (height, reach) = (contact_height(object), contact_reach(object));
    if outside >= reach {
        return 1.0;
    }
    let fade = 1.0 - rise.abs() / CONTACT_RISE_M;
    let hidden = if outside > 0.0 {
        let reach = 1.0 - outside / reach;
        0.5 * (1.0 - outside / (outside * outside + height * height).sqrt()) * reach * reach
    } else {
        let depth = (-local.max_element()).min(0.6) / 0.6;
        0.5 + 0.42 * depth
    };
    1.0 - hidden * fade
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3A;
    use proptest::prelude::*;

    fn object(centre: Vec2, turn: f32, half: Vec2, height: f32) -> MovingVolume {
        let (sin, cos) = endless_world::math::sin_cos(turn);
        let (low, high) = (Vec3A::ZERO, Vec3A::ZERO);
        MovingVolume {
            low,
            high,
            parts: Vec::new(),
            centre,
            along: Vec2::new(cos, sin),
            half,
            ground: 0.0,
            height,
            beams: Vec::new(),
        }
    }

    fn ground(x: f32, y: f32, z: f32) -> ShadingPoint {
        let (position, up) = (Vec3A::new(x, y, z), Vec3A::Z);
        ShadingPoint { position, geometric_normal: up, direction: -up, distance: 1.0 }
    }

    #[test]
    fn it_is_darkest_beneath_and_fades_away() {
        let car = object(Vec2::ZERO, 0.0, Vec2::new(2.2, 0.9), 1.5);
        let light = |y| contact_light(&car, &ground(0.0, y, 0.0));
        assert!(light(0.0) < 0.2);
        assert!(light(0.95) < light(1.5) && light(1.5) < light(2.2));
        assert_eq!(light(3.0), 1.0);
    }

    proptest! {
        #[test]
        fn a_box_with_a_darkened_point_is_never_left_out(
            turn in 0.0f32..6.3, x in -6.0f32..6.0, y in -6.0f32..6.0, z in -0.5f32..0.5,
            length in 0.2f32..4.0, height in 0.5f32..3.0,
            a in prop::array::uniform3(0.0f32..3.0), b in prop::array::uniform3(0.0f32..3.0),
        ) {
            let it = object(Vec2::new(0.3, -0.2), turn, Vec2::new(length, 0.2 + length * 0.2), height);
            let point = ground(x, y, z);
            let span = Bounds3 { low: point.position - Vec3A::from(a), high: point.position + Vec3A::from(b) };
            if contact_light(&it, &point) < 1.0 {
                prop_assert!(contact_may_reach(&it, &span));
            }
        }
    }
}
