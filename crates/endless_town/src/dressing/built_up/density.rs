//! How dense the streets are around a place: what is built there follows from it.

use endless_road::RoadNetwork;
use glam::DVec2;

/// Roads within this distance tell how dense a place is, metres.
const AROUND_M: f64 = 130.0;

/// Metres of lane on a hectare around places, on a grid.
#[derive(Debug, Clone)]
pub(crate) struct StreetDensity {
    low: DVec2,
    columns: usize,
    cells: Vec<f64>,
}

/// Side of the cells of [`StreetDensity`], metres.
const CELL_M: f64 = 32.0;

impl StreetDensity {
    /// Of the lanes that are streets: highways make no town.
    pub(crate) fn new(network: &RoadNetwork, streets: &[bool], low: DVec2, high: DVec2) -> Self {
        const STEP_M: f64 = 20.0;
        let size = (high - low).max(DVec2::ONE) / CELL_M;
        let (columns, rows) = (size.x.ceil() as usize, size.y.ceil() as usize);
        let mut cells = vec![0.0; columns * rows];
        let hectares = std::f64::consts::PI * AROUND_M * AROUND_M / 10_000.0;
        let reach = (AROUND_M / CELL_M).ceil() as usize;
        for lane in network.lanes.iter().filter(|l| streets[l.id.index()]) {
            let n = (lane.centerline.length() / STEP_M).ceil().max(1.0) as usize;
            let share = lane.centerline.length() / n as f64;
            for i in 0..n {
                let p = (lane.centerline.at((i as f64 + 0.5) * share).position.truncate() - low) / CELL_M;
                let (x, y) = (p.x.max(0.0) as usize, p.y.max(0.0) as usize);
                for row in y.saturating_sub(reach)..(y + reach + 1).min(rows) {
                    for column in x.saturating_sub(reach)..(x + reach + 1).min(columns) {
                        let middle = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                        if middle.distance(p) * CELL_M < AROUND_M {
                            cells[row * columns + column] += share / hectares;
                        }
                    }
                }
            }
        }
        Self { low, columns, cells }
    }

    /// Between the middles of the four cells around, so that no steps show.
    pub(crate) fn at(&self, p: DVec2) -> f64 {
        let rows = self.cells.len() / self.columns;
        let last = DVec2::new((self.columns - 1) as f64, (rows - 1) as f64);
        let q = ((p - self.low) / CELL_M - 0.5).clamp(DVec2::ZERO, last);
        let (x, y) = (q.x as usize, q.y as usize);
        let (x1, y1) = ((x + 1).min(self.columns - 1), (y + 1).min(rows - 1));
        let (u, v) = (q.x - x as f64, q.y - y as f64);
        let row = |y: usize| self.cells[y * self.columns + x] * (1.0 - u) + self.cells[y * self.columns + x1] * u;
        row(y) * (1.0 - v) + row(y1) * v
    }
}
