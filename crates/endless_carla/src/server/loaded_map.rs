//! Maps as episodes need them.

use super::call_error::CallError;
use super::error::ServerError;
use super::given_map::{self, DressedText};
use super::map_objects::{MapObject, map_objects};
use super::obstacles::MapObstacles;
use crate::map::CarlaMap;
use endless_asset::Catalogue;
use endless_city::{SharedModels, TownScene, TownThing};
use endless_interchange::MapLibrary;
use endless_render::{FrameDescription, FrameScene, Ray, RayCaster};
use endless_town::Town;
use endless_world::ClassTag;
use glam::{DVec3, Vec3A};
use std::collections::BTreeSet;
use std::sync::{Arc, OnceLock};

/// A map, ready for episodes.
pub(super) struct LoadedMap {
    pub(super) name: String,
    pub(super) town: Arc<Town>,
    pub(super) scene: TownScene,
    pub(super) roads: Arc<CarlaMap>,
    /// What stops those who drive and walk.
    pub(super) obstacles: MapObstacles,
    /// Nobody.
    empty: FrameScene,
    /// Told apart when first asked for.
    objects: Arc<OnceLock<Vec<MapObject>>>,
}

/// A map as a client has asked for it: CARLA's `Town03_Opt` is `Town03` in layers, and keeps its name.
#[derive(Clone)]
pub(super) struct NamedMap {
    /// Without a path.
    pub(super) name: String,
    pub(super) loaded: Arc<LoadedMap>,
}

impl LoadedMap {
    /// What stands in it and can be told apart.
    pub(super) fn objects(&self, catalogue: &Catalogue) -> &[MapObject] {
        self.objects.get_or_init(|| map_objects(&self.town, catalogue))
    }

    /// The same map, seen and felt without some of its things' parts.
    pub(super) fn without(&self, hidden: &BTreeSet<(TownThing, ClassTag)>) -> Self {
        let hides = |thing: TownThing, class: ClassTag| hidden.contains(&(thing, class));
        Self {
            name: self.name.clone(),
            town: Arc::clone(&self.town),
            scene: self.scene.without(hides),
            roads: Arc::clone(&self.roads),
            obstacles: self.obstacles.without(hides),
            empty: FrameScene::new(FrameDescription::default()),
            objects: Arc::clone(&self.objects),
        }
    }

    /// How far one can go along a way before something that blocks it, metres; none if nothing does.
    pub(super) fn free_way(&self, from: DVec3, way: DVec3, blocks: impl Fn(ClassTag) -> bool) -> Option<f64> {
        /// Leaves and what else is passed through.
        const PASSED: usize = 16;
        /// Behind it the way goes on from here, metres.
        const BEHIND_M: f32 = 0.01;
        let caster = RayCaster::new(self.scene.static_scene(), &self.empty);
        let (direction, length) = (Vec3A::from(way.normalize_or_zero().as_vec3()), way.length() as f32);
        let mut gone = 0.0;
        for _ in 0..PASSED {
            let origin = Vec3A::from(from.as_vec3()) + direction * gone;
            let hit = caster.closest(&Ray { origin, direction, tmax: length - gone })?;
            gone += hit.distance;
            if blocks(hit.tag) {
                return Some(gone.into());
            }
            gone += BEHIND_M;
        }
        None
    }

    /// Height of what one can stand on under somebody who is about at a place, metres.
    pub(super) fn ground(&self, place: DVec3) -> Option<f64> {
        /// Kerbs and ramps that are climbed in a step, metres.
        const CLIMBED_M: f32 = 0.6;
        /// Leaves, wires and what else is fallen through.
        const FALLEN_THROUGH: usize = 8;
        let caster = RayCaster::new(self.scene.static_scene(), &self.empty);
        let mut origin = Vec3A::from(place.as_vec3()) + CLIMBED_M * Vec3A::Z;
        for _ in 0..FALLEN_THROUGH {
            let hit = caster.closest(&Ray { origin, direction: Vec3A::NEG_Z, tmax: f32::MAX })?;
            origin.z -= hit.distance;
            if is_ground(hit.tag) {
                return Some(origin.z.into());
            }
            origin.z -= 0.01;
        }
        None
    }
}

/// What one can stand and drive on.
fn is_ground(tag: ClassTag) -> bool {
    use ClassTag::{Bridge, Ground, RailTrack, RoadLines, Roads, Sidewalks, Terrain};
    matches!(tag, Roads | Sidewalks | Terrain | RoadLines | Ground | Bridge | RailTrack)
}

