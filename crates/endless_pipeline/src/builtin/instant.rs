//! What moves at one instant, shared by all who need it: the renderer, labels, and the flow of the frames beside it.

use endless_city::ActorModels;
use endless_render::FrameScene;
use endless_world::WorldState;
use std::sync::{Arc, Mutex, PoisonError};

/// A world state, and the scene that is made of it when it is first needed.
pub(super) struct SceneInstant {
    pub(super) state: WorldState,
    scene: Mutex<Option<Arc<FrameScene>>>,
}

/// The instants before and after one, as far as anybody asks for them.
#[derive(Clone, Default)]
pub(super) struct NeighbourInstants {
    pub(super) before: Option<Arc<SceneInstant>>,
    pub(super) after: Option<Arc<SceneInstant>>,
}

impl SceneInstant {
    pub(super) fn new(state: WorldState) -> Self {
        Self { state, scene: Mutex::default() }
    }

    /// What moves then. It is made outside the lock, by all threads: one that waited for it might be the one that must
    /// help. So two that ask at the same time may both make it; either is right, and one is kept.
    pub(super) fn scene(&self, models: &ActorModels) -> Arc<FrameScene> {
        let known = || self.scene.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(scene) = &*known() {
            return Arc::clone(scene);
        }
        let made = Arc::new(models.frame_scene(&self.state));
        Arc::clone(known().get_or_insert(made))
    }
}
