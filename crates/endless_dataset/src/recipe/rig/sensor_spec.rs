//! One sensor.

use super::json_fields::{fields, value};
use super::{CameraSpec, EventCameraSpec, LidarSpec, MountSpec};
use endless_world::{GnssSettings, ImuSettings, RadarSettings};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// A sensor as users write it: what all have, and beside it the settings of its type.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Map<String, Value>", into = "Map<String, Value>")]
pub struct SensorSpec {
    /// Its folder; unique in the rig.
    pub name: String,
    /// Measurements a second, a divisor of the recipe's frames a second; `None` for as many.
    pub rate: Option<f64>,
    /// What carries it.
    pub mount: MountSpec,
    /// What it is.
    pub model: ModelSpec,
}

/// The type of a sensor, and its settings.
#[derive(Debug, Clone, PartialEq)]
pub enum ModelSpec {
    /// A camera.
    Camera(CameraSpec),
    /// A camera that tells changes of brightness.
    EventCamera(EventCameraSpec),
    /// A LiDAR.
    Lidar(LidarSpec),
    /// A radar.
    Radar(RadarSettings),
    /// Accelerometer, gyroscope and compass.
    Imu(ImuSettings),
    /// A receiver of satellite navigation.
    Gnss(GnssSettings),
    /// It notices whom its carrier touches.
    Collision,
    /// It notices painted lines that its carrier comes over.
    LaneInvasion,
}

impl ModelSpec {
    /// The types that there are.
    pub const TYPES: &[&str] =
        &["camera", "event_camera", "lidar", "radar", "imu", "gnss", "collision", "lane_invasion"];

    /// The word for it in a recipe.
    pub fn type_name(&self) -> &'static str {
        match self {
            Self::Camera(_) => "camera",
            Self::EventCamera(_) => "event_camera",
            Self::Lidar(_) => "lidar",
            Self::Radar(_) => "radar",
            Self::Imu(_) => "imu",
            Self::Gnss(_) => "gnss",
            Self::Collision => "collision",
            Self::LaneInvasion => "lane_invasion",
        }
    }

    fn parse(type_name: &str, settings: Map<String, Value>) -> Result<Self, String> {
        match type_name {
            "camera" => Ok(Self::Camera(value(settings)?)),
            "event_camera" => EventCameraSpec::parse(settings).map(Self::EventCamera),
            "lidar" => LidarSpec::parse(settings).map(Self::Lidar),
            "radar" => Ok(Self::Radar(value(settings)?)),
            "imu" => Ok(Self::Imu(value(settings)?)),
            "gnss" => Ok(Self::Gnss(value(settings)?)),
            "collision" => no_settings(&settings).map(|()| Self::Collision),
            "lane_invasion" => no_settings(&settings).map(|()| Self::LaneInvasion),
            other => Err(format!("unknown type '{other}', known are {}", Self::TYPES.join(", "))),
        }
    }

    fn settings(&self) -> Map<String, Value> {
        match self {
            Self::Camera(camera) => fields(camera),
            Self::EventCamera(camera) => camera.fields(),
            Self::Lidar(lidar) => lidar.fields(),
            Self::Radar(radar) => fields(radar),
            Self::Imu(imu) => fields(imu),
            Self::Gnss(gnss) => fields(gnss),
            Self::Collision | Self::LaneInvasion => Map::new(),
        }
    }
}

fn no_settings(given: &Map<String, Value>) -> Result<(), String> {
    given.keys().next().map_or(Ok(()), |key| Err(format!("unknown field `{key}`, there are none of this type")))
}

impl TryFrom<Map<String, Value>> for SensorSpec {
    type Error = String;

    fn try_from(mut given: Map<String, Value>) -> Result<Self, String> {
        let mut take = |key: &str| given.remove(key);
        let word = |key: &str, value: Option<Value>| match value {
            Some(Value::String(word)) => Ok(word),
            Some(other) => Err(format!("{key} cannot be {other}: write a word")),
            None => Err(format!("missing field `{key}`")),
        };
        let name = word("name", take("name"))?;
        let mut parse = || {
            let type_name = word("type", take("type"))?;
            let rate = take("rate").map(value).transpose()?;
            let mount = take("mount").ok_or("missing field `mount`")?;
            let mount = value(mount).map_err(|wrong| format!("mount: {wrong}"))?;
            Ok::<_, String>((type_name, rate, mount))
        };
        let of_sensor = |wrong: String| format!("sensor {name}: {wrong}");
        let (type_name, rate, mount) = parse().map_err(of_sensor)?;
        let model = ModelSpec::parse(&type_name, given).map_err(of_sensor)?;
        Ok(Self { name, rate, mount, model })
    }
}

impl From<SensorSpec> for Map<String, Value> {
    fn from(sensor: SensorSpec) -> Self {
        let SensorSpec { name, rate, mount, model } = sensor;
        let mut written = Self::new();
        written.insert("name".to_owned(), name.into());
        written.insert("type".to_owned(), model.type_name().into());
        if let Some(rate) = rate {
            written.insert("rate".to_owned(), rate.into());
        }
        written.insert("mount".to_owned(), fields(&mount).into());
        written.extend(model.settings());
        written
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RIG: &str = r#"
        [[sensor]]
        name = "front"
        type = "camera"
        rate = 10
        size = "640x360"
        fov = 90
        mount = { on = "vehicle", class = "car", at = [0.5, 0.0, 1.4], pitch = -3 }

        [[sensor]]
        name = "drone"
        type = "camera"
        mount = { on = "orbit", from = "junction", radius = 40, height = 60, period = 90 }
    "#;

    #[derive(Debug, Deserialize)]
    struct RigFile {
        sensor: Vec<SensorSpec>,
    }

    fn read(text: &str) -> Result<Vec<SensorSpec>, String> {
        toml::from_str(text).map(|file: RigFile| file.sensor).map_err(|wrong| wrong.message().to_owned())
    }

    #[test]
    fn what_is_written_is_read_again() {
        let sensors = read(RIG).expect("a rig");
        assert_eq!((sensors[0].name.as_str(), sensors[0].rate), ("front", Some(10.0)));
        let text = serde_json::to_string(&sensors).expect("plain");
        assert_eq!(serde_json::from_str::<Vec<SensorSpec>>(&text).expect("the same"), sensors);
    }

    #[test]
    fn what_cannot_be_names_the_sensor() {
        let told = |from: &str, to: &str| read(&RIG.replace(from, to)).expect_err("wrong");
        assert_eq!(
            told(
                "type = \"camera\"\n        mount = { on = \"orbit\"",
                "type = \"sonar\"\n        mount = { on = \"orbit\""
            ),
            "sensor drone: unknown type 'sonar', known are camera, event_camera, lidar, radar, imu, gnss, collision, lane_invasion"
        );
        assert!(told("fov = 90", "fow = 90").starts_with("sensor front: unknown field `fow`"));
        assert!(told("pitch = -3", "tilt = -3").starts_with("sensor front: mount: unknown field `tilt`"));
        assert!(told("on = \"orbit\"", "on = \"moon\"").starts_with("sensor drone: mount: unknown variant `moon`"));
        assert!(told("name = \"front\"", "name = 7").starts_with("name cannot be 7"));
    }
}
