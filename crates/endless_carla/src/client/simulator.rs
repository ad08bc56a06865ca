//! A CARLA server as a simulator.

use super::error::ClientError;
use super::fleet::Fleet;
use super::map::{CarlaMap, PlannedMap, hash};
use super::patience::Wait;
use super::server::{CarlaSettings, Server, ServerState};
use super::session::{CarlaSession, clock};
use super::sites::sites;
use super::world::World;
use endless_dataset::Recipe;
use endless_pipeline::{Capabilities, MapCatalog, MapSource, MapUse, SimulationSession, Simulator, SimulatorError};
use endless_road::{Georeference, JunctionPlace};
use endless_world::{CameraSite, LensModel, PerVideo, SceneSettings, SensorLayers};
use std::sync::{Arc, OnceLock};
use std::time::Duration;

/// The maps of the paper; those of some servers are called `Town01_Opt`.
const STANDARD: [&str; 8] = ["Town01", "Town02", "Town03", "Town04", "Town05", "Town06", "Town07", "Town10HD"];
/// How often a video is begun again.
const MOST_FAILURES: u32 = 20;
/// Time between attempts to connect again.
const AGAIN: Duration = Duration::from_millis(300);
/// The clock's step while a map is planned, seconds.
const STEP_S: f64 = 0.05;

/// Simulates and renders on a CARLA server.
pub struct CarlaSimulator {
    server: Server,
    maps: Vec<String>,
    fleet: OnceLock<Arc<Fleet>>,
}

impl CarlaSimulator {
    /// Connects to a server.
    ///
    /// # Errors
    /// When there is none, or it speaks something else.
    pub fn connect(settings: CarlaSettings) -> Result<Self, SimulatorError> {
        let address = settings.address.to_string();
        let connect = || {
            let mut world = World::connect(&settings.address, settings.frame_limit, &settings.stop)?;
            let maps = world.available_maps()?;
            Ok((world, maps))
        };
        let (world, maps) = connect().map_err(|error: ClientError| error.at(&address))?;
        Ok(Self { server: Server::new(settings, world), maps, fleet: OnceLock::new() })
    }

    /// A map, planned; it is loaded for that unless it is known. A server that goes meanwhile is waited for.
    fn planned(&self, map: &str) -> Result<Arc<PlannedMap>, SimulatorError> {
        let mut failures = 0;
        loop {
            match self.known_or_planned(map) {
                Err(error) if error.is_passing() => {
                    failures += 1;
                    self.recover(error, failures)?;
                }
                other => return other,
            }
        }
    }

    fn known_or_planned(&self, map: &str) -> Result<Arc<PlannedMap>, SimulatorError> {
        let mut state = self.server.state();
        if let Some(known) = state.planned.get(map) {
            return Ok(Arc::clone(known));
        }
        let planned = self.plan(&mut state, map).map_err(|error| self.server.told(error))?;
        state.planned.insert(map.to_owned(), Arc::clone(&planned));
        Ok(planned)
    }

    fn plan(&self, state: &mut ServerState, map: &str) -> Result<Arc<PlannedMap>, ClientError> {
        let world = state.load(map, &clock(STEP_S))?;
        let mut planned = PlannedMap::new(map, &world.opendrive()?)?;
        if self.server.settings.finds_sites {
            planned.sites = sites(world, map, &planned.road_map, &self.server.catalogue)?;
        }
        Ok(Arc::new(planned))
    }

    fn fleet(&self, world: &mut World) -> Result<Arc<Fleet>, ClientError> {
        if let Some(fleet) = self.fleet.get() {
            return Ok(Arc::clone(fleet));
        }
        let fleet = Arc::new(Fleet::of(world, &self.server.blueprints, &self.server.catalogue)?);
        Ok(Arc::clone(self.fleet.get_or_init(|| fleet)))
    }

    fn load(&self, wanted: &MapUse<'_>) -> Result<CarlaMap, ClientError> {
        let mut state = self.server.state();
        let planned = match state.planned.get(wanted.name) {
            Some(known) => Arc::clone(known),
            None => self.plan(&mut state, wanted.name)?,
        };
        let step_s = wanted.videos.first().map_or(STEP_S, |video| 1.0 / video.fps);
        let world = state.load(wanted.name, &clock(step_s))?;
        if hash(&world.opendrive()?) != planned.hash {
            return Err(ClientError::Unusable(format!(
                "its map {} is another one than when the dataset was planned",
                wanted.name
            )));
        }
        let fleet = self.fleet(world)?;
        CarlaMap::new(world, planned, fleet)
    }
}

impl Drop for CarlaSimulator {
    fn drop(&mut self) {
        let restored = self.server.while_stopping(World::restore_settings);
        if let Err(error) = restored {
            tracing::debug!("the server's settings were not restored: {error}");
        }
    }
}

