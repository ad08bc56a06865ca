//! One frame of all cameras: rendered and written, or read back when it is there already.

use super::{Recording, sink::SinkItem, stored::StoredFrames, times::Stage};
use crate::{Cameras, GenerateError, PeopleBodies};
use endless_annotate::{Bodies, Picture, SceneObjects, annotate, visible_objects};
use endless_dataset::{
    CameraLayout, DatasetError, Layer, RgbFormat, Yuv, decode_jpg, depth_from_rgb, depth_preview, encode_jpg,
    encode_png, instance_from_rgb, instance_preview, metres_from_rgb, read_rgb, rgb_from_depth, rgb_from_instance,
    write_atomic, yuv_from_rgb,
};
use endless_world::{Actor, Image, InstanceId, InstancePixel, PinholeCamera, SensorFrame, WorldState};
use std::collections::BTreeMap;

pub(super) struct FrameMaker<'a> {
    pub(super) recording: &'a Recording<'a>,
    pub(super) parked: &'a [Actor],
    pub(super) skin_tones: &'a BTreeMap<InstanceId, u8>,
    pub(super) bodies: Option<&'a dyn PeopleBodies>,
    /// One a camera.
    pub(super) lenses: &'a [PinholeCamera],
    pub(super) stored: &'a StoredFrames,
}

/// What the ordered work of one camera needs of a frame.
struct Layers {
    rgb: Option<Image<[u8; 3]>>,
    /// As it is stored.
    depth: Option<Image<[u8; 3]>>,
    instance: Image<InstancePixel>,
}

/// What is known of a frame beside its pictures.
struct Known<'a> {
    state: &'a WorldState,
    scene: SceneObjects,
    bodies: Bodies,
}

