//! The built-in city: towns, traffic and the ray tracer joined.

mod bodies;

use crate::assets::{self, AssetError, AssetFolder, AssetKind};
use crate::maps::{self, About, DrivingSide, MapError, MapStore, StoredMap};
use crate::{Cameras, MapCatalog, PeopleBodies, RenderStats, Scene, Simulator, SimulatorError, Traffic};
use bodies::CastBodies;
use endless_asset::Catalogue;
use endless_dataset::Spawned;
use endless_render::{CameraBake, Cast, FrameScene, RenderSettings, StaticScene};
use endless_road::{RoadMap, opendrive};
use endless_town::{Town, dress_map};
use endless_traffic::{Conditions, Simulation};
use endless_world::{Actor, CameraSite, Image, InstanceId, Motion, SceneSettings, SensorFrame, WorldState};
use glam::Vec3;
use std::{
    collections::BTreeMap,
    path::Path,
    sync::{Mutex, OnceLock, PoisonError},
};

/// Simulates and renders without anything outside this program.
#[derive(Debug)]
pub struct BuiltinSimulator {
    /// Built when first needed: a mistake in the recipe is told at once.
    catalogue: OnceLock<Catalogue>,
    /// What is asked of a town without loading it for good.
    known: Mutex<BTreeMap<String, (String, Vec<CameraSite>)>>,
    /// Where imported maps are kept; `None` where there is no such place.
    store: Option<MapStore>,
    /// Models from files.
    folder: Option<AssetFolder>,
}

/// A town and its geometry.
pub struct BuiltinMap {
    town: Town,
    still: StaticScene,
}

impl BuiltinSimulator {
    /// The built-in catalogue and towns, and the maps that the user imported.
    pub fn new() -> Self {
        Self { catalogue: OnceLock::new(), known: Mutex::default(), store: MapStore::user().ok(), folder: None }
    }

    /// With the imported maps of another place.
    pub fn with_maps(store: MapStore) -> Self {
        Self { store: Some(store), ..Self::new() }
    }

    /// With vehicles, props and buildings from a folder of models.
    #[must_use]
    pub fn with_assets(self, folder: AssetFolder) -> Self {
        Self { folder: Some(folder), catalogue: OnceLock::new(), known: Mutex::default(), ..self }
    }

    fn catalogue(&self) -> &Catalogue {
        let imported = || self.folder.iter().flat_map(|f| f.assets.iter().cloned());
        self.catalogue.get_or_init(|| Catalogue::builtin().with(imported()))
    }

