//! A loaded town.

use crate::SimulatorError;
use endless_asset::Catalogue;
use endless_city::TownScene;
use endless_town::Town;

/// A town and its geometry.
pub struct BuiltinMap {
    pub(super) town: Town,
    pub(super) town_scene: TownScene,
}

impl BuiltinMap {
    /// Builds the geometry of a town.
    ///
    /// # Errors
    /// [`SimulatorError::LoadMap`] when it has more parts than can be told apart.
    pub(super) fn load(town: Town, catalogue: &Catalogue) -> Result<Self, SimulatorError> {
        let town_scene = TownScene::load(&town, catalogue)
            .map_err(|source| SimulatorError::LoadMap { map: town.name.clone(), source: source.into() })?;
        Ok(Self { town, town_scene })
    }
}
