//! A grid in which things are looked up by place.

use glam::DVec2;

/// Size of a cell, metres.
const CELL_M: f64 = 8.0;

/// Numbers of things, by the cells that their boxes touch.
#[derive(Debug, Default)]
pub(super) struct CellGrid {
    /// Column, row, thing; in order.
    entries: Vec<(i32, i32, u32)>,
}

fn cell(at: DVec2) -> [i32; 2] {
    [(at.x / CELL_M).floor() as i32, (at.y / CELL_M).floor() as i32]
}

impl CellGrid {
    /// Of the boxes of things 0, 1, 2, …: corners from south-west to north-east.
    pub(super) fn rebuild(&mut self, boxes: impl Iterator<Item = [DVec2; 2]>) {
        self.entries.clear();
        for (thing, [low, high]) in (0..).zip(boxes) {
            let ([left, bottom], [right, top]) = (cell(low), cell(high));
            let cells = (left..=right).flat_map(|x| (bottom..=top).map(move |y| (x, y)));
            self.entries.extend(cells.map(|(x, y)| (x, y, thing)));
        }
        self.entries.sort_unstable();
    }

    /// The things whose cells a box touches; some more than once.
    pub(super) fn near(&self, [low, high]: [DVec2; 2]) -> impl Iterator<Item = usize> {
        let ([left, bottom], [right, top]) = (cell(low), cell(high));
        (left..=right).flat_map(move |x| {
            let from = self.entries.partition_point(|&(column, row, _)| (column, row) < (x, bottom));
            let column = self.entries[from..].iter().take_while(move |&&(column, row, _)| (column, row) <= (x, top));
            column.map(|&(_, _, thing)| thing as usize)
        })
    }
}
