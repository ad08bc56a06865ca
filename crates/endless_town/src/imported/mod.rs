//! Maps read from files, dressed as towns: pavements from their strips, land that follows them, buildings on footprints
//! or grown along the roads, and everything that stands in streets.

mod area;
mod arrow;
mod bump;
mod cover;
mod crossed;
mod footprint;
mod fray;
mod furniture;
mod garden;
mod growth;
mod infill;
mod iron;
mod land;
mod lawn;
mod look;
mod paint;
mod parking;
mod plant;
mod post;
mod road;
mod square;
mod urban;

use crate::assemble::{assemble, set_up_cameras};
use crate::building::WindowNumbers;
use crate::camera::{Relief, Solid};
use crate::dressing::{Stage, keep_the_seen};
use crate::geometry::{Occupied, Rect};
use crate::{Town, TownError};
use area::Areas;
use cover::Cover;
use endless_asset::Catalogue;
use endless_road::RoadMap;
use endless_scene::MeshBuilder;
use endless_world::fnv1a;
use garden::Gardener;
use glam::{Affine3A, DVec2};
use growth::{Density, Grower};
use land::Land;
use lawn::Lawns;
use plant::Planter;
use post::Poster;
use square::Furnisher;
use urban::{Mapped, Parcels};

pub(crate) use look::{Look, Zone};

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
    dress(name, map, &Look { summary: summary(map), grows: false, yards: true, ..Look::default() }, catalogue)
}

/// Makes a town of a map with a look of its own.
pub(crate) fn dress(name: &str, map: &RoadMap, look: &Look, catalogue: &Catalogue) -> Result<Town, TownError> {
    let (low, high) = bounds(map).ok_or_else(|| TownError::NoLanes { name: name.to_owned() })?;
    let size = high - low;
    if size.max_element() > MOST_M {
        let (width_km, height_km) = (size.x / 1000.0, size.y / 1000.0);
        return Err(TownError::TooLarge { name: name.to_owned(), width_km, height_km, most_km: MOST_M / 1000.0 });
    }
    let seed = fnv1a(name.bytes());
    let strips = road::laid(map);
    let mut cover = Cover::new(&strips, low, high);
    let holes = if map.junction_areas.is_empty() { infill::holes(&map.network, &cover) } else { Vec::new() };
    map.junction_areas.iter().map(Vec::as_slice).chain(holes.iter().map(<[_; 4]>::as_slice)).for_each(|outline| {
        cover.add_between(outline);
    });
    let land = Land::new(&cover, &|strip| strips[strip as usize].bridge, map.terrain.as_ref(), low, high);
    let areas = Areas::new(&map.areas, &land, map.terrain.is_some());
    let streets = urban::streets(&map.network, &cover);
    let density = Density::new(&map.network, &streets, low, high);
    let mut occupied = Occupied::default();
    let mut numbers = WindowNumbers::default();

    let paver = road::Paver::new(&strips, &cover, &land, look.paving);
    let piers = paver.piers(&mut occupied);
    let parcels = look.yards.then(|| Parcels::new(&map.network));
    let ground = || {
        let mut ground = MeshBuilder::new();
        paver.pave(&mut ground, &piers);
        road::junction_areas(&mut ground, map, look.paving);
        infill::pave(&mut ground, &holes);
        paint::add(&mut ground, map, &cover);
        arrow::add(&mut ground, map, &cover);
        bump::add(&mut ground, map, &cover);
        let mut lie = MeshBuilder::new();
        land.add(&mut lie, seed, &|p| areas.material(p, &|| urban::bare(p, &density, &areas, parcels.as_ref())));
        areas.lay(&mut lie);
        ground.mesh(&lie.finish(), Affine3A::IDENTITY);
        ground.finish()
    };
    let grower = Grower {
        network: &map.network,
        cover: &cover,
        land: &land,
        areas: &areas,
        density: &density,
        streets: &streets,
        look,
        mapped: (!map.footprints.is_empty() && !look.grows).then(|| Mapped::new(&map.footprints, low, high)),
        seed,
    };
    let (ground, (built, yards)) = rayon::join(ground, || {
        let mut built = footprint::build(&map.footprints, &cover, &land, &mut occupied, &mut numbers, seed);
        let (grown, yards): (Vec<_>, Vec<_>) = grower.grow(&mut occupied, &mut numbers).into_iter().unzip();
        built.extend(grown);
        (built, yards)
    });
    let mut own = vec![(ground, Affine3A::IDENTITY)];
    let solids: Vec<Solid> = built.iter().map(|b| b.solid.clone()).collect();
    let houses: Vec<Rect> = solids.iter().map(|s| footprint::around(&s.outline)).collect();
    own.extend(built.into_iter().map(|b| (b.mesh, b.place)));

    let mut stage = Stage::new(catalogue, occupied, seed);
    let poster = Poster { map, cover: &cover, land: &land, look };
    let planter = Planter { map, cover: &cover, land: &land, areas: &areas, density: &density, look, seed };
    poster.signals(&mut stage);
    poster.signs(&mut stage);
    poster.lamps(&mut stage);
    poster.things(&mut stage);
    let known_trees = planter.known(&mut stage);
    parking::add(&mut stage, &map.network, &strips, &areas, &cover, &land);
    let gardener = Gardener { cover: &cover, land: &land };
    let mut gardens = MeshBuilder::new();
    let forecourts = gardener.pave(&yards, &mut gardens, &mut stage);
    own.push((gardens.finish(), Affine3A::IDENTITY));

    let mut relief = Relief::new(&map.network, &own);
    for at in known_trees {
        relief.add_column(at, CROWN_M, TREE_M);
    }
    let cameras = set_up_cameras(&mut stage, &map.network, &relief, &solids, &areas.open());
    keep_the_seen(&mut stage.parked, &cameras);
    planter.rows(&mut stage, &poster, &cameras, &houses);
    Furnisher { network: &map.network, cover: &cover, land: &land, areas: &areas }.add(&mut stage, &poster, &cameras);
    gardener.fence(&yards, &mut stage);
    let mut wires = MeshBuilder::new();
    furniture::add(&mut stage, &mut wires, &poster, &cameras);
    own.push((wires.finish(), Affine3A::IDENTITY));
    iron::add(&mut stage, map, &cover);
    let bare = |p| urban::bare(p, &density, &areas, parcels.as_ref());
    let lawns = Lawns {
        network: &map.network,
        cover: &cover,
        land: &land,
        areas: &areas,
        bare: &bare,
        forecourts: &forecourts,
    };
    lawns.add(&mut stage, &cameras);
    lawns.fray(&mut stage, &cameras);
    if look.maize {
        planter.maize(&mut stage, &cameras);
    }
    planter.land(&mut stage, &cameras, low, high);
    planter.hills(&mut stage);
    Ok(assemble(name, &look.summary, map.network.clone(), own, stage, cameras))
}

/// Smallest and largest place of lanes and strips.
fn bounds(map: &RoadMap) -> Option<(DVec2, DVec2)> {
    let strips = map.strips.iter().flat_map(|s| s.left.iter().chain(&s.right));
    let lanes = map.network.lanes.iter().flat_map(|l| l.centerline.points());
    let points = lanes.chain(strips).map(|p| p.truncate()).filter(|p| p.is_finite());
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
