//! Lanes by place.

use endless_road::{LaneId, RoadNetwork};
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// Side of the cells by which lanes are found, metres.
const CELL_M: f64 = 16.0;
/// A metre of height counts like so many metres across: bridges and what is below them are apart.
const HEIGHT: f64 = 3.0;

/// Segments of lanes, found by place.
#[derive(Debug, Clone)]
pub(super) struct LaneIndex {
    segments: Vec<(LaneId, [DVec3; 2])>,
    cells: HashMap<[i32; 2], Vec<u32>>,
}

impl LaneIndex {
    pub(super) fn new(network: &RoadNetwork) -> Self {
        let pairs = |lane: &endless_road::Lane| {
            let id = lane.id;
            lane.centerline.points().windows(2).map(|pair| (id, [pair[0], pair[1]])).collect::<Vec<_>>()
        };
        let segments: Vec<(LaneId, [DVec3; 2])> = network.lanes.iter().flat_map(pairs).collect();
        let mut cells: HashMap<[i32; 2], Vec<u32>> = HashMap::new();
        for (index, (_, [a, b])) in (0..).zip(&segments) {
            let (low, high) = (cell(a.min(*b).truncate()), cell(a.max(*b).truncate()));
            for x in low[0]..=high[0] {
                for y in low[1]..=high[1] {
                    cells.entry([x, y]).or_default().push(index);
                }
            }
        }
        Self { segments, cells }
    }

    /// The lane whose middle passes nearest; `None` if all are farther away than 16 m at least.
    pub(super) fn nearest(&self, place: DVec3) -> Option<LaneId> {
        let [x, y] = cell(place.truncate());
        let mut best: Option<(f64, LaneId)> = None;
        for beside in (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| [x, y])) {
            for &index in self.cells.get(&beside).into_iter().flatten() {
                let (lane, [a, b]) = self.segments[index as usize];
                let along = b - a;
                let share = ((place - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
                let off = place - (a + along * share);
                let distance = off.truncate().length() + HEIGHT * off.z.abs();
                if best.is_none_or(|(least, of)| distance < least || (distance == least && lane < of)) {
                    best = Some((distance, lane));
                }
            }
        }
        best.map(|(_, lane)| lane)
    }
}

fn cell(place: DVec2) -> [i32; 2] {
    [(place.x / CELL_M).floor() as i32, (place.y / CELL_M).floor() as i32]
}
