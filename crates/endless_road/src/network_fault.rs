//! What a network promises to those who use it, and where it does not keep it.

use crate::{Lane, LaneId, RoadNetwork, WalkKind};
use endless_world::math::f64::wrap_angle;
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Lanes that follow one another meet within this, metres and degrees.
const MOST_GAP_M: f64 = 0.05;
const MOST_KINK_DEG: f64 = 2.0;
/// Lanes side by side may share this much of their width, metres: a line is painted on it, and a lane that widens has
/// one width here.
const SHARED_M: f64 = 0.5;
/// Distance between the places at which lanes are compared, metres.
const STEP_M: f64 = 2.0;
/// Lanes this much above one another do not overlap, metres.
const OTHER_LEVEL_M: f64 = 2.5;
/// Lanes that become one or part from one may overlap this near to where they do, metres.
const TAPER_M: f64 = 60.0;
/// A vehicle reaches this share of the lanes that its own is joined to.
const REACH: f64 = 0.8;

/// The share of the lanes around that must be reached from a spawn point: on a map without a way around, as many as
/// may be.
pub(crate) fn enough_reach(network: &RoadNetwork, reach: &[f64]) -> f64 {
    let outside = network.lanes.iter().filter(|lane| lane.junction.is_none());
    outside.map(|lane| reach[lane.id.index()]).fold(0.0, f64::max).min(REACH)
}

/// A place on a lane with its arc length.
type LaneSample = (LaneId, f64, DVec3);

/// Kind of a defect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum NetworkFaultKind {
    /// Two lanes outside junctions lie on one another.
    Overlap,
    /// A lane ends more than 5 cm from where its successor begins.
    Gap,
    /// A lane ends more than 2° from the direction in which its successor begins.
    Kink,
    /// From a spawn point one can neither leave the map nor reach 80 % of the lanes that are joined to its own (or, where
    /// no lane reaches so many, as many as from the best).
    Reach,
    /// A crossing that does not join two sidewalks.
    Crossing,
    /// A place to walk that no way leads to.
    Isolated,
}

/// A defect of a lane network.
#[derive(Debug, Clone, PartialEq)]
pub struct NetworkFault {
    /// What.
    pub kind: NetworkFaultKind,
    /// Where.
    pub place: DVec3,
    /// In words.
    pub text: String,
}

impl RoadNetwork {
    /// Everything that is wrong with a finished network, as far as is known: lanes overlap outside junctions, lanes
    /// do not meet, spawn points lead nowhere, crossings or sidewalks hang in the air.
    pub fn faults(&self) -> Vec<NetworkFault> {
        let mut faults = Vec::new();
        self.find_overlaps(&mut faults);
        self.find_bad_joints(&mut faults);
        self.find_unreachable(&mut faults);
        self.find_bad_walks(&mut faults);
        faults
    }

