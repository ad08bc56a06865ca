//! Makes details near cameras, whichever cameras a scene has.

use super::detail_ground::DetailGround;
use super::lawn::LawnDetail;
use super::maize;
use crate::dressing::assembly::TownAssembly;
use crate::placement::Placement;
use endless_asset::Catalogue;
use endless_road::RoadNetwork;
use endless_world::{CameraSite, fnv1a};
use std::sync::Arc;

/// What a town keeps of its ground, so that details can be put before cameras that are known later. By default it knows
/// of none, and no details are made. Clones share it.
#[derive(Debug, Clone, Default)]
pub struct DetailSource {
    ground: Option<Arc<DetailGround>>,
}

impl DetailSource {
    pub(crate) fn new(ground: DetailGround) -> Self {
        Self { ground: Some(Arc::new(ground)) }
    }

    /// Details before all of some cameras; what one camera's details take is not free for those of the next.
    pub(crate) fn place(&self, network: &RoadNetwork, cameras: &[CameraSite], catalogue: &Catalogue) -> Vec<Placement> {
        let Some(ground) = &self.ground else { return Vec::new() };
        let seed = fnv1a("details".bytes().chain(ground.seed.to_le_bytes()));
        let mut assembly = TownAssembly::new(catalogue, ground.occupied.clone(), seed);
        let lawns = LawnDetail { ground, network };
        lawns.add(&mut assembly, cameras);
        lawns.fray_edges(&mut assembly, cameras);
        if ground.maize {
            maize::add(&mut assembly, ground, cameras);
        }
        assembly.placements
    }
}
