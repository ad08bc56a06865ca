//! Which boxes may meet: those with a cell of a uniform grid in common.

use glam::DVec2;

/// Side of a cell, metres: a little more than a car is long.
const CELL_M: f64 = 6.0;

/// Pairs of boxes (low and high corners) that overlap along both axes, each once, the lower index first, in order.
pub(super) fn pairs(boxes: &[(DVec2, DVec2)]) -> Vec<(usize, usize)> {
    let mut cells = Vec::with_capacity(4 * boxes.len());
    for (index, (low, high)) in boxes.iter().enumerate() {
        let ([low_x, low_y], [high_x, high_y]) = (cell(*low), cell(*high));
        for x in low_x..=high_x {
            cells.extend((low_y..=high_y).map(|y| (x, y, index)));
        }
    }
    cells.sort_unstable();
    let mut pairs = Vec::new();
    for same in cells.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        for (position, &(.., first)) in same.iter().enumerate() {
            for &(.., second) in same.iter().skip(position + 1) {
                if let (Some(a), Some(b)) = (boxes.get(first), boxes.get(second))
                    && a.0.cmple(b.1).all()
                    && b.0.cmple(a.1).all()
                {
                    pairs.push((first, second));
                }
            }
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

fn cell(at: DVec2) -> [i64; 2] {
    [(at.x / CELL_M).floor() as i64, (at.y / CELL_M).floor() as i64]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::collection::vec;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn finds_what_looking_at_all_finds(boxes in vec((-30.0..30.0f64, -30.0..30.0f64, 0.1..15.0f64, 0.1..15.0f64), 0..30)) {
            let corners = |(x, y, w, h): (f64, f64, f64, f64)| (DVec2::new(x, y), DVec2::new(x + w, y + h));
            let boxes: Vec<_> = boxes.into_iter().map(corners).collect();
            let mut all = Vec::new();
            for a in 0..boxes.len() {
                for b in a + 1..boxes.len() {
                    if boxes[a].0.cmple(boxes[b].1).all() && boxes[b].0.cmple(boxes[a].1).all() {
                        all.push((a, b));
                    }
                }
            }
            prop_assert_eq!(pairs(&boxes), all);
        }
    }
}
