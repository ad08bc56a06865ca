//! Which pavement lies at a place: all strips of a map in bins, and the asphalt between them in junctions.

use crate::geometry::triangulate;
use endless_road::{LaneSurface, LaneType};
use glam::{DVec2, DVec3};

/// Side of a bin, metres.
const BIN_M: f64 = 8.0;

/// Places on the border of a piece belong to it, metres.
const BORDER_M: f64 = 1e-6;

/// One piece of a strip between two neighbouring pairs of points.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PavementPiece {
    pub(crate) strip: u32,
    pub(crate) kind: LaneType,
    pub(crate) in_junction: bool,
    /// Right and left at its beginning, then left and right at its end: counter-clockwise.
    pub(crate) corners: [DVec3; 4],
    /// The box around them.
    low: DVec2,
    high: DVec2,
}

impl PavementPiece {
    pub(crate) fn middle(&self) -> DVec3 {
        self.corners.iter().sum::<DVec3>() / 4.0
    }

    /// Height of its surface at a place inside, `None` outside.
    fn height_at(&self, p: DVec2) -> Option<f64> {
        if !(p.cmpge(self.low).all() && p.cmple(self.high).all()) {
            return None;
        }
        let [a, b, c, d] = self.corners;
        in_triangle(a, b, c, p).or_else(|| in_triangle(a, c, d, p))
    }
}

fn in_triangle(a: DVec3, b: DVec3, c: DVec3, p: DVec2) -> Option<f64> {
    let (a2, b2, c2) = (a.truncate(), b.truncate(), c.truncate());
    let area = (b2 - a2).perp_dot(c2 - a2);
    if area.abs() < 1e-9 {
        return None;
    }
    let (u, v) = ((b2 - p).perp_dot(c2 - p) / area, (c2 - p).perp_dot(a2 - p) / area);
    let w = 1.0 - u - v;
    (u >= -1e-9 && v >= -1e-9 && w >= -1e-9).then_some(a.z * u + b.z * v + c.z * w)
}

/// Whether vehicles drive or park on this.
pub(crate) fn is_carriageway(kind: LaneType) -> bool {
    matches!(kind, LaneType::Driving | LaneType::Parking | LaneType::Shoulder | LaneType::Biking)
}

/// A piece in a bin, with a box around its own that takes little memory: most are far from the place that is asked for.
#[derive(Debug, Clone, Copy)]
struct BinnedPiece {
    low: [f32; 2],
    high: [f32; 2],
    piece: u32,
}

impl BinnedPiece {
    fn new(piece: &PavementPiece, number: u32) -> Self {
        let below = |x: f64| (x as f32).next_down();
        let above = |x: f64| (x as f32).next_up();
        let (low, high) = (piece.low, piece.high);
        Self { low: [below(low.x), below(low.y)], high: [above(high.x), above(high.y)], piece: number }
    }

    fn may_hold(&self, p: DVec2) -> bool {
        f64::from(self.low[0]) <= p.x
            && p.x <= f64::from(self.high[0])
            && f64::from(self.low[1]) <= p.y
            && p.y <= f64::from(self.high[1])
    }
}

/// Pieces by place.
#[derive(Debug, Clone)]
pub(crate) struct PavementIndex {
    pub(crate) pieces: Vec<PavementPiece>,
    low: DVec2,
    columns: usize,
    rows: usize,
    /// The pieces that reach into each bin: bin `i` has those from `starts[i]` to `starts[i + 1]`.
    starts: Vec<u32>,
    binned: Vec<BinnedPiece>,
    /// Triangles of the asphalt between strips, and their bins.
    between: Vec<[DVec3; 3]>,
    between_bins: Vec<Vec<u32>>,
}

impl PavementIndex {
    pub(crate) fn new(lane_surfaces: &[LaneSurface], low: DVec2, high: DVec2) -> Self {
        let size = (high - low).max(DVec2::splat(1.0));
        let (columns, rows) = ((size.x / BIN_M).ceil() as usize, (size.y / BIN_M).ceil() as usize);
        let mut pavement = Self {
            pieces: Vec::new(),
            low,
            columns,
            rows,
            starts: vec![0; columns * rows + 1],
            binned: Vec::new(),
            between: Vec::new(),
            between_bins: vec![Vec::new(); columns * rows],
        };
        for (i, strip) in lane_surfaces.iter().enumerate() {
            for k in 0..strip.left.len().min(strip.right.len()).saturating_sub(1) {
                let corners = [strip.right[k], strip.right[k + 1], strip.left[k + 1], strip.left[k]];
                let flat = corners.map(DVec3::truncate);
                pavement.pieces.push(PavementPiece {
                    strip: i as u32,
                    kind: strip.kind,
                    in_junction: strip.in_junction,
                    corners,
                    low: flat.iter().fold(DVec2::INFINITY, |l, &p| l.min(p)) - BORDER_M,
                    high: flat.iter().fold(DVec2::NEG_INFINITY, |h, &p| h.max(p)) + BORDER_M,
                });
            }
        }
        pavement.bin_pieces();
        pavement
    }

