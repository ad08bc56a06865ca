//! Where people walk: sidewalk lanes, joined where the file joins them or where they touch, and crossings.

use super::super::document::ContactPoint;
use super::lane_links::LaneEnd;
use super::lane_surfaces::sidewalk_lift;
use super::lane_types::is_walked;
use super::sampled::SampledDocument;
use crate::{Crossing, CrossingId, ImportNote, WalkEdge, WalkKind, WalkNetwork, WalkNodeId};
use endless_world::math::segment::share_along;
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Longest edge, metres.
const LONGEST_M: f64 = 8.0;
/// Lines are simplified within this, metres.
const TOLERANCE_M: f64 = 0.15;
/// Ends nearer than this are one place, metres; those that the file links may be further apart.
const TOUCH_M: f64 = 0.8;
const LINKED_M: f64 = 3.0;
/// A crossing reaches sidewalks no further from its end than this, metres.
const REACH_M: f64 = 9.0;
/// Kept free along the edges of sidewalks, metres.
const MARGIN_M: f64 = 0.5;
const NARROWEST_M: f64 = 0.4;

/// The walk network. Crossings that do not lead from one sidewalk to another are taken out, with a note.
pub(super) fn walk(
    sampled: &SampledDocument<'_>,
    joins: &BTreeSet<(LaneEnd, LaneEnd)>,
    crossings: &mut Vec<Crossing>,
    notes: &mut Vec<ImportNote>,
) -> WalkNetwork {
    let mut walk = WalkBuilder::default();
    let ends = walk.add_lanes(sampled);
    walk.join_ends(&ends, joins);
    let mut kept = Vec::new();
    for crossing in std::mem::take(crossings) {
        if walk.add_crossing(&crossing, CrossingId(kept.len() as u16)) {
            kept.push(crossing);
        } else {
            let [a, b] = crossing.ends;
            let middle = a.midpoint(b);
            let place = format!("crosswalk at ({:.1}, {:.1})", middle.x, middle.y);
            notes.push(ImportNote { place, text: "leads to no sidewalk at one end: people do not use it".to_owned() });
        }
    }
    *crossings = kept;
    walk.finish()
}

#[derive(Default)]
struct WalkBuilder {
    nodes: Vec<DVec3>,
    /// Split edges are replaced by their first half; new ones are added at the end.
    edges: Vec<WalkEdge>,
}

impl WalkBuilder {
    fn node(&mut self, place: DVec3) -> WalkNodeId {
        self.nodes.push(place);
        WalkNodeId((self.nodes.len() - 1) as u32)
    }

    fn edge(&mut self, a: WalkNodeId, b: WalkNodeId, width_m: f64, kind: WalkKind) {
        self.edges.push(WalkEdge { nodes: [a, b], width_m, kind });
    }

    fn add_lanes(&mut self, sampled: &SampledDocument<'_>) -> BTreeMap<LaneEnd, WalkNodeId> {
        let lift = DVec3::Z * sidewalk_lift(sampled);
        let mut ends = BTreeMap::new();
        for (key, _) in sampled.keys().filter(|(_, record)| is_walked(&record.kind)) {
            let Some(lane) = sampled.lane(key) else { continue };
            let width = lane.width.iter().sum::<f64>() / lane.width.len() as f64;
            if width < NARROWEST_M {
                continue;
            }
            let line = simplified(&lane.middle());
            let mut last = None;
            for (i, &place) in line.iter().enumerate() {
                let here = self.node(place + lift);
                match last {
                    None => drop(ends.insert((key, ContactPoint::Start), here)),
                    Some(last) => self.edge(last, here, (width - MARGIN_M).max(NARROWEST_M), WalkKind::Sidewalk),
                }
                if i + 1 == line.len() {
                    ends.insert((key, ContactPoint::End), here);
                }
                last = Some(here);
            }
        }
        ends
    }