    /// A whole town, built in or imported.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn town(&self, name: &str) -> Result<Town, MapError> {
        let mut town = match self.stored(name)? {
            Some((store, stored)) => dress_map(name, &store.read(&stored)?, self.catalogue())?,
            None => endless_town::load(name, self.catalogue())?,
        };
        assets::stand_in(&mut town, self.catalogue());
        Ok(town)
    }

    /// The road map of an imported map; `None` for built-in towns.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn road_map(&self, name: &str) -> Result<Option<RoadMap>, MapError> {
        self.stored(name)?.map(|(store, stored)| store.read(&stored)).transpose()
    }

    /// The manifest of an imported map.
    fn stored(&self, name: &str) -> Result<Option<(&MapStore, StoredMap)>, MapError> {
        let Some(store) = &self.store else { return Ok(None) };
        Ok(store.find(name)?.map(|stored| (store, stored)))
    }

    /// Imports a map file: `None` for `name` takes the file's own. Returns its manifest, what it has become, and notes
    /// on what in the file was not understood or had to be mended.
    ///
    /// # Errors
    /// When it is no map, cannot be filmed, or its name is taken.
    pub fn import(
        &self,
        file: &Path,
        name: Option<&str>,
        side: Option<DrivingSide>,
        replace: bool,
    ) -> Result<(StoredMap, About, Vec<String>), MapError> {
        let store = self.store.as_ref().ok_or(MapError::NoFolder)?;
        let mut found = None;
        let stored = store.import(file, name, side, replace, |name, map| {
            let town = dress_map(name, map, self.catalogue())?;
            if town.cameras.len() < 2 {
                return Err(MapError::FewCameras { name: name.to_owned(), cameras: town.cameras.len() });
            }
            let notes = map.notes.iter().map(|n| format!("{}: {}", n.place, n.text)).collect();
            found = Some((About::of(&town), notes));
            Ok(())
        })?;
        let (about, notes) = found.expect("an imported map was judged");
        Ok((stored, about, notes))
    }

    /// A map's roads as an OpenDRIVE file.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn opendrive(&self, name: &str) -> Result<String, MapError> {
        let map = match self.road_map(name)? {
            Some(map) => map,
            None => RoadMap { network: self.town(name)?.network, ..RoadMap::default() },
        };
        Ok(opendrive::write(&map, name))
    }

    /// A whole dressed map as a binary glTF file.
    ///
    /// # Errors
    /// When there is no such map, it cannot be read, or it is too large.
    pub fn gltf(&self, name: &str) -> Result<Vec<u8>, MapError> {
        let too_large = |_: maps::gltf::TooLarge| MapError::TooLarge { name: name.to_owned() };
        maps::gltf::write(&self.town(name)?, self.catalogue()).map_err(too_large)
    }

    /// What is known of a map as GeoJSON.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn geojson(&self, name: &str) -> Result<String, MapError> {
        let map = self.road_map(name)?.unwrap_or_default();
        let town = self.town(name)?;
        let georeference = map.georeference.as_deref();
        Ok(maps::geojson::write(&maps::geojson::Source { town: &town, footprints: &map.footprints, georeference }))
    }

    /// A picture of a map: from above, and what each camera sees.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn preview(&self, name: &str) -> Result<Image<[u8; 3]>, MapError> {
        Ok(maps::preview(&self.town(name)?, self.catalogue()))
    }

    /// Everything that the catalogue holds: vehicles, people, plants, furniture.
    pub fn assets(&self) -> Vec<AssetKind> {
        assets::list(self.catalogue())
    }

    /// Views of one asset from all sides; `variant` counts its draws and colours.
    ///
    /// # Errors
    /// When there is no such asset.
    pub fn asset_preview(&self, name: &str, variant: u64) -> Result<Image<[u8; 3]>, AssetError> {
        assets::preview(self.catalogue(), name, variant)
    }

    /// One asset as a binary glTF file.
    ///
    /// # Errors
    /// When there is no such asset.
    pub fn asset_gltf(&self, name: &str, variant: u64) -> Result<Vec<u8>, AssetError> {
        assets::export(self.catalogue(), name, variant)
    }

    /// Of people on foot and of riders.
    fn skin_tones(&self, moving: &[Actor]) -> BTreeMap<InstanceId, u8> {
        let who = |actor: &Actor| {
            let on_foot = matches!(actor.motion, Motion::Walker(_));
            let id = if on_foot { Some(actor.id) } else { actor.rider_id };
            Some((id?, self.catalogue().skin_tone(actor.asset, on_foot)?))
        };
        moving.iter().filter_map(who).collect()
    }

    fn describe(&self, map: &str) -> Result<(String, Vec<CameraSite>), SimulatorError> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known.get(map) {
            return Ok(found.clone());
        }
        let town = self.town(map)?;
        let described = (town.summary.to_owned(), town.cameras);
        known.insert(map.to_owned(), described.clone());
        Ok(described)
    }
}

impl From<MapError> for SimulatorError {
    fn from(error: MapError) -> Self {
        Self(error.to_string())
    }
}

impl Default for BuiltinSimulator {
    fn default() -> Self {
        Self::new()
    }
}

impl MapCatalog for BuiltinSimulator {
    fn maps(&self) -> Vec<String> {
        endless_town::NAMES.iter().map(ToString::to_string).collect()
    }

    fn imported(&self) -> Vec<String> {
        self.store.as_ref().map_or_else(Vec::new, MapStore::names)
    }

