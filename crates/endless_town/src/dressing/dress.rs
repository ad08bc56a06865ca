//! The passes by which a road map becomes a town, in their order.

use crate::building::WindowNumbers;
use crate::camera::{BuildingPrism, HeightField};
use crate::dressing::assembly::TownAssembly;
use crate::dressing::built_up::density::StreetDensity;
use crate::dressing::built_up::footprint;
use crate::dressing::built_up::growth::BuildingGrowth;
use crate::dressing::built_up::streets::{self, FootprintGrid};
use crate::dressing::camera_poles::set_up_cameras;
use crate::dressing::ground::bare_ground::{YardParcels, bare};
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::land_use_map::LandUseMap;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::near_detail::{DetailGround, DetailSource};
use crate::dressing::pavement::{arrow, bump, features, infill, paint, surface};
use crate::dressing::planting::garden::GardenBuilder;
use crate::dressing::planting::square::SquareFurnisher;
use crate::dressing::planting::trees::TreePlanter;
use crate::dressing::preset::TownPreset;
use crate::dressing::road_furniture::post::RoadsidePosts;
use crate::dressing::road_furniture::{furniture, iron, parking};
use crate::geometry::{OccupiedSpace, Rect, around};
use crate::placement::{PlacedObject, Placement};
use crate::town::{Town, TownError};
use endless_asset::Catalogue;
use endless_road::{Georeference, RoadMap};
use endless_scene::{Mesh, MeshBuilder};
use endless_world::fnv1a;
use glam::{Affine3A, DVec2};

/// Size of a tree of the map, as sight sees it, metres.
const CROWN_M: f64 = 2.0;
const TREE_M: f32 = 8.0;
/// Longest side of a map, metres.
const MOST_M: f64 = 12_000.0;

/// Makes a town of a map. The same name and map give the same town everywhere.
///
/// # Errors
/// [`TownError::NoLanes`] if there is nothing to drive on, [`TownError::TooLarge`] if the map is larger than 12 km.
pub fn dress_map(name: &str, map: &RoadMap, catalogue: &Catalogue) -> Result<Town, TownError> {
    dress(
        name,
        map,
        &TownPreset { summary: summary(map), grows: false, yards: true, ..TownPreset::default() },
        catalogue,
    )
}

