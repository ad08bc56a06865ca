//! Built-in and imported towns by name, and their exports.

use crate::asset::{AssetFolder, stand_in};
use crate::map::{self, ImportOptions, MapError, MapStatistics, MapStore, StoredMap};
use crate::{geojson, gltf};
use endless_asset::Catalogue;
use endless_road::{RoadMap, RoadNetwork, opendrive};
use endless_town::{
    DressOptions, PlacedObject, Placement, SiteDrawer, Town, ViewCheck, draw_map_sites, dress_map, dress_map_with,
};
use endless_world::{CameraSite, Image};
use std::{
    collections::BTreeMap,
    path::Path,
    sync::{Mutex, MutexGuard, OnceLock, PoisonError},
};

/// All maps there are: those that come with the program and those that the user imported, and the catalogue of which
/// their towns are furnished.
#[derive(Debug, Default)]
pub struct MapLibrary {
    /// Built when first needed, so that an error in the recipe is reported at once.
    catalogue: OnceLock<Catalogue>,
    /// Where imported maps are kept; `None` where there is no such place.
    store: Option<MapStore>,
    /// Models from files.
    folder: Option<AssetFolder>,
    /// Towns that were planned.
    planned: Mutex<PlannedTowns>,
}

/// What is remembered of towns that were planned.
#[derive(Debug, Default)]
struct PlannedTowns {
    /// Of all that were asked for their cameras.
    summaries: BTreeMap<String, TownSummary>,
    /// The first of these, until it is asked for: what is planned for its cameras is usually filmed next.
    kept: Option<Town>,
}

/// What is asked of a town before it is filmed.
#[derive(Debug, Clone, PartialEq)]
pub struct TownSummary {
    /// One sentence on its character.
    pub summary: String,
    /// Its camera sites, in canonical order.
    pub cameras: Vec<CameraSite>,
}

/// A map that was imported.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedMap {
    /// Its manifest.
    pub stored: StoredMap,
    /// What it has become.
    pub statistics: MapStatistics,
    /// What in the file was not understood or had to be mended.
    pub notes: Vec<String>,
}

impl MapLibrary {
    /// The built-in towns alone, furnished from the built-in catalogue.
    pub fn builtin() -> Self {
        Self::default()
    }

    /// The built-in towns, and the maps that the user of this machine imported.
    pub fn user() -> Self {
        Self { store: MapStore::user().ok(), ..Self::builtin() }
    }

    /// With the imported maps of another place.
    #[must_use]
    pub fn with_maps(self, store: MapStore) -> Self {
        Self { store: Some(store), planned: Mutex::default(), ..self }
    }

    /// With vehicles, props and buildings from a folder of models.
    #[must_use]
    pub fn with_assets(self, folder: AssetFolder) -> Self {
        Self { folder: Some(folder), catalogue: OnceLock::new(), planned: Mutex::default(), ..self }
    }

    /// The built-in catalogue, and the models of the folder.
    pub fn catalogue(&self) -> &Catalogue {
        let imported = || self.folder.iter().flat_map(|f| f.assets.iter().cloned());
        self.catalogue.get_or_init(|| Catalogue::builtin().with(imported()))
    }

    /// BLAKE3 of each file of imported models, by its name.
    pub fn asset_files(&self) -> BTreeMap<String, String> {
        self.folder.as_ref().map_or_else(BTreeMap::new, |folder| folder.files.clone())
    }

    /// Names of the built-in towns, in canonical order.
    pub fn builtin_names(&self) -> Vec<String> {
        endless_town::NAMES.iter().map(ToString::to_string).collect()
    }

    /// Names of the imported maps, in order.
    pub fn imported_names(&self) -> Vec<String> {
        self.store.as_ref().map_or_else(Vec::new, MapStore::names)
    }

    /// [`StoredMap::content_hash`] of an imported map; `None` for built-in towns.
    ///
    /// # Errors
    /// When its manifest cannot be read.
    pub fn content_hash(&self, name: &str) -> Result<Option<String>, MapError> {
        Ok(self.stored(name)?.map(|(_, stored)| stored.content_hash()))
    }

