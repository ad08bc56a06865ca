//! Heights of the ground.

use super::surface::{Surface, SurfaceKind};
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// Side of the cells by which surfaces are found, metres.
const CELL_M: f64 = 8.0;

/// The surfaces of a town, found by place.
#[derive(Debug, Clone)]
pub(super) struct Ground {
    /// Their indices, ascending.
    cells: HashMap<[i32; 2], Vec<u32>>,
}

impl Ground {
    pub(super) fn new(surfaces: &[Surface]) -> Self {
        let mut cells: HashMap<[i32; 2], Vec<u32>> = HashMap::new();
        for (index, surface) in (0..).zip(surfaces) {
            let [low, high] = surface.bounds().map(cell);
            for x in low[0]..=high[0] {
                for y in low[1]..=high[1] {
                    cells.entry([x, y]).or_default().push(index);
                }
            }
        }
        Self { cells }
    }

    /// Of the surfaces at a place, the height of the one nearest to the place's own height; where some touch, of the one
    /// that counts. `None` beside all of them.
    pub(super) fn height(&self, surfaces: &[Surface], place: DVec3) -> Option<f64> {
        let at = place.truncate();
        let there = self.cells.get(&cell(at)).into_iter().flatten().filter_map(|&index| {
            let surface = &surfaces[index as usize];
            Some((surface.kind, surface.height(at)?))
        });
        let mut best: Option<(f64, SurfaceKind, f64)> = None;
        for (kind, z) in there {
            // Surfaces half a metre apart are levels of their own.
            let level = ((z - place.z).abs() / 0.5).floor();
            if best.is_none_or(|(least, of, _)| level < least || (level == least && kind > of)) {
                best = Some((level, kind, z));
            }
        }
        best.map(|(_, _, z)| z)
    }
}

impl Ground {
    /// Heights of the lanes at a place.
    pub(super) fn lane_heights(&self, surfaces: &[Surface], at: DVec2) -> impl Iterator<Item = f64> {
        let there = self.cells.get(&cell(at)).into_iter().flatten();
        there.filter_map(move |&index| {
            let surface = surfaces.get(index as usize)?;
            if surface.kind == SurfaceKind::Road { surface.height(at) } else { None }
        })
    }
}

fn cell(place: DVec2) -> [i32; 2] {
    [(place.x / CELL_M).floor() as i32, (place.y / CELL_M).floor() as i32]
}