    /// Makes one node of ends that are linked or touch.
    fn join_ends(&mut self, ends: &BTreeMap<LaneEnd, WalkNodeId>, joins: &BTreeSet<(LaneEnd, LaneEnd)>) {
        let mut same: Vec<usize> = (0..self.nodes.len()).collect();
        fn root(same: &mut [usize], mut i: usize) -> usize {
            while same[i] != i {
                same[i] = same[same[i]];
                i = same[i];
            }
            i
        }
        let near = |nodes: &[DVec3], a: WalkNodeId, b: WalkNodeId, most: f64| {
            nodes[a.index()].distance(nodes[b.index()]) < most
        };
        let linked = joins.iter().filter_map(|(a, b)| Some((*ends.get(a)?, *ends.get(b)?)));
        let mut pairs: Vec<(WalkNodeId, WalkNodeId)> =
            linked.filter(|&(a, b)| near(&self.nodes, a, b, LINKED_M)).collect();
        // Touching ends, found in a grid of cells as large as the reach.
        let cell = |p: DVec3| ((p.x / TOUCH_M).floor() as i64, (p.y / TOUCH_M).floor() as i64);
        let mut grid: BTreeMap<(i64, i64), Vec<WalkNodeId>> = BTreeMap::new();
        for &node in ends.values() {
            let (x, y) = cell(self.nodes[node.index()]);
            for dx in -1..=1 {
                for dy in -1..=1 {
                    let others = grid.get(&(x + dx, y + dy)).into_iter().flatten();
                    pairs.extend(others.filter(|&&o| near(&self.nodes, o, node, TOUCH_M)).map(|&o| (o, node)));
                }
            }
            // Many ends in one place are joined through the first.
            let here = grid.entry((x, y)).or_default();
            if here.len() < 8 {
                here.push(node);
            }
        }
        for (a, b) in pairs {
            let (a, b) = (root(&mut same, a.index()), root(&mut same, b.index()));
            same[a.max(b)] = a.min(b);
        }
        let mut sums: BTreeMap<usize, (DVec3, f64)> = BTreeMap::new();
        for i in 0..same.len() {
            let at = root(&mut same, i);
            let sum = sums.entry(at).or_default();
            *sum = (sum.0 + self.nodes[i], sum.1 + 1.0);
        }
        for (at, (sum, n)) in sums {
            self.nodes[at] = sum / n;
        }
        for edge in &mut self.edges {
            edge.nodes = edge.nodes.map(|node| WalkNodeId(root(&mut same, node.index()) as u32));
        }
        self.edges.retain(|edge| edge.nodes[0] != edge.nodes[1]);
    }

    /// Joins both ends of a crossing to the nearest sidewalks; tells whether there are two.
    fn add_crossing(&mut self, crossing: &Crossing, id: CrossingId) -> bool {
        let [a, b] = crossing.ends;
        let outwards = (b - a).truncate().normalize_or_zero();
        let (Some(at_a), Some(at_b)) = (self.nearest(a, -outwards), self.nearest(b, outwards)) else { return false };
        if at_a.0 == at_b.0 && at_a.1.distance(at_b.1) < 1.0 {
            return false;
        }
        let ways = [(a, at_a.1), (b, at_b.1)];
        let mut feet = Vec::new();
        for (end, foot) in ways {
            // Splitting for one end may have cut the edge of the other: look again.
            let sidewalk = self.split_at(foot);
            let kerb = end.truncate().extend(foot.z);
            if kerb.distance(foot) > 0.6 {
                let node = self.node(kerb);
                self.edge(node, sidewalk, (crossing.width_m - MARGIN_M).clamp(0.8, 3.0), WalkKind::Sidewalk);
                feet.push(node);
            } else {
                feet.push(sidewalk);
            }
        }
        if feet[0] == feet[1] {
            return false;
        }
        let width = (crossing.width_m - 0.4).max(NARROWEST_M);
        self.edge(feet[0], feet[1], width, WalkKind::Crossing(id));
        true
    }

