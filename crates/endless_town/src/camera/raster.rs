//! Triangles on a grid.

use glam::Vec2;
use std::ops::Range;

/// Calls `each` with the column and row of every cell whose middle lies in a triangle, and with the weights there of its
/// first two corners. Corners are in cells; the grid has so many columns, and of its rows some are asked for.
pub(super) fn cells_in(
    [a, b, c]: [Vec2; 3],
    columns: usize,
    rows: Range<usize>,
    mut each: impl FnMut(usize, usize, [f32; 2]),
) {
    let area = (b - a).perp_dot(c - a);
    let limit = Vec2::new(columns as f32, rows.end as f32) - 1.0;
    let low = (a.min(b).min(c) - 0.5).ceil().max(Vec2::new(0.0, rows.start as f32));
    let high = (a.max(b).max(c) - 0.5).floor().min(limit);
    if area.abs() <= 1e-6 || low.x > high.x || low.y > high.y {
        return;
    }
    for y in low.y as usize..=high.y as usize {
        for x in low.x as usize..=high.x as usize {
            let p = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
            let (u, v) = ((b - p).perp_dot(c - p) / area, (c - p).perp_dot(a - p) / area);
            if u >= 0.0 && v >= 0.0 && u + v <= 1.0 {
                each(x, y, [u, v]);
            }
        }
    }
}
