//! A frame as the recorder takes it.

use super::instances::InstanceTable;
use endless_annotate::{Box3d, CameraView, ObjectShapes, SceneObjects, WorldKeypoints};
use endless_pipeline::{RenderTask, SceneTruth, SimulatorError};
use endless_world::{Actor, InstanceId, SensorFrame, WorldState};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A frame whose pictures are here.
pub(super) struct CarlaRenderTask {
    frames: Vec<SensorFrame>,
    stills: Vec<Actor>,
    boxes: BTreeMap<InstanceId, Box3d>,
}

impl CarlaRenderTask {
    pub(super) fn new(frames: Vec<SensorFrame>, table: &InstanceTable) -> Self {
        Self { frames, stills: table.stills(), boxes: table.boxes().clone() }
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

    fn render(self: Box<Self>, _state: &WorldState) -> Result<Vec<SensorFrame>, SimulatorError> {
        Ok(self.frames)
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
