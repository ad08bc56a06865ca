//! One frame of all cameras: rendered and written, or read back where it is stored already, and then labelled.

use super::{
    layers::{self, StoredImages, StoredLayers},
    recording::Recording,
    sink::SinkItem,
    stored::StoredFrames,
    times::Stage,
};
use crate::{GenerateError, SceneTruth, SimulationStep, SimulatorError};
use endless_annotate::{AnnotateError, CameraView, FrameObjects, ObjectShapes, SceneFrame, annotate, visible_objects};
use endless_dataset::{DatasetError, LastPng, Layer, StoredImage, Yuv, metres_from_rgb, rgb_from_metres, yuv_from_rgb};
use endless_world::{PinholeCamera, SceneCamera, SensorFrame};

pub(super) struct FrameRecorder<'a> {
    pub(super) recording: &'a Recording<'a>,
    stored: &'a StoredFrames,
    /// One a camera.
    lenses: Vec<PinholeCamera>,
    /// By camera and layer: what was written last.
    written: Vec<Vec<LastPng>>,
}

/// One frame: its ground truth and the images of all cameras.
pub(super) struct CapturedFrame<'a> {
    frame: u32,
    truth: SceneTruth<'a>,
    scene: Option<SceneFrame>,
    pictures: FrameImages,
}

/// One a camera.
enum FrameImages {
    Rendered(Vec<SensorFrame>),
    Stored(Vec<StoredLayers>),
}

impl CapturedFrame<'_> {
    /// Whether it was stored already.
    pub(super) fn is_stored(&self) -> bool {
        matches!(self.pictures, FrameImages::Stored(_))
    }

    /// The line of `frames.jsonl`, if the simulator knows it.
    pub(super) fn into_scene_frame(self) -> Option<SceneFrame> {
        self.scene
    }
}

impl<'a> FrameRecorder<'a> {
    pub(super) fn new(recording: &'a Recording<'a>, stored: &'a StoredFrames) -> Self {
        let size = recording.settings.size;
        let lens =
            |SceneCamera { site, look }: &SceneCamera| PinholeCamera::new(site, size).with_distortion(look.distortion);
        let lenses: Vec<PinholeCamera> = recording.settings.cameras.iter().map(lens).collect();
        let layers = || recording.recipe.layers.iter().map(|_| LastPng::default()).collect();
        let written = lenses.iter().map(|_| layers()).collect();
        Self { recording, stored, lenses, written }
    }

