//! Spring arms, on which cameras follow smoothly.
//!
//! An arm reaches from its parent to the place of what hangs on it, level whatever the parent's pitch and roll. It turns after
//! its parent with a lag, and what hangs on it looks along it to the parent, turned from there as it says itself.

use crate::frames;
use crate::wire::{Location, Rotation, Transform};
use endless_world::math::f64::atan2;
use glam::DVec3;

/// How fast an arm turns after its parent: the share of what is missing, a second.
const TURNS: f64 = 8.0;
/// A shorter arm has no direction, metres.
const SHORTEST_M: f64 = 0.01;

/// A spring arm.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SpringArm {
    /// Whether it passes through walls.
    pub(super) is_ghost: bool,
    /// Of the arm; none before the first step, degrees.
    yaw_deg: Option<f64>,
}

impl SpringArm {
    /// CARLA's number of an attachment: 1 for an arm, 2 for one that passes through walls, all others for none.
    pub(super) fn of_attachment(attachment: u8) -> Option<Self> {
        matches!(attachment, 1 | 2).then_some(Self { is_ghost: attachment == 2, yaw_deg: None })
    }

    /// Time passes: it turns after its parent.
    pub(super) fn turn(&mut self, parent_yaw_deg: f64, step_s: f64) {
        let yaw_deg = self.yaw_deg.unwrap_or(parent_yaw_deg);
        let missing = (parent_yaw_deg - yaw_deg + 180.0).rem_euclid(360.0) - 180.0;
        self.yaw_deg = Some(yaw_deg + missing * (TURNS * step_s).clamp(0.0, 1.0));
    }

    /// Where something is that hangs on it, with its place in the frame of the parent.
    pub(super) fn end(&self, parent: &Transform, own: &Transform) -> Transform {
        let yaw = self.yaw_deg.map_or(parent.rotation.yaw, |yaw| yaw as f32);
        let level = Transform { location: parent.location.clone(), rotation: Rotation { pitch: 0.0, yaw, roll: 0.0 } };
        let Location { x, y, z } = own.location;
        let [x, y, z] = [x, y, z].map(f64::from);
        let along = DVec3::new(x, y, 0.0).length();
        if along.hypot(z) < SHORTEST_M {
            return frames::attached(&level, own);
        }
        let looks = Transform {
            location: own.location.clone(),
            rotation: Rotation {
                pitch: atan2(-z, along).to_degrees() as f32,
                yaw: if along > 0.0 { atan2(-y, -x).to_degrees() as f32 } else { 0.0 },
                roll: 0.0,
            },
        };
        let turned = Transform { location: Location::default(), rotation: own.rotation.clone() };
        frames::attached(&frames::attached(&level, &looks), &turned)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f32, y: f32, z: f32, pitch: f32, yaw: f32) -> Transform {
        Transform { location: Location { x, y, z }, rotation: Rotation { pitch, yaw, roll: 0.0 } }
    }

    #[test]
    fn what_hangs_on_an_arm_looks_at_its_parent() {
        let arm = SpringArm::of_attachment(2).expect("an arm");
        let parent =
            Transform { rotation: Rotation { pitch: 20.0, yaw: 90.0, roll: -10.0 }, ..at(10.0, 5.0, 0.0, 0.0, 0.0) };
        let end = arm.end(&parent, &at(-5.0, 0.0, 5.0, 8.0, 0.0));
        assert!(
            (end.location.x - 10.0).abs() < 1e-4 && end.location.y.abs() < 1e-4 && (end.location.z - 5.0).abs() < 1e-4
        );
        assert!((end.rotation.pitch + 37.0).abs() < 1e-3 && (end.rotation.yaw - 90.0).abs() < 1e-3, "{end:?}");
        assert!(end.rotation.roll.abs() < 1e-3);
        // Without a length it is where its parent is.
        assert_eq!(arm.end(&at(1.0, 2.0, 3.0, 9.0, 0.0), &Transform::default()), at(1.0, 2.0, 3.0, 0.0, 0.0));
        assert_eq!([0, 3, 160].map(SpringArm::of_attachment), [None, None, None]);
    }

    #[test]
    fn arms_turn_after_their_parents() {
        let mut arm = SpringArm::of_attachment(1).expect("an arm");
        arm.turn(170.0, 0.05);
        assert_eq!(arm.yaw_deg, Some(170.0), "at once in the first step");
        arm.turn(-170.0, 0.05);
        assert!((arm.yaw_deg.expect("turned") - 178.0).abs() < 1e-9, "the shorter way");
        for _ in 0..100 {
            arm.turn(-170.0, 0.05);
        }
        assert!((arm.yaw_deg.expect("turned") - 190.0).abs() < 1e-6);
        arm.turn(0.0, 5.0);
        assert!((arm.yaw_deg.expect("turned") - 360.0).abs() < 1e-6, "no farther than its parent");
    }
}
