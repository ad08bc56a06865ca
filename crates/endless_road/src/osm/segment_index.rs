//! A grid index of line segments, for those near a point.

use crate::Polyline;
use glam::DVec2;
use std::collections::BTreeMap;

const CELL_M: f64 = 32.0;

/// Lines by the squares that they pass, with a square around.
#[derive(Debug, Clone, Default)]
pub(super) struct SegmentIndex {
    cells: BTreeMap<(i64, i64), Vec<usize>>,
}

fn cell(p: DVec2) -> (i64, i64) {
    let c = (p / CELL_M).floor();
    (c.x as i64, c.y as i64)
}

impl SegmentIndex {
    /// Of numbered lines.
    pub(super) fn new<'a>(lines: impl Iterator<Item = (usize, &'a Polyline)>) -> Self {
        let mut near = Self::default();
        for (i, line) in lines {
            let n = (line.length() / (0.5 * CELL_M)).ceil().max(1.0) as usize;
            for k in 0..=n {
                let (x, y) = cell(line.at(line.length() * k as f64 / n as f64).position.truncate());
                for (dx, dy) in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy))) {
                    let list = near.cells.entry((x + dx, y + dy)).or_default();
                    if list.last() != Some(&i) && !list.contains(&i) {
                        list.push(i);
                    }
                }
            }
        }
        near
    }

    /// The lines that may pass within half a square of a place.
    pub(super) fn at(&self, p: DVec2) -> &[usize] {
        self.cells.get(&cell(p)).map_or(&[], Vec::as_slice)
    }
}
