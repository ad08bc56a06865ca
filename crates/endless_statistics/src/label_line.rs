//! The parts of a dataset's files that statistics need: what is not named here is passed over unread.

use endless_world::{ObjectClass, Parking, Reid, TimeOfDay, Weather};
use serde::Deserialize;
use std::borrow::Cow;

/// A line of `objects.jsonl`.
#[derive(Debug, Deserialize)]
pub(crate) struct FrameLine {
    pub(crate) frame: u32,
    pub(crate) objects: Vec<ObjectLine>,
}

/// An object in it.
#[derive(Debug, Deserialize)]
pub(crate) struct ObjectLine {
    pub(crate) id: u32,
    pub(crate) class: ObjectClass,
    pub(crate) bbox: [u32; 4],
    pub(crate) pixels: u32,
    pub(crate) truncated: bool,
    pub(crate) parked: bool,
    pub(crate) speed_mps: f64,
    #[serde(default)]
    pub(crate) parking: Option<Parking>,
    #[serde(default)]
    pub(crate) distance_m: Option<f64>,
    #[serde(default)]
    pub(crate) visibility: Option<f64>,
    #[serde(default)]
    pub(crate) truncation: Option<f64>,
}

/// A line of `frames.jsonl`.
#[derive(Debug, Deserialize)]
pub(crate) struct SceneLine<'a> {
    pub(crate) frame: u32,
    pub(crate) weather: WeatherName,
    pub(crate) light: LightName,
    #[serde(default, borrow)]
    pub(crate) events: Vec<Kind<'a>>,
}

#[derive(Debug, Deserialize)]
pub(crate) struct WeatherName {
    pub(crate) name: Weather,
}

#[derive(Debug, Deserialize)]
pub(crate) struct LightName {
    pub(crate) time_of_day: TimeOfDay,
}

/// Something of a kind.
#[derive(Debug, Deserialize)]
pub(crate) struct Kind<'a> {
    #[serde(borrow)]
    pub(crate) kind: Cow<'a, str>,
}

/// `scene.json`.
#[derive(Debug, Deserialize)]
pub(crate) struct SceneFile {
    pub(crate) fps: f64,
    pub(crate) spawned: Spawned,
    #[serde(default)]
    pub(crate) incidents: Vec<IncidentFile>,
    #[serde(default)]
    pub(crate) missed_events: Vec<String>,
}

#[derive(Debug, Deserialize)]
pub(crate) struct Spawned {
    pub(crate) vehicles: u32,
    pub(crate) pedestrians: u32,
}

#[derive(Debug, Deserialize)]
pub(crate) struct IncidentFile {
    pub(crate) kind: String,
}

/// `camera.json`.
#[derive(Debug, Deserialize)]
pub(crate) struct CameraFile {
    pub(crate) size: SizeFile,
    pub(crate) fps: f64,
}

#[derive(Debug, Deserialize)]
pub(crate) struct SizeFile {
    pub(crate) width: u32,
    pub(crate) height: u32,
}

/// An entry of `actors.json`.
#[derive(Debug, Deserialize)]
pub(crate) struct ActorFile {
    pub(crate) id: u32,
    #[serde(default)]
    pub(crate) reid: Option<Reid>,
    #[serde(default)]
    pub(crate) person: Option<PersonFile>,
    #[serde(default)]
    pub(crate) vehicle: Option<VehicleFile>,
}

#[derive(Debug, Deserialize)]
pub(crate) struct PersonFile {
    pub(crate) identity: Reid,
    pub(crate) age_years: u32,
    pub(crate) age_group: String,
    pub(crate) sex: String,
    pub(crate) skin_tone: u8,
}

#[derive(Debug, Deserialize)]
pub(crate) struct VehicleFile {
    pub(crate) model: String,
    #[serde(default)]
    pub(crate) subclass: Option<String>,
    #[serde(default)]
    pub(crate) color: Option<ColorFile>,
}

#[derive(Debug, Deserialize)]
pub(crate) struct ColorFile {
    pub(crate) name: String,
}
