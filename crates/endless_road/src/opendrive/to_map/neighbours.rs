//! Lanes side by side, where their mark lets traffic change.

use super::super::document::RoadMark;
use super::lanes::LaneGraph;
use super::sampled::{LaneKey, SampledDocument};
use crate::{Lane, LaneId};
use std::collections::BTreeMap;

/// A change must be allowed along this share of the shorter lane.
const SHARE: f64 = 0.4;

/// Fills `left` and `right` of lanes outside junctions.
pub(super) fn find(sampled: &SampledDocument<'_>, graph: &LaneGraph, lanes: &mut [Lane]) {
    // Length along which a change is allowed, and whether it goes to the right.
    let mut allowed: BTreeMap<(LaneId, LaneId), (f64, bool)> = BTreeMap::new();
    let along_roads = lengths_along_roads(sampled, graph);
    for (key, _) in sampled.keys() {
        // The pair (this lane, the next one to its right along `s`), on one side of the centre.
        let right = LaneKey { lane: key.lane - 1, ..key };
        let (Some(a), Some(b)) = (graph.id(key), graph.id(right)) else { continue };
        let Some(section) = sampled.sections[key.road][key.section].as_ref() else { continue };
        let along = sampled.runs_along(key);
        if a == b || key.lane * right.lane < 0 || along != sampled.runs_along(right) {
            continue;
        }
        if lanes[a.index()].junction.is_some() || lanes[b.index()].junction.is_some() {
            continue;
        }
        let inner = if key.lane > 0 { right } else { key };
        let marks = sampled.record(inner).map_or(&[][..], |lane| &lane.marks);
        let (from, to) = (section.stations[0], section.stations[section.stations.len() - 1]);
        let start = sampled.document.roads[key.road].sections[key.section].s;
        for i in 0..marks.len().max(1) {
            let begin = if i == 0 { from } else { (start + marks[i].s).max(from) };
            let end = marks.get(i + 1).map_or(to, |next| start + next.s).min(to);
            let length = (end - begin).max(0.0);
            let (up, down) = marks.get(i).map_or((true, true), changes);
            // From `a` to `b` the id decreases.
            allowed.entry((a, b)).or_insert((0.0, along)).0 += if down { length } else { 0.0 };
            allowed.entry((b, a)).or_insert((0.0, !along)).0 += if up { length } else { 0.0 };
        }
    }
    for (&(from, to), &(length, to_the_right)) in &allowed {
        // In a bend the outer lane is longer than the road's line along which marks are measured.
        let of = |lane: LaneId| lanes[lane.index()].centerline.length().min(along_roads[&lane]);
        let shorter = of(from).min(of(to));
        if length < SHARE * shorter {
            continue;
        }
        let lane = &mut lanes[from.index()];
        let side = if to_the_right { &mut lane.right } else { &mut lane.left };
        side.get_or_insert(to);
    }
}

/// How far each lane runs, along the lines of its roads.
fn lengths_along_roads(sampled: &SampledDocument<'_>, graph: &LaneGraph) -> BTreeMap<LaneId, f64> {
    let mut lengths = BTreeMap::new();
    for (key, _) in sampled.keys() {
        let (Some(lane), Some(section)) = (graph.id(key), sampled.sections[key.road][key.section].as_ref()) else {
            continue;
        };
        let stations = &section.stations;
        *lengths.entry(lane).or_insert(0.0) += stations[stations.len() - 1] - stations[0];
    }
    lengths
}

/// Whether a mark may be crossed towards higher and lower lane ids.
fn changes(mark: &RoadMark) -> (bool, bool) {
    match mark.lane_change.as_deref() {
        Some("none") => (false, false),
        Some("increase") => (true, false),
        Some("decrease") => (false, true),
        Some("both") => (true, true),
        _ => match mark.kind.as_str() {
            "solid" | "solid solid" | "curb" | "grass" | "edge" => (false, false),
            // Named from the inside to the outside; which id is higher depends on the side, so neither.
            "solid broken" | "broken solid" => (false, false),
            _ => (true, true),
        },
    }
}
