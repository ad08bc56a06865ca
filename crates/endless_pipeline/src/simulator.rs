//! What simulates and renders: the built-in city, a server elsewhere, a test double. Everything after it is the same code.

use crate::SimulatorError;
use endless_annotate::{SceneObjects, WorldKeypoints};
use endless_dataset::SpawnCounts;
use endless_world::{CameraSite, SceneSettings, SensorFrame, WorldState};
use std::collections::BTreeMap;

/// Which maps a recipe can name, and of which files they and their models are made.
pub trait MapSource {
    /// Names of the maps that are used if none is named, in canonical order.
    fn maps(&self) -> Vec<String>;

    /// Names of further maps that can be named: those that the user imported.
    fn imported(&self) -> Vec<String> {
        Vec::new()
    }

    /// Hash of an imported map's file; `None` for maps that come with the simulator.
    ///
    /// # Errors
    /// When the map cannot be read.
    fn content_hash(&self, _map: &str) -> Result<Option<String>, SimulatorError> {
        Ok(None)
    }

    /// Hashes of the files of imported models, by their names.
    fn asset_files(&self) -> BTreeMap<String, String> {
        BTreeMap::new()
    }
}

/// Where the cameras of each map hang.
pub trait MapCatalog {
    /// The camera sites of a map, in canonical order.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made.
    fn cameras(&self, map: &str) -> Result<Vec<CameraSite>, SimulatorError>;
}

/// What a simulator can do: by this, recording chooses how it works.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Capabilities {
    /// A frame can be rendered while the session goes on, several at the same time and in any order. Else each is
    /// rendered before the next tick.
    pub random_access: bool,
    /// The same settings give the same video every time. Else a video that was interrupted is begun again.
    pub repeatable: bool,
}

/// Loads maps and opens sessions on them.
pub trait Simulator: MapCatalog + Sync {
    /// A loaded map, shared by all of its sessions.
    type Map: Sync;

    /// What it can do.
    fn capabilities(&self) -> Capabilities;

    /// Loads a map.
    ///
    /// # Errors
    /// When there is no such map, it cannot be made, or the simulator cannot be reached.
    fn load_map(&self, name: &str) -> Result<Self::Map, SimulatorError>;

    /// Populates a map: cheap against [`SimulationSession::prepare`].
    ///
    /// # Errors
    /// When the scene cannot be made, or the simulator cannot be reached.
    fn open_session<'m>(
        &'m self,
        map: &'m Self::Map,
        settings: &'m SceneSettings,
    ) -> Result<Box<dyn SimulationSession<'m> + 'm>, SimulatorError>;
}

/// One populated scene. It is passed from thread to thread, and used by one at a time.
pub trait SimulationSession<'m>: Send {
    /// What was really placed.
    fn spawned(&self) -> SpawnCounts;

    /// Makes ready to render, before the first tick. May take long and use all threads; left out where no frame must be
    /// rendered, and frames can be rendered without.
    ///
    /// # Errors
    /// When the simulator fails.
    fn prepare(&mut self) -> Result<(), SimulatorError> {
        Ok(())
    }

    /// Goes on by a frame; the first call gives frame 0.
    ///
    /// # Errors
    /// When the simulator fails: the session is not used any more.
    fn tick(&mut self) -> Result<SimulationStep<'m>, SimulatorError>;

    /// What rendering has cost until now.
    fn stats(&self) -> RenderStats {
        RenderStats::default()
    }
}

/// One instant of a session.
pub struct SimulationStep<'m> {
    /// The world. Actors may come and go from frame to frame.
    pub state: WorldState,
    /// Shows it.
    pub task: Box<dyn RenderTask + 'm>,
}

/// Shows the world at one instant.
pub trait RenderTask: Send {
    /// Everything that labels can speak of at this instant.
    fn truth(&self, state: &WorldState) -> SceneTruth {
        SceneTruth { objects: SceneObjects::new(state, &[]), bodies: WorldKeypoints::new() }
    }

    /// What each camera sees, in the order of the settings. Without [`Capabilities::random_access`] it is called before the
    /// next tick. Not called for frames that are stored already.
    ///
    /// # Errors
    /// When the simulator fails, or gives another frame than this one.
    fn render(self: Box<Self>, state: &WorldState) -> Result<Vec<SensorFrame>, SimulatorError>;
}

/// What is known of a scene at one instant, seen or not.
pub struct SceneTruth {
    /// All objects, parked ones included.
    pub objects: SceneObjects,
    /// Where the keypoints of people and riders are, of those of whom it is known.
    pub bodies: WorldKeypoints,
}

/// Counters of a renderer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RenderStats {
    /// Rays traced for the static bake.
    pub bake_rays: u64,
    /// Rays traced for frames.
    pub frame_rays: u64,
}
