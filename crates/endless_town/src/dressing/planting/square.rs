//! What stands on squares and along the ways of parks: trees in rows, benches, café tables, planters, lamps, kiosks; a
//! railing where a square ends at the water.

use crate::camera::{blocks_view, occludes_view};
use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::land_use_map::LandUseMap;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::road_furniture::post::RoadsidePosts;
use crate::geometry::{inside, unit};
use endless_asset::Prop;
use endless_road::{LandUse, LandUseArea, RoadNetwork};
use endless_world::math::f64::atan2;
use endless_world::math::segment::share_along;
use endless_world::{CameraSite, Stream};
use glam::{DVec2, Vec3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Distance between the places at which something may stand, metres.
const STEP_M: f64 = 4.6;
/// A place this near to the edge of a square belongs to its border, metres.
const BORDER_M: f64 = 5.0;
/// Things keep so far from the edge, and from the ways of people, metres.
const INSET_M: f64 = 1.3;
const BESIDE_WAY_M: f64 = 0.7;
/// Between lamps, and between benches of a park, metres.
const LAMPS_M: f64 = 22.0;
const BENCHES_M: f64 = 13.0;
/// A square ends at the water if it begins within this distance, metres.
const WATERSIDE_M: f64 = 9.0;
/// Half the room that a fountain and a monument take, metres.
const FOUNTAIN_M: f64 = 2.8;
const MONUMENT_M: f64 = 1.3;
/// Most things on all squares of a map.
const MOST: usize = 1500;

/// A way of people, with half its width.
struct WalkSegment {
    from: DVec2,
    to: DVec2,
    half: f64,
}

impl WalkSegment {
    fn distance(&self, p: DVec2) -> f64 {
        let along = self.to - self.from;
        let t = share_along(p, self.from, self.to);
        (self.from + along * t).distance(p) - self.half
    }
}

/// Furnishes squares and parks.
pub(crate) struct SquareFurnisher<'a> {
    pub(crate) network: &'a RoadNetwork,
    pub(crate) pavement: &'a PavementIndex,
    pub(crate) land: &'a GroundGrid,
    pub(crate) areas: &'a LandUseMap,
}

