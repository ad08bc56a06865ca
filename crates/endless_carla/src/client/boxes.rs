//! Boxes of actors, and what they hold.

use endless_annotate::Box3d;
use endless_world::Pose;
use glam::{Mat3, Vec2, Vec3};

/// The box that stands on the ground at a pose.
pub(super) fn box_on_ground(pose: &Pose, size: Vec3) -> Box3d {
    let half = Vec2::new(0.5 * size.x, 0.5 * size.y);
    Box3d::new(pose, (-half).extend(0.0), half.extend(size.z))
}

/// Depth is told so exactly, metres.
pub(super) const ROUNDING_M: f32 = 0.005;

/// A box that holds those of these points, too, that are near to it.
pub(super) fn grown(told: &Box3d, points: &[Vec3], beside: Vec3) -> Box3d {
    let half = 0.5 * told.size;
    let own = points.iter().map(|point| in_box(told, *point)).filter(|own| is_near(told, *own, beside));
    let (low, high) =
        own.fold((-half, half), |(low, high), own| (low.min(own - ROUNDING_M), high.max(own + ROUNDING_M)));
    between(told, low, high)
}

/// The box between two corners in another's frame.
pub(super) fn between(told: &Box3d, low: Vec3, high: Vec3) -> Box3d {
    let middle = told.centre + told.world_from_object * (0.5 * (low + high));
    Box3d { centre: middle, size: high - low, ..*told }
}

/// A point in a box's own frame.
pub(super) fn in_box(around: &Box3d, point: Vec3) -> Vec3 {
    Mat3::from_quat(around.world_from_object).transpose() * (point - around.centre)
}

/// Whether a point of a box's own frame is in it or so near to it.
pub(super) fn is_near(around: &Box3d, own: Vec3, beside: Vec3) -> bool {
    (own.abs() - 0.5 * around.size).cmple(beside).all()
}

/// Whether a point is in a box or so near to it.
pub(super) fn holds(around: &Box3d, point: Vec3, beside: Vec3) -> bool {
    is_near(around, in_box(around, point), beside)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_grown_box_holds_what_it_shall(
            at in prop::array::uniform3(-50.0f32..50.0),
            yaw in -3.0f32..3.0,
            points in prop::collection::vec(prop::array::uniform3(-3.0f32..3.0), 0..20),
        ) {
            let pose = Pose::level(at.into(), yaw);
            let told = box_on_ground(&pose, Vec3::new(4.0, 2.0, 1.5));
            let points: Vec<Vec3> = points.into_iter().map(|p| told.centre + Vec3::from_array(p)).collect();
            let near = |point: &&Vec3| holds(&told, **point, Vec3::ONE);
            let bigger = grown(&told, &points, Vec3::ONE);
            prop_assert!(points.iter().filter(near).all(|point| holds(&bigger, *point, Vec3::ZERO)));
            prop_assert!((bigger.size - told.size).cmpge(Vec3::splat(-1e-5)).all());
            prop_assert!((bigger.size - told.size).cmple(Vec3::splat(2.1)).all());
        }
    }
}
