//! Heights: bridges over other roads are raised, tunnels sink, ramps lead up and down. The ground is flat
//! unless its relief is known.

use super::curve::segments_cross;
use super::street_segment::{StreetSegment, StructureLevel, WayVertex};
use glam::DVec2;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, BinaryHeap};

/// From one level to the next, metres.
const STOREY_M: f64 = 5.6;
/// Slope of ramps, and of roads that dive into tunnels.
const RAMP: f64 = 0.06;
const DIVE: f64 = 0.09;
/// Deepest a tunnel lies, metres.
const DEEPEST_M: f64 = 6.0;
/// Longest piece of a ramp, metres.
const PIECE_M: f64 = 8.0;
/// Levels are smoothed over so many pieces to both sides.
const SMOOTH_PIECES: usize = 2;
/// Where roads meet and one of them is steeper than this, they lie level so far from the middle, metres: ways that cross
/// do so at one height.
const STEEP: f64 = 0.1;
const TABLE_M: f64 = 11.0;
/// A road takes this long to pass from level to its slope, metres.
const EASE_M: f64 = 8.0;

/// Height of the land at a place, metres.
pub(super) type GroundHeight<'a> = &'a dyn Fn(DVec2) -> f64;

/// Gives every node a height, metres; nodes that are not in it lie at 0. Divides long segments where there are ramps.
pub(super) fn heights(stretches: &mut [StreetSegment], ground: Option<GroundHeight<'_>>) -> BTreeMap<i64, f64> {
    let mut raised = raised(stretches);
    let tunnels = stretches.iter().any(|s| s.levels.iter().any(|l| l.tunnel));
    if raised.is_empty() && !tunnels && ground.is_none() {
        return BTreeMap::new();
    }
    let mut next_id = i64::MIN / 2;
    for stretch in stretches.iter_mut() {
        divide(stretch, &mut raised, &mut next_id);
    }
    let edges = edges(stretches);
    let mut heights = spread(&edges, raised, RAMP, |_| true);
    sink(stretches, &edges, &mut heights);
    if let Some(ground) = ground {
        let mut levels: BTreeMap<i64, f64> = BTreeMap::new();
        let steep = steep_meetings(stretches, &edges, ground);
        for stretch in stretches.iter() {
            let tables = [0, stretch.vertices.len() - 1].map(|k| steep.contains(&stretch.vertices[k].node));
            levels.extend(profile(stretch, ground, tables));
        }
        for (node, level) in levels {
            *heights.entry(node).or_default() += level;
        }
    }
    heights
}

/// Nodes where roads meet and one of them is steep.
fn steep_meetings(stretches: &[StreetSegment], edges: &HeightGraph, ground: GroundHeight<'_>) -> BTreeSet<i64> {
    let mut steep = BTreeSet::new();
    for stretch in stretches {
        let n = stretch.vertices.len() - 1;
        for (end, next) in [(0, 1), (n, n - 1)] {
            let (a, b) = (stretch.vertices[end], stretch.vertices[next]);
            let rise = (ground(a.at) - ground(b.at)).abs();
            if edges.get(&a.node).is_some_and(|arms| arms.len() > 2) && rise > STEEP * a.at.distance(b.at) {
                steep.insert(a.node);
            }
        }
    }
    steep
}

/// Levels of a stretch's nodes on the land: straight over bridges and through tunnels, smooth elsewhere, and level at the
/// ends with `tables`.
fn profile(stretch: &StreetSegment, ground: GroundHeight<'_>, tables: [bool; 2]) -> Vec<(i64, f64)> {
    let n = stretch.vertices.len() - 1;
    let course = SlopeProfile::new(stretch, tables);
    let mut levels = course.levels(stretch, ground);
    let mut from = 0;
    while from < n {
        let free = |k: &usize| !stretch.levels[*k].bridge && !stretch.levels[*k].tunnel;
        let to = (from..n).find(free).unwrap_or(n);
        for k in from + 1..to {
            levels[k] = levels[from] + (levels[to] - levels[from]) * (k - from) as f64 / (to - from) as f64;
        }
        from = to.max(from) + 1;
    }
    let smoothed = (0..=n).map(|k| {
        // Ends stay where they are: other stretches begin there.
        let window = if course.on_table(k) { 0 } else { SMOOTH_PIECES.min(k).min(n - k) };
        let around = &levels[k - window..=k + window];
        (stretch.vertices[k].node, around.iter().sum::<f64>() / around.len() as f64)
    });
    smoothed.collect()
}

