//! Irradiance probes of a whole town for cameras that go anywhere: on one lattice over the ground, made where they are first
//! wanted, and kept.
//!
//! ```text
//! a camera's place ──► window of columns ──► those that are missing are baked ──► a grid of all of them
//! ```
//! A column is five probes above one another. When the light changes a little, columns are baked again some at a time, those
//! nearest to a camera first; until then they keep what they had.

use super::indirect_hits::{IndirectRays, PROBE_BOUNCES};
use super::probe_bake::{RAYS, probe};
use super::probe_grid::{HEIGHTS_M, LAYERS, Probe, ProbeGrid, SPACING_M};
use crate::accel::Ray;
use crate::material::noise;
use crate::scene::StaticScene;
use crate::shade::Tracer;
use crate::work_share;
use endless_world::ClassTag;
use glam::{Vec2, Vec3, Vec3A};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Columns from the middle of a window to its edge: 90 m.
const REACH: i32 = 15;
/// Columns along the edge of a window.
const EDGE: u32 = 2 * REACH as u32 + 1;

/// A place on the lattice: column and row.
pub(crate) type Cell = [i32; 2];

/// The probes of a town, as far as they are known.
pub(crate) struct ProbeMap {
    columns: BTreeMap<Cell, Column>,
    /// Height of the ground where there is none, metres.
    ground: f32,
    pattern: u32,
    /// Counts the changes of light.
    light: u32,
}

/// Probes above one another.
#[derive(Debug, Clone)]
struct Column {
    ground: f32,
    bounces: [[Probe; LAYERS]; PROBE_BOUNCES],
    /// In which light it was baked.
    light: u32,
}

impl ProbeMap {
    /// Nothing known yet; `pattern` is that of the rays, `ground` a height for where there is no ground, metres.
    pub(crate) fn new(pattern: u32, ground: f32) -> Self {
        Self { columns: BTreeMap::new(), ground, pattern, light: 0 }
    }

    /// The cell in whose middle a place lies.
    pub(crate) fn cell(place: Vec3) -> Cell {
        let of = |along: f32| (along / SPACING_M).round() as i32;
        [of(place.x), of(place.y)]
    }

    /// The rectangle that a window covers.
    pub(crate) fn bounds([x, y]: Cell) -> [Vec2; 2] {
        let corner = |aside: i32| Vec2::new((x + aside) as f32, (y + aside) as f32) * SPACING_M;
        [corner(-REACH), corner(REACH)]
    }

    /// The light has changed: what is known is out of date.
    pub(crate) fn age(&mut self) {
        self.light += 1;
    }

    /// Bakes what a window lacks, and again so many columns at most that are out of date; tells whether it changed anything.
    pub(crate) fn complete(&mut self, without_probes: &Tracer<'_>, middle: Cell, most_again: usize) -> bool {
        let still = without_probes.still;
        let missing: Vec<Cell> = window(middle).filter(|cell| !self.columns.contains_key(cell)).collect();
        let grounds: Vec<f32> =
            missing.par_iter().map(|&cell| ground_below(still, cell).unwrap_or(self.ground)).collect();
        for (&cell, ground) in missing.iter().zip(grounds) {
            let bounces = [[Probe::NONE; LAYERS]; PROBE_BOUNCES];
            self.columns.insert(cell, Column { ground, bounces, light: self.light });
        }
        let mut wanted = missing;
        wanted.extend(self.out_of_date(middle, most_again));
        if wanted.is_empty() {
            return false;
        }
        for bounce in 0..PROBE_BOUNCES {
            let known = (bounce > 0).then(|| self.grid(middle, bounce - 1));
            let tracer = Tracer { probes: known.as_ref(), ..*without_probes };
            let baked: Vec<[Probe; LAYERS]> = wanted
                .par_iter()
                .with_max_len(work_share::PLACES)
                .map(|&cell| std::array::from_fn(|layer| self.baked(&tracer, cell, layer, bounce)))
                .collect();
            for (cell, probes) in wanted.iter().zip(baked) {
                if let Some(column) = self.columns.get_mut(cell) {
                    (column.bounces[bounce], column.light) = (probes, self.light);
                }
            }
        }
        true
    }

    /// The probes of a window; those that are not known are dark.
    pub(crate) fn window(&self, middle: Cell) -> ProbeGrid {
        self.grid(middle, PROBE_BOUNCES - 1)
    }

    fn out_of_date(&self, [x, y]: Cell, most: usize) -> Vec<Cell> {
        if most == 0 || self.light == 0 {
            return Vec::new();
        }
        let is_old = |cell: &Cell| self.columns.get(cell).is_some_and(|column| column.light != self.light);
        let mut old: Vec<Cell> = window([x, y]).filter(is_old).collect();
        old.sort_by_key(|cell| (cell[0] - x).pow(2) + (cell[1] - y).pow(2));
        old.truncate(most);
        old
    }

    fn baked(&self, tracer: &Tracer<'_>, cell: Cell, layer: usize, bounce: usize) -> Probe {
        let ground = self.columns.get(&cell).map_or(self.ground, |column| column.ground);
        let place = place_of(cell).extend(ground + HEIGHTS_M[layer]);
        let [x, y] = cell.map(i32::cast_unsigned);
        let pattern = noise::hash(x ^ noise::hash(y ^ noise::hash(layer as u32))) ^ noise::hash(self.pattern);
        let mut tape = IndirectRays::Trace.tape(|hits| &hits.probes[bounce], 0);
        probe(tracer, &mut tape, place.into(), pattern, RAYS[bounce])
    }

    fn grid(&self, middle: Cell, bounce: usize) -> ProbeGrid {
        let columns: Vec<Option<&Column>> = window(middle).map(|cell| self.columns.get(&cell)).collect();
        let ground = columns.iter().map(|column| column.map_or(self.ground, |column| column.ground)).collect();
        let layer = |layer: usize| {
            columns.iter().map(move |column| column.map_or(Probe::NONE, |column| column.bounces[bounce][layer]))
        };
        let [low, _] = Self::bounds(middle);
        ProbeGrid::of_columns(low, EDGE, ground, (0..LAYERS).flat_map(layer).collect())
    }
}

/// The cells of a window, row by row.
fn window([x, y]: Cell) -> impl Iterator<Item = Cell> {
    (-REACH..=REACH).flat_map(move |row| (-REACH..=REACH).map(move |column| [x + column, y + row]))
}

fn place_of([x, y]: Cell) -> Vec2 {
    Vec2::new(x as f32, y as f32) * SPACING_M
}

/// Height of the lowest ground at a column: under bridges, that on which they stand.
fn ground_below(still: &StaticScene, cell: Cell) -> Option<f32> {
    use ClassTag::{Ground, RoadLines, Roads, Sidewalks, Terrain};
    /// Higher than any roof, metres.
    const ABOVE_M: f32 = 1000.0;
    /// Floors and roofs above one another.
    const MOST: usize = 64;
    let mut origin = Vec3A::from(place_of(cell).extend(ABOVE_M));
    let mut lowest = None;
    for _ in 0..MOST {
        let Some(hit) = still.accel.closest(&Ray { origin, direction: Vec3A::NEG_Z, tmax: f32::MAX }) else { break };
        origin.z -= hit.t;
        let instance = &still.instances[hit.instance as usize];
        let tag = instance.class.unwrap_or(instance.material_of(hit.triangle).1.tag);
        if matches!(tag, Roads | Sidewalks | Terrain | RoadLines | Ground) {
            lowest = Some(origin.z);
        }
        origin.z -= 0.01;
    }
    lowest
}
