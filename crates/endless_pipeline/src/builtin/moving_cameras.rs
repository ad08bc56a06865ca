//! The cameras of a rig that move, each with the light of its way.

use super::{bake_cache::render_settings, helped_once::HelpedOnce};
use endless_render::{FrameScene, IndirectLight, MovingCamera, RenderSettings, StaticScene};
use endless_world::{PinholeCamera, SceneSettings, SceneWeather, SensorFrame, SensorLayers};
use std::collections::BTreeMap;

/// The cameras of a rig that move, by their places in it.
pub(super) struct MovingCameras(BTreeMap<usize, MovingRigCamera>);

struct MovingRigCamera {
    settings: RenderSettings,
    way: Vec<PinholeCamera>,
    made: HelpedOnce<MovingCamera>,
}

impl MovingCameras {
    /// Along these ways.
    pub(super) fn new<'a>(
        video: &SceneSettings,
        weather: SceneWeather,
        layers: SensorLayers,
        ways: impl Iterator<Item = (usize, &'a [PinholeCamera])>,
    ) -> Self {
        let camera = |(place, way): (usize, &[PinholeCamera])| {
            let camera = video.sensors[place].model.camera().expect("what has a way has a lens");
            let settings = RenderSettings { layers, weather, ..render_settings(video, camera.look, camera.size) };
            (place, MovingRigCamera { settings, way: way.to_vec(), made: HelpedOnce::default() })
        };
        Self(ways.map(camera).collect())
    }

    /// Finds the light along all ways.
    pub(super) fn prepare(&self, still: &StaticScene) {
        self.0.values().for_each(|camera| {
            camera.get(still);
        });
    }

    /// What the camera at a place of the rig sees as it stands now; `None` if no camera moves there.
    pub(super) fn render(
        &self,
        place: usize,
        still: &StaticScene,
        frame: &FrameScene,
        now: &PinholeCamera,
    ) -> Option<SensorFrame> {
        Some(self.0.get(&place)?.get(still).render(still, frame, now))
    }
}

impl MovingRigCamera {
    fn get(&self, still: &StaticScene) -> &MovingCamera {
        self.made.get_or_make(|| MovingCamera::new(still, &self.settings, IndirectLight::Probes, &self.way))
    }
}
