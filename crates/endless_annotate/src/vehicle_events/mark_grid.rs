//! Painted lines, found by where they are.

use crate::{MarkAttributes, MarkFeature};
use glam::{DVec2, DVec3};
use std::collections::{BTreeMap, BTreeSet};

/// Side of a cell, metres.
const CELL_M: f64 = 8.0;
/// Gaps of broken lines are no longer, metres: from paint to paint.
const GAP_M: f64 = 16.0;
/// Lines that are more above or below are of another road, metres.
const STOREY_M: f64 = 2.5;

/// The lines of a map, in cells.
#[derive(Debug, Clone, Default)]
pub(super) struct MarkGrid {
    marks: Vec<MarkAttributes>,
    /// Pieces of lines, gaps between paint included: index of the line, and both ends.
    segments: Vec<(usize, [DVec3; 2])>,
    cells: BTreeMap<(i32, i32), Vec<usize>>,
}

impl MarkGrid {
    pub(super) fn new(marks: &[MarkFeature]) -> Self {
        let mut grid = Self::default();
        for (index, mark) in marks.iter().enumerate() {
            grid.marks.push(mark.attributes.clone());
            for piece in &mark.pieces {
                piece.windows(2).for_each(|ends| grid.add(index, [ends[0], ends[1]]));
            }
            for pair in mark.pieces.windows(2).filter(|_| mark.attributes.broken) {
                if let (Some(&end), Some(&begin)) = (pair[0].last(), pair[1].first())
                    && end.distance(begin) < GAP_M
                {
                    grid.add(index, [end, begin]);
                }
            }
        }
        grid
    }

    fn add(&mut self, mark: usize, ends: [DVec3; 2]) {
        let number = self.segments.len();
        self.segments.push((mark, ends));
        for cell in cells_around(ends.map(DVec3::truncate)) {
            self.cells.entry(cell).or_default().push(number);
        }
    }

    /// The lines that ways on the ground at this height cross, by index, each once.
    pub(super) fn crossed(&self, ways: &[[DVec2; 2]], height_m: f64) -> impl Iterator<Item = &MarkAttributes> {
        let mut found = BTreeSet::new();
        for way in ways {
            for cell in cells_around(*way) {
                for (mark, ends) in self.cells.get(&cell).into_iter().flatten().map(|&number| &self.segments[number]) {
                    let level = (0.5 * (ends[0].z + ends[1].z) - height_m).abs() < STOREY_M;
                    if level && crosses(*way, ends.map(DVec3::truncate)) {
                        found.insert(*mark);
                    }
                }
            }
        }
        found.into_iter().map(|mark| &self.marks[mark])
    }
}

/// The cells that the box around two points covers.
fn cells_around([a, b]: [DVec2; 2]) -> impl Iterator<Item = (i32, i32)> {
    let cell = |p: DVec2| ((p.x / CELL_M).floor() as i32, (p.y / CELL_M).floor() as i32);
    let ((x0, y0), (x1, y1)) = (cell(a.min(b)), cell(a.max(b)));
    (x0..=x1).flat_map(move |x| (y0..=y1).map(move |y| (x, y)))
}

/// Whether two lines cross; one that ends on the other belongs to one of its sides, so that a way over a line that is cut into
/// pieces crosses it once.
fn crosses([a, b]: [DVec2; 2], [p, q]: [DVec2; 2]) -> bool {
    let left = |from: DVec2, to: DVec2, of: DVec2| (to - from).perp_dot(of - from) > 0.0;
    left(p, q, a) != left(p, q, b) && left(a, b, p) != left(a, b, q)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PaintColor;
    use proptest::prelude::*;

    fn mark(id: u32, broken: bool, pieces: &[&[[f64; 2]]]) -> MarkFeature {
        let attributes = MarkAttributes { id, broken, color: PaintColor::White, width_m: 0.12 };
        let piece = |piece: &&[[f64; 2]]| piece.iter().map(|&[x, y]| DVec3::new(x, y, 1.0)).collect();
        MarkFeature { attributes, pieces: pieces.iter().map(piece).collect() }
    }

    #[test]
    fn gaps_of_broken_lines_are_crossed_and_others_are_not() {
        let pieces: &[&[[f64; 2]]] =
            &[&[[0.0, 0.0], [3.0, 0.0]], &[[9.0, 0.0], [12.0, 0.0]], &[[60.0, 0.0], [63.0, 0.0]]];
        let grid = MarkGrid::new(&[mark(4, true, pieces), mark(9, false, pieces)]);
        let ids = |x: f64, z: f64| {
            let way = [DVec2::new(x, -0.5), DVec2::new(x + 0.1, 0.5)];
            grid.crossed(&[way, way], z).map(|mark| mark.id).collect::<Vec<_>>()
        };
        assert_eq!(ids(1.0, 1.2), [4, 9]);
        assert_eq!(ids(6.0, 1.2), [4], "in the gap");
        assert_eq!(ids(30.0, 1.2), [0; 0], "too long for a gap");
        assert_eq!(ids(1.0, 7.0), [0; 0], "on a bridge above");
    }

    proptest! {
        #[test]
        fn the_grid_finds_what_is_there(
            lines in prop::collection::vec([-40.0..40.0f64, -40.0..40.0f64, -40.0..40.0f64, -40.0..40.0f64], 1..30),
            way in [-40.0..40.0f64, -40.0..40.0f64, -40.0..40.0f64, -40.0..40.0f64],
        ) {
            let ends = |[a, b, c, d]: [f64; 4]| [DVec2::new(a, b), DVec2::new(c, d)];
            let marks: Vec<MarkFeature> =
                (0..).zip(&lines).map(|(id, &[a, b, c, d])| mark(id, false, &[&[[a, b], [c, d]]])).collect();
            let found: Vec<u32> = MarkGrid::new(&marks).crossed(&[ends(way)], 0.0).map(|mark| mark.id).collect();
            let expected: Vec<u32> =
                (0..).zip(&lines).filter(|(_, line)| crosses(ends(way), ends(**line))).map(|(id, _)| id).collect();
            prop_assert_eq!(found, expected);
        }
    }
}
