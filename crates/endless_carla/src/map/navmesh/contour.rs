//! Outlines of regions, with no more corners than needed. Two regions have the same corners where they meet.

use super::super::surface::SurfaceKind;
use super::grid::{CLIMB_M, Grid, NONE};
use super::walk_area::WalkArea;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// Outlines may leave the cells' edges by this many cells.
const OFF_CELLS: f64 = 1.1;
/// And in height by this, metres.
const OFF_M: f64 = 0.08;

/// A corner of cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Corner {
    /// Column and row of the corner, and the lowest span at it on this floor.
    pub(super) key: ([i32; 2], u32),
    /// In the world, metres.
    pub(super) place: DVec3,
}

/// The outline of a region, counter-clockwise seen from above.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Contour {
    pub(super) area: WalkArea,
    pub(super) corners: Vec<Corner>,
}

/// An edge of an outline: where it begins, and what lies beyond.
#[derive(Debug, Clone, Copy)]
struct Edge {
    to: [i32; 2],
    from: Corner,
    beyond: u32,
}

/// Outlines of all regions, by their number.
pub(super) fn contours(grid: &Grid, region: &[u32]) -> Vec<Contour> {
    let mut by_region: Vec<u32> = (0..grid.spans.len() as u32).collect();
    by_region.sort_by_key(|&span| region[span as usize]);
    let regions = by_region.chunk_by(|&a, &b| region[a as usize] == region[b as usize]);
    regions.filter_map(|spans| contour(grid, region, spans)).collect()
}

fn contour(grid: &Grid, region: &[u32], spans: &[u32]) -> Option<Contour> {
    let own = region[spans[0] as usize];
    let mut edges: BTreeMap<[i32; 2], Edge> = BTreeMap::new();
    for &index in spans {
        let span = &grid.spans[index as usize];
        for (direction, beside) in span.beside.into_iter().enumerate() {
            let beyond = if beside == NONE { NONE } else { region[beside as usize] };
            if beyond != own {
                let ends = [direction, direction + 1].map(|side| corner_of([span.column, span.row], side % 4));
                edges.insert(ends[0], Edge { to: ends[1], from: corner(grid, index, ends[0]), beyond });
            }
        }
    }
    let (&start, _) = edges.first_key_value()?;
    let mut outline: Vec<Edge> = Vec::with_capacity(edges.len());
    let mut at = start;
    while let Some(edge) = edges.remove(&at) {
        at = edge.to;
        outline.push(edge);
    }
    let corners = simplified(&outline, grid.cell_m);
    let area = WalkArea::from(grid.spans[spans[0] as usize].kind);
    (corners.len() >= 3).then_some(Contour { area, corners })
}

/// The corner of a cell at which its side in a direction begins, going round counter-clockwise: south-east first.
fn corner_of([column, row]: [i32; 2], direction: usize) -> [i32; 2] {
    match direction {
        0 => [column + 1, row],
        1 => [column + 1, row + 1],
        2 => [column, row + 1],
        _ => [column, row],
    }
}

/// A corner on the floor of one of its spans. Sidewalks end at their own height, at kerbs too.
fn corner(grid: &Grid, span: u32, at: [i32; 2]) -> Corner {
    let [x, y] = at;
    let around = [[x - 1, y - 1], [x, y - 1], [x - 1, y], [x, y]];
    let mut floors: Vec<(u32, f64, SurfaceKind)> = around
        .into_iter()
        .flat_map(|[column, row]| grid.cell(column, row))
        .map(|(index, span)| (index, span.z, span.kind))
        .collect();
    floors.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
    let mut floor: &[(u32, f64, SurfaceKind)] = &[];
    for near in floors.chunk_by(|a, b| b.1 - a.1 < CLIMB_M) {
        if near.iter().any(|&(index, ..)| index == span) {
            floor = near;
        }
    }
    let lowest = floor.iter().map(|f| f.0).min().unwrap_or(span);
    let mean = |kept: &dyn Fn(SurfaceKind) -> bool| {
        let kept = || floor.iter().filter(|f| kept(f.2)).map(|f| f.1);
        let count = kept().count();
        (count > 0).then(|| kept().sum::<f64>() / count as f64)
    };
    let z = mean(&|kind| kind == SurfaceKind::Sidewalk).or_else(|| mean(&|_| true)).unwrap_or_default();
    let place = (DVec2::new(f64::from(x), f64::from(y)) * grid.cell_m).extend(z);
    Corner { key: (at, lowest), place }
}

