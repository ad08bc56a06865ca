//! One sensor at one frame.

use super::{lidar, obstacle, radar};
use crate::blueprint::SensorKind;
use crate::server::actor::{CameraSettings, ObstacleSettings};
use crate::server::episode::Episode;
use crate::stream::SensorHeader;
use endless_render::RayCaster;
use endless_sensor::{Atmosphere, SweepInterval};
use endless_world::{EventCameraSettings, InstanceId, LidarSettings, RadarSettings, SceneWeather, SensorPose};

/// A sensor that measures at this frame.
pub(super) struct Measurement {
    pub(super) kind: SensorKind,
    pub(super) stream: u32,
    pub(super) header: SensorHeader,
    /// How often it had measured before.
    pub(super) number: u32,
    /// Of its noise.
    pub(super) seed: u64,
    pub(super) pose: SensorPose,
    /// Since it measured last, seconds.
    pub(super) interval_s: f64,
    /// In pictures, of whom it hangs on.
    pub(super) carrier: Option<InstanceId>,
    pub(super) what: Measured,
}

/// How it measures, where that needs to know the scene.
pub(super) enum Measured {
    Camera(CameraSettings),
    Events(CameraSettings, Box<EventCameraSettings>),
    Lidar(Box<LidarSettings>),
    Radar(Box<RadarSettings>),
    /// Of this sensor on this carrier.
    Obstacle(ObstacleSettings, [u32; 2]),
    /// It has measured already.
    Done(Vec<u8>),
}

impl Measurement {
    pub(super) fn camera(&self) -> Option<CameraSettings> {
        match self.what {
            Measured::Camera(settings) | Measured::Events(settings, _) => Some(settings),
            _ => None,
        }
    }

    /// Whether it needs what the renderer draws.
    pub(super) fn looks(&self) -> bool {
        !matches!(self.what, Measured::Done(_) | Measured::Obstacle(..))
    }

    /// What it tells that needs no picture.
    pub(super) fn message(self, episode: &Episode) -> Option<Vec<u8>> {
        match self.what {
            Measured::Done(message) => Some(message),
            Measured::Obstacle(settings, ids) => obstacle::message(&self.header, episode, ids, &settings, &self.pose),
            _ => None,
        }
    }

    /// Whether it shows more than shapes.
    pub(super) fn needs_light(&self) -> bool {
        use SensorKind::{Depth, Instance, Normals, Semantic};
        !matches!(self.kind, Depth | Instance | Normals | Semantic)
    }

    pub(super) fn sweep(&self, caster: &RayCaster<'_>, weather: &SceneWeather) -> Vec<u8> {
        let caster = caster.ignoring(self.carrier.as_slice());
        // By its own count, not by the frame: the same script gives the same noise whenever its world was loaded.
        let interval = SweepInterval::standing(self.pose, self.interval_s, self.number);
        let seed = self.seed;
        match &self.what {
            Measured::Lidar(settings) => {
                lidar::message(&self.header, self.kind, settings, &caster, &Atmosphere::from(weather), &interval, seed)
            }
            Measured::Radar(settings) => radar::message(&self.header, settings, &caster, &interval, seed),
            _ => Vec::new(),
        }
    }
}
