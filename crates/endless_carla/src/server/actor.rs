//! Actors of an episode.

use super::friction::FrictionTrigger;
use super::spring_arm::SpringArm;
use super::vehicle_actor::VehicleActor;
use super::walker_actor::WalkerActor;
use crate::blueprint::{Blueprint, PropBody, SensorKind};
use crate::stream::SensorHeader;
use crate::wire::{Actor, Bytes, Transform, Vector3D};
use endless_sensor::Imu;
use endless_world::{EventCameraSettings, GnssSettings, ImageSize, ImuSettings, LidarSettings, RadarSettings};

/// An actor at an instant.
pub(super) struct ServerActor {
    /// What clients are told of it once.
    pub(super) told: Actor,
    /// In the world.
    pub(super) transform: Transform,
    /// Metres a second.
    pub(super) velocity: Vector3D,
    /// Degrees a second.
    pub(super) angular_velocity: Vector3D,
    /// Metres a second squared.
    pub(super) acceleration: Vector3D,
    /// Where it is on whom it is attached to.
    pub(super) on_parent: Option<Transform>,
    /// What it hangs on there; none if rigidly.
    pub(super) arm: Option<SpringArm>,
    pub(super) body: Body,
}

/// What only actors of a kind have.
pub(super) enum Body {
    Vehicle(Box<VehicleActor>),
    Walker(Box<WalkerActor>),
    Sensor(SensorActor),
    Prop(PropActor),
    /// By its place in the map's list.
    Light(usize),
    /// By its number in the OpenDRIVE file.
    Sign(String),
    FrictionTrigger(FrictionTrigger),
    Other,
}

/// A prop.
pub(super) struct PropActor {
    /// What is seen of it.
    pub(super) body: Option<PropBody>,
    pub(super) collides: bool,
}

/// A sensor.
pub(super) struct SensorActor {
    pub(super) kind: SensorKind,
    /// The number of its stream; 0 if it has none.
    pub(super) stream: u32,
    pub(super) model: SensorModel,
    /// Seconds from one measurement to the next; 0 for every frame.
    pub(super) tick_s: f64,
    /// When it measures next, seconds of the episode.
    pub(super) due_s: f64,
    /// When it measured last, seconds of the episode.
    pub(super) last_s: Option<f64>,
    /// How often it has measured.
    pub(super) count: u32,
    /// Of its noise.
    pub(super) seed: u64,
}

/// How a sensor measures.
#[derive(Debug, Clone)]
pub(super) enum SensorModel {
    Camera(CameraSettings),
    /// One that tells where it becomes brighter or darker.
    Events(CameraSettings, Box<EventCameraSettings>),
    Lidar(Box<LidarSettings>),
    Radar(Box<RadarSettings>),
    Imu(Box<ImuSettings>, Option<Box<Imu>>),
    Gnss(Box<GnssSettings>),
    Obstacle(ObstacleSettings),
    /// It tells of what happens, not of every frame.
    Event,
}

impl SensorModel {
    /// Whether it measures what rays meet.
    pub(super) fn looks(&self) -> bool {
        matches!(self, Self::Camera(_) | Self::Events(..) | Self::Lidar(_) | Self::Radar(_))
    }
}

/// What a detector of obstacles sends ahead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ObstacleSettings {
    pub(super) distance_m: f64,
    pub(super) hit_radius_m: f64,
    /// Vehicles and people alone.
    pub(super) only_dynamics: bool,
}

/// The picture of a camera.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CameraSettings {
    pub(super) size: ImageSize,
    /// Across, degrees.
    pub(super) fov_deg: f32,
    /// It hangs on another actor.
    pub(super) is_carried: bool,
}

impl SensorActor {
    /// What begins its messages, of a frame at a time of the episode.
    pub(super) fn header(&self, transform: &Transform, frame: u64, now_s: f64) -> SensorHeader {
        let type_id = self.kind.stream_type_id();
        SensorHeader { type_id, frame, timestamp: now_s, transform: transform.clone() }
    }

    /// Whether it measures at this time of its episode; then it says when it does so next.
    pub(super) fn measures(&mut self, now_s: f64) -> bool {
        // A frame's time is a sum of many steps.
        const ROUNDING_S: f64 = 1e-6;
        if self.tick_s <= 0.0 {
            return true;
        }
        let is_due = now_s + ROUNDING_S >= self.due_s;
        if is_due {
            let missed = ((now_s - self.due_s) / self.tick_s).floor().max(0.0);
            self.due_s += (missed + 1.0) * self.tick_s;
        }
        is_due
    }
}

impl ServerActor {
    /// One of the server's own: the spectator, lights, signs.
    pub(super) fn own(blueprint: &Blueprint, id: u32, transform: Transform, body: Body) -> Self {
        let told = Actor {
            id,
            parent_id: 0,
            description: blueprint.description(),
            bounding_box: blueprint.bounding_box.clone(),
            semantic_tags: Bytes(blueprint.semantic_tags.clone()),
            stream_token: Bytes::default(),
        };
        Self::new(told, transform, body)
    }

    /// That does not move yet.
    pub(super) fn new(told: Actor, transform: Transform, body: Body) -> Self {
        let zero = Vector3D::default;
        Self {
            told,
            transform,
            velocity: zero(),
            angular_velocity: zero(),
            acceleration: zero(),
            on_parent: None,
            arm: None,
            body,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sensors_measure_as_often_as_they_shall() {
        let mut sensor = SensorActor {
            kind: SensorKind::Collision,
            stream: 1,
            model: SensorModel::Event,
            tick_s: 0.2,
            due_s: 0.0,
            last_s: None,
            count: 0,
            seed: 0,
        };
        let mut measured = Vec::new();
        let mut now_s = 0.0;
        for frame in 0..20 {
            now_s += 0.05;
            if sensor.measures(now_s) {
                measured.push(frame);
            }
        }
        assert_eq!(measured, [0, 3, 7, 11, 15, 19]);
        // After a long step it measures once.
        assert!(sensor.measures(9.0) && !sensor.measures(9.05));
        let mut always = SensorActor { tick_s: 0.0, ..sensor };
        assert!(always.measures(9.1) && always.measures(9.1));
    }
}
