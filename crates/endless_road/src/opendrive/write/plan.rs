//! Which lanes make up which road, and how roads are joined.

use super::curve::{FittedLine, directions, tightened};
use crate::{Junction, Lane, LaneId, RoadNetwork};
use glam::{DVec2, DVec3};
use std::collections::BTreeSet;

/// Lanes of one road may be off their place beside its reference line by this, metres.
const MOST_OFF_M: f64 = 0.008;

/// Where an edge is shorter than its lane's middle by more than this share, lanes are laid from the middle.
const LEAST_EDGE: f64 = 0.3;

/// A road to write.
pub(super) struct PlannedRoad {
    /// From left to right in the direction of travel.
    pub(super) lanes: Vec<LaneId>,
    /// The reference line: the left edge of the leftmost lane, or in left-hand traffic the right edge of the rightmost.
    /// In bends too sharp for that, the middle of that lane.
    pub(super) line: FittedLine,
    /// `t` of that edge: 0, or half of that lane's width.
    pub(super) lane_offset: f64,
    /// The junction it lies in.
    pub(super) junction: Option<usize>,
}

/// What an end of a road is joined to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum RoadEndLink {
    Nothing,
    Road(usize),
    Junction(usize),
}

/// All roads of a network.
pub(super) struct WritePlan<'a> {
    pub(super) network: &'a RoadNetwork,
    pub(super) left_hand: bool,
    pub(super) roads: Vec<PlannedRoad>,
    /// The road of each lane.
    pub(super) road_of: Vec<usize>,
    /// Lanes that split or merge outside junctions: roads in, one direct junction each.
    pub(super) direct: Vec<BTreeSet<usize>>,
}

impl<'a> WritePlan<'a> {
    pub(super) fn new(network: &'a RoadNetwork, left_hand: bool) -> Self {
        let mut plan = Self {
            network,
            left_hand,
            roads: Vec::new(),
            road_of: vec![usize::MAX; network.lanes.len()],
            direct: Vec::new(),
        };
        for lane in &network.lanes {
            if plan.road_of[lane.id.index()] == usize::MAX {
                let group = side_by_side(network, lane, &plan.road_of);
                if !plan.add(&group) {
                    for lane in group {
                        plan.add(&[lane]);
                    }
                }
            }
        }
        plan.find_direct_junctions();
        plan
    }

    /// Adds a road of these lanes, if they keep their distances; a single lane always does.
    fn add(&mut self, lanes: &[LaneId]) -> bool {
        let network = self.network;
        let reference = if self.left_hand { lanes.len() - 1 } else { 0 };
        let points = network.lane(lanes[reference]).centerline.points();
        let mut along = directions(points);
        if lanes.len() > 1 {
            let other = network.lane(lanes[if reference == 0 { lanes.len() - 1 } else { 0 }]).centerline.points();
            if lanes.iter().any(|&lane| network.lane(lane).centerline.points().len() != points.len()) {
                return false;
            }
            // Straight across, from lane to lane, says the direction better than the points of one lane.
            for (i, direction) in along.iter_mut().enumerate() {
                let across = (points[i] - other[i]).truncate().normalize_or_zero();
                let seen = if reference == 0 { -across.perp() } else { across.perp() };
                if seen.dot(*direction) > 0.9 {
                    *direction = seen;
                }
            }
            let fits = lanes.iter().enumerate().all(|(k, &lane)| {
                let offset = self.offset(lanes, reference, k);
                network.lane(lane).centerline.points().iter().zip(points).zip(&along).all(|((p, q), direction)| {
                    let expected = *q + (direction.perp() * offset).extend(0.0);
                    p.distance(expected) < MOST_OFF_M
                })
            });
            if !fits {
                return false;
            }
        }
        for &lane in lanes {
            self.road_of[lane.index()] = self.roads.len();
        }
        let (points, along) = if lanes.len() > 1 { (points.to_vec(), along) } else { tightened(points, &along) };
        let half = 0.5 * network.lane(lanes[reference]).width_m;
        let to_edge = if self.left_hand { -half } else { half };
        let (line, lane_offset) = match edge(&points, &along, to_edge) {
            Some(edge) => (FittedLine::new(&edge, &along), 0.0),
            None => (FittedLine::new(&points, &along), to_edge),
        };
        let junction = network.lane(lanes[0]).junction.map(crate::JunctionId::index);
        self.roads.push(PlannedRoad { lanes: lanes.to_vec(), line, lane_offset, junction });
        true
    }

    /// `t` of the middle of lane `k`, from the middle of the reference lane.
    fn offset(&self, lanes: &[LaneId], reference: usize, k: usize) -> f64 {
        let width = |k: usize| self.network.lane(lanes[k]).width_m;
        let (low, high) = (k.min(reference), k.max(reference));
        let between: f64 = (low + 1..high).map(width).sum();
        let distance = if low == high { 0.0 } else { 0.5 * (width(low) + width(high)) + between };
        if k < reference { distance } else { -distance }
    }

    /// The OpenDRIVE id of a lane's road.
    pub(super) fn road_id(&self, lane: LaneId) -> u32 {
        self.road_of[lane.index()] as u32 + 1
    }