/// How a stretch takes a slope: at a table it stays level at first, and climbs the more steeply between.
struct SlopeProfile {
    /// Distance of each vertex from the beginning, metres.
    along: Vec<f64>,
    /// Length of the level piece at each end, metres.
    table: [f64; 2],
    /// Length over which it passes from level to its slope, metres.
    ease: [f64; 2],
}

impl SlopeProfile {
    fn new(stretch: &StreetSegment, tables: [bool; 2]) -> Self {
        let mut along = vec![0.0];
        for pair in stretch.vertices.windows(2) {
            along.push(along[along.len() - 1] + pair[0].at.distance(pair[1].at));
        }
        let length = along[along.len() - 1];
        let table = tables.map(|level| if level { TABLE_M.min(0.3 * length) } else { 0.0 });
        let ease = tables.map(|level| if level { EASE_M.min(0.1 * length) } else { 0.0 });
        Self { along, table, ease }
    }

    fn length(&self) -> f64 {
        self.along[self.along.len() - 1]
    }

    /// Whether a vertex lies on a level piece.
    fn on_table(&self, k: usize) -> bool {
        self.along[k] <= self.table[0] || self.length() - self.along[k] <= self.table[1]
    }

    /// Way that an end takes from the climb up to a distance from it, metres.
    fn lost(&self, end: usize, distance: f64) -> f64 {
        let over = (distance - self.table[end]).max(0.0);
        let ease = self.ease[end];
        let climbed = if over < ease { 0.5 * over * over / ease } else { over - 0.5 * ease };
        distance - climbed
    }

    /// The place whose height the stretch has at a distance from its beginning.
    fn place(&self, s: f64) -> f64 {
        let length = self.length();
        let whole = length - self.lost(0, length) - self.lost(1, length);
        let way = s - self.lost(0, s) - self.lost(1, length) + self.lost(1, length - s);
        (way / whole.max(1e-9) * length).clamp(0.0, length)
    }

    /// Heights at a stretch's nodes.
    fn levels(&self, stretch: &StreetSegment, ground: GroundHeight<'_>) -> Vec<f64> {
        let at = |s: f64| {
            let k = self.along.partition_point(|&a| a < s).clamp(1, self.along.len() - 1);
            let share = (s - self.along[k - 1]) / (self.along[k] - self.along[k - 1]).max(1e-9);
            stretch.vertices[k - 1].at.lerp(stretch.vertices[k].at, share)
        };
        self.along.iter().map(|&s| ground(at(self.place(s)))).collect()
    }
}

/// Nodes of bridges that pass over another road, with their heights.
fn raised(stretches: &[StreetSegment]) -> BTreeMap<i64, f64> {
    let mut raised: BTreeMap<i64, f64> = BTreeMap::new();
    for stretch in stretches {
        let mut i = 0;
        while i < stretch.levels.len() {
            let level = stretch.levels[i];
            let mut to = i + 1;
            while to < stretch.levels.len() && stretch.levels[to] == level {
                to += 1;
            }
            if level.bridge
                && let Some(storeys) = storeys(stretches, &stretch.vertices[i..=to], level)
            {
                for vertex in &stretch.vertices[i..=to] {
                    let height = raised.entry(vertex.node).or_default();
                    *height = height.max(storeys * STOREY_M);
                }
            }
            i = to;
        }
    }
    raised
}

/// By how many levels a bridge must be raised above what it crosses.
fn storeys(stretches: &[StreetSegment], bridge: &[WayVertex], level: StructureLevel) -> Option<f64> {
    let mut most: Option<i8> = None;
    for other in stretches {
        for (under, pair) in other.levels.iter().zip(other.vertices.windows(2)) {
            if under.layer >= level.layer || under.tunnel {
                continue;
            }
            // A little longer, so that a way through the other's very node counts.
            let over = 0.01 * (pair[1].at - pair[0].at);
            let (from, to) = (pair[0].at - over, pair[1].at + over);
            let crosses = bridge.windows(2).any(|b| segments_cross(b[0].at, b[1].at, from, to).is_some());
            if crosses {
                let by = (level.layer - under.layer.max(0)).clamp(1, 3);
                most = Some(most.map_or(by, |m| m.max(by)));
            }
        }
    }
    most.map(f64::from)
}

