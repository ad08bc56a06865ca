//! The built-in city as a simulator.

use super::{
    bake_cache::BakeCache, lookout, map::BuiltinMap, scene_boxes::SceneBoxes, session::BuiltinSession, track_fit,
};
use crate::{
    Capabilities, MapCatalog, MapSource, MapUse, SimulationSession, Simulator, SimulatorError, SiteRequest,
    TrackFileSummary,
};
use endless_annotate::MapFeatures;
use endless_asset::Catalogue;
use endless_city::SharedModels;
use endless_dataset::Recipe;
use endless_interchange::{MapLibrary, TrackFile};
use endless_road::{Georeference, JunctionPlace, RoadNetwork};
use endless_town::{DressOptions, SiteDrawer, TownSites};
use endless_world::{CameraSite, SceneSettings, SensorLayers, Track};
use rayon::prelude::*;
use std::{collections::BTreeMap, sync::Arc};

/// Simulates and renders without anything outside this program.
#[derive(Debug)]
pub struct BuiltinSimulator {
    map_library: MapLibrary,
    models: Arc<SharedModels>,
    cache: Arc<BakeCache>,
    tracks: Option<TrackFile>,
}

impl BuiltinSimulator {
    /// Over the maps and the catalogue of a library.
    pub fn new(map_library: MapLibrary) -> Self {
        Self { map_library, models: Arc::default(), cache: Arc::default(), tracks: None }
    }

    /// Keeps what bakes of the same camera share.
    #[must_use]
    pub fn with_bake_cache(self, cache: BakeCache) -> Self {
        Self { cache: Arc::new(cache), ..self }
    }

    /// Plays the tracks of a file in all scenes.
    #[must_use]
    pub fn with_tracks(self, tracks: TrackFile) -> Self {
        Self { tracks: Some(tracks), ..self }
    }

    /// The boxes that a recording of this scene has in every `stride`th frame, from frame 0 on: traffic and instance images are
    /// those of the recording, but no light is computed, so that it takes a small part of the time. Boxes have at least
    /// `min_pixels` pixels.
    ///
    /// # Errors
    /// When the scene cannot be made.
    pub fn scene_boxes(
        &self,
        map: &BuiltinMap,
        settings: &SceneSettings,
        stride: u32,
        min_pixels: u32,
    ) -> Result<Vec<SceneBoxes>, SimulatorError> {
        let mut session =
            BuiltinSession::open(map, self.catalogue(), settings, SensorLayers::default(), self.tracks())?;
        let mut boxes = Vec::new();
        for frame in 0..settings.frames {
            let instant = session.advance();
            if frame % stride.max(1) == 0 {
                boxes.push(session.boxes(&instant, min_pixels));
            }
        }
        Ok(boxes)
    }

    /// Lanes outside junctions that each camera of a scene sees, near enough for a vehicle there to have a box, metres.
    pub fn roads_seen_m(&self, map: &BuiltinMap, settings: &SceneSettings) -> Vec<f64> {
        lookout::sight(map, settings).roads_seen_m(map.traffic.network())
    }

    /// The models of which scenes are made.
    pub(super) fn catalogue(&self) -> &Catalogue {
        self.map_library.catalogue()
    }

    /// The tracks that are played in all scenes.
    pub(super) fn tracks(&self) -> &[Track] {
        self.tracks.as_ref().map_or(&[], |file| &file.tracks)
    }
}

impl MapSource for BuiltinSimulator {
    fn maps(&self) -> Vec<String> {
        self.map_library.builtin_names()
    }

    fn imported(&self) -> Vec<String> {
        self.map_library.imported_names()
    }

    fn random_map(&self, number: u32) -> Option<String> {
        Some(endless_town::random_name(number))
    }

    fn content_hash(&self, map: &str) -> Result<Option<String>, SimulatorError> {
        Ok(self.map_library.content_hash(map)?)
    }

    fn track_file(&self) -> Option<TrackFileSummary> {
        self.tracks.as_ref().map(track_fit::summary)
    }

    fn track_notes(&self, recipe: &Recipe) -> Result<Vec<String>, SimulatorError> {
        let (Some(file), [map]) = (&self.tracks, &recipe.maps[..]) else { return Ok(Vec::new()) };
        self.map_library.with_road_network(map, |network| track_fit::notes(file, recipe, map, network))?
    }

