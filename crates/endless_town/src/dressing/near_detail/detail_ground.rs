//! What is known of a town's ground where details are put.

use crate::dressing::assembly::TownAssembly;
use crate::dressing::built_up::density::StreetDensity;
use crate::dressing::ground::bare_ground::{YardParcels, bare};
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::land_use_map::LandUseMap;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::geometry::OccupiedSpace;
use endless_scene::Material;
use endless_world::{CameraSite, Stream, fnv1a};
use glam::DVec2;

/// The ground of a town and what stands on it.
#[derive(Debug)]
pub(crate) struct DetailGround {
    pub(crate) pavement: PavementIndex,
    pub(crate) land: GroundGrid,
    pub(crate) areas: LandUseMap,
    pub(crate) density: StreetDensity,
    pub(crate) parcels: Option<YardParcels>,
    /// Paved ground before houses.
    pub(crate) forecourts: OccupiedSpace,
    /// Where something stands.
    pub(crate) occupied: OccupiedSpace,
    /// Maize grows on the fields.
    pub(crate) maize: bool,
    pub(crate) seed: u64,
}

impl DetailGround {
    /// What covers ground of which the map says nothing.
    pub(crate) fn bare(&self, p: DVec2) -> Material {
        bare(p, &self.density, &self.areas, self.parcels.as_ref())
    }
}

/// The stream of one trade before one camera: the same whatever other cameras there are.
pub(crate) fn camera_stream(assembly: &TownAssembly<'_>, trade: u64, site: &CameraSite) -> Stream {
    let [x, y, z] = site.position;
    let bits = [x, y, z, site.yaw_rad].into_iter().flat_map(|v| v.to_bits().to_le_bytes());
    assembly.stream(trade).fork(fnv1a(bits))
}
