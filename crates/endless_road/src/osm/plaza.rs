//! Squares to walk across: a mesh of ways that keeps clear of what stands there, joined to the walks at its edge.

use super::import_context::ImportContext;
use super::ring::contains;
use super::walk::WalkNetworkBuilder;
use crate::{LandUse, LandUseArea, Lane, RoadNetwork, WalkKind, WalkNetwork, WalkNodeId};
use glam::DVec2;
use std::collections::BTreeMap;

/// Height above the level of roads, metres: squares lie a little lower than the sidewalks around them.
const SQUARE_Z_M: f64 = 0.09;
/// Distance between the ways of a mesh, metres; more on squares so large that there would be more than so many.
const STEP_M: f64 = 11.0;
const MOST_ACROSS: f64 = 40.0;
/// Width of its ways, metres.
const WIDTH_M: f64 = 3.0;
/// They keep so far from the square's edge and from buildings, metres.
const CLEAR_M: f64 = 2.0;
/// Walks so far outside of the edge lead onto the square, metres.
const DOOR_M: f64 = 5.0;

/// Makes a mesh of every square.
pub(super) fn add(
    areas: &[LandUseArea],
    buildings: &[Vec<DVec2>],
    context: &ImportContext<'_>,
    network: &mut RoadNetwork,
) {
    let squares = areas.iter().filter(|a| a.kind == LandUse::Plaza && a.outline.len() >= 3);
    for area in squares {
        let square = PlazaMesh::new(area, buildings, network);
        let doors = square.doors(&network.walk);
        square.lay(&doors, context, &mut network.walk);
    }
}

fn distance(ring: &[DVec2], p: DVec2) -> f64 {
    let sides = (0..ring.len()).map(|i| (ring[i], ring[(i + 1) % ring.len()]));
    sides.map(|(a, b)| to_segment(a, b, p)).fold(f64::INFINITY, f64::min)
}