impl MapSource for CarlaSimulator {
    fn maps(&self) -> Vec<String> {
        let has = |name: &String| self.maps.contains(name);
        let name = |town: &&str| [(*town).to_owned(), format!("{town}_Opt")].into_iter().find(has);
        let standard: Vec<String> = STANDARD.iter().filter_map(name).collect();
        if standard.is_empty() { self.maps.clone() } else { standard }
    }

    fn imported(&self) -> Vec<String> {
        let standard = self.maps();
        self.maps.iter().filter(|map| !standard.contains(map)).cloned().collect()
    }

    fn content_hash(&self, map: &str) -> Result<Option<String>, SimulatorError> {
        Ok(Some(self.planned(map)?.hash.clone()))
    }

    fn accepts(&self, recipe: &Recipe) -> Result<(), SimulatorError> {
        let refuse = |what: &str, instead| Err(SimulatorError::Unsupported { what: what.to_owned(), instead });
        let layers = endless_dataset::Layer::wanted(&recipe.layers);
        if layers != SensorLayers::default() {
            return refuse(
                "layers but rgb, depth, instance, semantic and panoptic",
                "leave out the others, or use the built-in simulator",
            );
        }
        if !recipe.sensor.is_empty() {
            return refuse("rigs", "leave out --rig, or use the built-in simulator");
        }
        if recipe.amodal_masks {
            return refuse("amodal masks", "leave out --amodal-masks, or use the built-in simulator");
        }
        if recipe.cameras.values().flatten().any(|site| site.lens != LensModel::Pinhole) {
            return refuse("cameras but pinholes", "use lens = \"pinhole\", or the built-in simulator");
        }
        if recipe.town_seed != PerVideo::Fixed || recipe.sites != PerVideo::Fixed {
            return refuse(
                "drawn towns and sites",
                "use --town-seed fixed and --sites fixed, or the built-in simulator",
            );
        }
        if !recipe.events.is_empty() {
            return refuse("events", "leave out --events, or use the built-in simulator");
        }
        if recipe.traffic_file.is_some() {
            return refuse("traffic of a file", "leave out --traffic, or use the built-in simulator");
        }
        Ok(())
    }
}

impl MapCatalog for CarlaSimulator {
    fn cameras(&self, map: &str) -> Result<Vec<CameraSite>, SimulatorError> {
        Ok(self.planned(map)?.sites.clone())
    }

    fn largest_junction(&self, map: &str) -> Result<Option<JunctionPlace>, SimulatorError> {
        Ok(self.planned(map)?.road_map.network.largest_junction())
    }

    fn ground(&self, map: &str, places: &[[f64; 2]]) -> Result<Vec<Option<f64>>, SimulatorError> {
        let planned = self.planned(map)?;
        Ok(places.iter().map(|&at| planned.road_map.network.ground_near(at.into())).collect())
    }
}

impl Simulator for CarlaSimulator {
    type Map = CarlaMap;

    fn capabilities(&self) -> Capabilities {
        Capabilities { random_access: true, repeatable: false, waits: true }
    }

    fn load_map(&self, wanted: &MapUse<'_>) -> Result<CarlaMap, SimulatorError> {
        self.load(wanted).map_err(|error| self.server.told(error))
    }

    fn recover(&self, failure: SimulatorError, failures: u32) -> Result<(), SimulatorError> {
        if failures > MOST_FAILURES {
            return Err(failure);
        }
        tracing::warn!("{failure}: connecting again");
        let CarlaSettings { address, frame_limit, reconnect_limit, stop, .. } = &self.server.settings;
        self.server.state().world = None;
        let wait = Wait::new("come back", *reconnect_limit, stop);
        loop {
            match World::connect(address, *frame_limit, stop) {
                Ok(world) => {
                    let mut state = self.server.state();
                    (state.world, state.loaded) = (Some(world), None);
                    return Ok(());
                }
                Err(ClientError::Interrupted) => return Err(SimulatorError::Interrupted),
                Err(error @ ClientError::Unusable(_)) => return Err(self.server.told(error)),
                Err(_) => {}
            }
            match wait.sleep(AGAIN) {
                Ok(()) => {}
                Err(ClientError::Interrupted) => return Err(SimulatorError::Interrupted),
                Err(_) => return Err(failure),
            }
        }
    }

    fn georeference(&self, map: &CarlaMap) -> Georeference {
        map.georeference()
    }

    fn open_session<'m>(
        &'m self,
        map: &'m CarlaMap,
        settings: &'m SceneSettings,
        _wanted: SensorLayers,
    ) -> Result<Box<dyn SimulationSession<'m> + 'm>, SimulatorError> {
        let session = CarlaSession::open(&self.server, map, settings).map_err(|error| self.server.told(error))?;
        Ok(Box::new(session))
    }
}