    /// A whole town, built in or imported, without the details near its cameras.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn town(&self, name: &str) -> Result<Town, MapError> {
        let kept = self.planned().kept.take_if(|town| town.name == name);
        kept.map_or_else(|| self.load(name), Ok)
    }

    /// The same with what its own cameras see near by, as it is shown and exported.
    fn town_with_details(&self, name: &str) -> Result<Town, MapError> {
        let town = self.town(name)?;
        let cameras = town.cameras.clone();
        Ok(self.with_details(town, &cameras))
    }

    /// The same with what cameras see near by: details before each of these.
    ///
    /// # Errors
    /// As [`Self::town`].
    pub fn town_before(&self, cameras: &[CameraSite], name: &str) -> Result<Town, MapError> {
        Ok(self.with_details(self.town(name)?, cameras))
    }

    /// Another town on a map's roads, with what cameras see near by.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn town_dressed(
        &self,
        name: &str,
        options: &DressOptions<'_>,
        cameras: &[CameraSite],
    ) -> Result<Town, MapError> {
        let mut town = match self.stored(name)? {
            Some((store, stored)) => dress_map_with(name, &store.read(&stored)?, options, self.catalogue())?,
            None => endless_town::load_with(name, options, self.catalogue())?,
        };
        stand_in(&mut town, self.catalogue());
        Ok(self.with_details(town, cameras))
    }

    /// Asks a drawer of new camera sites on a map, whose town is dressed by a seed or as usual.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn draw_sites<R>(
        &self,
        name: &str,
        town_seed: Option<u64>,
        ask: impl FnOnce(&SiteDrawer<'_>) -> R,
    ) -> Result<R, MapError> {
        Ok(match self.stored(name)? {
            Some((store, stored)) => draw_map_sites(name, &store.read(&stored)?, town_seed, self.catalogue(), ask)?,
            None => endless_town::draw_builtin_sites(name, town_seed, self.catalogue(), ask)?,
        })
    }

    /// A town with details before cameras, and imported props in the places of some.
    fn with_details(&self, mut town: Town, cameras: &[CameraSite]) -> Town {
        let placements = town.details_near(cameras, self.catalogue());
        let mut details = Town { name: town.name.clone(), placements, ..Town::default() };
        stand_in(&mut details, self.catalogue());
        let first_mesh = town.meshes.len() as u32;
        let moved = |object| match object {
            PlacedObject::TownMesh(mesh) => PlacedObject::TownMesh(first_mesh + mesh),
            prop @ PlacedObject::Prop(..) => prop,
        };
        town.meshes.append(&mut details.meshes);
        town.placements.extend(details.placements.into_iter().map(|p| Placement { object: moved(p.object), ..p }));
        town
    }

    /// A town's character and its cameras; planned once.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn summary(&self, name: &str) -> Result<TownSummary, MapError> {
        // Not locked while the town is planned: others may ask for what is known.
        if let Some(known) = self.planned().summaries.get(name) {
            return Ok(known.clone());
        }
        let town = self.load(name)?;
        let summary = TownSummary { summary: town.summary.clone(), cameras: town.cameras.clone() };
        let mut planned = self.planned();
        planned.summaries.insert(name.to_owned(), summary.clone());
        planned.kept.get_or_insert(town);
        Ok(summary)
    }

    /// Camera sites of a map, in canonical order.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn cameras(&self, name: &str) -> Result<Vec<CameraSite>, MapError> {
        // Parked cars stand before lenses: imported ones may move a site.
        let catalogue = self.catalogue();
        let as_built = catalogue.imported_vehicles().is_empty() && catalogue.imported_static_models().is_empty();
        let imported = self.stored(name)?.is_some();
        let known = (as_built && !imported).then(|| endless_town::known_cameras(name)).flatten();
        known.map_or_else(|| Ok(self.summary(name)?.cameras), Ok)
    }

    /// Asks a judge of other places for a map's cameras.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn with_view_check<R>(&self, name: &str, ask: impl FnOnce(&ViewCheck<'_>) -> R) -> Result<R, MapError> {
        let town = self.town(name)?;
        let answer = ask(&ViewCheck::new(&town, self.catalogue()));
        self.planned().kept.get_or_insert(town);
        Ok(answer)
    }

    /// Looks at a map's roads.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn with_road_network<R>(&self, name: &str, look: impl FnOnce(&RoadNetwork) -> R) -> Result<R, MapError> {
        let town = self.town(name)?;
        let seen = look(&town.network);
        self.planned().kept.get_or_insert(town);
        Ok(seen)
    }

    fn planned(&self) -> MutexGuard<'_, PlannedTowns> {
        self.planned.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Makes a town, with imported models in their places.
    fn load(&self, name: &str) -> Result<Town, MapError> {
        let mut town = match self.stored(name)? {
            Some((store, stored)) => dress_map(name, &store.read(&stored)?, self.catalogue())?,
            None => endless_town::load(name, self.catalogue())?,
        };
        stand_in(&mut town, self.catalogue());
        Ok(town)
    }

    /// A town of a map file that is not kept, without the details near its cameras.
    ///
    /// # Errors
    /// When the file cannot be read or is no map, or cannot be a town.
    pub fn town_of_file(&self, file: &Path) -> Result<Town, MapError> {
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        let mut town = dress_map(&name, &map::read_map(file)?, self.catalogue())?;
        stand_in(&mut town, self.catalogue());
        Ok(town)
    }

    /// A town of an OpenDRIVE text that is not kept, and its roads as our own writer has them.
    ///
    /// # Errors
    /// When the text is no map, or cannot be a town.
    pub fn town_of_opendrive(&self, name: &str, text: &str) -> Result<(Town, String), MapError> {
        let cause = |cause| MapError::OpenDrive { path: name.into(), cause };
        let map = opendrive::read(text).map_err(cause)?;
        let mut town = dress_map(name, &map, self.catalogue())?;
        stand_in(&mut town, self.catalogue());
        let written = opendrive::write(&map, name);
        Ok((town, written))
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

    /// Imports a map file.
    ///
    /// # Errors
    /// When it is no map, cannot be filmed, or its name is taken.
    pub fn import(&self, file: &Path, options: &ImportOptions<'_>) -> Result<ImportedMap, MapError> {
        let store = self.store.as_ref().ok_or(MapError::NoFolder)?;
        let mut found = None;
        let stored = store.import(file, options, |name, map| {
            let town = dress_map(name, map, self.catalogue())?;
            if town.cameras.len() < 2 {
                return Err(MapError::FewCameras { name: name.to_owned(), cameras: town.cameras.len() });
            }
            let notes = map.notes.iter().map(|n| format!("{}: {}", n.place, n.text)).collect();
            found = Some((MapStatistics::of(&town), notes));
            Ok(())
        })?;
        let (statistics, notes) = found.expect("an imported map was judged");
        Ok(ImportedMap { stored, statistics, notes })
    }

    /// A map's roads as an OpenDRIVE file.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn opendrive(&self, name: &str) -> Result<String, MapError> {
        self.written(name, || Ok(self.town(name)?.network))
    }

    /// The roads of a town that has been loaded as an OpenDRIVE file: [`Self::opendrive`] without loading it again.
    ///
    /// # Errors
    /// When its imported map cannot be read.
    pub fn opendrive_of(&self, town: &Town) -> Result<String, MapError> {
        self.written(&town.name, || Ok(town.network.clone()))
    }

    /// A map as an OpenDRIVE file: as it was imported, or else of its network.
    fn written(&self, name: &str, network: impl FnOnce() -> Result<RoadNetwork, MapError>) -> Result<String, MapError> {
        let map = match self.road_map(name)? {
            Some(map) => map,
            None => RoadMap { network: network()?, ..RoadMap::default() },
        };
        Ok(opendrive::write(&map, name))
    }

    /// A whole dressed map as a binary glTF file.
    ///
    /// # Errors
    /// When there is no such map, it cannot be read, or it is too large.
    pub fn gltf(&self, name: &str) -> Result<Vec<u8>, MapError> {
        let too_large = |_: gltf::TooLarge| MapError::TooLarge { name: name.to_owned() };
        gltf::write_town(&self.town_with_details(name)?, self.catalogue()).map_err(too_large)
    }

    /// What is known of a map as GeoJSON.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn geojson(&self, name: &str) -> Result<String, MapError> {
        let map = self.road_map(name)?.unwrap_or_default();
        let town = self.town(name)?;
        let georeference = map.georeference.as_deref();
        Ok(geojson::write(&geojson::GeoJsonSource { town: &town, footprints: &map.footprints, georeference }))
    }

    /// A picture of a map: from above, and what each camera sees.
    ///
    /// # Errors
    /// When there is no such map or it cannot be read.
    pub fn preview(&self, name: &str) -> Result<Image<[u8; 3]>, MapError> {
        Ok(map::preview(&self.town_with_details(name)?, self.catalogue())?)
    }
}
