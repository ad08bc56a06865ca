//! Surfaces on a grid of cells, on as many levels as there are.

use super::super::surface::{Surface, SurfaceKind};
use glam::{DVec2, DVec3};

/// Surfaces nearer to one another in height than this are one floor, metres.
const FLOOR_M: f64 = 1.0;
/// Who walks climbs this from a cell to the next, metres.
pub(super) const CLIMB_M: f64 = 0.4;
/// Connected parts smaller than this are left out, m².
const LEAST_M2: f64 = 4.0;
/// No neighbour.
pub(super) const NONE: u32 = u32::MAX;
/// Steps to the neighbours of a cell, as column and row: east, north, west, south.
pub(super) const STEPS: [[i32; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];
const WEST: usize = 2;
const SOUTH: usize = 3;

/// One floor of one cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    pub(super) column: i32,
    pub(super) row: i32,
    /// Height in the middle of the cell, metres.
    pub(super) z: f64,
    pub(super) kind: SurfaceKind,
    /// Indices of the neighbours in the order of [`STEPS`].
    pub(super) beside: [u32; 4],
}

impl Span {
    /// The neighbour to the west.
    pub(super) fn west(&self) -> u32 {
        self.beside[WEST]
    }

    /// The neighbour to the south.
    pub(super) fn south(&self) -> u32 {
        self.beside[SOUTH]
    }
}

/// All floors of all cells, by row, column and height. Cell (0, 0) has its south-western corner in the world's origin.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    pub(super) cell_m: f64,
    pub(super) spans: Vec<Span>,
    first_row: i32,
    /// Index of the first span of each row, and the end.
    rows: Vec<usize>,
}

impl Grid {
    /// Of surfaces. People keep a cell's width from edges beyond which there is nothing to walk on; ways are kept open
    /// wherever they lead.
    pub(super) fn new(surfaces: &[Surface], cell_m: f64) -> Self {
        let mut samples = Vec::new();
        for surface in surfaces.iter().filter(|surface| surface.kind != SurfaceKind::Way) {
            sample(surface, cell_m, &mut samples);
        }
        let whole = Self::of_samples(samples, cell_m);
        let inside = |span: &&Span| !span.beside.contains(&NONE);
        let mut samples: Vec<Span> = whole.spans.iter().filter(inside).copied().collect();
        for way in surfaces.iter().filter(|surface| surface.kind == SurfaceKind::Way) {
            sample(way, cell_m, &mut samples);
        }
        Self::of_samples(samples, cell_m).without_crumbs()
    }

    fn of_samples(mut samples: Vec<Span>, cell_m: f64) -> Self {
        samples.sort_unstable_by(|a, b| {
            (a.row, a.column).cmp(&(b.row, b.column)).then(a.z.total_cmp(&b.z)).then(a.kind.cmp(&b.kind))
        });
        let mut spans: Vec<Span> = Vec::new();
        let mut from = 0;
        while from < samples.len() {
            let cell = |i: usize| (samples[i].row, samples[i].column);
            let mut to = from + 1;
            while to < samples.len() && cell(to) == cell(from) && samples[to].z - samples[to - 1].z < FLOOR_M {
                to += 1;
            }
            spans.push(floor(&samples[from..to]));
            from = to;
        }
        let mut grid = Self { cell_m, spans, first_row: 0, rows: Vec::new() };
        grid.index_rows();
        grid.find_neighbours();
        grid
    }

    fn index_rows(&mut self) {
        self.first_row = self.spans.first().map_or(0, |span| span.row);
        let count = self.spans.last().map_or(0, |span| (span.row - self.first_row + 1) as usize);
        self.rows = vec![0; count + 1];
        for span in &self.spans {
            self.rows[(span.row - self.first_row) as usize + 1] += 1;
        }
        for row in 0..count {
            self.rows[row + 1] += self.rows[row];
        }
    }

    fn find_neighbours(&mut self) {
        for i in 0..self.spans.len() {
            let span = self.spans[i];
            self.spans[i].beside = STEPS.map(|[column, row]| {
                let there = self.cell(span.column + column, span.row + row);
                let near = |&(_, other): &(u32, &Span)| (other.z - span.z).abs() < CLIMB_M;
                there.filter(near).map(|(index, _)| index).next().unwrap_or(NONE)
            });
        }
    }

