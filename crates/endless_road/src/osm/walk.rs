//! Where people walk: sidewalks, corners, crossings.

use super::crossing::CROSSING_M;
use super::curve::simplified;
use super::graph::StreetSegmentEnd;
use super::junction_surface::{corner_line, walk_width};
use super::lane::inside;
use super::plan::StreetPlan;
use super::section::KERB_M;
use super::surface::{KERB_HEIGHT_M, STUB_M};
use crate::{Crossing, CrossingId, RoadNetwork, WalkEdge, WalkKind, WalkNetwork, WalkNodeId};
use glam::DVec3;

/// Distance between nodes along a sidewalk, metres.
const STEP_M: f64 = 8.0;

/// Straight pieces may leave a bend's middle by this much, metres.
const BULGE_M: f64 = 0.1;

/// At corners people keep this much more from the kerb, metres, if enough is left for two to pass.
const SHY_M: f64 = 0.4;
const PASS_M: f64 = 1.2;

/// Adds nodes and edges to the walk network.
pub(super) struct WalkNetworkBuilder<'a> {
    pub(super) walk: &'a mut WalkNetwork,
}

impl WalkNetworkBuilder<'_> {
    pub(super) fn node(&mut self, p: DVec3) -> WalkNodeId {
        self.walk.nodes.push(p);
        WalkNodeId(self.walk.nodes.len() as u32 - 1)
    }

    pub(super) fn edge(&mut self, a: WalkNodeId, b: WalkNodeId, width_m: f64, kind: WalkKind) {
        if a != b {
            self.walk.edges.push(WalkEdge { nodes: [a, b], width_m, kind });
        }
    }
}

/// By street, end and side (0 left of its line): the node at which the corner's path takes over.
type CornerNodes = Vec<[[Option<WalkNodeId>; 2]; 2]>;

/// Adds the crossings and everything that people walk on along streets.
pub(super) fn add(plan: &mut StreetPlan, network: &mut RoadNetwork) {
    add_crossings(plan, network);
    let mut walks = WalkNetworkBuilder { walk: &mut network.walk };
    let anchors = sides(plan, &mut walks);
    for intersection in &plan.intersections {
        let n = intersection.arms.len();
        // Nobody walks through the loop at a dead end.
        if n < 2 || intersection.turnaround {
            continue;
        }
        for i in 0..n {
            corner(plan, intersection.arms[i], intersection.arms[(i + 1) % n], &anchors, &mut walks);
        }
    }
}

fn add_crossings(plan: &mut StreetPlan, network: &mut RoadNetwork) {
    let hidden = inside(plan);
    for (street, hidden) in plan.streets.iter_mut().zip(hidden) {
        if hidden {
            street.crossings.clear();
        }
        let mut crossings = std::mem::take(&mut street.crossings);
        for crossing in &mut crossings {
            let ends = street.section.kerbs.map(|t| street.point(crossing.s, t));
            crossing.id = Some(CrossingId(network.crossings.len().min(usize::from(u16::MAX)) as u16));
            network.crossings.push(Crossing { ends, width_m: CROSSING_M, signal: crossing.signal, cuts: Vec::new() });
        }
        street.crossings = crossings;
    }
}

fn sides(plan: &StreetPlan, walks: &mut WalkNetworkBuilder<'_>) -> CornerNodes {
    let hidden = inside(plan);
    let mut anchors: CornerNodes = vec![[[None; 2]; 2]; plan.streets.len()];
    for (i, street) in plan.streets.iter().enumerate().filter(|(i, _)| !hidden[*i]) {
        let mut at_crossing = vec![[None; 2]; street.crossings.len()];
        for side in 0..2 {
            let t = street.section.walk_line(side);
            let point = |s: f64| street.point(s, t) + DVec3::Z * KERB_HEIGHT_M;
            if street.section.sidewalks[side] <= 0.0 {
                // Nobody walks here, but people arrive over the crossings at its ends.
                for (c, crossing) in street.crossings.iter().enumerate() {
                    let node = walks.node(point(crossing.s));
                    at_crossing[c][side] = Some(node);
                    if let Some(end) = crossing.end {
                        anchors[i][end][side] = Some(node);
                    }
                }
                continue;
            }
            let width = street.section.sidewalks[side];
            let (from, to) = (street.cuts[0], street.length() - street.cuts[1]);
            let mut last: Option<(f64, WalkNodeId)> = None;
            let places = stations(from, to, street.crossings.iter().map(|c| c.s));
            for (s, crossing) in around_bends(places, &point) {
                let node = walks.node(point(s));
                if let Some((_, before)) = last {
                    walks.edge(before, node, (width - KERB_M).max(0.3), WalkKind::Sidewalk);
                } else {
                    anchors[i][0][side] = Some(node);
                }
                if let Some(c) = crossing {
                    at_crossing[c][side] = Some(node);
                }
                last = Some((s, node));
            }
            anchors[i][1][side] = last.map(|(_, node)| node);
        }
        for (crossing, nodes) in street.crossings.iter().zip(at_crossing) {
            if let ([Some(a), Some(b)], Some(id)) = (nodes, crossing.id) {
                walks.edge(a, b, CROSSING_M - 0.4, WalkKind::Crossing(id));
            }
        }
    }
    anchors
}

