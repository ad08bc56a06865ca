//! The interface of simulators: the built-in city, a remote server, a test double. All later stages are the same for each.

use crate::SimulatorError;
use endless_annotate::{
    ActorRecord, BodySize, MapFeatures, ObjectShapes, RoadFacts, SceneFrame, SceneObjects, WorldKeypoints,
};
use endless_dataset::{Recipe, SpawnCounts};
use endless_road::{Georeference, JunctionPlace};
use endless_world::{
    Actor, CameraSite, InstanceId, LidarSweep, RadarScan, SceneSettings, SensorFrame, SensorLayers, SensorPose,
    StagedIncidents, ViewSubject, WorldState,
};
use std::{collections::BTreeMap, time::Duration};

/// The maps that a recipe can name, and the hashes of imported files.
pub trait MapSource {
    /// The maps that are used by default, in canonical order.
    fn maps(&self) -> Vec<String>;

    /// The maps that the user imported, which are used only if named.
    fn imported(&self) -> Vec<String> {
        Vec::new()
    }

    /// Name of the random map of a number; `None` of simulators that have none.
    fn random_map(&self, _number: u32) -> Option<String> {
        None
    }

    /// Hash of an imported map's file; `None` for maps that come with the simulator.
    ///
    /// # Errors
    /// When the map cannot be read.
    fn content_hash(&self, _map: &str) -> Result<Option<String>, SimulatorError> {
        Ok(None)
    }

    /// The file of recorded tracks that is played, if one is.
    fn track_file(&self) -> Option<TrackFileSummary> {
        None
    }

    /// What in that file does not fit a recipe: one line for each kind of thing.
    ///
    /// # Errors
    /// When nobody would be seen on the map, or the map cannot be read.
    fn track_notes(&self, _recipe: &Recipe) -> Result<Vec<String>, SimulatorError> {
        Ok(Vec::new())
    }

    /// Whether a recipe asks for nothing that this simulator cannot make.
    ///
    /// # Errors
    /// What it cannot make.
    fn accepts(&self, _recipe: &Recipe) -> Result<(), SimulatorError> {
        Ok(())
    }

    /// Hashes of the files of imported models, by their names.
    fn asset_files(&self) -> BTreeMap<String, String> {
        BTreeMap::new()
    }
}

/// What a recipe needs to know of a file of recorded tracks.
#[derive(Debug, Clone, PartialEq)]
pub struct TrackFileSummary {
    /// Hash of its bytes.
    pub content_hash: String,
    /// The first instant at which anybody is there, on the file's clock, seconds.
    pub begin_s: f64,
    /// The last one.
    pub end_s: f64,
    /// Whether it has vehicles.
    pub vehicles: bool,
    /// Whether it has people on foot.
    pub people: bool,
}

/// The cameras of a scene that are to be drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SiteRequest {
    /// The map on which they are.
    pub map: String,
    /// By which they are drawn.
    pub seed: u64,
    /// By which the map's town is dressed; `None`: as it usually is.
    pub town_seed: Option<u64>,
    /// How many.
    pub cameras: u32,
    /// Whether they see the same street.
    pub overlapping: bool,
    /// What they look at.
    pub views: Vec<ViewSubject>,
}

/// The camera sites of each map.
pub trait MapCatalog {
    /// The camera sites of a map, in canonical order.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made.
    fn cameras(&self, map: &str) -> Result<Vec<CameraSite>, SimulatorError>;

    /// New camera sites for each of these scenes; `None` where the map has no such views. Scenes of one town that follow one
    /// another cost one look at it.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made, or the simulator draws no cameras.
    fn draw_sites(&self, _scenes: &[SiteRequest]) -> Result<Vec<Option<Vec<CameraSite>>>, SimulatorError> {
        Err(SimulatorError::Unsupported {
            what: "drawn camera sites".to_owned(),
            instead: "use --sites fixed, or the built-in simulator",
        })
    }

    /// Of other places of a map's cameras, which see about as much of the street as the usual ones; any, where nobody
    /// knows. Each is a pair: the usual, the moved.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made.
    fn see_as_well(&self, _map: &str, moved: &[[CameraSite; 2]]) -> Result<Vec<bool>, SimulatorError> {
        Ok(vec![true; moved.len()])
    }