    fn find_overlaps(&self, faults: &mut Vec<NetworkFault>) {
        let mut cells: BTreeMap<(i64, i64), Vec<LaneSample>> = BTreeMap::new();
        let cell = |p: DVec3| ((p.x / 8.0).floor() as i64, (p.y / 8.0).floor() as i64);
        for lane in self.lanes.iter().filter(|lane| lane.junction.is_none()) {
            let length = lane.centerline.length();
            let n = (length / STEP_M).ceil().max(2.0) as usize;
            for i in 1..n {
                let s = length * i as f64 / n as f64;
                let place = lane.centerline.position(s);
                cells.entry(cell(place)).or_default().push((lane.id, s, place));
            }
        }
        let mut told: BTreeSet<(LaneId, LaneId)> = BTreeSet::new();
        for (&(x, y), places) in &cells {
            let around = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy)));
            let others: Vec<_> = around.filter_map(|at| cells.get(&at)).flatten().collect();
            for &(a, s, p) in places {
                for &&(b, r, q) in others.iter().filter(|(b, ..)| *b > a) {
                    let (first, second) = (self.lane(a), self.lane(b));
                    let room = 0.5 * (first.width_m + second.width_m) - SHARED_M;
                    let flat = (p - q).truncate();
                    let near = flat.length() < room && (p.z - q.z).abs() < OTHER_LEVEL_M;
                    if near && !self.tapers((first, s), (second, r)) && told.insert((a, b)) {
                        // Samples are apart along the lane, too.
                        let apart = first.centerline.direction(s).perp_dot(flat).abs();
                        let text = format!("lanes {} and {} are {apart:.2} m apart", a.0, b.0);
                        faults.push(NetworkFault { kind: NetworkFaultKind::Overlap, place: p, text });
                    }
                }
            }
        }
    }

    /// Whether two places lie near a common end of their lanes, where one becomes two or two one.
    fn tapers(&self, (a, s): (&Lane, f64), (b, r): (&Lane, f64)) -> bool {
        let end = |lane: &Lane, s: f64| lane.centerline.length() - s;
        let shared = |a: &[LaneId], b: &[LaneId]| a.iter().any(|id| b.contains(id));
        (shared(&a.successors, &b.successors) && end(a, s).min(end(b, r)) < TAPER_M)
            || (shared(&a.predecessors, &b.predecessors) && s.min(r) < TAPER_M)
            || a.successors.contains(&b.id)
            || b.successors.contains(&a.id)
    }

    fn find_bad_joints(&self, faults: &mut Vec<NetworkFault>) {
        for lane in &self.lanes {
            let end = lane.centerline.at(lane.centerline.length());
            for &next in &lane.successors {
                let start = self.lane(next).centerline.at(0.0);
                let gap = end.position.distance(start.position);
                let kink = wrap_angle(start.heading_rad - end.heading_rad).abs().to_degrees();
                let place = end.position;
                if gap > MOST_GAP_M {
                    let text = format!("lane {} ends {gap:.3} m from lane {}", lane.id.0, next.0);
                    faults.push(NetworkFault { kind: NetworkFaultKind::Gap, place, text });
                }
                if kink > MOST_KINK_DEG {
                    let text = format!("lane {} ends {kink:.1}° from the direction of lane {}", lane.id.0, next.0);
                    faults.push(NetworkFault { kind: NetworkFaultKind::Kink, place, text });
                }
            }
        }
    }

    fn find_unreachable(&self, faults: &mut Vec<NetworkFault>) {
        let reach = self.lane_reach();
        let enough = enough_reach(self, &reach);
        let borders = self.borders();
        let leaves = if borders.are_open() { self.lanes_in_use(&borders) } else { vec![false; self.lanes.len()] };
        let lanes: BTreeSet<LaneId> = self.spawn_points.iter().map(|point| point.lane).collect();
        for lane in lanes {
            if reach[lane.index()] < enough && !leaves[lane.index()] {
                let percent = 100.0 * reach[lane.index()];
                let text = format!("from lane {} only {percent:.0} % of the lanes around are reached", lane.0);
                faults.push(NetworkFault {
                    kind: NetworkFaultKind::Reach,
                    place: self.lane(lane).centerline.position(0.0),
                    text,
                });
            }
        }
    }

    fn find_bad_walks(&self, faults: &mut Vec<NetworkFault>) {
        let walk = &self.walk;
        let mut edges = vec![0usize; walk.nodes.len()];
        let mut sidewalks = vec![0usize; walk.nodes.len()];
        let mut used = vec![false; self.crossings.len()];
        for edge in &walk.edges {
            for node in edge.nodes {
                edges[node.index()] += 1;
                sidewalks[node.index()] += usize::from(edge.kind == WalkKind::Sidewalk);
            }
        }
        for edge in &walk.edges {
            let WalkKind::Crossing(id) = edge.kind else { continue };
            used[id.index()] = true;
            for node in edge.nodes.into_iter().filter(|node| sidewalks[node.index()] == 0) {
                let text = format!("crossing {} does not end on a sidewalk", id.0);
                faults.push(NetworkFault { kind: NetworkFaultKind::Crossing, place: walk.nodes[node.index()], text });
            }
        }
        for (id, crossing) in self.crossings.iter().enumerate().filter(|(id, _)| !used[*id]) {
            let text = format!("crossing {id} is no way for anybody");
            faults.push(NetworkFault { kind: NetworkFaultKind::Crossing, place: crossing.ends[0], text });
        }
        for (id, &place) in walk.nodes.iter().enumerate().filter(|(id, _)| edges[*id] == 0) {
            faults.push(NetworkFault {
                kind: NetworkFaultKind::Isolated,
                place,
                text: format!("walk node {id} has no edge"),
            });
        }
    }
}