    fn bin_pieces(&mut self) {
        let mut bins: Vec<(usize, u32)> = Vec::new();
        for (number, piece) in self.pieces.iter().enumerate() {
            bins.extend(self.bins_in(piece.low, piece.high).map(|bin| (bin, number as u32)));
        }
        for (bin, _) in &bins {
            self.starts[bin + 1] += 1;
        }
        for bin in 1..self.starts.len() {
            self.starts[bin] += self.starts[bin - 1];
        }
        let mut next = self.starts.clone();
        self.binned = vec![BinnedPiece { low: [0.0; 2], high: [0.0; 2], piece: 0 }; bins.len()];
        for (bin, number) in bins {
            self.binned[next[bin] as usize] = BinnedPiece::new(&self.pieces[number as usize], number);
            next[bin] += 1;
        }
    }

    /// Asphalt that no strip tells of, by its outline, counter-clockwise.
    pub(crate) fn add_between(&mut self, outline: &[DVec3]) {
        let flat: Vec<DVec2> = outline.iter().map(|p| p.truncate()).collect();
        if flat.len() < 3 || crate::geometry::area(&flat) <= 0.0 {
            return;
        }
        for triangle in triangulate(&flat, &[]).1 {
            let number = self.between.len() as u32;
            let corners = triangle.map(|k| flat[k]);
            let (low, high) = (corners[0].min(corners[1]).min(corners[2]), corners[0].max(corners[1]).max(corners[2]));
            for bin in self.bins_in(low, high) {
                self.between_bins[bin].push(number);
            }
            self.between.push(triangle.map(|k| outline[k]));
        }
    }

    fn bins_in(&self, low: DVec2, high: DVec2) -> impl Iterator<Item = usize> + use<> {
        let (x0, x1, columns) = (self.column(low.x), self.column(high.x), self.columns);
        (self.row(low.y)..=self.row(high.y)).flat_map(move |y| (x0..=x1).map(move |x| y * columns + x))
    }

    fn column(&self, x: f64) -> usize {
        (((x - self.low.x) / BIN_M).max(0.0) as usize).min(self.columns - 1)
    }

    fn row(&self, y: f64) -> usize {
        (((y - self.low.y) / BIN_M).max(0.0) as usize).min(self.rows - 1)
    }

    fn bin(&self, p: DVec2) -> usize {
        self.row(p.y) * self.columns + self.column(p.x)
    }

    /// The pieces over a place, with the height of each.
    pub(crate) fn at(&self, p: DVec2) -> impl Iterator<Item = (&PavementPiece, f64)> {
        let bin = self.bin(p);
        let near = &self.binned[self.starts[bin] as usize..self.starts[bin + 1] as usize];
        near.iter().filter(move |near| near.may_hold(p)).filter_map(move |near| {
            let piece = &self.pieces[near.piece as usize];
            Some((piece, piece.height_at(p)?))
        })
    }

    /// Heights of the asphalt between strips at a place.
    pub(crate) fn between(&self, p: DVec2) -> impl Iterator<Item = f64> {
        self.between_bins[self.bin(p)].iter().filter_map(move |&i| {
            let [a, b, c] = self.between[i as usize];
            in_triangle(a, b, c, p)
        })
    }

    /// Whether any pavement lies here.
    pub(crate) fn is_paved(&self, p: DVec2) -> bool {
        self.at(p).next().is_some() || self.between(p).next().is_some()
    }

    /// Whether vehicles drive or park here.
    pub(crate) fn is_carriageway(&self, p: DVec2) -> bool {
        self.at(p).any(|(piece, _)| is_carriageway(piece.kind)) || self.between(p).next().is_some()
    }

    /// The highest pavement at a place that is not above `ceiling`.
    pub(crate) fn height(&self, p: DVec2, ceiling: f64) -> Option<f64> {
        self.at(p).map(|(_, z)| z).chain(self.between(p)).filter(|z| *z <= ceiling).max_by(f64::total_cmp)
    }

    /// Whether pavement lies within `reach` of a place, in eight directions.
    pub(crate) fn is_near(&self, p: DVec2, reach: f64) -> bool {
        self.is_paved(p)
            || (0..8).any(|k| {
                let way = crate::geometry::unit(std::f64::consts::FRAC_PI_4 * f64::from(k));
                self.is_paved(p + way * reach) || self.is_paved(p + way * (reach * 0.5))
            })
    }
}