/// Places from `from` to `to`, at crossings and between; with the crossing's number.
fn stations(from: f64, to: f64, crossings: impl Iterator<Item = f64>) -> Vec<(f64, Option<usize>)> {
    let mut fixed: Vec<(f64, Option<usize>)> = vec![(from, None), (to, None)];
    fixed.extend(crossings.enumerate().map(|(c, s)| (s.clamp(from, to), Some(c))));
    fixed.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut out: Vec<(f64, Option<usize>)> = Vec::new();
    for (s, crossing) in fixed {
        if let Some(&(last, _)) = out.last() {
            let n = ((s - last) / STEP_M).ceil().max(1.0) as usize;
            out.extend((1..n).map(|k| (last + (s - last) * k as f64 / n as f64, None)));
        }
        out.push((s, crossing));
    }
    out
}

/// The same places with more between where the straight way from one to the next would leave the bend.
fn around_bends(places: Vec<(f64, Option<usize>)>, point: &dyn Fn(f64) -> DVec3) -> Vec<(f64, Option<usize>)> {
    let mut out: Vec<(f64, Option<usize>)> = Vec::with_capacity(places.len());
    for place in places {
        if let Some(&(from, _)) = out.last() {
            let sagitta = |a: f64, b: f64| {
                let middle = point(a).truncate().midpoint(point(b).truncate());
                middle.distance(point(0.5 * (a + b)).truncate())
            };
            let pieces = (1..=4).find(|&n| {
                let at = |k: usize| from + (place.0 - from) * k as f64 / n as f64;
                (0..n).all(|k| sagitta(at(k), at(k + 1)) < BULGE_M)
            });
            let n = pieces.unwrap_or(4);
            out.extend((1..n).map(|k| (from + (place.0 - from) * k as f64 / n as f64, None)));
        }
        out.push(place);
    }
    out
}

fn corner(
    plan: &StreetPlan,
    a: StreetSegmentEnd,
    b: StreetSegmentEnd,
    anchors: &CornerNodes,
    walks: &mut WalkNetworkBuilder<'_>,
) {
    let anchor = |arm: StreetSegmentEnd, left: bool| anchors[arm.stretch][arm.end][usize::from(left == (arm.end == 1))];
    let (from, to) = (anchor(a, true), anchor(b, false));
    let (Some(from), Some(to)) = (from, to) else { return };
    let (wa, wb) = (walk_width(plan, a, true).unwrap_or(STUB_M), walk_width(plan, b, false).unwrap_or(STUB_M));
    // Those who turn come near the kerb here, with their front or rear over it.
    let shy = (wa.min(wb) - KERB_M - PASS_M).clamp(0.0, SHY_M);
    let middle = |w: f64| 0.5 * (w + KERB_M + shy);
    let line = corner_line(plan, a, b, middle(wa), middle(wb));
    let width = (wa.min(wb) - KERB_M - shy).max(0.3);
    let bends = simplified(&line, BULGE_M);
    let mut last = from;
    for k in 1..bends.len() - 1 {
        let p = bends[k] + DVec3::Z * KERB_HEIGHT_M;
        if walks.walk.nodes[last.index()].distance(p) < 0.3 || walks.walk.nodes[to.index()].distance(p) < 0.3 {
            continue;
        }
        let node = walks.node(p);
        walks.edge(last, node, width, WalkKind::Sidewalk);
        last = node;
    }
    walks.edge(last, to, width, WalkKind::Sidewalk);
}
