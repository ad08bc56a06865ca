//! The settings of one scene, which the paper writes as JSON before simulation.

use crate::{
    ActorDensity, CameraSite, ConditionChange, ImageSize, IncidentKind, SceneCamera, SceneRandomisation, SceneSensor,
    TimeOfDay, TrackPlayback, TrafficProfile, Weather,
};
use serde::{Deserialize, Serialize};

/// A camera that stands still, and the size of its pictures.
#[derive(Debug, Clone, PartialEq)]
pub struct FixedCamera {
    /// The camera.
    pub camera: SceneCamera,
    /// Of its pictures.
    pub size: ImageSize,
}

/// Everything that decides one video.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneSettings {
    /// The video's place in the shuffled list.
    pub video: u32,
    /// Map name, e.g. `Town03`.
    pub map: String,
    /// Seed by which the map's town is dressed; `None`: as it usually is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub town_seed: Option<u64>,
    /// The cameras were drawn for this video: the town is made for them alone.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub drawn_sites: bool,
    /// Weather.
    pub weather: Weather,
    /// Time of day.
    pub time_of_day: TimeOfDay,
    /// How high the sun stands, degrees above the horizon, if the video draws that; `None`: as the condition has it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sun_elevation_deg: Option<f32>,
    /// What weather and time of day become by the last frame, if they change.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub changing_to: Option<ConditionChange>,
    /// The cameras, filming the same instants. Written as a list of sites, `cameras`, and one of looks, `looks`, which is
    /// left out where all are clean.
    #[serde(flatten, with = "cameras_and_looks")]
    pub cameras: Vec<SceneCamera>,
    /// The sensors of its rig, if it has one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sensors: Vec<SceneSensor>,
    /// Moving vehicles to spawn, in addition to parked ones.
    pub vehicles: u32,
    /// Pedestrians asked for.
    pub pedestrians: u32,
    /// Where their numbers follow from how busy streets are; those above are 0 then.
    #[serde(default, skip_serializing_if = "ActorDensity::is_nothing")]
    pub density: ActorDensity,
    /// Share of them who come to what the cameras see, 0 to 1.
    #[serde(default = "usual_focus")]
    pub focus: f64,
    /// What is driven on its streets, and how.
    #[serde(default, skip_serializing_if = "TrafficProfile::is_usual")]
    pub profile: TrafficProfile,
    /// Share of pedestrians who cross roads away from crossings, 0 to 1.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub jaywalking: f64,
    /// Share of pedestrians who walk in groups, 0 to 1.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub groups: f64,
    /// Events to stage before its cameras.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub events: Vec<IncidentKind>,
    /// Image size.
    pub size: ImageSize,
    /// Frames a second.
    pub fps: f64,
    /// Frames of each camera: `round(fps × duration)`.
    pub frames: u32,
    /// Seed of everything random in this scene.
    pub seed: u64,
    /// What is randomised, if anything is; of cameras, [`Self::cameras`] are as they were drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub randomised: Option<SceneRandomisation>,
    /// How recorded tracks are played, if any are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub playback: Option<TrackPlayback>,
}

impl SceneSettings {
    /// Whether both are filmed in the same town.
    pub fn shares_town(&self, other: &Self) -> bool {
        let of_all = |scene: &Self| scene.town_seed.is_none() && !scene.drawn_sites;
        self.video == other.video || self.map == other.map && of_all(self) && of_all(other)
    }

    /// The cameras that stand still: those of the scene, then those of its rig.
    pub fn fixed_cameras(&self) -> Vec<FixedCamera> {
        let scene = self.cameras.iter().map(|camera| FixedCamera { camera: camera.clone(), size: self.size });
        let of_rig = self.sensors.iter().filter_map(|sensor| {
            Some(FixedCamera { camera: sensor.fixed_camera()?, size: sensor.model.camera()?.size })
        });
        scene.chain(of_rig).collect()
    }

    /// The cameras' sites if nobody moved them: traffic gathers before these, so that it is the same before moved ones.
    pub fn usual_sites(&self) -> impl Iterator<Item = &CameraSite> {
        let usual = self.randomised.as_ref().map_or(&[][..], |randomised| &randomised.usual_cameras);
        let own = if usual.is_empty() { &self.cameras[..] } else { &[] };
        usual.iter().chain(own.iter().map(|camera| &camera.site))
    }
}

/// Of scenes that do not tell: their traffic gathered before the cameras, too.
fn usual_focus() -> f64 {
    0.8
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it")]
fn is_zero(share: &f64) -> bool {
    *share == 0.0
}

mod cameras_and_looks {
    use super::SceneCamera;
    use crate::{CameraLook, CameraSite};
    use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

    #[derive(Serialize)]
    struct WrittenCameras<'a> {
        cameras: Vec<&'a CameraSite>,
        #[serde(skip_serializing_if = "Vec::is_empty")]
        looks: Vec<&'a CameraLook>,
    }

    #[derive(Deserialize)]
    struct ReadCameras {
        cameras: Vec<CameraSite>,
        looks: Option<Vec<CameraLook>>,
    }

    pub(super) fn serialize<S: Serializer>(cameras: &[SceneCamera], serializer: S) -> Result<S::Ok, S::Error> {
        let clean = cameras.iter().all(|c| c.look.is_clean());
        let looks = if clean { Vec::new() } else { cameras.iter().map(|c| &c.look).collect() };
        WrittenCameras { cameras: cameras.iter().map(|c| &c.site).collect(), looks }.serialize(serializer)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<SceneCamera>, D::Error> {
        let ReadCameras { cameras, looks } = ReadCameras::deserialize(deserializer)?;
        let looks = looks.unwrap_or_else(|| vec![CameraLook::CLEAN; cameras.len()]);
        if looks.len() != cameras.len() {
            return Err(D::Error::custom(format!("{} looks of {} cameras", looks.len(), cameras.len())));
        }
        Ok(cameras.into_iter().zip(looks).map(|(site, look)| SceneCamera { site, look }).collect())
    }
}
