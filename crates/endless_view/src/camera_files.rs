//! The cameras of a video: those of its scene, and those of its rig.

use crate::folder::{DatasetFolder, is_plain_name};
use endless_dataset::{CameraLayout, Layer, RgbFormat, VideoLayout};
use endless_world::{SceneSettings, SensorModel};

/// Where a camera's files lie.
#[derive(Debug, Clone)]
pub(crate) struct CameraFiles {
    /// Of its site, or of the rig's sensor.
    pub(crate) name: String,
    /// Its folder's name.
    pub(crate) folder: String,
    /// Its paths.
    pub(crate) layout: CameraLayout,
    /// It films at every so many frames.
    pub(crate) every: u32,
    /// Whether it belongs to the rig.
    pub(crate) of_rig: bool,
}

impl CameraFiles {
    /// All cameras that a page can show. Sensors whose names are no plain names are left out.
    pub(crate) fn of(settings: &SceneSettings, video: &VideoLayout) -> Vec<Self> {
        let fixed = settings.cameras.iter().take(endless_dataset::MAX_CAMERAS as usize).enumerate();
        let fixed = fixed.map(|(i, camera)| Self {
            name: camera.site.name.clone(),
            folder: VideoLayout::camera_name(i),
            layout: video.camera(i),
            every: 1,
            of_rig: false,
        });
        let films = |model: &SensorModel| matches!(model, SensorModel::Camera(_));
        let rig = settings.sensors.iter().filter(|sensor| films(&sensor.model) && is_plain_name(&sensor.name));
        let rig = rig.map(|sensor| Self {
            name: sensor.name.clone(),
            folder: sensor.name.clone(),
            layout: video.sensor(&sensor.name),
            every: sensor.every.max(1),
            of_rig: true,
        });
        fixed.chain(rig).collect()
    }

    /// The layers that it has images of.
    pub(crate) fn layers(&self, folder: &DatasetFolder) -> Vec<Layer> {
        let there = folder.list(self.layout.folder());
        Layer::ALL.iter().copied().filter(|layer| there.iter().any(|name| name == layer.name())).collect()
    }

    /// How many frames can be shown from the first on: those whose images of a layer are there without a gap.
    pub(crate) fn frames_there(&self, folder: &DatasetFolder, layer: Layer, rgb_format: RgbFormat) -> u32 {
        let ending = format!(".{}", layer.format(rgb_format));
        let number = |name: String| name.strip_suffix(&ending)?.parse::<u32>().ok();
        let mut numbers: Vec<u32> = folder.list(&self.layout.layer(layer)).into_iter().filter_map(number).collect();
        numbers.sort_unstable();
        let whole = numbers.iter().zip((0..).step_by(self.every as usize)).take_while(|(have, want)| *have == want);
        whole.count() as u32
    }
}
