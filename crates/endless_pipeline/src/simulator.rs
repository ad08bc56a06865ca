//! What simulates and renders: the built-in city, a CARLA server, a test double. Everything after it is the same code.

use endless_annotate::Bodies;
use endless_dataset::Spawned;
use endless_world::{Actor, CameraSite, InstanceId, SceneSettings, SensorFrame, WorldState};
use std::collections::BTreeMap;

/// What a simulator says when it cannot do what it is asked.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct SimulatorError(pub String);

/// Which maps there are and where their cameras hang.
pub trait MapCatalog {
    /// Names of the maps that are used if none is named, in canonical order.
    fn maps(&self) -> Vec<String>;

    /// Names of further maps that can be named: those that the user imported.
    fn imported(&self) -> Vec<String> {
        Vec::new()
    }

    /// Hash of an imported map's file; `None` for maps that come with the program.
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

    /// One sentence on a map's character.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made.
    fn summary(&self, map: &str) -> Result<String, SimulatorError>;

    /// The camera sites of a map, in canonical order.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made.
    fn cameras(&self, map: &str) -> Result<Vec<CameraSite>, SimulatorError>;
}

/// Loads maps and scenes of them, and renders what fixed cameras see.
pub trait Simulator: MapCatalog + Sync {
    /// A loaded map, shared by all of its scenes.
    type Map: Sync;

    /// Loads a map.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made.
    fn load_map(&self, name: &str) -> Result<Self::Map, SimulatorError>;

    /// Populates a map: cheap against [`Self::bake`].
    ///
    /// # Errors
    /// When the scene cannot be made.
    fn load_scene<'m>(&'m self, map: &'m Self::Map, settings: &SceneSettings) -> Result<Scene<'m>, SimulatorError>;

    /// Prepares the cameras of a scene in which these actors move. May take long and use all cores; left out where no frame must be rendered.
    ///
    /// # Errors
    /// When the scene cannot be made.
    fn bake<'m>(
        &'m self,
        map: &'m Self::Map,
        settings: &SceneSettings,
        moving: &[Actor],
    ) -> Result<Box<dyn Cameras + 'm>, SimulatorError>;
}

/// A populated scene, before its first frame.
pub struct Scene<'m> {
    /// What was really placed.
    pub spawned: Spawned,
    /// Parked vehicles, which no [`WorldState`] lists.
    pub parked: Vec<Actor>,
    /// Everything that moves, as it stands in frame 0. Nothing appears later.
    pub moving: Vec<Actor>,
    /// Skin of people and riders, 1 to 10 on the Monk scale, where it is known.
    pub skin_tones: BTreeMap<InstanceId, u8>,
    /// Who knows where people's keypoints are, if anybody does.
    pub bodies: Option<Box<dyn PeopleBodies + 'm>>,
    /// What moves.
    pub traffic: Box<dyn Traffic + 'm>,
}

/// Knows the bodies of people.
pub trait PeopleBodies: Sync {
    /// Keypoints of people and riders at an instant. A pure function of the state.
    fn at(&self, state: &WorldState) -> Bodies;
}

/// The moving part of a scene.
pub trait Traffic: Send {
    /// The state of the next frame; the first call gives frame 0.
    fn tick(&mut self) -> WorldState;
}

/// Cameras ready to film.
pub trait Cameras: Sync + Send {
    /// What each sees, in the order of the settings. A pure function of the state: frames can be rendered in any order, on any number of threads.
    fn render(&self, state: &WorldState) -> Vec<SensorFrame>;

    /// What rendering has cost until now.
    fn stats(&self) -> RenderStats {
        RenderStats::default()
    }
}

/// Counters of a renderer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RenderStats {
    /// Rays traced for the static bake.
    pub bake_rays: u64,
    /// Rays traced for frames.
    pub frame_rays: u64,
}
