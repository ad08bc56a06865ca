//! What is recorded of a video: the scene's cameras, then the sensors of its rig, each with files of its own.

use super::sensor_times::{SensorTimes, StreamClock};
use endless_dataset::{CameraLayout, CameraOutput, FrameFolder, ModelSpec, Recipe, VideoLayout};
use endless_world::{
    EventCameraSettings, GnssSettings, ImageSize, ImuSettings, PinholeCamera, RigCamera, SceneCamera, SceneSensor,
    SceneSettings, SensorModel, Stream as RandomStream,
};
use std::path::PathBuf;

/// A camera or another sensor of a video.
pub(crate) struct Stream<'a> {
    pub(crate) files: CameraLayout,
    /// It measures at every so many frames.
    pub(crate) every: u32,
    /// Its place in the rig, unless it is a camera of the scene.
    pub(crate) sensor: Option<(usize, &'a SceneSensor)>,
    pub(crate) model: StreamModel<'a>,
    /// Frames of the video.
    frames: u32,
    /// What is random of what is measured in the order of frames.
    pub(crate) seed: u64,
    /// Folders with one file for each measurement, layers left out.
    pub(crate) folders: Vec<FrameFolder>,
    /// The file with a line for each measurement or event.
    pub(crate) lines: Option<PathBuf>,
    /// Bytes of a measurement, roughly, layers left out.
    pub(crate) bytes_a_measurement: f64,
    /// What it takes.
    pub(super) clock: StreamClock,
}

/// What a stream consists of.
pub(crate) enum StreamModel<'a> {
    /// Images and their labels.
    Camera(CameraStream<'a>),
    /// Events between images.
    Events { settings: EventCameraSettings, size: ImageSize },
    /// Files that the simulator's readings make: a LiDAR, a radar.
    Readings,
    /// Poses make its lines.
    Imu(&'a ImuSettings),
    /// Poses make its lines.
    Gnss(&'a GnssSettings),
    /// World states make its lines.
    Collision,
    /// World states make its lines.
    LaneInvasion,
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
        let frames = settings.frames;
        let plain = |files: CameraLayout, model: StreamModel<'a>| Self {
            files,
            every: 1,
            sensor: None,
            model,
            frames,
            seed: 0,
            folders: Vec::new(),
            lines: None,
            bytes_a_measurement: 0.0,
            clock: StreamClock::default(),
        };
        let scene = settings.cameras.iter().enumerate().map(|(number, camera)| {
            let output = recipe.camera_output();
            let lens = StreamLens::Fixed { number, camera: lens(camera, &output) };
            plain(layout.camera(number), StreamModel::Camera(CameraStream { output, lens }))
        });
        let mut streams: Vec<Self> = scene.collect();
        let mut number = settings.cameras.len();
        for (place, (sensor, spec)) in settings.sensors.iter().zip(&recipe.sensor).enumerate() {
            let model = match (&sensor.model, &spec.model) {
                (SensorModel::Camera(camera), ModelSpec::Camera(asked)) => {
                    let output = recipe.rig_camera_output(spec, asked);
                    let lens = match sensor.fixed_camera() {
                        Some(fixed) => StreamLens::Fixed { number, camera: lens(&fixed, &output) },
                        None => StreamLens::Moving(camera),
                    };
                    StreamModel::Camera(CameraStream { output, lens })
                }
                (SensorModel::EventCamera(camera), _) => {
                    StreamModel::Events { settings: camera.settings, size: camera.camera.size }
                }
                (SensorModel::Imu(settings), _) => StreamModel::Imu(settings),
                (SensorModel::Gnss(settings), _) => StreamModel::Gnss(settings),
                (SensorModel::Collision, _) => StreamModel::Collision,
                (SensorModel::LaneInvasion, _) => StreamModel::LaneInvasion,
                (SensorModel::Camera(_) | SensorModel::Lidar(_) | SensorModel::Radar(_), _) => StreamModel::Readings,
            };
            number += usize::from(sensor.fixed_camera().is_some());
            let files = layout.sensor(&sensor.name);
            streams.push(Self {
                every: sensor.every,
                sensor: Some((place, sensor)),
                seed: sensor_seed(settings, place),
                folders: spec.model.frame_folders(),
                lines: spec.model.lines_file().map(|name| files.folder().join(name)),
                bytes_a_measurement: spec.model.bytes_a_measurement(settings.fps / f64::from(sensor.every)),
                ..plain(files, model)
            });
        }
        streams
    }

    /// The name of its folder.
    pub(crate) fn name(&self) -> String {
        self.files.folder().file_name().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Adds what it took to what sensors of its name took before.
    pub(crate) fn add_times(&self, sensors: &mut Vec<SensorTimes>) {
        self.clock.add_to(&self.name(), sensors);
    }

    /// Whether it measures at a frame.
    pub(crate) fn measures_at(&self, frame: u32) -> bool {
        frame.is_multiple_of(self.every)
    }

    /// The frames at which it measures.
    pub(crate) fn frames(&self) -> impl ExactSizeIterator<Item = u32> + DoubleEndedIterator + Clone + use<> {
        (0..self.frames).step_by(self.every.max(1) as usize)
    }

    /// Folders with one file for each measurement, and what the names of these end with.
    pub(crate) fn frame_folders(&self) -> Vec<(PathBuf, String)> {
        let layers = match &self.model {
            StreamModel::Camera(CameraStream { output, .. }) => &output.layers[..],
            _ => &[],
        };
        let layer = |layer: &endless_dataset::Layer| {
            let StreamModel::Camera(CameraStream { output, .. }) = &self.model else { unreachable!("it has layers") };
            (self.files.layer(*layer), layer.format(output.rgb_format).to_string())
        };
        let folder = |folder: &FrameFolder| (self.files.frame_folder(*folder), folder.extension().to_owned());
        layers.iter().map(layer).chain(self.folders.iter().map(folder)).collect()
    }
}

/// What is random of a sensor, in this video.
pub(crate) fn sensor_seed(settings: &SceneSettings, place: usize) -> u64 {
    RandomStream::named(settings.seed, "sensor", &[place as u64]).next_u64()
}

/// A camera's lens at the size of its pictures.
fn lens(camera: &SceneCamera, output: &CameraOutput) -> PinholeCamera {
    PinholeCamera::new(&camera.site, output.size).with_distortion(camera.look.distortion)
}
