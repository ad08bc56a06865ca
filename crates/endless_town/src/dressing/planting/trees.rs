//! Trees and bushes: those of the map, rows along streets, woods and parks, and woods on the hills around.

use crate::camera::blocks_view;
use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::dressing::built_up::density::StreetDensity;
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::land_use_map::LandUseMap;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::preset::TownPreset;
use crate::dressing::road_furniture::post::RoadsidePosts;
use crate::geometry::Rect;
use endless_asset::Prop;
use endless_road::{LandUse, MapObjectKind, RoadMap};
use endless_world::{CameraSite, Stream};
use glam::{DVec2, Vec3};
use std::f64::consts::TAU;

/// Most trees of each sort of planting.
const MOST_ON_LAND: usize = 2600;
const MOST_ON_HILLS: usize = 1100;
const MOST_IN_ROWS: usize = 900;
/// Distance between street trees, metres.
const ROW_M: f64 = 15.0;

/// Plants a map.
pub(crate) struct TreePlanter<'a> {
    pub(crate) map: &'a RoadMap,
    pub(crate) pavement: &'a PavementIndex,
    pub(crate) land: &'a GroundGrid,
    pub(crate) areas: &'a LandUseMap,
    pub(crate) density: &'a StreetDensity,
    pub(crate) preset: &'a TownPreset,
    pub(crate) seed: u64,
}

fn tall(at: DVec2, z: f64, size: (f32, f32), stream: &mut Stream) -> PropPose {
    let scale = Vec3::splat(stream.range_f32(size.0, size.1));
    PropPose { at, z: z - 0.03, yaw: stream.range_f64(0.0, TAU), scale }
}

impl TreePlanter<'_> {
    /// The trees that the map knows of; they were there before any camera.
    pub(crate) fn known(&self, assembly: &mut TownAssembly<'_>) -> Vec<DVec2> {
        let mut stream = assembly.stream(20_000);
        let mut placed = Vec::new();
        for object in &self.map.objects {
            let MapObjectKind::Tree(height) = object.kind else { continue };
            let at = object.position.truncate();
            if self.pavement.is_carriageway(at) {
                continue;
            }
            let scale = height.map_or_else(|| stream.range_f32(0.85, 1.15), |h| (h as f32 / 9.0).clamp(0.45, 2.0));
            let z = self.pavement.height(at, object.position.z + 2.0).unwrap_or_else(|| self.land.height(at));
            let spot = PropPose { at, z, yaw: stream.range_f64(0.0, TAU), scale: Vec3::splat(scale) };
            if assembly.put(Prop::BroadleafTree, spot, DVec2::splat(0.4), None) {
                placed.push(at);
            }
        }
        placed
    }

    /// A row behind the kerb or beside the road, where no camera looks through it.
    pub(crate) fn rows(
        &self,
        assembly: &mut TownAssembly<'_>,
        posts: &RoadsidePosts<'_>,
        sites: &[CameraSite],
        houses: &[Rect],
    ) {
        let mut planted = 0;
        for (i, lane) in self.map.network.lanes.iter().enumerate() {
            let length = lane.centerline.length();
            if lane.junction.is_some() || !posts.is_outermost(lane) || length < 20.0 {
                continue;
            }
            let mut stream = assembly.stream(21_000 + i as u64);
            let fast = lane.speed_limit_mps > 16.0;
            let mut s = stream.range_f64(4.0, 10.0);
            while s < length - 5.0 && planted < MOST_IN_ROWS {
                let beyond = if fast { stream.range_f64(4.0, 9.0) } else { 0.75 };
                let verge = posts.verge(lane, s, posts.side(), beyond);
                s += ROW_M * stream.range_f64(0.85, if fast { 2.6 } else { 1.3 });
                let Some(verge) = verge else { continue };
                // Narrow sidewalks have no room for trees.
                let roomy = fast || !verge.walk || {
                    let out = (verge.at - lane.centerline.at(s).position.truncate()).normalize_or(DVec2::X);
                    self.pavement.is_paved(verge.at + out * 1.9)
                };
                let lit = assembly.lamps.iter().any(|l| l.position.truncate().as_dvec2().distance(verge.at) < 4.5);
                let crown = Rect::around(verge.at, 2.2);
                let blocked = lit || blocks_view(sites, verge.at, 2.6) || houses.iter().any(|h| h.meets(&crown));
                if roomy && !blocked && stream.chance(0.85) {
                    let spot = tall(verge.at, verge.z, (0.8, 1.05), &mut stream);
                    let prop = if stream.chance(self.preset.palms) { Prop::Palm } else { Prop::BroadleafTree };
                    planted += usize::from(assembly.put(prop, spot, DVec2::splat(0.4), None));
                }
            }
        }
    }

    /// Trees and bushes on open land: dense in woods, sparse in gardens and meadows.
    pub(crate) fn land(&self, assembly: &mut TownAssembly<'_>, sites: &[CameraSite], low: DVec2, high: DVec2) {
        let mut stream = assembly.stream(22_000);
        let (low, size) = (low - 60.0, high - low + 120.0);
        let hectares = size.x * size.y / 10_000.0;
        let tries = (hectares * 70.0).min(60_000.0) as usize;
        let mut planted = 0;
        for _ in 0..tries {
            let at = low + size * DVec2::new(stream.f64(), stream.f64());
            let (dice, kind, height) = (stream.f64(), stream.f64(), stream.range_f32(0.8, 1.2));
            let (tree, bush) = match self.areas.at(at) {
                Some(LandUse::Wood) => (1.0, 0.0),
                Some(LandUse::Park) => (0.5, 0.2),
                Some(LandUse::Grass | LandUse::Residential) => (0.3, 0.2),
                Some(_) => (0.0, 0.0),
                None if self.density.at(at) > 60.0 => (0.3, 0.25),
                None => (0.4, 0.1),
            };
            let (prop, room) = match dice {
                d if d < tree && kind < self.preset.conifers => (Prop::Conifer, 2.2),
                d if d < tree && kind > 1.0 - self.preset.palms => (Prop::Palm, 1.8),
                d if d < tree => (Prop::BroadleafTree, 2.4),
                d if d < tree + bush => (Prop::Bush, 0.9),
                _ => continue,
            };
            if planted >= MOST_ON_LAND || self.pavement.is_near(at, room + 0.8) || blocks_view(sites, at, room) {
                continue;
            }
            if assembly.occupied.is_free(&Rect::around(at, room)) {
                let spot =
                    PropPose { scale: Vec3::splat(height), ..tall(at, self.land.height(at), (1.0, 1.01), &mut stream) };
                planted += usize::from(assembly.put(
                    prop,
                    spot,
                    DVec2::splat(if prop == Prop::Bush { 0.6 } else { 1.2 }),
                    None,
                ));
            }
        }
    }

    /// Woods around the map: they hide the edge of the world.
    pub(crate) fn hills(&self, assembly: &mut TownAssembly<'_>) {
        let mut stream = assembly.stream(23_000);
        for _ in 0..MOST_ON_HILLS {
            let ring = stream.weighted(&[1.2, 1.5, 1.5, 0.9]);
            let place = self.land.on_hills(self.seed, ring, (stream.f64(), stream.f64()));
            let prop = if stream.chance(self.preset.conifers + 0.13) { Prop::Conifer } else { Prop::BroadleafTree };
            let spot = tall(place.truncate(), place.z, (0.9, 1.4), &mut stream);
            assembly.place(prop, spot, None);
        }
    }
}