    /// The floors of a cell, from below.
    pub(super) fn cell(&self, column: i32, row: i32) -> impl Iterator<Item = (u32, &Span)> {
        let row = i64::from(row) - i64::from(self.first_row);
        let inside = row >= 0 && row + 1 < self.rows.len() as i64;
        let range = if inside { self.rows[row as usize]..self.rows[row as usize + 1] } else { 0..0 };
        let spans = &self.spans[range.clone()];
        let from = spans.partition_point(|span| span.column < column);
        let first = range.start + from;
        (first as u32..).zip(spans[from..].iter().take_while(move |span| span.column == column))
    }

    /// Without connected parts that are too small, or that are roads alone.
    fn without_crumbs(mut self) -> Self {
        let least = (LEAST_M2 / (self.cell_m * self.cell_m)) as usize;
        let mut seen = vec![false; self.spans.len()];
        let mut kept = vec![false; self.spans.len()];
        for start in 0..self.spans.len() {
            if seen[start] {
                continue;
            }
            seen[start] = true;
            let (mut part, mut next) = (vec![start], 0);
            while next < part.len() {
                for beside in self.spans[part[next]].beside {
                    if beside != NONE && !std::mem::replace(&mut seen[beside as usize], true) {
                        part.push(beside as usize);
                    }
                }
                next += 1;
            }
            if part.len() >= least && part.iter().any(|&span| self.spans[span].kind == SurfaceKind::Sidewalk) {
                part.into_iter().for_each(|span| kept[span] = true);
            }
        }
        let mut index = 0;
        self.spans.retain(|_| {
            index += 1;
            kept[index - 1]
        });
        self.index_rows();
        self.find_neighbours();
        self
    }
}

/// The floor that samples of a cell make: the kind that counts, at its mean height.
fn floor(samples: &[Span]) -> Span {
    let kind = samples.iter().map(|s| s.kind).max().unwrap_or(SurfaceKind::Road);
    // Ways are sidewalks from here on.
    let shown = if kind == SurfaceKind::Way { SurfaceKind::Sidewalk } else { kind };
    let of_kind = || samples.iter().filter(|s| s.kind == kind);
    let z = of_kind().map(|s| s.z).sum::<f64>() / of_kind().count().max(1) as f64;
    Span { z, kind: shown, ..samples[0] }
}

/// The cells whose middle lies on a surface.
fn sample(surface: &Surface, cell_m: f64, into: &mut Vec<Span>) {
    for triangle in surface.triangles() {
        let [a, b, c] = triangle;
        let normal = (b - a).cross(c - a);
        if normal.z.abs() < 1e-9 {
            continue;
        }
        let slope = -normal.truncate() / normal.z;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        for row in middle_from(low.y, cell_m)..=middle_to(high.y, cell_m) {
            let y = (f64::from(row) + 0.5) * cell_m;
            let Some([from, to]) = crossed(&triangle, y) else { continue };
            for column in middle_from(from, cell_m)..=middle_to(to, cell_m) {
                let place = DVec2::new((f64::from(column) + 0.5) * cell_m, y);
                let z = a.z + slope.dot(place - a.truncate());
                into.push(Span { column, row, z, kind: surface.kind, beside: [NONE; 4] });
            }
        }
    }
}

/// The first cell whose middle is not before a place.
fn middle_from(place: f64, cell_m: f64) -> i32 {
    (place / cell_m - 0.5 - 1e-9).ceil() as i32
}

/// The last cell whose middle is not behind a place.
fn middle_to(place: f64, cell_m: f64) -> i32 {
    (place / cell_m - 0.5 + 1e-9).floor() as i32
}

/// Where a line from west to east crosses a triangle.
fn crossed(triangle: &[DVec3; 3], y: f64) -> Option<[f64; 2]> {
    let mut found: Option<[f64; 2]> = None;
    for i in 0..3 {
        let (a, b) = (triangle[i], triangle[(i + 1) % 3]);
        if (a.y - y) * (b.y - y) > 0.0 {
            continue;
        }
        let ends = if a.y == b.y {
            [a.x.min(b.x), a.x.max(b.x)]
        } else {
            let x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
            [x, x]
        };
        let [from, to] = found.unwrap_or(ends);
        found = Some([from.min(ends[0]), to.max(ends[1])]);
    }
    found
}
