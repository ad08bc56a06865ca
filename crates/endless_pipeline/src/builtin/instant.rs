//! What moves at one instant, shared by all who need it: the renderer, labels, and the flow of the frames beside it.

use super::helped_once::HelpedOnce;
use endless_city::ActorModels;
use endless_render::{CoveredCentres, FrameScene};
use endless_traffic::{DrivingCondition, Simulation};
use endless_world::{SensorLayers, WorldState};
use std::sync::Arc;

/// A world state, and the scene that is made of it when it is first needed.
pub(super) struct SceneInstant {
    pub(super) state: WorldState,
    scene: HelpedOnce<Arc<FrameScene>>,
    /// Of each camera.
    pub(super) covered: Vec<CoveredCentres>,
}

/// The instants before and after one, as far as anybody asks for them.
#[derive(Clone, Default)]
pub(super) struct NeighbourInstants {
    pub(super) before: Option<Arc<SceneInstant>>,
    pub(super) after: Option<Arc<SceneInstant>>,
}

impl SceneInstant {
    pub(super) fn new(state: WorldState, cameras: usize) -> Self {
        let covered = (0..cameras).map(|_| CoveredCentres::default()).collect();
        Self { state, scene: HelpedOnce::default(), covered }
    }

    /// What moves then, made once: who needs it while another makes it helps.
    pub(super) fn scene(&self, models: &ActorModels) -> Arc<FrameScene> {
        Arc::clone(self.scene.get_or_make(|| Arc::new(models.frame_scene(&self.state))))
    }
}

/// Gives one instant after the other, and ticks ahead where a frame needs to know the next.
pub(super) struct InstantSource {
    simulation: Simulation,
    wanted: SensorLayers,
    cameras: usize,
    /// Of the video.
    frames: u32,
    begun: bool,
    /// The one that was given out last, where frames need those beside them.
    last: Option<Arc<SceneInstant>>,
    /// The one that follows it, if the simulation is ahead.
    ahead: Option<Arc<SceneInstant>>,
}

impl InstantSource {
    /// For these layers of a video of so many cameras and frames.
    pub(super) fn new(simulation: Simulation, wanted: SensorLayers, cameras: usize, frames: u32) -> Self {
        Self { simulation, wanted, cameras, frames, begun: false, last: None, ahead: None }
    }

    /// The next instant and those beside it, as far as the layers ask for them. The last frame has none after it, although
    /// the simulation could go on. `condition` tells the weather of a frame.
    pub(super) fn next(
        &mut self,
        condition: impl Fn(u32) -> DrivingCondition,
    ) -> (Arc<SceneInstant>, NeighbourInstants) {
        let instant = self.ahead.take().unwrap_or_else(|| self.advance(&condition));
        if !self.wanted.needs_neighbours() {
            return (instant, NeighbourInstants::default());
        }
        let before = self.last.replace(Arc::clone(&instant)).filter(|_| self.wanted.flow_backward);
        let goes_on = self.wanted.flow && instant.state.frame + 1 < self.frames;
        self.ahead = goes_on.then(|| self.advance(&condition));
        (instant, NeighbourInstants { before, after: self.ahead.clone() })
    }

    fn advance(&mut self, condition: impl Fn(u32) -> DrivingCondition) -> Arc<SceneInstant> {
        if self.begun {
            self.simulation.tick();
        }
        self.begun = true;
        let state = self.simulation.state();
        // From this frame to the next.
        self.simulation.set_condition(condition(state.frame + 1));
        Arc::new(SceneInstant::new(state, self.cameras))
    }
}
