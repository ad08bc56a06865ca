//! Where in the picture the middles of boxes lie.

use crate::merge::Merge;
use serde::Serialize;

/// Cells from left to right.
pub(crate) const COLUMNS: usize = 32;
/// Cells from top to bottom.
pub(crate) const ROWS: usize = 18;

/// Numbers of boxes by where in the picture their middles are, whatever the picture's size.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct HeatMap {
    /// Cells from left to right.
    pub columns: usize,
    /// Cells from top to bottom.
    pub rows: usize,
    /// Boxes in each cell, row by row from the top left.
    pub counts: Vec<u64>,
}

impl Default for HeatMap {
    fn default() -> Self {
        Self { columns: COLUMNS, rows: ROWS, counts: vec![0; COLUMNS * ROWS] }
    }
}

impl HeatMap {
    /// Counts a box `[x, y, w, h]` in a picture of this width and height.
    pub fn add(&mut self, [x, y, w, h]: [f64; 4], [width, height]: [f64; 2]) {
        let cell = |middle: f64, length: f64, cells: usize| {
            ((middle * cells as f64 / length).max(0.0) as usize).min(cells - 1)
        };
        let column = cell(x + 0.5 * w, width, self.columns);
        let row = cell(y + 0.5 * h, height, self.rows);
        self.counts[row * self.columns + column] += 1;
    }

    /// How many boxes there are.
    pub fn total(&self) -> u64 {
        self.counts.iter().sum()
    }
}

impl Merge for HeatMap {
    fn absorb(&mut self, other: Self) {
        for (own, other) in self.counts.iter_mut().zip(other.counts) {
            *own += other;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn middles_are_counted_where_they_are() {
        let mut map = HeatMap::default();
        map.add([0.0, 0.0, 10.0, 10.0], [640.0, 360.0]);
        map.add([630.0, 350.0, 10.0, 10.0], [640.0, 360.0]);
        map.add([310.0, 170.0, 20.0, 20.0], [640.0, 360.0]);
        // Beyond the picture, and in one that has no size.
        map.add([-90.0, 900.0, 2.0, 2.0], [640.0, 360.0]);
        map.add([0.0, 0.0, 0.0, 0.0], [0.0, 0.0]);
        let at = |column: usize, row: usize| map.counts[row * COLUMNS + column];
        assert_eq!([at(0, 0), at(31, 17), at(16, 9), at(0, 17)], [2, 1, 1, 1]);
        assert_eq!(map.total(), 5);
    }
}