impl FrameMaker<'_> {
    /// The frame, and whether it was there already. `None` when there are no cameras to render with.
    pub(super) fn make<'c>(
        &self,
        state: &WorldState,
        cameras: impl Fn() -> Option<&'c (dyn Cameras + 'c)>,
    ) -> Result<Option<(Vec<SinkItem>, bool)>, GenerateError> {
        let known = self.recording.clock.time(Stage::Boxes, || Known {
            state,
            scene: SceneObjects::new(state, self.parked).with_skin_tones(self.skin_tones),
            bodies: self.bodies.map(|bodies| bodies.at(state)).unwrap_or_default(),
        });
        if self.stored.has(state.frame) {
            let read = self.recording.clock.time(Stage::Resume, || -> Result<Vec<Layers>, DatasetError> {
                (0..self.lenses.len()).map(|camera| self.read(camera, state.frame)).collect()
            });
            match read {
                Ok(layers) => return Ok(Some((self.items(&layers, &known)?, true))),
                // Somebody spoilt the image: it is made again.
                Err(DatasetError::Malformed { .. }) => {}
                Err(other) => return Err(other.into()),
            }
        }
        let Some(cameras) = cameras() else { return Ok(None) };
        let frames = self.recording.clock.time(Stage::Render, || cameras.render(state));
        let layers = self.recording.clock.time(Stage::Images, || -> Result<Vec<Layers>, DatasetError> {
            frames.into_iter().enumerate().map(|(camera, frame)| self.write(camera, frame)).collect()
        })?;
        Ok(Some((self.items(&layers, &known)?, false)))
    }

    fn items(&self, layers: &[Layers], known: &Known<'_>) -> Result<Vec<SinkItem>, GenerateError> {
        layers.iter().enumerate().map(|(camera, layers)| self.item(camera, layers, known)).collect()
    }

    fn wants_video(&self, layer: Layer) -> bool {
        self.recording.recipe.mp4.contains(&layer)
    }

    fn read(&self, camera: usize, frame: u32) -> Result<Layers, DatasetError> {
        let recipe = self.recording.recipe;
        let files = self.recording.layout.camera(camera);
        let load = |layer: Layer| {
            let format = if layer == Layer::Rgb { recipe.rgb_format } else { RgbFormat::Png };
            let path = files.frame(layer, frame, recipe);
            let image = read_rgb(&path, format)?;
            if image.size == recipe.size { Ok(image) } else { Err(DatasetError::malformed(path, "has another size")) }
        };
        // All are decoded, also those that are not used, so that a spoilt one is noticed.
        let mut layers = Layers { rgb: None, depth: None, instance: Image { size: recipe.size, data: Vec::new() } };
        for &layer in &recipe.layers {
            let image = load(layer)?;
            match layer {
                Layer::Rgb => layers.rgb = Some(image),
                Layer::Depth => layers.depth = Some(image),
                Layer::Instance => {
                    let path = files.frame(layer, frame, recipe);
                    layers.instance = instance_from_rgb(&image)
                        .map_err(|tag| DatasetError::malformed(path, format!("has the tag {tag}")))?;
                }
            }
        }
        Ok(layers)
    }

    fn write(&self, camera: usize, frame: SensorFrame) -> Result<Layers, DatasetError> {
        let recipe = self.recording.recipe;
        let files: CameraLayout = self.recording.layout.camera(camera);
        let mut layers = Layers { rgb: None, depth: None, instance: frame.instance };
        for &layer in &recipe.layers {
            let path = files.frame(layer, frame.frame, recipe);
            match (layer, recipe.rgb_format) {
                (Layer::Rgb, RgbFormat::Png) => {
                    write_atomic(&path, &encode_png(&frame.rgb))?;
                }
                (Layer::Rgb, RgbFormat::Jpg) => {
                    let bytes = encode_jpg(&frame.rgb).map_err(|reason| DatasetError::malformed(&path, reason))?;
                    write_atomic(&path, &bytes)?;
                    // The video is made of the frames as they lie on disk, so that a resumed one is the same.
                    if self.wants_video(layer) {
                        let stored = decode_jpg(&bytes).map_err(|reason| DatasetError::malformed(&path, reason))?;
                        layers.rgb = Some(stored);
                    }
                }
                (Layer::Depth, _) => {
                    let encoded = rgb_from_depth(&frame.depth);
                    write_atomic(&path, &encode_png(&encoded))?;
                    layers.depth = Some(encoded);
                }
                (Layer::Instance, _) => {
                    write_atomic(&path, &encode_png(&rgb_from_instance(&layers.instance)))?;
                }
            }
        }
        if recipe.rgb_format == RgbFormat::Png {
            layers.rgb = Some(frame.rgb);
        }
        Ok(layers)
    }

    fn item(&self, camera: usize, layers: &Layers, known: &Known<'_>) -> Result<SinkItem, GenerateError> {
        let Recording { settings, recipe, clock, .. } = *self.recording;
        let Known { state, scene, bodies } = known;
        let line = clock.time(Stage::Boxes, || {
            let visible = visible_objects(&layers.instance);
            let time_s = f64::from(state.frame) / settings.fps;
            let line = annotate(state.frame, time_s, &visible, scene, settings.size, recipe.min_pixels)?;
            // By the depth as it is stored, so that a resumed video is the same.
            let depth = layers.depth.as_ref().map(|image| |pixel: usize| metres_from_rgb(image.data[pixel]));
            let depth = depth.as_ref().map(|of| of as &dyn Fn(usize) -> f32);
            let picture = Picture { camera: &self.lenses[camera], instance: &layers.instance, depth };
            Ok::<_, GenerateError>(line.with_keypoints(bodies, &picture))
        })?;
        let pictures = clock.time(Stage::Video, || {
            let picture = |layer: &Layer| match layer {
                Layer::Rgb => layers.rgb.as_ref().map(yuv_from_rgb),
                Layer::Depth => layers.depth.as_ref().map(|d| yuv_from_rgb(&depth_preview(&depth_from_rgb(d)))),
                Layer::Instance => Some(yuv_from_rgb(&instance_preview(&layers.instance))),
            };
            recipe.mp4.iter().filter_map(picture).collect::<Vec<Yuv>>()
        });
        Ok(SinkItem { line, pictures })
    }
}
