//! A loaded town.

use super::bake_cache::{BakeCache, MapBakes};
use super::map_features::map_features;
use crate::SimulatorError;
use endless_annotate::MapFeatures;
use endless_asset::Catalogue;
use endless_city::{SharedModels, TownScene};
use endless_road::opendrive::{self, LaneName};
use endless_town::Town;
use endless_traffic::TrafficMap;
use endless_world::SceneSettings;
use std::sync::Arc;

/// A town, its geometry, its roads as drivers know them, and what is kept of its cameras.
pub struct BuiltinMap {
    pub(super) town: Town,
    pub(super) town_scene: TownScene,
    pub(super) traffic: TrafficMap,
    pub(super) bakes: MapBakes,
    pub(super) features: MapFeatures,
    /// OpenDRIVE's, by index.
    pub(super) lane_names: Vec<LaneName>,
}

impl BuiltinMap {
    /// Builds the geometry of a town.
    ///
    /// # Errors
    /// [`SimulatorError::LoadMap`] when it has more parts than can be told apart.
    pub(super) fn load(
        town: Town,
        catalogue: &Catalogue,
        models: Arc<SharedModels>,
        cache: &Arc<BakeCache>,
        videos: &[&SceneSettings],
    ) -> Result<Self, SimulatorError> {
        let (town_scene, (traffic, lane_names)) = rayon::join(
            || TownScene::load_sharing(&town, catalogue, models),
            || {
                let traffic = TrafficMap::new(town.network.clone(), &catalogue.vehicle_specs());
                (traffic, opendrive::lane_names(&town.network, town.streets.left_hand))
            },
        );
        let town_scene =
            town_scene.map_err(|source| SimulatorError::LoadMap { map: town.name.clone(), source: source.into() })?;
        let bakes = MapBakes::new(cache, town_scene.static_scene(), videos);
        let features = map_features(&town, catalogue, &lane_names);
        Ok(Self { town, town_scene, traffic, bakes, features, lane_names })
    }

    /// Number of the town's triangles as placed: those of a tree count wherever it stands.
    pub fn placed_triangles(&self) -> usize {
        self.town_scene.static_scene().placed_triangles()
    }
}
