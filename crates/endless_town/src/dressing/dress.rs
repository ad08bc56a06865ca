//! The passes by which a road map becomes a town, in their order.

use super::drawn_preset::DrawnPreset;
use super::options::{DressOptions, TownSites};
use crate::building::WindowNumbers;
use crate::camera::{BuildingPrism, CameraSurroundings, HeightField, OpenSpace, PropOcclusion, SiteDrawer};
use crate::dressing::assembly::TownAssembly;
use crate::dressing::built_up::density::StreetDensity;
use crate::dressing::built_up::footprint;
use crate::dressing::built_up::growth::{BuildingGrowth, FrontYard};
use crate::dressing::built_up::streets::{self, FootprintGrid};
use crate::dressing::camera_poles::{put_up_poles, set_up_cameras};
use crate::dressing::ground::bare_ground::{YardParcels, bare};
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::land_use_map::LandUseMap;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::near_detail::{DetailGround, DetailSource};
use crate::dressing::pavement::{arrow, bump, features, infill, old_paint, paint, surface};
use crate::dressing::planting::garden::GardenBuilder;
use crate::dressing::planting::square::SquareFurnisher;
use crate::dressing::planting::trees::TreePlanter;
use crate::dressing::preset::TownPreset;
use crate::dressing::road_furniture::parking::KerbBay;
use crate::dressing::road_furniture::post::RoadsidePosts;
use crate::dressing::road_furniture::{furniture, iron, kerb_guard, parking, street_life, street_sign, walk_signal};
use crate::geometry::{OccupiedSpace, Rect, around};
use crate::placement::{PlacedObject, Placement};
use crate::town::{Town, TownError};
use endless_asset::Catalogue;
use endless_road::{Georeference, LaneSurface, RoadMap};
use endless_scene::{Mesh, MeshBuilder};
use endless_world::{CameraSite, Stream, fnv1a};
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
    dress_map_with(name, map, &DressOptions::default(), catalogue)
}

/// Makes another town of the same map.
///
/// # Errors
/// As [`dress_map`].
pub fn dress_map_with(
    name: &str,
    map: &RoadMap,
    options: &DressOptions<'_>,
    catalogue: &Catalogue,
) -> Result<Town, TownError> {
    dress(name, map, &preset_of(map), options, catalogue)
}

