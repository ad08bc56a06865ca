//! The cameras of a rig that move, each with the light of its way: one, or one at every key frame of a video in which weather
//! or time changes.

use super::{bake_cache::render_settings, helped_once::HelpedOnce};
use endless_render::{FrameScene, IndirectLight, MovingCamera, NeighbourFrames, RenderSettings, StaticScene};
use endless_world::{PinholeCamera, SceneSettings, SensorFrame, SensorLayers, WeatherTimeline};
use std::collections::BTreeMap;

/// The cameras of a rig that move, by their places in it.
pub(super) struct MovingCameras(BTreeMap<usize, MovingRigCamera>);

struct MovingRigCamera {
    settings: RenderSettings,
    way: Vec<PinholeCamera>,
    timeline: WeatherTimeline,
    /// By key frame.
    made: Vec<HelpedOnce<MovingCamera>>,
}

/// What a frame of a camera that moves shows.
pub(super) struct MovingView<'a> {
    pub(super) still: &'a StaticScene,
    pub(super) frame: &'a FrameScene,
    /// The frame's number.
    pub(super) number: u32,
    /// The camera, as it stands now.
    pub(super) camera: &'a PinholeCamera,
    pub(super) neighbours: NeighbourFrames<'a>,
}

impl MovingCameras {
    /// Along these ways.
    pub(super) fn new<'a>(
        video: &SceneSettings,
        timeline: &WeatherTimeline,
        layers: SensorLayers,
        ways: impl Iterator<Item = (usize, &'a [PinholeCamera])>,
    ) -> Self {
        let camera = |(place, way): (usize, &[PinholeCamera])| {
            let camera = video.sensors[place].model.camera().expect("what has a way has a lens");
            let settings = RenderSettings { layers, ..render_settings(video, camera.look, camera.size) };
            let made = (0..=timeline.intervals()).map(|_| HelpedOnce::default()).collect();
            (place, MovingRigCamera { settings, way: way.to_vec(), timeline: *timeline, made })
        };
        Self(ways.map(camera).collect())
    }

    /// Finds the light along all ways at the first frame.
    pub(super) fn prepare(&self, still: &StaticScene) {
        self.0.values().for_each(|camera| {
            camera.at_key(still, 0);
        });
    }

    /// What the camera at a place of the rig sees; `None` if no camera moves there.
    pub(super) fn render(&self, place: usize, view: &MovingView<'_>) -> Option<SensorFrame> {
        let MovingView { still, frame, number, camera, neighbours } = *view;
        let of = self.0.get(&place)?;
        let (key, share) = of.timeline.place(number);
        let before = of.at_key(still, key);
        Some(match share > 0.0 {
            true => before.render_changing((of.at_key(still, key + 1), share), still, frame, camera, neighbours),
            false => before.render_between(still, frame, camera, neighbours),
        })
    }
}

impl MovingRigCamera {
    fn at_key(&self, still: &StaticScene, key: u32) -> &MovingCamera {
        self.made[key as usize].get_or_make(|| {
            let settings = RenderSettings { weather: self.timeline.at_key(key), ..self.settings.clone() };
            MovingCamera::new(still, &settings, IndirectLight::Probes, &self.way)
        })
    }
}