/// Cuts long segments; what lies between raised nodes of a bridge is raised as well.
fn divide(stretch: &mut StreetSegment, raised: &mut BTreeMap<i64, f64>, next_id: &mut i64) {
    let (mut vertices, mut levels) = (vec![stretch.vertices[0]], Vec::new());
    for (pair, &level) in stretch.vertices.windows(2).zip(&stretch.levels) {
        let pieces = (pair[0].at.distance(pair[1].at) / PIECE_M).ceil().clamp(1.0, 1000.0) as usize;
        let high = [0, 1].map(|end| raised.get(&pair[end].node).copied());
        for k in 1..=pieces {
            let share = k as f64 / pieces as f64;
            let at = pair[0].at.lerp(pair[1].at, share);
            *next_id += 1;
            if let ([Some(from), Some(to)], true) = (high, level.bridge && k < pieces) {
                raised.insert(*next_id, from + (to - from) * share);
            }
            vertices.push(if k == pieces { pair[1] } else { WayVertex { node: *next_id, at } });
            levels.push(level);
        }
    }
    stretch.vertices = vertices;
    stretch.levels = levels;
}

type HeightGraph = BTreeMap<i64, Vec<(i64, f64)>>;

fn edges(stretches: &[StreetSegment]) -> HeightGraph {
    let mut edges: HeightGraph = BTreeMap::new();
    for pair in stretches.iter().flat_map(|s| s.vertices.windows(2)) {
        let length = pair[0].at.distance(pair[1].at);
        edges.entry(pair[0].node).or_default().push((pair[1].node, length));
        edges.entry(pair[1].node).or_default().push((pair[0].node, length));
    }
    edges
}

/// Lets heights fall off along the roads by a slope, down to 0, over the nodes that are wanted.
fn spread(
    edges: &HeightGraph,
    seeds: BTreeMap<i64, f64>,
    slope: f64,
    wanted: impl Fn(i64) -> bool,
) -> BTreeMap<i64, f64> {
    let key = |z: f64| (z * 1e6) as i64;
    let mut queue: BinaryHeap<(i64, Reverse<i64>)> = seeds.iter().map(|(&n, &z)| (key(z), Reverse(n))).collect();
    let mut heights = seeds;
    while let Some((z, Reverse(node))) = queue.pop() {
        let here = heights[&node];
        if z < key(here) {
            continue;
        }
        for &(next, length) in edges.get(&node).into_iter().flatten() {
            let there = here - slope * length;
            if there > 0.01 && wanted(next) && heights.get(&next).is_none_or(|&h| there > h + 1e-6) {
                heights.insert(next, there);
                queue.push((key(there), Reverse(next)));
            }
        }
    }
    heights
}

/// Tunnels: as deep as the way to the nearest mouth allows.
fn sink(stretches: &[StreetSegment], edges: &HeightGraph, heights: &mut BTreeMap<i64, f64>) {
    // A node where anything touches the open is a mouth.
    let mut inside: BTreeMap<i64, bool> = BTreeMap::new();
    for stretch in stretches {
        for (level, pair) in stretch.levels.iter().zip(stretch.vertices.windows(2)) {
            for vertex in pair {
                *inside.entry(vertex.node).or_insert(true) &= level.tunnel;
            }
        }
    }
    let mouths = inside.iter().filter(|(_, i)| !**i).map(|(&n, _)| (n, DEEPEST_M)).collect();
    // Height above the deepest floor falls from the mouths inwards.
    let above = spread(edges, mouths, DIVE, |n| inside[&n]);
    for (&node, _) in inside.iter().filter(|(_, i)| **i) {
        heights.insert(node, above.get(&node).copied().unwrap_or(0.0) - DEEPEST_M);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_road_climbs_from_table_to_table(length in 0.5..300.0f64, meets: [bool; 2]) {
            let table = meets.map(|m| if m { TABLE_M.min(0.3 * length) } else { 0.0 });
            let ease = meets.map(|m| if m { EASE_M.min(0.1 * length) } else { 0.0 });
            let course = SlopeProfile { along: vec![0.0, length], table, ease };
            let near = |a: f64, b: f64| (a - b).abs() < 1e-6 * length;
            prop_assert!(near(course.place(table[0]), 0.0));
            prop_assert!(near(course.place(length - table[1]), length));
            let steps: Vec<f64> = (0..=200).map(|k| course.place(length * f64::from(k) / 200.0)).collect();
            for pair in steps.windows(2) {
                let slope = (pair[1] - pair[0]) / (length / 200.0);
                prop_assert!((-1e-9..=3.4).contains(&slope), "{slope}");
            }
            if meets == [false; 2] {
                prop_assert!(near(course.place(0.4 * length), 0.4 * length));
            }
        }
    }
}