fn to_segment(a: DVec2, b: DVec2, p: DVec2) -> f64 {
    let along = b - a;
    let t = ((p - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
    (a + along * t).distance(p)
}

/// A place of the mesh by its column and row.
type PlazaCell = (i64, i64);

struct PlazaMesh<'a> {
    area: &'a LandUseArea,
    /// Buildings and holes in it.
    solids: Vec<&'a [DVec2]>,
    /// The direction of its longest side, and the middle.
    axis: DVec2,
    middle: DVec2,
    step: f64,
    /// Places where people can walk.
    cells: BTreeMap<PlazaCell, DVec2>,
}

impl<'a> PlazaMesh<'a> {
    fn new(area: &'a LandUseArea, buildings: &'a [Vec<DVec2>], network: &RoadNetwork) -> Self {
        let ring = &area.outline;
        let (low, high) = bounds(ring);
        let meets = |other: &[DVec2]| {
            let (l, h) = bounds(other);
            l.cmple(high).all() && h.cmpge(low).all()
        };
        let solids = buildings.iter().chain(&area.holes).map(Vec::as_slice).filter(|b| b.len() >= 3 && meets(b));
        let longest = (0..ring.len())
            .map(|i| ring[(i + 1) % ring.len()] - ring[i])
            .fold(DVec2::X * 1e-9, |a, b| if b.length_squared() > a.length_squared() { b } else { a });
        let step = STEP_M.max((high - low).max_element() / MOST_ACROSS);
        let axis = longest.normalize_or(DVec2::X);
        let solids = solids.collect();
        let mut square = Self { area, solids, axis, middle: low.midpoint(high), step, cells: BTreeMap::new() };
        let reach = ((high - low).length() / 2.0 / step).ceil() as i64;
        let lanes: Vec<&Lane> = network
            .lanes
            .iter()
            .filter(|lane| meets(&lane.centerline.points().iter().map(|p| p.truncate()).collect::<Vec<_>>()))
            .collect();
        let walks: Vec<(DVec2, DVec2, f64)> = network
            .walk
            .edges
            .iter()
            .map(|e| {
                let [a, b] = e.nodes.map(|n| network.walk.nodes[n.index()].truncate());
                (a, b, e.width_m)
            })
            .filter(|(a, b, _)| meets(&[*a, *b]))
            .collect();
        for row in -reach..=reach {
            for column in -reach..=reach {
                let p = square.place((column, row));
                let on_lane = || lanes.iter().any(|l| l.centerline.project(p).1.abs() < 0.5 * l.width_m + CLEAR_M);
                let on_walk = || walks.iter().any(|&(a, b, width)| to_segment(a, b, p) < 0.5 * (width + WIDTH_M));
                if square.free(p) && !on_lane() && !on_walk() {
                    square.cells.insert((column, row), p);
                }
            }
        }
        square
    }

    fn place(&self, (column, row): PlazaCell) -> DVec2 {
        self.middle + (self.axis * column as f64 + self.axis.perp() * row as f64) * self.step
    }

    fn free(&self, p: DVec2) -> bool {
        contains(&self.area.outline, p)
            && distance(&self.area.outline, p) > CLEAR_M
            && self.solids.iter().all(|solid| !contains(solid, p) && distance(solid, p) > CLEAR_M)
    }

    fn straight(&self, a: DVec2, b: DVec2) -> bool {
        let n = a.distance(b).ceil().max(1.0) as usize;
        (0..=n).all(|k| self.free(a.lerp(b, k as f64 / n as f64)))
    }

    /// Walks at the edge, each with the place of the mesh to which it leads.
    fn doors(&self, walk: &WalkNetwork) -> Vec<(WalkNodeId, PlazaCell)> {
        let (low, high) = bounds(&self.area.outline);
        let mut found: Vec<(f64, usize, PlazaCell)> = Vec::new();
        for (i, node) in walk.nodes.iter().enumerate() {
            let p = node.truncate();
            if p.cmplt(low - DOOR_M).any() || p.cmpgt(high + DOOR_M).any() {
                continue;
            }
            let near = self.cells.iter().map(|(cell, at)| (at.distance(p), *cell, *at));
            let Some((far, cell, at)) = near.min_by(|a, b| a.0.total_cmp(&b.0)) else { break };
            let inwards = p.lerp(at, ((DOOR_M + CLEAR_M) / far.max(1e-6)).min(1.0));
            if far > 0.5 && far < self.step + DOOR_M + CLEAR_M && self.straight(inwards, at) {
                found.push((far, i, cell));
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut taken: BTreeMap<PlazaCell, usize> = BTreeMap::new();
        found
            .into_iter()
            .filter(|(_, _, cell)| {
                let count = taken.entry(*cell).or_default();
                *count += 1;
                *count <= 2
            })
            .map(|(_, i, cell)| (WalkNodeId(i as u32), cell))
            .collect()
    }

    /// Adds what can be reached through the doors.
    fn lay(&self, doors: &[(WalkNodeId, PlazaCell)], context: &ImportContext<'_>, walk: &mut WalkNetwork) {
        let mut walks = WalkNetworkBuilder { walk };
        let mut nodes: BTreeMap<PlazaCell, WalkNodeId> = BTreeMap::new();
        let mut open: Vec<PlazaCell> = doors.iter().map(|d| d.1).collect();
        while let Some(cell) = open.pop() {
            if nodes.contains_key(&cell) {
                continue;
            }
            let at = self.cells[&cell];
            nodes.insert(cell, walks.node(at.extend(SQUARE_Z_M + context.ground(at))));
            let reached = |next: &PlazaCell| self.cells.get(next).is_some_and(|there| self.straight(at, *there));
            for next in around(cell).into_iter().filter(reached) {
                match nodes.get(&next) {
                    Some(&other) => walks.edge(nodes[&cell], other, WIDTH_M, WalkKind::Sidewalk),
                    None => open.push(next),
                }
            }
        }
        for (door, cell) in doors {
            walks.edge(*door, nodes[cell], WIDTH_M, WalkKind::Sidewalk);
        }
    }
}

fn around((column, row): PlazaCell) -> [PlazaCell; 4] {
    [(column + 1, row), (column - 1, row), (column, row + 1), (column, row - 1)]
}

fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    points.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), &p| (l.min(p), h.max(p)))
}