    /// Numbers of a map's places of vehicles and people that each of these sites sees, ascending; where nobody knows, all
    /// see the same one.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made.
    fn places_seen(&self, _map: &str, sites: &[CameraSite]) -> Result<Vec<Vec<u32>>, SimulatorError> {
        Ok(vec![vec![0]; sites.len()])
    }

    /// The largest junction of a map: that with the most lanes; `None` where there is none, or nobody
    /// knows.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made.
    fn largest_junction(&self, _map: &str) -> Result<Option<JunctionPlace>, SimulatorError> {
        Ok(None)
    }

    /// Heights of the ground at places east and north of a map's origin, metres; `None` where nobody knows.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made.
    fn ground(&self, _map: &str, places: &[[f64; 2]]) -> Result<Vec<Option<f64>>, SimulatorError> {
        Ok(vec![None; places.len()])
    }
}

/// The capabilities of a simulator, by which recording schedules its work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Capabilities {
    /// Frames can be rendered while the session ticks on, several at the same time and in any order. Otherwise each frame
    /// is rendered before the next tick.
    pub random_access: bool,
    /// The same settings give the same video every time. Otherwise an interrupted video is recorded again.
    pub repeatable: bool,
    /// A tick is a wait for another program: there is one worker more than there are threads, as one of them only waits.
    pub waits: bool,
}

/// A map, and what for it is loaded.
#[derive(Debug, Clone, Copy)]
pub struct MapUse<'a> {
    /// Its name.
    pub name: &'a str,
    /// All cameras that may film it: the same for all videos of a recipe, whichever of them are still to be made.
    pub cameras: &'a [CameraSite],
    /// The videos to come, in order of work.
    pub videos: &'a [&'a SceneSettings],
}

/// Loads maps and opens sessions on them.
pub trait Simulator: MapCatalog + Sync {
    /// A loaded map, shared by all of its sessions.
    type Map: Sync;

    /// Its capabilities.
    fn capabilities(&self) -> Capabilities;

    /// Loads a map.
    ///
    /// # Errors
    /// When there is no such map, it cannot be made, or the simulator cannot be reached.
    fn load_map(&self, wanted: &MapUse<'_>) -> Result<Self::Map, SimulatorError>;

    /// After a failure that may pass: waits until the map can be loaded again and the video begun again. `failures` is how
    /// often this video has failed, from 1.
    ///
    /// # Errors
    /// The failure, when trying again helps nothing or has been tried often enough.
    fn recover(&self, failure: SimulatorError, _failures: u32) -> Result<(), SimulatorError> {
        Err(failure)
    }

    /// What a map has on and beside its roads, of simulators that know: each camera gets a `map.json` then.
    fn map_features<'m>(&self, _map: &'m Self::Map) -> Option<&'m MapFeatures> {
        None
    }

    /// Where on Earth a map lies.
    fn georeference(&self, _map: &Self::Map) -> Georeference {
        Georeference::default()
    }

    /// Populates a map. Cheap, compared with [`SimulationSession::prepare`]. Its sensor frames have the images that are
    /// `wanted` of any camera, and may lack those that are not.
    ///
    /// # Errors
    /// When the scene cannot be made, or the simulator cannot be reached.
    fn open_session<'m>(
        &'m self,
        map: &'m Self::Map,
        settings: &'m SceneSettings,
        wanted: SensorLayers,
    ) -> Result<Box<dyn SimulationSession<'m> + 'm>, SimulatorError>;
}

