//! The shapes of objects, and where these are.

use crate::rounding::{hundredths, thousandths};
use crate::{Box3d, Box3dRecord, CameraView};
use endless_world::InstanceId;
use glam::Vec3;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The shapes of a scene's objects at one instant.
pub trait ObjectShapes {
    /// The box around an object; `None` if there is no such object.
    fn box3d(&self, id: InstanceId) -> Option<Box3d>;

    /// The pixels of a camera's picture, by row-major index, that an object would show by itself: at least all those that
    /// show something else now.
    fn covered(&self, view: &CameraView<'_>, id: InstanceId) -> Option<Arc<[u32]>>;

    /// The rectangle around an object's projection, `[left, top, right, bottom]` in pixels, also beyond the picture.
    fn image_bounds(&self, view: &CameraView<'_>, id: InstanceId) -> Option<[f32; 4]>;
}

/// Where an object is, as `objects.jsonl` has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Spatial {
    /// The box around it.
    pub box3d: Box3dRecord,
    /// From the lens to the box's middle, metres.
    pub distance_m: f64,
    /// Velocity of the box's middle in the picture, pixels a second; `null` if that lies beside or behind the camera.
    pub image_velocity_pxps: Option<[f64; 2]>,
}

impl Spatial {
    /// Of an object with this velocity in the world.
    pub(crate) fn new(around: &Box3d, velocity_mps: Vec3, view: &CameraView<'_>) -> Self {
        // As far as it gets in a thousandth of a second, before and after: the way there and back bends as the lens does.
        let beside = |seconds: f32| view.camera.project(around.centre + velocity_mps * seconds).map(|(at, _)| at);
        const STEP_S: f32 = 1e-2;
        let image_velocity = beside(STEP_S)
            .zip(beside(-STEP_S))
            .map(|(after, before)| view.camera.way_in_image(before, after) / (2.0 * STEP_S));
        Self {
            box3d: around.record(view.camera),
            distance_m: thousandths(view.camera.position.distance(around.centre)),
            image_velocity_pxps: image_velocity.map(|v| v.to_array().map(hundredths)),
        }
    }
}