    /// The sidewalk edge nearest to a crossing's end, and the place on it; rather outwards than back over the road.
    fn nearest(&self, end: DVec3, outwards: glam::DVec2) -> Option<(usize, DVec3)> {
        let mut best = (REACH_M, None);
        for (i, edge) in self.edges.iter().enumerate().filter(|(_, edge)| edge.kind == WalkKind::Sidewalk) {
            let [a, b] = edge.nodes.map(|node| self.nodes[node.index()]);
            let along = b - a;
            let t = share_along(end, a, b);
            let foot = a + along * t;
            let back = (-(foot - end).truncate().dot(outwards) - 1.0).max(0.0);
            let distance = foot.distance(end) + 3.0 * back;
            if distance < best.0 && (foot.z - end.z).abs() < 1.5 {
                best = (distance, Some((i, foot)));
            }
        }
        best.1
    }

    /// The node at a place on a sidewalk edge: one of its ends if that is near, or a new one.
    fn split_at(&mut self, place: DVec3) -> WalkNodeId {
        let mut best = (f64::INFINITY, 0);
        for (i, edge) in self.edges.iter().enumerate().filter(|(_, edge)| edge.kind == WalkKind::Sidewalk) {
            let [a, b] = edge.nodes.map(|node| self.nodes[node.index()]);
            let along = b - a;
            let t = share_along(place, a, b);
            let distance = place.distance(a + along * t);
            if distance < best.0 {
                best = (distance, i);
            }
        }
        let edge = self.edges[best.1];
        for node in edge.nodes {
            if self.nodes[node.index()].distance(place) < 1.0 {
                return node;
            }
        }
        let middle = self.node(place);
        self.edges[best.1].nodes[1] = middle;
        self.edge(middle, edge.nodes[1], edge.width_m, edge.kind);
        middle
    }

    /// Nodes without edges dropped, and edges that are given twice.
    fn finish(mut self) -> WalkNetwork {
        let mut seen = BTreeSet::new();
        self.edges.retain(|edge| {
            let [a, b] = edge.nodes;
            a != b && (edge.kind != WalkKind::Sidewalk || seen.insert((a.min(b), a.max(b))))
        });
        let mut place: BTreeMap<WalkNodeId, WalkNodeId> = BTreeMap::new();
        let mut nodes = Vec::new();
        for edge in &mut self.edges {
            edge.nodes = edge.nodes.map(|node| {
                *place.entry(node).or_insert_with(|| {
                    nodes.push(self.nodes[node.index()]);
                    WalkNodeId((nodes.len() - 1) as u32)
                })
            });
        }
        WalkNetwork { nodes, edges: self.edges }
    }
}

/// Fewer points on the same line (Douglas and Peucker 1973), none further apart than an edge may be.
fn simplified(line: &[DVec3]) -> Vec<DVec3> {
    let mut keep = vec![false; line.len()];
    (keep[0], keep[line.len() - 1]) = (true, true);
    let mut open = vec![(0, line.len() - 1)];
    while let Some((a, b)) = open.pop() {
        let along = line[b] - line[a];
        let off = |i: usize| {
            let t = share_along(line[i], line[a], line[b]);
            line[i].distance(line[a] + along * t)
        };
        let Some(worst) = (a + 1..b).max_by(|&i, &j| off(i).total_cmp(&off(j))) else { continue };
        if off(worst) > TOLERANCE_M {
            keep[worst] = true;
            open.extend([(a, worst), (worst, b)]);
        }
    }
    let kept: Vec<DVec3> = line.iter().zip(keep).filter(|(_, keep)| *keep).map(|(p, _)| *p).collect();
    let mut out = vec![kept[0]];
    for pair in kept.windows(2) {
        let n = (pair[0].distance(pair[1]) / LONGEST_M).ceil().clamp(1.0, 1e5) as usize;
        out.extend((1..=n).map(|i| if i == n { pair[1] } else { pair[0].lerp(pair[1], i as f64 / n as f64) }));
    }
    out
}