impl SquareFurnisher<'_> {
    pub(crate) fn add(&self, assembly: &mut TownAssembly<'_>, posts: &RoadsidePosts<'_>, sites: &[CameraSite]) {
        let begin = assembly.placements.len();
        for (i, area) in self.areas.of(LandUse::Plaza).enumerate() {
            let mut stream = assembly.stream(120_000 + i as u64);
            if assembly.placements.len() - begin < MOST {
                self.waterside(assembly, area);
                self.square(assembly, posts, sites, area, &mut stream);
            }
        }
        for area in self.areas.of(LandUse::Park) {
            if assembly.placements.len() - begin < MOST {
                self.park(assembly, posts, sites, area);
            }
        }
    }

    /// The ways that pass through an area.
    fn ways(&self, area: &LandUseArea) -> Vec<WalkSegment> {
        let (low, high) = bounds(&area.outline);
        let walk = &self.network.walk;
        let all = walk.edges.iter().map(|e| {
            let [from, to] = e.nodes.map(|n| walk.nodes[n.index()].truncate());
            WalkSegment { from, to, half: e.width_m / 2.0 }
        });
        all.filter(|w| w.from.min(w.to).cmple(high).all() && w.from.max(w.to).cmpge(low).all()).collect()
    }

    fn spot(&self, at: DVec2, yaw: f64) -> PropPose {
        let z = self.pavement.height(at, self.land.level(at) + 0.5).unwrap_or_else(|| self.land.level(at));
        PropPose { z: z - 0.03, ..PropPose::new(at, yaw) }
    }

    fn square(
        &self,
        assembly: &mut TownAssembly<'_>,
        posts: &RoadsidePosts<'_>,
        sites: &[CameraSite],
        area: &LandUseArea,
        stream: &mut Stream,
    ) {
        let rect = crate::geometry::around(&area.outline);
        let ways = self.ways(area);
        // Tables stand together, at one corner of the square.
        let cafe = rect.corners()[stream.below(4)];
        let reach = rect.half.min_element() * 0.9;
        let (nx, ny) = ((rect.half.x / STEP_M).floor() as i32, (rect.half.y / STEP_M).floor() as i32);
        let mut lamps: Vec<DVec2> = Vec::new();
        self.centrepiece(assembly, sites, area, &ways, stream);
        for row in -ny..=ny {
            for column in -nx..=nx {
                let at = rect.centre
                    + rect.axis * (f64::from(column) * STEP_M)
                    + rect.axis.perp() * (f64::from(row) * STEP_M);
                let (dice, turn) = (stream.f64(), stream.f64());
                let edge = edge_distance(&area.outline, at);
                let clear = inside(&area.outline, at)
                    && !area.holes.iter().any(|h| inside(h, at))
                    && edge > INSET_M
                    && !self.pavement.is_near(at, 1.0);
                if !clear {
                    continue;
                }
                let room = ways.iter().map(|w| w.distance(at)).fold(f64::INFINITY, f64::min) - BESIDE_WAY_M;
                let inwards = rect.centre - at;
                let facing = atan2(inwards.y, inwards.x);
                let tall_is_seen = blocks_view(sites, at, 2.2);
                let lit = lamps.iter().all(|l| l.distance(at) > LAMPS_M);
                if lit && room > 0.25 && !occludes_view(sites, at) {
                    if posts.lamp(assembly, at, self.spot(at, facing).z, facing) {
                        lamps.push(at);
                    }
                    continue;
                }
                let tree = (column + row).rem_euclid(2) == 0;
                let (prop, half, yaw) = match dice {
                    d if at.distance(cafe) < reach && d < 0.8 => (Prop::CafeTable, [1.25, 1.25], TAU * turn),
                    d if tree && d < 0.85 && !tall_is_seen => (Prop::BroadleafTree, [0.5, 0.5], TAU * turn),
                    d if edge < BORDER_M && d < 0.35 => (Prop::Bench, [0.42, 0.95], facing),
                    d if edge < BORDER_M && d < 0.5 => (Prop::BikeRack, [0.5, 0.4], facing),
                    d if edge < BORDER_M && d < 0.62 => (Prop::Bin, [0.3, 0.3], facing),
                    d if d < 0.3 => (Prop::Planter, [0.4, 0.8], facing),
                    d if d < 0.36 => (Prop::BikeStand, [0.4, 1.2], facing),
                    d if d < 0.42 => (Prop::StoneBench, [0.3, 1.1], facing),
                    d if d < 0.5 => (Prop::Bench, [0.42, 0.95], facing + FRAC_PI_2),
                    d if d > 0.9 && !tall_is_seen => (Prop::MarketStall, [1.2, 1.5], facing),
                    d if d > 0.87 && !tall_is_seen => (Prop::AdvertColumn, [0.75, 0.75], facing),
                    d if d > 0.84 && !tall_is_seen => (Prop::Kiosk, [1.4, 1.4], facing),
                    _ => continue,
                };
                if f64::max(half[0], half[1]) < room {
                    let scale = if prop == Prop::BroadleafTree { 0.7 + 0.25 * turn as f32 } else { 1.0 };
                    let spot = PropPose { scale: Vec3::splat(scale), ..self.spot(at, yaw) };
                    assembly.put(prop, spot, DVec2::from_array(half), None);
                }
            }
        }
    }

    /// A fountain or a monument where the ways of people leave most room.
    fn centrepiece(
        &self,
        assembly: &mut TownAssembly<'_>,
        sites: &[CameraSite],
        area: &LandUseArea,
        ways: &[WalkSegment],
        stream: &mut Stream,
    ) {
        let rect = crate::geometry::around(&area.outline);
        let place = |i: i32| {
            let (x, y) = (f64::from(i % 13 - 6) / 9.0, f64::from(i / 13 - 6) / 9.0);
            rect.centre + rect.axis * (rect.half.x * x) + rect.axis.perp() * (rect.half.y * y)
        };
        let room = |at: DVec2| {
            let hole = area.holes.iter().map(|h| edge_distance(h, at)).fold(f64::INFINITY, f64::min);
            let paved = if self.pavement.is_near(at, FOUNTAIN_M) { 0.0 } else { f64::INFINITY };
            let way = ways.iter().map(|w| w.distance(at)).fold(f64::INFINITY, f64::min) - BESIDE_WAY_M;
            // The middle, if there is a choice.
            let central = 0.05 * (rect.half.length() - at.distance(rect.centre));
            edge_distance(&area.outline, at).min(hole).min(paved).min(way).min(FOUNTAIN_M + 0.5) + central
        };
        let open = |at: &DVec2| inside(&area.outline, *at) && !area.holes.iter().any(|h| inside(h, *at));
        let best = (0..169).map(place).filter(open).max_by(|a, b| room(*a).total_cmp(&room(*b)));
        let Some((at, room)) = best.map(|at| (at, room(at))) else { return };
        let inwards = rect.centre - at;
        let facing = if inwards.length() > 1.0 { atan2(inwards.y, inwards.x) } else { stream.range_f64(0.0, TAU) };
        let fountain = stream.chance(0.6);
        let (prop, half) = match room {
            r if r > FOUNTAIN_M && fountain => (Prop::Fountain, FOUNTAIN_M),
            r if r > MONUMENT_M => (Prop::Monument, MONUMENT_M),
            _ => return,
        };
        if !occludes_view(sites, at) {
            assembly.put(prop, self.spot(at, facing), DVec2::splat(half), None);
        }
    }

    /// A railing along the sides behind which water begins.
    fn waterside(&self, assembly: &mut TownAssembly<'_>, area: &LandUseArea) {
        const PANEL_M: f64 = 2.0;
        let n = area.outline.len();
        let turn = if crate::geometry::area(&area.outline) > 0.0 { 1.0 } else { -1.0 };
        for k in 0..n {
            let (a, b) = (area.outline[k], area.outline[(k + 1) % n]);
            let along = (b - a).normalize_or(DVec2::X);
            let out = -along.perp() * turn;
            for i in 0..(a.distance(b) / PANEL_M).floor() as usize {
                let at = a + along * (PANEL_M * (i as f64 + 0.5));
                let water =
                    (1..=WATERSIDE_M as i32).any(|d| self.areas.at(at + out * f64::from(d)) == Some(LandUse::Water));
                if water {
                    let spot = self.spot(at - out * 0.3, atan2(along.y, along.x));
                    assembly.put(Prop::Railing, spot, DVec2::new(PANEL_M / 2.0 - 0.02, 0.1), None);
                }
            }
        }
    }

    /// Benches, bins and lamps beside the ways of a park.
    fn park(
        &self,
        assembly: &mut TownAssembly<'_>,
        posts: &RoadsidePosts<'_>,
        sites: &[CameraSite],
        area: &LandUseArea,
    ) {
        let mut lamps: Vec<DVec2> = Vec::new();
        let mut benches: Vec<DVec2> = Vec::new();
        for (i, way) in self.ways(area).iter().enumerate() {
            let along = (way.to - way.from).normalize_or(DVec2::X);
            let side = if i % 2 == 0 { 1.0 } else { -1.0 };
            let at = way.from.midpoint(way.to) + along.perp() * (side * (way.half + 0.9));
            let open = inside(&area.outline, at) && !self.pavement.is_near(at, 0.3);
            let facing = atan2(-along.perp().y * side, -along.perp().x * side);
            if !open {
                continue;
            }
            if lamps.iter().all(|l| l.distance(at) > LAMPS_M) && !occludes_view(sites, at) {
                if posts.lamp(assembly, at, self.spot(at, facing).z, facing) {
                    lamps.push(at);
                }
            } else if benches.iter().all(|b| b.distance(at) > BENCHES_M)
                && assembly.put(Prop::Bench, self.spot(at, facing), DVec2::new(0.42, 0.95), None)
            {
                benches.push(at);
                let beside = at + unit(facing).perp() * 1.5;
                if inside(&area.outline, beside) && !self.pavement.is_near(beside, 0.1) {
                    assembly.put(Prop::Bin, self.spot(beside, facing), DVec2::splat(0.3), None);
                }
            }
        }
    }
}

fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    points.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), &p| (l.min(p), h.max(p)))
}

/// Distance to the nearest side of an outline.
fn edge_distance(outline: &[DVec2], p: DVec2) -> f64 {
    let n = outline.len();
    let side = |k: usize| WalkSegment { from: outline[k], to: outline[(k + 1) % n], half: 0.0 }.distance(p);
    (0..n).map(side).fold(f64::INFINITY, f64::min)
}
