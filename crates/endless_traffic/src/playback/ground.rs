//! What lies under a place of the map: lanes, sidewalks, their heights.

use endless_road::{CrossingId, LaneId, RoadNetwork, WalkKind};
use endless_world::math::f64::wrap_angle;
use endless_world::math::segment::share_along;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// Side of a cell, metres.
const CELL_M: f64 = 8.0;
/// Who is further from every lane and sidewalk is off the map, metres.
const OFF_MAP_M: f64 = 30.0;
/// Cells around a place in which something nearer than that may lie.
const FAR_CELLS: i32 = 4;
/// What is further above or below is another level, metres.
const LEVEL_M: f64 = 2.5;
/// What being on another level counts for, metres.
const OTHER_LEVEL_M: f64 = 100.0;
/// A lane that leads elsewhere is none that a vehicle is on, radians.
const ALONG: f64 = 1.0;
/// Who stands nearer to an end of a crossing waits for it, metres.
const KERB_M: f64 = 2.0;

/// What lies in each cell, by number.
type Cells = BTreeMap<(i32, i32), Vec<u32>>;

/// Lanes and sidewalks by place.
#[derive(Debug, Clone)]
pub(super) struct GroundIndex {
    lanes: Cells,
    /// Edges of the walk network: sidewalks, and crossings.
    walks: Cells,
}

/// A place on a lane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OnLane {
    pub(super) lane: LaneId,
    pub(super) s: f64,
}

fn cell(at: DVec2) -> (i32, i32) {
    ((at.x / CELL_M).floor() as i32, (at.y / CELL_M).floor() as i32)
}

fn put(cells: &mut Cells, at: DVec2, item: u32) {
    let list = cells.entry(cell(at)).or_default();
    if list.last() != Some(&item) {
        list.push(item);
    }
}

/// What of a list lies in the cells around a place, each once.
fn around(cells: &Cells, at: DVec2, reach: i32) -> Vec<u32> {
    let (x, y) = cell(at);
    let rows = (x.saturating_sub(reach)..=x.saturating_add(reach))
        .flat_map(|x| cells.range((x, y.saturating_sub(reach))..=(x, y.saturating_add(reach))));
    let mut found: Vec<u32> = rows.flat_map(|(_, list)| list.iter().copied()).collect();
    found.sort_unstable();
    found.dedup();
    found
}

impl GroundIndex {
    pub(super) fn new(network: &RoadNetwork) -> Self {
        let mut index = Self { lanes: BTreeMap::new(), walks: BTreeMap::new() };
        for lane in &network.lanes {
            let steps = (lane.centerline.length() / (0.5 * CELL_M)).ceil().max(1.0) as u32;
            for step in 0..=steps {
                let s = lane.centerline.length() * f64::from(step) / f64::from(steps);
                put(&mut index.lanes, lane.centerline.position(s).truncate(), lane.id.0);
            }
        }
        for (edge, number) in network.walk.edges.iter().zip(0..) {
            let [a, b] = edge.nodes.map(|node| network.walk.nodes[node.index()].truncate());
            let steps = (a.distance(b) / (0.5 * CELL_M)).ceil().max(1.0) as u32;
            for step in 0..=steps {
                put(&mut index.walks, a.lerp(b, f64::from(step) / f64::from(steps)), number);
            }
        }
        index
    }

    /// The lane that a vehicle with a heading is on; of several above one another the one at about this height.
    pub(super) fn lane(&self, network: &RoadNetwork, at: DVec2, yaw: f64, height_m: Option<f64>) -> Option<OnLane> {
        let mut best: Option<(f64, OnLane)> = None;
        for number in around(&self.lanes, at, 1) {
            let lane = &network.lanes[number as usize];
            let (s, t) = lane.centerline.project(at);
            let on = lane.centerline.at(s);
            let turned = wrap_angle(on.heading_rad - yaw).abs();
            if t.abs() > 0.5 * lane.width_m + 0.5 || turned > ALONG {
                continue;
            }
            let off = t.abs() + 2.0 * turned + other_level(on.position.z, height_m);
            if best.is_none_or(|(least, _)| off < least) {
                best = Some((off, OnLane { lane: lane.id, s }));
            }
        }
        best.map(|(_, on)| on)
    }

    /// Height of the ground, metres: of people that of sidewalks, where they are on one. `None` off the map.
    pub(super) fn height_m(
        &self,
        network: &RoadNetwork,
        at: DVec2,
        on_foot: bool,
        height_m: Option<f64>,
    ) -> Option<f64> {
        [1, FAR_CELLS].into_iter().find_map(|reach| {
            let lanes = around(&self.lanes, at, reach).into_iter().map(|number| {
                let lane = &network.lanes[number as usize];
                let (s, t) = lane.centerline.project(at);
                ((t.abs() - 0.5 * lane.width_m).max(0.0), t.abs(), lane.centerline.position(s).z)
            });
            let walks = around(&self.walks, at, reach).into_iter().filter_map(|number| {
                let edge = &network.walk.edges[number as usize];
                let [a, b] = edge.nodes.map(|node| network.walk.nodes[node.index()]);
                let nearest = a.lerp(b, share_along(at, a.truncate(), b.truncate()));
                let apart = nearest.truncate().distance(at);
                // Vehicles are on the road wherever it is near.
                let less = if on_foot { 0.0 } else { 2.0 };
                let sidewalk = matches!(edge.kind, WalkKind::Sidewalk);
                sidewalk.then_some(((apart - 0.5 * edge.width_m).max(0.0) + less, apart + less, nearest.z))
            });
            let mut best: Option<(f64, f64, f64)> = None;
            for (beside, apart, z) in lanes.chain(walks).filter(|(beside, ..)| *beside <= OFF_MAP_M) {
                let beside = beside + other_level(z, height_m);
                if best.is_none_or(|(least, nearest, _)| (beside, apart) < (least, nearest)) {
                    best = Some((beside, apart, z));
                }
            }
            best.map(|(.., z)| z)
        })
    }

    /// The crossing underfoot, and metres along it from its first end; or the one at whose end somebody is.
    pub(super) fn crossing(network: &RoadNetwork, at: DVec2) -> Option<OnCrossing> {
        let mut nearest: Option<OnCrossing> = None;
        for (crossing, id) in network.crossings.iter().zip(0..) {
            let [from, to] = crossing.ends.map(DVec3::truncate);
            let length = from.distance(to);
            let along = (to - from).normalize_or_zero();
            let (along_m, beside_m) = ((at - from).dot(along), along.perp_dot(at - from).abs());
            let beyond_m = (-along_m).max(along_m - length);
            if beside_m < 0.5 * crossing.width_m + 0.5
                && beyond_m < KERB_M
                && nearest.is_none_or(|other| beyond_m < other.beyond_m)
            {
                nearest = Some(OnCrossing { crossing: CrossingId(id), along_m, along, beyond_m });
            }
        }
        nearest
    }
}

/// A place on a crossing, or at its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OnCrossing {
    pub(super) crossing: CrossingId,
    /// From its first end, metres.
    pub(super) along_m: f64,
    /// Its direction from there, a unit vector.
    pub(super) along: DVec2,
    /// Metres to its end; negative on it.
    pub(super) beyond_m: f64,
}

fn other_level(z: f64, height_m: Option<f64>) -> f64 {
    if height_m.is_some_and(|height| (height - z).abs() > LEVEL_M) { OTHER_LEVEL_M } else { 0.0 }
}
