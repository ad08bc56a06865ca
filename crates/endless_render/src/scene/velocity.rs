//! How a rigid piece moves at an instant.

use endless_world::{Actor, Motion, math};
use glam::Vec3A;

/// A rigid motion: a velocity and a turn about a point, world frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Velocity {
    /// Of the point `about`, m/s.
    linear: Vec3A,
    /// Radians a second about each axis.
    angular: Vec3A,
    about: Vec3A,
}

impl Velocity {
    /// Standing still.
    pub(crate) const ZERO: Self = Self { linear: Vec3A::ZERO, angular: Vec3A::ZERO, about: Vec3A::ZERO };

    /// Of an actor's body. A vehicle turns as its front wheels are steered over a `wheelbase_m`.
    pub(crate) fn of(actor: &Actor, wheelbase_m: f32) -> Self {
        let turn = match actor.motion {
            Motion::Vehicle(m) if wheelbase_m > 0.0 => m.speed_mps * math::tan(m.steer_rad) / wheelbase_m,
            _ => 0.0,
        };
        Self {
            linear: Vec3A::from(actor.velocity_mps),
            angular: Vec3A::Z * turn,
            about: Vec3A::from(actor.pose.position),
        }
    }

    /// Of a wheel that this body carries: it also turns about its `axle` (unit, to the left), at `hub`.
    pub(crate) fn of_wheel(&self, hub: Vec3A, axle: Vec3A, radians_per_second: f32) -> Self {
        Self { linear: self.at(hub), angular: self.angular + axle * radians_per_second, about: hub }
    }

    /// Of a piece that this body draws by a `hitch`, and that turns by some radians a second.
    pub(crate) fn of_drawn(&self, hitch: Vec3A, turn: f32) -> Self {
        Self { linear: self.at(hitch), angular: Vec3A::Z * turn, about: hitch }
    }

    /// Of a point of the piece, m/s.
    pub(crate) fn at(&self, point: Vec3A) -> Vec3A {
        self.linear + self.angular.cross(point - self.about)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{InstanceId, ObjectClass, Pose, VehicleModelId, VehicleMotion, VehicleRef};
    use glam::Vec3;

    #[test]
    fn a_rolling_wheel_stands_on_the_road_and_its_top_is_twice_as_fast() {
        let car = Actor {
            id: InstanceId(1),
            rider_id: None,
            class: ObjectClass::Car,
            asset: VehicleRef { model: VehicleModelId(0), variant: 0 }.into(),
            pose: Pose::level(Vec3::new(5.0, 5.0, 0.0), 0.0),
            velocity_mps: Vec3::new(10.0, 0.0, 0.0),
            motion: Motion::Vehicle(VehicleMotion { speed_mps: 10.0, ..VehicleMotion::default() }),
            parked: false,
        };
        let wheel = Velocity::of(&car, 2.6).of_wheel(Vec3A::new(6.3, 5.8, 0.3), Vec3A::Y, 10.0 / 0.3);
        assert!(wheel.at(Vec3A::new(6.3, 5.8, 0.0)).length() < 1e-4);
        assert!((wheel.at(Vec3A::new(6.3, 5.8, 0.6)) - Vec3A::X * 20.0).length() < 1e-4);
        // To the left, the inner side is the slower one.
        let bent = Actor {
            motion: Motion::Vehicle(VehicleMotion { speed_mps: 10.0, steer_rad: 0.3, ..VehicleMotion::default() }),
            ..car
        };
        let turning = Velocity::of(&bent, 2.6);
        assert!(turning.at(Vec3A::new(5.0, 6.0, 0.0)).x < turning.at(Vec3A::new(5.0, 4.0, 0.0)).x);
    }
}
