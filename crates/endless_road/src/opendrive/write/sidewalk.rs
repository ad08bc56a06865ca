//! Sidewalks as roads of their own with one lane for walking: the network does not say beside which road they run.

use super::curve::{FittedLine, directions};
use super::element::{ElementWriter, number};
use super::road::{elevation, plan_view};
use crate::{WalkEdge, WalkKind, WalkNetwork, WalkNodeId};
use glam::DVec3;
use std::collections::BTreeMap;

/// People keep this much of a sidewalk free, metres: lanes are wider by it than their usable width.
const MARGIN_M: f64 = 0.5;
/// The surface lies this much above the road, metres.
const KERB_M: f64 = 0.15;
/// Chains are broken where they turn more than this (cosine).
const STRAIGHT: f64 = 0.9;

/// A road for every chain of sidewalk edges; ids count on from `first_id`.
pub(super) fn roads(walk: &WalkNetwork, first_id: usize) -> Vec<ElementWriter> {
    chains(walk).into_iter().enumerate().map(|(i, chain)| road(walk, &chain, first_id + i)).collect()
}

/// A way along sidewalks without forks or sharp turns.
struct SidewalkChain {
    nodes: Vec<WalkNodeId>,
    width_m: f64,
}

fn chains(walk: &WalkNetwork) -> Vec<SidewalkChain> {
    let sidewalks: Vec<&WalkEdge> = walk.edges.iter().filter(|edge| edge.kind == WalkKind::Sidewalk).collect();
    let mut at: BTreeMap<WalkNodeId, Vec<usize>> = BTreeMap::new();
    for (i, edge) in sidewalks.iter().enumerate() {
        for node in edge.nodes {
            at.entry(node).or_default().push(i);
        }
    }
    let place = |node: WalkNodeId| walk.nodes[node.index()];
    let mut used = vec![false; sidewalks.len()];
    // The edge that goes on from a node, nearly straight and as wide.
    let onwards = |from: WalkNodeId, node: WalkNodeId, edge: usize, used: &[bool]| -> Option<(usize, WalkNodeId)> {
        let [a, b] = at[&node][..] else { return None };
        let next = if a == edge { b } else { a };
        let [p, q] = sidewalks[next].nodes;
        let to = if p == node { q } else { p };
        let direction = |a: WalkNodeId, b: WalkNodeId| (place(b) - place(a)).truncate().normalize_or_zero();
        let straight = direction(from, node).dot(direction(node, to)) > STRAIGHT;
        let same = (sidewalks[next].width_m - sidewalks[edge].width_m).abs() < 0.05;
        (!used[next] && straight && same).then_some((next, to))
    };
    let mut chains = Vec::new();
    for start in 0..sidewalks.len() {
        if used[start] {
            continue;
        }
        used[start] = true;
        let mut nodes = sidewalks[start].nodes.to_vec();
        for _ in 0..2 {
            let mut edge = start;
            while let Some((next, to)) = onwards(nodes[nodes.len() - 2], nodes[nodes.len() - 1], edge, &used) {
                used[next] = true;
                nodes.push(to);
                edge = next;
            }
            nodes.reverse();
        }
        chains.push(SidewalkChain { nodes, width_m: sidewalks[start].width_m });
    }
    chains
}

fn road(walk: &WalkNetwork, chain: &SidewalkChain, id: usize) -> ElementWriter {
    let points: Vec<DVec3> = chain.nodes.iter().map(|node| walk.nodes[node.index()] - DVec3::Z * KERB_M).collect();
    let line = FittedLine::new(&points, &directions(&points));
    let width = chain.width_m + MARGIN_M;
    let lane = ElementWriter::new("lane").with("id", "-1").with("type", "sidewalk").with("level", "false").holding([
        ElementWriter::new("link"),
        ElementWriter::new("width").with("sOffset", "0").with_cubic([width, 0.0, 0.0, 0.0]),
        ElementWriter::new("height").with("sOffset", "0").with("inner", number(KERB_M)).with("outer", number(KERB_M)),
    ]);
    let centre = ElementWriter::new("lane").with("id", "0").with("type", "none").with("level", "false");
    let section = ElementWriter::new("laneSection")
        .with("s", "0")
        .holding([ElementWriter::new("center").holding([centre]), ElementWriter::new("right").holding([lane])]);
    ElementWriter::new("road")
        .with("name", "")
        .with("length", number(line.length))
        .with("id", id)
        .with("junction", "-1")
        .holding([
            ElementWriter::new("link"),
            ElementWriter::new("type").with("s", "0").with("type", "pedestrian"),
            plan_view(&line),
            elevation(&line),
            ElementWriter::new("lateralProfile"),
            ElementWriter::new("lanes").holding([
                ElementWriter::new("laneOffset").with("s", "0").with_cubic([0.5 * width, 0.0, 0.0, 0.0]),
                section,
            ]),
        ])
}
