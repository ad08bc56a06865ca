//! A frame as the recorder takes it.

use super::camera::Pictures;
use super::instances::{InstanceTable, SeenObjects};
use endless_annotate::{Box3d, CameraView, ObjectShapes, SceneObjects, WorldKeypoints};
use endless_pipeline::{RenderTask, SceneTruth, SimulatorError};
use endless_world::{Actor, InstanceId, SensorFrame, WorldState};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A frame whose pictures are here, and fit: they are decoded while the server makes the next ones.
pub(super) struct CarlaRenderTask {
    /// One a camera.
    seen: Vec<(Pictures, SeenObjects)>,
    stills: Vec<Actor>,
    boxes: BTreeMap<InstanceId, Box3d>,
}

impl CarlaRenderTask {
    pub(super) fn new(seen: Vec<(Pictures, SeenObjects)>, table: &InstanceTable) -> Self {
        Self { seen, stills: table.stills(), boxes: table.boxes().clone() }
    }
}

impl<'m> RenderTask<'m> for CarlaRenderTask {
    fn truth(&self, state: &WorldState) -> SceneTruth<'m> {
        SceneTruth {
            objects: SceneObjects::new(state, &self.stills),
            bodies: WorldKeypoints::new(),
            shapes: Some(Box::new(ActorBoxes(self.boxes.clone()))),
        }
    }

    fn render(self: Box<Self>, state: &WorldState) -> Result<Vec<SensorFrame>, SimulatorError> {
        let decoded = |(Pictures { rgb, depth, instance }, objects): (Pictures, SeenObjects)| SensorFrame {
            frame: state.frame,
            rgb: rgb.rgb(),
            depth: depth.depth(),
            instance: objects.instance(&instance),
            normals: None,
            albedo: None,
            shadow: None,
            body_parts: None,
            flow: None,
            flow_backward: None,
        };
        Ok(self.seen.into_iter().map(decoded).collect())
    }
}

/// A server tells the boxes of its actors, and not their shapes.
struct ActorBoxes(BTreeMap<InstanceId, Box3d>);

impl ObjectShapes for ActorBoxes {
    fn box3d(&self, id: InstanceId) -> Option<Box3d> {
        self.0.get(&id).copied()
    }

    fn covered(&self, _view: &CameraView<'_>, _id: InstanceId) -> Option<Arc<[u32]>> {
        None
    }

    fn image_bounds(&self, _view: &CameraView<'_>, _id: InstanceId) -> Option<[f32; 4]> {
        None
    }
}