/// Makes a town of a map with a preset of its own.
pub(crate) fn dress(name: &str, map: &RoadMap, preset: &TownPreset, catalogue: &Catalogue) -> Result<Town, TownError> {
    let (low, high) = bounds(map).ok_or_else(|| TownError::NoLanes { name: name.to_owned() })?;
    let size = high - low;
    if size.max_element() > MOST_M {
        let (width_km, height_km) = (size.x / 1000.0, size.y / 1000.0);
        return Err(TownError::TooLarge { name: name.to_owned(), width_km, height_km, most_km: MOST_M / 1000.0 });
    }
    let seed = fnv1a(name.bytes());
    let lane_surfaces = surface::laid(map);
    let mut pavement = PavementIndex::new(&lane_surfaces, low, high);
    let holes = if map.junction_areas.is_empty() { infill::holes(&map.network, &pavement) } else { Vec::new() };
    map.junction_areas.iter().map(Vec::as_slice).chain(holes.iter().map(<[_; 4]>::as_slice)).for_each(|outline| {
        pavement.add_between(outline);
    });
    let land =
        GroundGrid::new(&pavement, &|strip| lane_surfaces[strip as usize].bridge, map.terrain.as_ref(), low, high);
    let areas = LandUseMap::new(&map.areas, &land, map.terrain.is_some());
    let streets = streets::streets(&map.network, &pavement);
    let density = StreetDensity::new(&map.network, &streets, low, high);
    let mut occupied = OccupiedSpace::default();
    let mut numbers = WindowNumbers::default();

    let paver = surface::PavementMesher::new(&lane_surfaces, &pavement, &land, preset.paving);
    let piers = paver.piers(&mut occupied);
    let parcels = preset.yards.then(|| YardParcels::new(&map.network));
    let ground = || {
        let mut ground = MeshBuilder::new();
        paver.pave(&mut ground, &piers);
        surface::junction_areas(&mut ground, map, preset.paving);
        infill::pave(&mut ground, &holes);
        paint::add(&mut ground, map, &pavement);
        arrow::add(&mut ground, map, &pavement);
        bump::add(&mut ground, map, &pavement);
        let mut lie = MeshBuilder::new();
        land.add(&mut lie, seed, &|p| areas.material(p, &|| bare(p, &density, &areas, parcels.as_ref())));
        areas.lay(&mut lie);
        ground.mesh(&lie.finish(), Affine3A::IDENTITY);
        ground.finish()
    };
    let grower = BuildingGrowth {
        network: &map.network,
        pavement: &pavement,
        land: &land,
        areas: &areas,
        density: &density,
        streets: &streets,
        preset,
        mapped: (!map.footprints.is_empty() && !preset.grows).then(|| FootprintGrid::new(&map.footprints, low, high)),
        seed,
    };
    let (ground, (built, yards)) = rayon::join(ground, || {
        let mut built = footprint::build(&map.footprints, &pavement, &land, &mut occupied, &mut numbers, seed);
        let (grown, yards): (Vec<_>, Vec<_>) = grower.grow(&mut occupied, &mut numbers).into_iter().unzip();
        built.extend(grown);
        (built, yards)
    });
    let mut own = vec![(ground, Affine3A::IDENTITY)];
    let solids: Vec<BuildingPrism> = built.iter().map(|b| b.solid.clone()).collect();
    let houses: Vec<Rect> = solids.iter().map(|s| around(&s.outline)).collect();
    own.extend(built.into_iter().map(|b| (b.mesh, b.place)));

    let mut assembly = TownAssembly::new(catalogue, occupied, seed);
    let posts = RoadsidePosts { map, pavement: &pavement, land: &land, preset };
    let planter = TreePlanter { map, pavement: &pavement, land: &land, areas: &areas, density: &density, preset, seed };
    posts.signals(&mut assembly);
    posts.signs(&mut assembly);
    posts.lamps(&mut assembly);
    posts.street_furniture(&mut assembly);
    let known_trees = planter.known(&mut assembly);
    let kerb_bays = parking::add(&mut assembly, &map.network, &lane_surfaces, &areas, &pavement, &land);
    let gardener = GardenBuilder { pavement: &pavement, land: &land };
    let mut gardens = MeshBuilder::new();
    let forecourts = gardener.pave(&yards, &mut gardens, &mut assembly);
    own.push((gardens.finish(), Affine3A::IDENTITY));

    let mut relief = HeightField::new(&map.network, &own);
    for at in known_trees {
        relief.add_column(at, CROWN_M, TREE_M);
    }
    let cameras = set_up_cameras(&mut assembly, &map.network, &relief, &solids, &areas.open());
    planter.rows(&mut assembly, &posts, &cameras, &houses);
    SquareFurnisher { network: &map.network, pavement: &pavement, land: &land, areas: &areas }.add(
        &mut assembly,
        &posts,
        &cameras,
    );
    gardener.fence(&yards, &mut assembly);
    let mut wires = MeshBuilder::new();
    furniture::add(&mut assembly, &mut wires, &posts, &cameras);
    own.push((wires.finish(), Affine3A::IDENTITY));
    iron::add(&mut assembly, map, &pavement);
    planter.land(&mut assembly, &cameras, low, high);
    planter.hills(&mut assembly);
    let street_features = features::features(map, &lane_surfaces, &pavement);
    let (placements, parked, lamps, occupied) =
        (assembly.placements, assembly.parked, assembly.lamps, assembly.occupied);
    let parking_bays = parking::usable(&kerb_bays, &occupied);
    let maize = preset.maize;
    let detail = DetailGround { pavement, land, areas, density, parcels, forecourts, occupied, maize, seed };
    Ok(Town {
        name: name.to_owned(),
        summary: preset.summary.clone(),
        network: map.network.clone(),
        georeference: map.georeference.as_deref().and_then(Georeference::parse),
        placements: own_placements(&own).chain(placements).collect(),
        meshes: own.into_iter().map(|(mesh, _)| mesh.into()).collect(),
        parked,
        parking_bays,
        lamps,
        cameras,
        streets: street_features,
        detail_source: DetailSource::new(detail),
    })
}

/// The town's own meshes, each at its place.
fn own_placements(own: &[(Mesh, Affine3A)]) -> impl Iterator<Item = Placement> {
    own.iter().enumerate().map(|(i, &(_, world_from_object))| Placement {
        object: PlacedObject::TownMesh(i as u32),
        world_from_object,
        signal: None,
    })
}

/// Smallest and largest place of lanes and strips.
fn bounds(map: &RoadMap) -> Option<(DVec2, DVec2)> {
    let lane_surfaces = map.lane_surfaces.iter().flat_map(|s| s.left.iter().chain(&s.right));
    let lanes = map.network.lanes.iter().flat_map(|l| l.centerline.points());
    let points = lanes.chain(lane_surfaces).map(|p| p.truncate()).filter(|p| p.is_finite());
    let (low, high) = points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
    (!map.network.lanes.is_empty() && low.x <= high.x).then_some((low, high))
}

/// One sentence on what the map has.
fn summary(map: &RoadMap) -> String {
    let network = &map.network;
    let kilometres: f64 = network.lanes.iter().map(|l| l.centerline.length()).sum::<f64>() / 1000.0;
    let signals = network.junctions.iter().filter(|j| j.program.is_some()).count();
    let buildings = map.footprints.len();
    format!(
        "An imported map: {} lanes ({kilometres:.1} km), {} junctions ({signals} with signals), {buildings} known buildings.",
        network.lanes.len(),
        network.junctions.len(),
    )
}
