//! The land as roads shape it, once it is known: heights, lines laid on it, and junctions cut to follow it.

use super::curve::area;
use super::ring::clipped;
use crate::{Polyline, Terrain};
use glam::{DVec2, DVec3};

/// What is nearer to the ground than this lies on it, metres.
const ON_GROUND_M: f64 = 0.8;
/// Junctions are divided into pieces of this size, metres.
const PIECE_M: f64 = 3.0;

/// The land as roads shape it.
#[derive(Debug, Clone)]
pub(super) struct Formation(Terrain);

impl Formation {
    /// Of a terrain that has been shaped.
    pub(super) fn new(terrain: Terrain) -> Self {
        Self(terrain)
    }

    /// Lays a line through a junction on the ground between its ends, which stay, so that ways that cross there do so at
    /// one height. Lines on bridges stay as they are.
    pub(super) fn lay(&self, line: &mut Polyline) {
        let length = line.length();
        let over = |p: DVec3| p.z - self.height(p.truncate());
        let (first, last) = (over(line.at(0.0).position), over(line.at(length).position));
        if first.abs().max(last.abs()) > ON_GROUND_M || length < 0.5 {
            return;
        }
        let mut s = 0.0;
        let points = line.points();
        let laid: Vec<DVec3> = (0..points.len())
            .map(|i| {
                s += if i > 0 { points[i].distance(points[i - 1]) } else { 0.0 };
                let p = points[i].truncate();
                p.extend(self.height(p) + first + (last - first) * (s / length).min(1.0))
            })
            .collect();
        *line = Polyline::new(laid);
    }

    /// A junction's asphalt in pieces that are small enough to follow the ground.
    pub(super) fn pieces(&self, outline: &[DVec3]) -> Vec<Vec<DVec3>> {
        if outline.iter().any(|p| (p.z - self.height(p.truncate())).abs() > ON_GROUND_M) {
            return vec![outline.to_vec()];
        }
        let flat: Vec<DVec2> = outline.iter().map(|p| p.truncate()).collect();
        let (low, high) = flat.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), &p| (l.min(p), h.max(p)));
        let (low, high) = ((low / PIECE_M).floor(), (high / PIECE_M).ceil());
        let mut pieces = Vec::new();
        for y in low.y as i64..high.y as i64 {
            for x in low.x as i64..high.x as i64 {
                let corner = DVec2::new(x as f64, y as f64) * PIECE_M;
                let piece = clipped(&flat, [corner, corner + PIECE_M]);
                if piece.len() >= 3 && area(&piece) > 0.01 {
                    pieces.push(piece.into_iter().map(|p| p.extend(self.height(p))).collect());
                }
            }
        }
        pieces
    }

    /// Height at a place, metres.
    pub(super) fn height(&self, p: DVec2) -> f64 {
        self.0.height(p)
    }
}