    /// What needs the simulator.
    pub(super) fn take<'m>(&self, step: SimulationStep<'m>) -> Result<CapturedFrame<'m>, GenerateError> {
        let SimulationStep { state, task } = step;
        let clock = self.recording.clock;
        let (truth, scene) = clock.time(Stage::Boxes, || (task.truth(&state), task.scene_frame(&state)));
        let frame = state.frame;
        let pictures = match self.read(frame)? {
            Some(layers) => FrameImages::Stored(layers),
            None => {
                let frames = clock.time(Stage::Render, || task.render(&state))?;
                self.refuse_other_frames(frame, &frames)?;
                FrameImages::Rendered(frames)
            }
        };
        Ok(CapturedFrame { frame, truth, scene, pictures })
    }

    fn refuse_other_frames(&self, frame: u32, frames: &[SensorFrame]) -> Result<(), SimulatorError> {
        let (expected, got) = (self.lenses.len(), frames.len());
        if got != expected {
            return Err(SimulatorError::CamerasMissing { frame, expected, got });
        }
        match frames.iter().find(|f| f.frame != frame) {
            Some(other) => Err(SimulatorError::FramesDropped { expected: frame, got: other.frame }),
            None => Ok(()),
        }
    }

    /// The frame if it is stored; a damaged one is rendered again.
    fn read(&self, frame: u32) -> Result<Option<Vec<StoredLayers>>, DatasetError> {
        if !self.stored.has(frame) {
            return Ok(None);
        }
        let Recording { recipe, layout, clock, .. } = *self.recording;
        let read = clock.time(Stage::Resume, || {
            layout.cameras(self.lenses.len()).map(|files| StoredLayers::read(&files, recipe, frame)).collect()
        });
        match read {
            Ok(layers) => Ok(Some(layers)),
            Err(DatasetError::Malformed { .. }) => Ok(None),
            Err(other) => Err(other),
        }
    }

    /// Images on disk, and what each camera's sink gets.
    pub(super) fn finish(&self, taken: &CapturedFrame<'_>) -> Result<Vec<SinkItem>, GenerateError> {
        let Recording { recipe, layout, clock, .. } = *self.recording;
        let cameras = self.lenses.iter().enumerate();
        match &taken.pictures {
            FrameImages::Stored(cameras_layers) => {
                let item = |((camera, lens), stored): ((usize, &PinholeCamera), &StoredLayers)| {
                    let depth = |pixel: usize| metres_from_rgb(stored.depth.data[pixel]);
                    let view = CameraView { number: camera, camera: lens, instance: &stored.instance, depth: &depth };
                    self.item(taken, &view, &stored.images)
                };
                cameras.zip(cameras_layers).map(item).collect()
            }
            FrameImages::Rendered(frames) => {
                let item = |((camera, lens), frame): ((usize, &PinholeCamera), &SensorFrame)| {
                    let write = || layers::write(&layout.camera(camera), recipe, frame, &self.written[camera], clock);
                    let images = clock.time(Stage::Images, write)?;
                    // As it is or would be stored: labels do not depend on which layers are.
                    let depth = |pixel: usize| metres_from_rgb(rgb_from_metres(frame.depth.data[pixel]));
                    let view = CameraView { number: camera, camera: lens, instance: &frame.instance, depth: &depth };
                    self.item(taken, &view, &images)
                };
                cameras.zip(frames).map(item).collect()
            }
        }
    }

    /// Labels, and pictures of videos.
    fn item(
        &self,
        taken: &CapturedFrame<'_>,
        view: &CameraView<'_>,
        images: &StoredImages<'_>,
    ) -> Result<SinkItem, GenerateError> {
        let line = self.labels(taken, view)?;
        let clock = self.recording.clock;
        let pictures = clock.time(Stage::Video, || {
            let picture = |(layer, image): &(Layer, StoredImage<'_>)| {
                let preview = (layer.entry().preview)(image);
                preview.map(|p| yuv_from_rgb(&p)).map_err(|reason| DatasetError::Video { reason })
            };
            images.iter().map(picture).collect::<Result<Vec<Yuv>, _>>()
        })?;
        Ok(SinkItem { line, pictures, scene: None })
    }

    /// All that is told of the objects that a camera sees.
    fn labels(&self, taken: &CapturedFrame<'_>, view: &CameraView<'_>) -> Result<FrameObjects, AnnotateError> {
        let Recording { settings, recipe, clock, .. } = *self.recording;
        let CapturedFrame { frame, truth, .. } = taken;
        let shapes = truth.shapes.as_deref().map(|shapes| shapes as &dyn ObjectShapes);
        let line = clock.time(Stage::Boxes, || {
            let visible = visible_objects(view.instance);
            let time_s = f64::from(*frame) / settings.fps;
            let line = annotate(*frame, time_s, &visible, &truth.objects, settings.size, recipe.min_pixels)?;
            Ok::<_, AnnotateError>(line.with_keypoints(&truth.bodies, view))
        })?;
        let line = match shapes {
            Some(shapes) => {
                let line = clock.time(Stage::Amodal, || line.with_amodal(shapes, view, recipe.amodal_masks));
                clock.time(Stage::Boxes, || line.with_boxes3d(shapes, view))
            }
            None => line,
        };
        Ok(clock.time(Stage::Boxes, || line.with_riders(shapes, view)))
    }
}
