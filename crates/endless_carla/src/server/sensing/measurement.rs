//! One sensor at one frame.

use super::{lidar, radar};
use crate::blueprint::SensorKind;
use crate::server::actor::CameraSettings;
use crate::stream::SensorHeader;
use endless_render::RayCaster;
use endless_sensor::{Atmosphere, SweepInterval};
use endless_world::{InstanceId, LidarSettings, RadarSettings, SceneWeather, SensorPose};

/// A sensor that measures at this frame.
pub(super) struct Measurement {
    pub(super) kind: SensorKind,
    pub(super) stream: u32,
    pub(super) header: SensorHeader,
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
    Lidar(Box<LidarSettings>),
    Radar(Box<RadarSettings>),
    /// It has measured already.
    Done(Vec<u8>),
}

impl Measurement {
    pub(super) fn camera(&self) -> Option<CameraSettings> {
        match self.what {
            Measured::Camera(settings) => Some(settings),
            _ => None,
        }
    }

    /// Whether it shows more than shapes.
    pub(super) fn needs_light(&self) -> bool {
        use SensorKind::{Depth, Instance, Normals, Semantic};
        !matches!(self.kind, Depth | Instance | Normals | Semantic)
    }

    pub(super) fn sweep(&self, caster: &RayCaster<'_>, weather: &SceneWeather, seed: u64) -> Vec<u8> {
        let caster = caster.ignoring(self.carrier.as_slice());
        let interval = SweepInterval::standing(self.pose, self.interval_s, self.header.frame as u32);
        let seed = seed ^ u64::from(self.stream);
        match &self.what {
            Measured::Lidar(settings) => {
                lidar::message(&self.header, self.kind, settings, &caster, &Atmosphere::from(weather), &interval, seed)
            }
            Measured::Radar(settings) => radar::message(&self.header, settings, &caster, &interval, seed),
            Measured::Camera(_) | Measured::Done(_) => Vec::new(),
        }
    }
}