/// One populated scene. It is passed between threads and used by one at a time.
pub trait SimulationSession<'m>: Send {
    /// The numbers of actors that were placed.
    fn spawned(&self) -> SpawnCounts;

    /// What came of the events that the settings ask for.
    fn incidents(&self) -> StagedIncidents {
        StagedIncidents::default()
    }

    /// What stays the same of every object that may appear, riders and parked ones included, by ascending id; `None` if
    /// that is not known before they appear.
    fn actors(&self) -> Option<Vec<ActorRecord>> {
        None
    }

    /// Prepares for rendering, before the first tick. May take long and use all threads. Not called if all frames are
    /// stored already; rendering must work without it.
    ///
    /// # Errors
    /// When the simulator fails.
    fn prepare(&mut self) -> Result<(), SimulatorError> {
        Ok(())
    }

    /// Advances by one frame; the first call gives frame 0.
    ///
    /// # Errors
    /// When the simulator fails; the session is not used afterwards.
    fn tick(&mut self) -> Result<SimulationStep<'m>, SimulatorError>;

    /// Who carries a sensor of the rig, by its place in the settings.
    fn carrier(&self, _sensor: usize) -> Option<InstanceId> {
        None
    }

    /// What carriers of sensors may touch, if there are sensors that notice it.
    fn bodies(&self) -> SceneBodies {
        SceneBodies::default()
    }

    /// What relations and events are judged by: lanes, lights, and how large those who move are.
    fn road_facts(&self) -> RoadFacts {
        RoadFacts::default()
    }

    /// Statistics of rendering so far.
    fn stats(&self) -> RenderStats {
        RenderStats::default()
    }
}

/// The bodies of a scene on the ground.
#[derive(Debug, Clone, Default)]
pub struct SceneBodies {
    /// How large everybody is.
    pub sizes: BTreeMap<InstanceId, BodySize>,
    /// Those that world states leave out: parked vehicles.
    pub still: Vec<Actor>,
}

/// The world at one instant, and its render task.
pub struct SimulationStep<'m> {
    /// The world state. Actors may appear and disappear between frames.
    pub state: WorldState,
    /// Renders it.
    pub task: Box<dyn RenderTask<'m> + 'm>,
}

/// Renders the world at one instant and knows its ground truth.
pub trait RenderTask<'m>: Send {
    /// The ground truth that labels are made of.
    fn truth(&self, state: &WorldState) -> SceneTruth<'m> {
        SceneTruth { objects: SceneObjects::new(state, &[]), bodies: WorldKeypoints::new(), shapes: None }
    }

    /// The line of `frames.jsonl`, of simulators that know what it tells; then of every frame.
    fn scene_frame(&self, _state: &WorldState) -> Option<SceneFrame> {
        None
    }

    /// Where a sensor of the rig is, by its place in the settings.
    ///
    /// # Errors
    /// When the simulator has no such sensors.
    fn sensor_pose(&self, _state: &WorldState, _sensor: usize) -> Result<SensorPose, SimulatorError> {
        Err(SimulatorError::NoRigs)
    }

    /// What a camera, an event camera, a LiDAR or a radar of the rig measures. Called before [`Self::render`], of those that measure at this frame.
    ///
    /// # Errors
    /// When the simulator fails, or has no such sensors.
    fn sense(&self, _state: &WorldState, _sensor: usize) -> Result<SensorReading, SimulatorError> {
        Err(SimulatorError::NoRigs)
    }

    /// The sensor frame of each of the scene's cameras, in the order of the settings. Without [`Capabilities::random_access`] it is called before the
    /// next tick. Not called for frames that are stored already.
    ///
    /// # Errors
    /// When the simulator fails, or gives another frame than this one.
    fn render(self: Box<Self>, state: &WorldState) -> Result<Vec<SensorFrame>, SimulatorError>;
}

/// What a sensor of a rig measured.
pub enum SensorReading {
    /// Of a camera, or the picture from which an event camera's events are made.
    Camera(Box<SensorFrame>),
    /// Of a LiDAR.
    Lidar(LidarSweep),
    /// Of a radar.
    Radar(RadarScan),
}

/// The ground truth of a scene at one instant, visible or not.
pub struct SceneTruth<'m> {
    /// All objects, parked ones included.
    pub objects: SceneObjects,
    /// Where the keypoints of people and riders are, of those of whom it is known.
    pub bodies: WorldKeypoints,
    /// The shapes of all objects, if they are known: they are asked of those that a camera sees.
    pub shapes: Option<Box<dyn ObjectShapes + Send + 'm>>,
}

/// Counters of a renderer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RenderStats {
    /// Rays traced for the static bake.
    pub bake_rays: u64,
    /// Rays traced for frames.
    pub frame_rays: u64,
    /// Wall time of the static bake, with all threads; the models of what moves are left out.
    pub bake: Duration,
}
