//! `sensor.json`: a sensor of a rig.

use endless_world::{InstanceId, Placement, SceneSensor, SensorMount};
use serde::{Deserialize, Serialize};

/// A sensor of a rig: its settings, and who carries it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SensorRecord {
    /// Conventions of the numbers.
    pub conventions: String,
    /// Its settings.
    #[serde(flatten)]
    pub sensor: SceneSensor,
    /// Measurements a second.
    pub rate_hz: f64,
    /// Whose it is, of sensors that somebody carries.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub carrier_id: Option<InstanceId>,
    /// Row-major 4×4, of sensors that somebody carries: `carrier = carrier_from_sensor · sensor`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub carrier_from_sensor: Option<[[f64; 4]; 4]>,
}

const CONVENTIONS: &str = "metres, seconds and radians; world: right-handed, x east, y north, z up; sensor and carrier \
                           (body frames): x forward, y left, z up, a carrier's origin on the ground under its middle; \
                           quaternions are w, x, y, z and turn the sensor's frame into the world; matrices are \
                           row-major and act on columns";

impl SensorRecord {
    /// The record of a sensor of a scene with so many frames a second.
    pub fn new(sensor: &SceneSensor, scene_fps: f64, carrier_id: Option<InstanceId>) -> Self {
        let carrier_from_sensor = match &sensor.mount {
            SensorMount::Carried { at, .. } => Some(matrix(at)),
            _ => None,
        };
        Self {
            conventions: CONVENTIONS.into(),
            sensor: sensor.clone(),
            rate_hz: scene_fps / f64::from(sensor.every),
            carrier_id,
            carrier_from_sensor,
        }
    }
}

/// Row-major.
fn matrix(at: &Placement) -> [[f64; 4]; 4] {
    let r = glam::DMat3::from_quat(at.rotation());
    let row = |i: usize| [r.col(0)[i], r.col(1)[i], r.col(2)[i], at.position[i]];
    [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]]
}
