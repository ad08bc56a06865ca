//! Which pavement lies at a place: all strips of a map in bins.

use endless_road::{Strip, StripKind};
use glam::{DVec2, DVec3};

/// Side of a bin, metres.
const BIN_M: f64 = 8.0;

/// Places on the border of a piece belong to it, metres.
const BORDER_M: f64 = 1e-6;

/// One piece of a strip between two neighbouring pairs of points.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece {
    pub(crate) strip: u32,
    pub(crate) kind: StripKind,
    pub(crate) in_junction: bool,
    /// Right and left at its beginning, then left and right at its end: counter-clockwise.
    pub(crate) corners: [DVec3; 4],
    /// The box around them.
    low: DVec2,
    high: DVec2,
}

impl Piece {
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
pub(crate) fn is_carriageway(kind: StripKind) -> bool {
    matches!(kind, StripKind::Driving | StripKind::Parking | StripKind::Shoulder | StripKind::Biking)
}

/// Pieces by place.
#[derive(Debug, Clone)]
pub(crate) struct Cover {
    pub(crate) pieces: Vec<Piece>,
    low: DVec2,
    columns: usize,
    rows: usize,
    bins: Vec<Vec<u32>>,
}

impl Cover {
    pub(crate) fn new(strips: &[Strip], low: DVec2, high: DVec2) -> Self {
        let size = (high - low).max(DVec2::splat(1.0));
        let (columns, rows) = ((size.x / BIN_M).ceil() as usize, (size.y / BIN_M).ceil() as usize);
        let mut cover = Self { pieces: Vec::new(), low, columns, rows, bins: vec![Vec::new(); columns * rows] };
        for (i, strip) in strips.iter().enumerate() {
            for k in 0..strip.left.len().min(strip.right.len()).saturating_sub(1) {
                let corners = [strip.right[k], strip.right[k + 1], strip.left[k + 1], strip.left[k]];
                let flat = corners.map(DVec3::truncate);
                cover.add(Piece {
                    strip: i as u32,
                    kind: strip.kind,
                    in_junction: strip.in_junction,
                    corners,
                    low: flat.iter().fold(DVec2::INFINITY, |l, &p| l.min(p)) - BORDER_M,
                    high: flat.iter().fold(DVec2::NEG_INFINITY, |h, &p| h.max(p)) + BORDER_M,
                });
            }
        }
        cover
    }

    fn add(&mut self, piece: Piece) {
        let number = self.pieces.len() as u32;
        for y in self.row(piece.low.y)..=self.row(piece.high.y) {
            for x in self.column(piece.low.x)..=self.column(piece.high.x) {
                self.bins[y * self.columns + x].push(number);
            }
        }
        self.pieces.push(piece);
    }

    fn column(&self, x: f64) -> usize {
        (((x - self.low.x) / BIN_M).max(0.0) as usize).min(self.columns - 1)
    }

    fn row(&self, y: f64) -> usize {
        (((y - self.low.y) / BIN_M).max(0.0) as usize).min(self.rows - 1)
    }

    /// The pieces over a place, with the height of each.
    pub(crate) fn at(&self, p: DVec2) -> impl Iterator<Item = (&Piece, f64)> {
        self.bins[self.row(p.y) * self.columns + self.column(p.x)].iter().filter_map(move |&i| {
            let piece = &self.pieces[i as usize];
            Some((piece, piece.height_at(p)?))
        })
    }

    /// Whether any pavement lies here.
    pub(crate) fn is_paved(&self, p: DVec2) -> bool {
        self.at(p).next().is_some()
    }

    /// Whether vehicles drive or park here.
    pub(crate) fn is_carriageway(&self, p: DVec2) -> bool {
        self.at(p).any(|(piece, _)| is_carriageway(piece.kind))
    }

    /// The highest pavement at a place that is not above `ceiling`.
    pub(crate) fn height(&self, p: DVec2, ceiling: f64) -> Option<f64> {
        self.at(p).map(|(_, z)| z).filter(|z| *z <= ceiling).max_by(f64::total_cmp)
    }

    /// Whether pavement lies within `reach` of a place, in eight directions.
    pub(crate) fn is_near(&self, p: DVec2, reach: f64) -> bool {
        self.is_paved(p)
            || (0..8).any(|k| {
                let way = crate::plot::unit(std::f64::consts::FRAC_PI_4 * f64::from(k));
                self.is_paved(p + way * reach) || self.is_paved(p + way * (reach * 0.5))
            })
    }
}