    /// The OpenDRIVE id of a lane.
    pub(super) fn lane_id(&self, lane: LaneId) -> i32 {
        let lanes = &self.roads[self.road_of[lane.index()]].lanes;
        let k = lanes.iter().position(|&l| l == lane).unwrap_or(0) as i32;
        if self.left_hand { lanes.len() as i32 - k } else { -1 - k }
    }

    /// What a road's beginning or end is joined to.
    pub(super) fn joined(&self, road: usize, at_end: bool) -> RoadEndLink {
        let linked = self.linked_lanes(road, at_end);
        let Some(&first) = linked.first() else { return RoadEndLink::Nothing };
        // From inside a junction always a road.
        if self.roads[road].junction.is_none() {
            if let Some(junction) = linked.iter().find_map(|&lane| self.network.lane(lane).junction) {
                return RoadEndLink::Junction(junction.index());
            }
            let into = if at_end { vec![road] } else { linked.iter().map(|l| self.road_of[l.index()]).collect() };
            if let Some(place) = self.direct.iter().position(|roads| roads.contains(&into[0])) {
                return RoadEndLink::Junction(self.network.junctions.len() + place);
            }
        }
        RoadEndLink::Road(self.road_of[first.index()])
    }

    /// The lanes that follow a road's lanes, or precede them.
    fn linked_lanes(&self, road: usize, at_end: bool) -> Vec<LaneId> {
        let of = |lane: &LaneId| {
            let lane = self.network.lane(*lane);
            if at_end { lane.successors.clone() } else { lane.predecessors.clone() }
        };
        self.roads[road].lanes.iter().flat_map(of).collect()
    }

    /// Roads outside junctions that lead to several others, or share the one they lead to.
    fn find_direct_junctions(&mut self) {
        let outside = |lane: &Lane| lane.junction.is_none();
        let mut groups: Vec<BTreeSet<usize>> = Vec::new();
        for road in 0..self.roads.len() {
            if self.roads[road].junction.is_some() {
                continue;
            }
            let roads_of = |lanes: Vec<LaneId>| -> BTreeSet<usize> {
                let lanes = lanes.into_iter().filter(|&lane| outside(self.network.lane(lane)));
                lanes.map(|lane| self.road_of[lane.index()]).collect()
            };
            let next = roads_of(self.linked_lanes(road, true));
            let mut into = BTreeSet::from([road]);
            for &to in &next {
                into.extend(roads_of(self.linked_lanes(to, false)));
            }
            if next.len() > 1 || into.len() > 1 {
                match groups.iter_mut().find(|group| !group.is_disjoint(&into)) {
                    Some(group) => group.extend(into),
                    None => groups.push(into),
                }
            }
        }
        self.direct = groups;
    }

    /// The lanes of roads that lead into a junction, with the connecting lane each leads to.
    pub(super) fn entries(&self, junction: &Junction) -> Vec<(LaneId, LaneId)> {
        let mut entries = Vec::new();
        for &way in &junction.lanes {
            for &before in &self.network.lane(way).predecessors {
                if self.network.lane(before).junction.is_none() {
                    entries.push((before, way));
                }
            }
        }
        entries
    }

    /// The right edge of a road as `t`.
    pub(super) fn right_edge(&self, road: usize) -> f64 {
        let width: f64 = self.roads[road].lanes.iter().map(|&lane| self.network.lane(lane).width_m).sum();
        self.roads[road].lane_offset - if self.left_hand { 0.0 } else { width }
    }
}

/// A chain moved to its left by `t`; `None` if that would fold it.
fn edge(points: &[DVec3], directions: &[DVec2], t: f64) -> Option<Vec<DVec3>> {
    let edge: Vec<DVec3> = points.iter().zip(directions).map(|(p, d)| *p + (d.perp() * t).extend(0.0)).collect();
    let keeps = |(inner, middle): (&[DVec3], &[DVec3])| {
        let along = (middle[1] - middle[0]).truncate();
        (inner[1] - inner[0]).truncate().dot(along) > LEAST_EDGE * along.length_squared()
    };
    edge.windows(2).zip(points.windows(2)).all(keeps).then_some(edge)
}

/// The lanes of a lane's carriageway, from left to right, that no road has yet.
fn side_by_side(network: &RoadNetwork, lane: &Lane, road_of: &[usize]) -> Vec<LaneId> {
    let mutual_left = |lane: &Lane| lane.left.filter(|&left| network.lane(left).right == Some(lane.id));
    let mutual_right = |lane: &Lane| lane.right.filter(|&right| network.lane(right).left == Some(lane.id));
    let free = |id: &LaneId| road_of[id.index()] == usize::MAX && network.lane(*id).junction == lane.junction;
    let mut lanes = vec![lane.id];
    let mut at = lane;
    while let Some(left) = mutual_left(at).filter(free).filter(|left| !lanes.contains(left)) {
        lanes.insert(0, left);
        at = network.lane(left);
    }
    at = lane;
    while let Some(right) = mutual_right(at).filter(free).filter(|right| !lanes.contains(right)) {
        lanes.push(right);
        at = network.lane(right);
    }
    lanes
}
