//! What is recorded of a video: the scene's cameras, then the sensors of its rig, each with files of its own.

use endless_dataset::{CameraLayout, CameraOutput, ModelSpec, Recipe, VideoLayout};
use endless_world::{PinholeCamera, RigCamera, SceneCamera, SceneSensor, SceneSettings, SensorModel};

/// A camera or another sensor of a video.
pub(crate) struct Stream<'a> {
    pub(crate) files: CameraLayout,
    /// It measures at every so many frames.
    pub(crate) every: u32,
    /// Its place in the rig, unless it is a camera of the scene.
    pub(crate) sensor: Option<(usize, &'a SceneSensor)>,
    pub(crate) model: StreamModel<'a>,
}

/// What a stream consists of.
pub(crate) enum StreamModel<'a> {
    /// Images and their labels.
    Camera(CameraStream<'a>),
}

/// A camera.
pub(crate) struct CameraStream<'a> {
    pub(crate) output: CameraOutput,
    pub(crate) lens: StreamLens<'a>,
}

/// Where a camera looks.
pub(crate) enum StreamLens<'a> {
    /// Always there; the number counts the cameras that stand still.
    Fixed { number: usize, camera: PinholeCamera },
    /// Where the sensor is at a frame.
    Moving(&'a RigCamera),
}

impl<'a> Stream<'a> {
    /// All of a video.
    pub(crate) fn all(recipe: &'a Recipe, settings: &'a SceneSettings, layout: &VideoLayout) -> Vec<Self> {
        let scene = settings.cameras.iter().enumerate().map(|(number, camera)| {
            let output = recipe.camera_output();
            let lens = StreamLens::Fixed { number, camera: lens(camera, &output) };
            let model = StreamModel::Camera(CameraStream { output, lens });
            Self { files: layout.camera(number), every: 1, sensor: None, model }
        });
        let mut streams: Vec<Self> = scene.collect();
        let mut number = settings.cameras.len();
        for (place, (sensor, spec)) in settings.sensors.iter().zip(&recipe.sensor).enumerate() {
            let model = match (&sensor.model, &spec.model) {
                (SensorModel::Camera(camera), ModelSpec::Camera(asked)) => {
                    let output = recipe.rig_camera_output(spec, asked);
                    let lens = match sensor.fixed_camera() {
                        Some(fixed) => {
                            number += 1;
                            StreamLens::Fixed { number: number - 1, camera: self::lens(&fixed, &output) }
                        }
                        None => StreamLens::Moving(camera),
                    };
                    StreamModel::Camera(CameraStream { output, lens })
                }
            };
            let files = layout.sensor(&sensor.name);
            streams.push(Self { files, every: sensor.every, sensor: Some((place, sensor)), model });
        }
        streams
    }

    /// Whether it measures at a frame.
    pub(crate) fn measures_at(&self, frame: u32) -> bool {
        frame.is_multiple_of(self.every)
    }

    /// How many images it stores.
    pub(crate) fn images(&self) -> u64 {
        match &self.model {
            StreamModel::Camera(camera) => u64::from(camera.output.count()) * camera.output.layers.len() as u64,
        }
    }
}

/// A camera's lens at the size of its pictures.
fn lens(camera: &SceneCamera, output: &CameraOutput) -> PinholeCamera {
    PinholeCamera::new(&camera.site, output.size).with_distortion(camera.look.distortion)
}