    fn asset_files(&self) -> BTreeMap<String, String> {
        self.map_library.asset_files()
    }
}

impl MapCatalog for BuiltinSimulator {
    fn cameras(&self, map: &str) -> Result<Vec<CameraSite>, SimulatorError> {
        Ok(self.map_library.cameras(map)?)
    }

    fn draw_sites(&self, scenes: &[SiteRequest]) -> Result<Vec<Option<Vec<CameraSite>>>, SimulatorError> {
        let draw = |drawer: &SiteDrawer<'_>, scene: &SiteRequest| {
            drawer.draw(scene.seed, scene.cameras as usize, scene.overlapping, &scene.views)
        };
        // Of the towns that are dressed anew each is built for its scene alone.
        let one_town = |a: &SiteRequest, b: &SiteRequest| a.map == b.map && a.town_seed == b.town_seed;
        let parts = scenes.par_chunk_by(one_town).map(|of_town| {
            let ask = |drawer: &SiteDrawer<'_>| of_town.par_iter().map(|scene| draw(drawer, scene)).collect();
            self.map_library.draw_sites(&of_town[0].map, of_town[0].town_seed, ask)
        });
        let parts: Vec<Vec<Option<Vec<CameraSite>>>> = parts.collect::<Result<_, _>>()?;
        Ok(parts.into_iter().flatten().collect())
    }

    fn see_as_well(&self, map: &str, moved: &[[CameraSite; 2]]) -> Result<Vec<bool>, SimulatorError> {
        let judged = self.map_library.with_view_check(map, |check| {
            moved.par_iter().map(|[usual, moved]| check.sees_as_well(usual, moved)).collect()
        })?;
        Ok(judged)
    }

    fn places_seen(&self, map: &str, sites: &[CameraSite]) -> Result<Vec<Vec<u32>>, SimulatorError> {
        Ok(self.map_library.with_view_check(map, |check| check.places_seen(sites))?)
    }

    fn largest_junction(&self, map: &str) -> Result<Option<JunctionPlace>, SimulatorError> {
        Ok(self.map_library.with_road_network(map, RoadNetwork::largest_junction)?)
    }

    fn ground(&self, map: &str, places: &[[f64; 2]]) -> Result<Vec<Option<f64>>, SimulatorError> {
        if places.is_empty() {
            return Ok(Vec::new());
        }
        let heights = |network: &RoadNetwork| places.iter().map(|&at| network.ground_near(at.into())).collect();
        Ok(self.map_library.with_road_network(map, heights)?)
    }
}

impl Simulator for BuiltinSimulator {
    type Map = BuiltinMap;

    fn capabilities(&self) -> Capabilities {
        Capabilities { random_access: true, repeatable: true, waits: false }
    }

    fn load_map(&self, wanted: &MapUse<'_>) -> Result<BuiltinMap, SimulatorError> {
        let first = wanted.videos.first();
        let mut town = match first.filter(|video| video.town_seed.is_some() || video.drawn_sites) {
            Some(video) => {
                let cameras: Vec<CameraSite> = video.cameras.iter().map(|camera| camera.site.clone()).collect();
                let sites = if video.drawn_sites { TownSites::Drawn(&cameras) } else { TownSites::Given(&cameras) };
                let options = DressOptions { seed: video.town_seed, sites };
                self.map_library.town_dressed(wanted.name, &options, wanted.cameras)?
            }
            None => self.map_library.town_before(wanted.cameras, wanted.name)?,
        };
        let parked = first.map_or(1.0, |video| video.profile.parked);
        town.keep_parked(parked);
        BuiltinMap::load(town, self.map_library.catalogue(), Arc::clone(&self.models), &self.cache, wanted.videos)
    }

    fn map_features<'m>(&self, map: &'m BuiltinMap) -> Option<&'m MapFeatures> {
        Some(&map.features)
    }

    fn georeference(&self, map: &BuiltinMap) -> Georeference {
        map.town.georeference.unwrap_or_default()
    }

    fn open_session<'m>(
        &'m self,
        map: &'m BuiltinMap,
        settings: &'m SceneSettings,
        wanted: SensorLayers,
    ) -> Result<Box<dyn SimulationSession<'m> + 'm>, SimulatorError> {
        Ok(Box::new(BuiltinSession::open(map, self.catalogue(), settings, wanted, self.tracks())?))
    }
}