/// The maps there are, the last ones kept.
pub(super) struct MapShelf {
    maps: MapLibrary,
    models: Arc<SharedModels>,
    kept: Vec<Arc<LoadedMap>>,
    /// Of the last OpenDRIVE text that a client has sent.
    given: Option<GivenMap>,
}

/// A map of a client's OpenDRIVE text: its scene is made when it is first loaded.
enum GivenMap {
    Dressed(Box<DressedText>),
    Loaded(Arc<LoadedMap>),
}

/// What CARLA writes after the names of maps in layers.
const LAYERED: &str = "_Opt";
/// As many maps are kept for those who come back to them.
const KEPT: usize = 2;

impl MapShelf {
    pub(super) fn new(maps: MapLibrary) -> Self {
        Self { maps, models: Arc::default(), kept: Vec::new(), given: None }
    }

    /// The names that clients may load, as CARLA writes them.
    pub(super) fn names(&self) -> Vec<String> {
        let names = self.maps.builtin_names().into_iter().chain(self.maps.imported_names());
        names.map(|name| format!("/Game/Carla/Maps/{name}")).collect()
    }

    /// A map by any way in which clients write its name.
    pub(super) fn load(&mut self, name: &str) -> Result<NamedMap, ServerError> {
        let name = name.rsplit('/').next().unwrap_or(name);
        let loaded = self.load_own(name.strip_suffix(LAYERED).unwrap_or(name))?;
        Ok(NamedMap { name: name.to_owned(), loaded })
    }

    fn load_own(&mut self, name: &str) -> Result<Arc<LoadedMap>, ServerError> {
        if let Some(given) = self.given.take_if(|_| name == given_map::NAME) {
            let map = self.load_given(given)?;
            self.given = Some(GivenMap::Loaded(Arc::clone(&map)));
            return Ok(map);
        }
        if let Some(place) = self.kept.iter().position(|map| map.name == name) {
            let map = self.kept.remove(place);
            self.kept.push(Arc::clone(&map));
            return Ok(map);
        }
        let town = self.maps.town(name)?;
        let opendrive = self.maps.opendrive_of(&town)?;
        let map = Arc::new(self.made(name, town, |town| CarlaMap::new(town, opendrive))?);
        if self.kept.len() >= KEPT {
            self.kept.remove(0);
        }
        self.kept.push(Arc::clone(&map));
        Ok(map)
    }

    /// Takes an OpenDRIVE text as the map of the name [`given_map::NAME`], in place of the one before it.
    ///
    /// # Errors
    /// When it is no map or cannot be a town: the one before it stays.
    pub(super) fn give(&mut self, text: &str, has_walkers: bool) -> Result<(), CallError> {
        let dressed = given_map::dress(&self.maps, text, has_walkers)?;
        self.given = Some(GivenMap::Dressed(Box::new(dressed)));
        Ok(())
    }

    fn load_given(&self, given: GivenMap) -> Result<Arc<LoadedMap>, ServerError> {
        match given {
            GivenMap::Loaded(map) => Ok(map),
            GivenMap::Dressed(dressed) => {
                let DressedText { town, opendrive, has_walkers } = *dressed;
                let roads = |town: &Town| {
                    let roads = CarlaMap::new(town, opendrive);
                    if has_walkers { roads } else { roads.without_walkers() }
                };
                Ok(Arc::new(self.made(given_map::NAME, town, roads)?))
            }
        }
    }

    fn made(&self, name: &str, town: Town, roads: impl FnOnce(&Town) -> CarlaMap) -> Result<LoadedMap, ServerError> {
        let scene = TownScene::load_sharing(&town, self.maps.catalogue(), Arc::clone(&self.models));
        let scene = scene.map_err(|error| ServerError::Scene { map: name.to_owned(), reason: error.to_string() })?;
        let roads = roads(&town);
        let obstacles = MapObstacles::new(&town, &roads, self.maps.catalogue());
        Ok(LoadedMap {
            name: name.to_owned(),
            town: Arc::new(town),
            scene,
            roads: Arc::new(roads),
            obstacles,
            empty: FrameScene::new(FrameDescription::default()),
            objects: Arc::default(),
        })
    }

    pub(super) fn catalogue(&self) -> &Catalogue {
        self.maps.catalogue()
    }
}
