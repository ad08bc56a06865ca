//! Actors: pose, motion and lights of one at one instant.

use crate::{AssetRef, Behaviour, InstanceId, ObjectClass};
use glam::{Affine3A, EulerRot, Quat, Vec3};

/// Position and heading in the world frame. The origin of a vehicle or person is on the ground, under its centre.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Pose {
    /// Metres.
    pub position: Vec3,
    /// Counter-clockwise from east, radians.
    pub yaw_rad: f32,
    /// Nose up is positive, radians.
    pub pitch_rad: f32,
    /// Left side up is positive (a lean to the right), radians.
    pub roll_rad: f32,
}

impl Pose {
    /// On level ground.
    pub fn level(position: Vec3, yaw_rad: f32) -> Self {
        Self { position, yaw_rad, pitch_rad: 0.0, roll_rad: 0.0 }
    }

    /// The transform from the object frame (x forward, y left, z up) to the world.
    pub fn world_from_object(&self) -> Affine3A {
        let rotation = Quat::from_euler(EulerRot::ZYX, self.yaw_rad, -self.pitch_rad, self.roll_rad);
        Affine3A::from_rotation_translation(rotation, self.position)
    }
}

bitflags::bitflags! {
    /// The lights of a vehicle, CARLA's bit layout.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
    pub struct VehicleLights: u32 {
        /// Side and tail lights.
        const POSITION = 1;
        /// Dipped headlights.
        const LOW_BEAM = 2;
        /// Main beam.
        const HIGH_BEAM = 4;
        /// Brake lights.
        const BRAKE = 8;
        /// Right indicator, lit (blinking is the traffic's business).
        const RIGHT_BLINKER = 16;
        /// Left indicator, lit.
        const LEFT_BLINKER = 32;
        /// Reversing lights.
        const REVERSE = 64;
        /// Fog lights.
        const FOG = 128;
        /// Cabin light.
        const INTERIOR = 256;
        /// The left half of the beacons of emergency vehicles, lit (flashing is the traffic's business).
        const SPECIAL1 = 512;
        /// The right half of them.
        const SPECIAL2 = 1024;
    }
}

/// Motion of a vehicle and its moving parts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct VehicleMotion {
    /// Forward speed, m/s.
    pub speed_mps: f32,
    /// Distance rolled since the scene began, metres; wheels turn by this over their radius.
    pub rolled_m: f32,
    /// Angle of the front wheels, positive to the left, radians.
    pub steer_rad: f32,
    /// Heading of what it draws against its own, positive to the left, radians.
    pub hitch_rad: f32,
    /// Lights that are on at this instant.
    pub lights: VehicleLights,
}

/// What a person is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Gait {
    /// Standing.
    #[default]
    Stand,
    /// Standing about: shifts weight, looks around.
    Idle,
    /// Waiting for something: looks out for it.
    Wait,
    /// Standing and talking.
    Talk,
    /// Walking.
    Walk,
    /// Walking as fast as one can.
    Hurry,
    /// Running.
    Run,
    /// Sitting, on the way down to a seat or up from it, or rolling in a wheelchair.
    Sit,
    /// Walking with both hands on something on wheels.
    Push,
}

/// A foot on the ground or on its way, in the person's object frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FootPlace {
    /// Where the ankle's vertical meets the ground when the sole is flat, metres forward and to the left.
    pub at: [f32; 2],
    /// Toes turned to the left, radians.
    pub yaw_rad: f32,
    /// Sole above the ground, metres.
    pub lift_m: f32,
    /// Heel up is positive: on the ground the foot rolls over its ball; toes up is negative: over its heel. Radians.
    pub pitch_rad: f32,
    /// Toes bent upwards, radians.
    pub toes_rad: f32,
}

/// Positions of both feet where they differ from those of a steady walk: while starting, stopping and turning.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Footing {
    /// Place in the cycle of two steps, 0 to 1; the left foot strikes at 0.
    pub phase: f32,
    /// Left, right.
    pub feet: [FootPlace; 2],
}

/// Motion of a person.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WalkerMotion {
    /// Forward speed, m/s.
    pub speed_mps: f32,
    /// Their gait.
    pub gait: Gait,
    /// Distance walked since the scene began, metres: legs swing by distance, so that feet do not slide.
    pub walked_m: f32,
    /// Seconds since the scene began, for breathing and idling.
    pub time_s: f32,
    /// Positions of the feet; `None` for a steady walk straight ahead.
    pub footing: Option<Footing>,
    /// Of who sits: the share of the way up from a seat to a stand, 0 while they sit.
    pub risen: f32,
}

/// Motion, by kind of actor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// A car, van, truck, bus, motorcycle or bicycle.
    Vehicle(VehicleMotion),
    /// A person on foot.
    Walker(WalkerMotion),
}

/// One actor at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Actor {
    /// Unique within the video.
    pub id: InstanceId,
    /// The id of the person riding it, for two-wheelers: class [`ObjectClass::Rider`].
    pub rider_id: Option<InstanceId>,
    /// Its class.
    pub class: ObjectClass,
    /// Its catalogue entry.
    pub asset: AssetRef,
    /// Its pose.
    pub pose: Pose,
    /// World-frame velocity, m/s.
    pub velocity_mps: Vec3,
    /// Motion of its parts.
    pub motion: Motion,
    /// What it is doing on the road network.
    pub behaviour: Behaviour,
    /// Placed by the town and still for the whole video.
    pub parked: bool,
}