/// The corners at which another region begins beyond, and those between that are needed.
fn simplified(outline: &[Edge], cell_m: f64) -> Vec<Corner> {
    let n = outline.len();
    let mut kept: Vec<usize> = (0..n).filter(|&i| outline[i].beyond != outline[(i + n - 1) % n].beyond).collect();
    if kept.len() < 2 {
        // The same all around: from the first corner to the one farthest from it.
        let first = kept.first().copied().unwrap_or(0);
        let away = |&i: &usize| {
            let [x, y] = [0, 1].map(|k| i64::from(outline[i].from.key.0[k]) - i64::from(outline[first].from.key.0[k]));
            x * x + y * y
        };
        let Some(farthest) = (0..n).max_by_key(away).filter(|&i| i != first) else { return Vec::new() };
        kept = vec![first.min(farthest), first.max(farthest)];
    }
    let mut corners = Vec::new();
    for (k, &from) in kept.iter().enumerate() {
        let to = kept[(k + 1) % kept.len()];
        let length = (to + n - from) % n;
        let mut chain: Vec<Corner> = (0..=length).map(|i| outline[(from + i) % n].from).collect();
        // From either side the same corners are chosen.
        let turned = chain[0].key > chain[length].key;
        if turned {
            chain.reverse();
        }
        let mut needed = vec![false; chain.len()];
        (needed[0], needed[length]) = (true, true);
        find_needed(&chain, &mut needed, 0, length, cell_m);
        let mut chosen: Vec<Corner> = chain.iter().zip(needed).filter(|(_, needed)| *needed).map(|(c, _)| *c).collect();
        if turned {
            chosen.reverse();
        }
        chosen.pop();
        corners.extend(chosen);
    }
    corners
}

/// Douglas and Peucker (1973), in the plane and in height.
fn find_needed(chain: &[Corner], needed: &mut [bool], from: usize, to: usize, cell_m: f64) {
    let (a, b) = (chain[from].place, chain[to].place);
    let along = (b - a).truncate();
    let mut worst = (1.0, None);
    for i in from + 1..to {
        let p = chain[i].place;
        let share = ((p - a).truncate().dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
        let on = a + (b - a) * share;
        let off = (p - on).truncate().length() / (OFF_CELLS * cell_m);
        let off = off.max((p.z - on.z).abs() / OFF_M);
        if off > worst.0 {
            worst = (off, Some(i));
        }
    }
    if let Some(i) = worst.1 {
        needed[i] = true;
        find_needed(chain, needed, from, i, cell_m);
        find_needed(chain, needed, i, to, cell_m);
    }
}

#[cfg(test)]
mod tests {
    use super::super::grid::STEPS;
    use super::*;

    #[test]
    fn sides_are_crossed_by_their_steps() {
        for (direction, step) in STEPS.into_iter().enumerate() {
            let (a, b) = (corner_of([0, 0], direction), corner_of([0, 0], (direction + 1) % 4));
            // Twice the way from the cell's middle to the middle of the side.
            assert_eq!([a[0] + b[0] - 1, a[1] + b[1] - 1], step);
            // Counter-clockwise: the cell lies to the left.
            assert_eq!([-(b[1] - a[1]), b[0] - a[0]], [-step[0], -step[1]]);
        }
    }
}