/// Asks a drawer of new camera sites on a map, dressed by a seed or as usual.
///
/// # Errors
/// As [`dress_map`].
pub fn draw_map_sites<R>(
    name: &str,
    map: &RoadMap,
    seed: Option<u64>,
    catalogue: &Catalogue,
    ask: impl FnOnce(&SiteDrawer<'_>) -> R,
) -> Result<R, TownError> {
    draw_sites(name, map, &preset_of(map), seed, catalogue, ask)
}

/// How a map is dressed that has no preset of its own.
fn preset_of(map: &RoadMap) -> TownPreset {
    TownPreset { summary: summary(map), grows: false, yards: true, ..TownPreset::default() }
}

/// Makes a town of a map with a preset of its own.
pub(crate) fn dress(
    name: &str,
    map: &RoadMap,
    preset: &TownPreset,
    options: &DressOptions<'_>,
    catalogue: &Catalogue,
) -> Result<Town, TownError> {
    let drawn = options.seed.map(|seed| DrawnPreset::new(preset, seed));
    let preset = drawn.as_ref().map_or(preset, |drawn| &drawn.preset);
    let shell = TownShell::build(name, map, preset, options, catalogue)?;
    let mut town = shell.finish(options.sites);
    if let Some(drawn) = &drawn {
        town.meshes = town.meshes.into_iter().map(|mesh| drawn.tints.applied(mesh)).collect();
    }
    Ok(town)
}

/// [`draw_map_sites`] with a preset of its own.
pub(crate) fn draw_sites<R>(
    name: &str,
    map: &RoadMap,
    preset: &TownPreset,
    seed: Option<u64>,
    catalogue: &Catalogue,
    ask: impl FnOnce(&SiteDrawer<'_>) -> R,
) -> Result<R, TownError> {
    let drawn = seed.map(|seed| DrawnPreset::new(preset, seed));
    let preset = drawn.as_ref().map_or(preset, |drawn| &drawn.preset);
    let options = DressOptions { seed, sites: TownSites::Drawn(&[]) };
    let shell = TownShell::build(name, map, preset, &options, catalogue)?;
    let props = PropOcclusion::new(catalogue, &shell.assembly.placements);
    let open = shell.areas.open();
    Ok(ask(&SiteDrawer::new(shell.surroundings(&props, &open), &props, &shell.assembly.occupied)))
}

/// The town's own meshes, each at its place.
fn own_placements(own: &[(Mesh, Affine3A)]) -> impl Iterator<Item = Placement> {
    own.iter().enumerate().map(|(i, &(_, world_from_object))| Placement {
        object: PlacedObject::TownMesh(i as u32),
        world_from_object,
        signal: None,
    })
}

/// A town before its cameras: ground, buildings, posts and signs, parked vehicles.
struct TownShell<'m> {
    name: &'m str,
    map: &'m RoadMap,
    preset: &'m TownPreset,
    seed: u64,
    low: DVec2,
    high: DVec2,
    lane_surfaces: Vec<LaneSurface>,
    pavement: PavementIndex,
    land: GroundGrid,
    areas: LandUseMap,
    density: StreetDensity,
    parcels: Option<YardParcels>,
    /// The town's own meshes, each at its place.
    own: Vec<(Mesh, Affine3A)>,
    solids: Vec<BuildingPrism>,
    yards: Vec<FrontYard>,
    forecourts: OccupiedSpace,
    kerb_bays: Vec<KerbBay>,
    relief: HeightField,
    assembly: TownAssembly<'m>,
}

impl<'m> TownShell<'m> {
    fn build(
        name: &'m str,
        map: &'m RoadMap,
        preset: &'m TownPreset,
        options: &DressOptions<'_>,
        catalogue: &'m Catalogue,
    ) -> Result<Self, TownError> {
        let (low, high) = bounds(map).ok_or_else(|| TownError::NoLanes { name: name.to_owned() })?;
        let size = high - low;
        if size.max_element() > MOST_M {
            let (width_km, height_km) = (size.x / 1000.0, size.y / 1000.0);
            return Err(TownError::TooLarge { name: name.to_owned(), width_km, height_km, most_km: MOST_M / 1000.0 });
        }
        let seed = options.seed.map_or_else(
            || fnv1a(name.bytes()),
            |seed| Stream::named(seed, "town/dressed anew", &[fnv1a(name.bytes())]).next_u64(),
        );
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
        let parcels = preset.yards.then(|| YardParcels::new(&map.network, preset.green_yards));
        let ground = || {
            let mut ground = MeshBuilder::new();
            paver.pave(&mut ground, &piers);
            surface::junction_areas(&mut ground, map, preset.paving);
            infill::pave(&mut ground, &holes);
            paint::add(&mut ground, map, &pavement);
            old_paint::add_traces(&mut ground, map, preset.old_paint, seed);
            if let Some(color) = preset.bus_lanes {
                old_paint::add_bus_lanes(&mut ground, map, color);
            }
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
            mapped: (!map.footprints.is_empty() && !preset.grows)
                .then(|| FootprintGrid::new(&map.footprints, low, high)),
            sites: options.sites.built_around(),
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
        own.extend(built.into_iter().map(|b| (b.mesh, b.place)));

        let mut assembly = TownAssembly::new(catalogue, occupied, seed);
        let posts = RoadsidePosts { map, pavement: &pavement, land: &land, preset };
        let planter =
            TreePlanter { map, pavement: &pavement, land: &land, areas: &areas, density: &density, preset, seed };
        posts.signals(&mut assembly);
        if preset.walk_signals {
            walk_signal::add(&mut assembly, &posts);
        }
        posts.signs(&mut assembly);
        if let Some(standard) = preset.street_signs {
            street_sign::add(&mut assembly, &posts, standard);
        }
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
        Ok(Self {
            name,
            map,
            preset,
            seed,
            low,
            high,
            lane_surfaces,
            pavement,
            land,
            areas,
            density,
            parcels,
            own,
            solids,
            yards,
            forecourts,
            kerb_bays,
            relief,
            assembly,
        })
    }

    /// What cameras are chosen among.
    fn surroundings<'s>(&'s self, props: &PropOcclusion, open: &'s [OpenSpace]) -> CameraSurroundings<'s> {
        CameraSurroundings {
            network: &self.map.network,
            relief: &self.relief,
            solids: &self.solids,
            open,
            posts: props.posts(),
            parked: self.assembly.parked.iter().map(|p| p.pose.position).collect(),
        }
    }

    /// Sets up the cameras, and puts down what keeps out of their sight.
    fn finish(mut self, sites: TownSites<'_>) -> Town {
        let Self {
            map, preset, seed, low, high, pavement, land, areas, density, solids, yards, relief, assembly, ..
        } = &mut self;
        let cameras = match sites.given() {
            Some(cameras) => {
                put_up_poles(assembly, relief, cameras);
                cameras.to_vec()
            }
            None => set_up_cameras(assembly, &map.network, relief, solids, &areas.open()),
        };
        let posts = RoadsidePosts { map, pavement, land, preset };
        let planter = TreePlanter { map, pavement, land, areas, density, preset, seed: *seed };
        let gardener = GardenBuilder { pavement, land };
        let houses: Vec<Rect> = solids.iter().map(|s| around(&s.outline)).collect();
        planter.rows(assembly, &posts, &cameras, &houses);
        SquareFurnisher { network: &map.network, pavement, land, areas }.add(assembly, &posts, &cameras);
        gardener.fence(yards, assembly);
        let mut wires = MeshBuilder::new();
        furniture::add(assembly, &mut wires, &posts, &cameras);
        if let Some(guard) = preset.kerb_guard {
            kerb_guard::add(assembly, &posts, guard);
        }
        street_life::add(assembly, &posts, yards, &cameras, preset.life);
        iron::add(assembly, map, pavement);
        planter.land(assembly, &cameras, *low, *high);
        planter.hills(assembly);
        self.own.push((wires.finish(), Affine3A::IDENTITY));
        self.town(cameras)
    }

    /// The town as it stands.
    fn town(self, cameras: Vec<CameraSite>) -> Town {
        let Self { map, preset, own, pavement, land, areas, density, parcels, forecourts, seed, .. } = self;
        let street_features = features::features(map, &self.lane_surfaces, &pavement);
        let TownAssembly { placements, parked, lamps, occupied, .. } = self.assembly;
        let parking_bays = parking::usable(&self.kerb_bays, &occupied);
        let maize = preset.maize;
        let detail = DetailGround { pavement, land, areas, density, parcels, forecourts, occupied, maize, seed };
        Town {
            name: self.name.to_owned(),
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
        }
    }
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