    fn content_hash(&self, map: &str) -> Result<Option<String>, SimulatorError> {
        Ok(self.stored(map)?.map(|(_, stored)| stored.hash))
    }

    fn asset_files(&self) -> BTreeMap<String, String> {
        self.folder.as_ref().map_or_else(BTreeMap::new, |folder| folder.files.clone())
    }

    fn summary(&self, map: &str) -> Result<String, SimulatorError> {
        Ok(self.describe(map)?.0)
    }

    fn cameras(&self, map: &str) -> Result<Vec<CameraSite>, SimulatorError> {
        Ok(self.describe(map)?.1)
    }
}

impl Simulator for BuiltinSimulator {
    type Map = BuiltinMap;

    fn load_map(&self, name: &str) -> Result<BuiltinMap, SimulatorError> {
        let town = self.town(name)?;
        let still = StaticScene::load(&town, self.catalogue());
        Ok(BuiltinMap { town, still })
    }

    fn load_scene<'m>(&'m self, map: &'m BuiltinMap, settings: &SceneSettings) -> Result<Scene<'m>, SimulatorError> {
        let SceneSettings { weather, time_of_day, vehicles, pedestrians, seed, fps, .. } = *settings;
        let conditions = Conditions::new(weather, time_of_day);
        // Traffic over the whole map, denser where the cameras look.
        let focus = settings.cameras.each_ref().map(|site| Vec3::from_array(site.position));
        let simulation =
            Simulation::focused(&map.town, self.catalogue(), vehicles, pedestrians, seed, conditions, fps, &focus);
        let population = simulation.population();
        let parked = simulation.parked().to_vec();
        let spawned = Spawned {
            vehicles: population.vehicles_spawned,
            pedestrians: population.pedestrians_spawned,
            parked: parked.len() as u32,
        };
        let moving = simulation.state().actors;
        let skin_tones = self.skin_tones(&moving);
        let bodies = Some(Box::new(CastBodies::of(self.catalogue(), &moving)) as Box<dyn PeopleBodies>);
        let traffic = Box::new(City { simulation, begun: false });
        Ok(Scene { spawned, parked, moving, skin_tones, bodies, traffic })
    }

    fn bake<'m>(
        &'m self,
        map: &'m BuiltinMap,
        settings: &SceneSettings,
        moving: &[Actor],
    ) -> Result<Box<dyn Cameras + 'm>, SimulatorError> {
        let bake = |camera: usize| {
            let render = RenderSettings {
                look: settings.looks[camera],
                fps: settings.fps,
                ..RenderSettings::new(settings.weather, settings.time_of_day, settings.seed, settings.size)
            };
            CameraBake::bake(&map.still, &render, &settings.cameras[camera])
        };
        let baked = [0, 1].map(bake);
        let bake_rays = rays(&baked);
        Ok(Box::new(Pair {
            still: &map.still,
            cast: Cast::in_town(&map.still, self.catalogue(), moving),
            baked,
            bake_rays,
        }))
    }
}

struct City {
    simulation: Simulation,
    begun: bool,
}

impl Traffic for City {
    fn tick(&mut self) -> WorldState {
        if self.begun {
            self.simulation.tick();
        }
        self.begun = true;
        self.simulation.state()
    }
}

struct Pair<'m> {
    still: &'m StaticScene,
    cast: Cast,
    baked: [CameraBake; 2],
    bake_rays: u64,
}

fn rays(baked: &[CameraBake; 2]) -> u64 {
    baked.iter().map(|b| b.stats().rays()).sum()
}

impl Cameras for Pair<'_> {
    fn render(&self, state: &WorldState) -> [SensorFrame; 2] {
        let frame = FrameScene::new(&self.cast, state);
        self.baked.each_ref().map(|camera| camera.render(self.still, &frame))
    }

    fn stats(&self) -> RenderStats {
        RenderStats { bake_rays: self.bake_rays, frame_rays: rays(&self.baked) - self.bake_rays }
    }
}
