//! A smooth reference line through the points of a lane's centre line: straight pieces and cubics whose directions
//! agree where they meet.

use endless_world::math::f64::{atan2, sin_cos, wrap_angle};
use endless_world::math::segment::share_along;
use glam::{DVec2, DVec3};

/// Pieces that leave their chord by less than this are straight, metres.
const STRAIGHT_M: f64 = 1e-4;
/// And turn less than this, radians: lanes far from the reference line swing with it.
const STRAIGHT_RAD: f64 = 4e-4;

/// A curve leaves its chord by this share of the chord's length at most, for a bend of 1 at one of its ends: the greatest
/// value of t (1 - t)^2.
const HERMITE_OFF: f64 = 4.0 / 27.0;
/// Curves may leave the chain that they are to follow by this, metres.
const MOST_OFF_M: f64 = 0.004;

/// One piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct FittedPiece {
    pub(super) s: f64,
    pub(super) start: DVec2,
    pub(super) heading: f64,
    pub(super) length: f64,
    /// `[aU bU cU dU], [aV bV cV dV]` over a parameter from 0 to 1; `None` if straight.
    pub(super) cubic: Option<[[f64; 4]; 2]>,
}

/// The point of a reference line that is nearest to a place.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearestPoint {
    pub(super) s: f64,
    pub(super) place: DVec3,
    /// Counter-clockwise from east, radians.
    pub(super) heading: f64,
    /// Rise over run of the line there.
    pub(super) grade: f64,
}

/// A reference line with its height.
#[derive(Debug, Clone)]
pub(super) struct FittedLine {
    pub(super) pieces: Vec<FittedPiece>,
    /// `s` and height at each point.
    pub(super) heights: Vec<(f64, f64)>,
    pub(super) length: f64,
}

impl FittedLine {
    /// Through points, with the direction at each.
    pub(super) fn new(points: &[DVec3], directions: &[DVec2]) -> Self {
        let mut line = Self { pieces: Vec::new(), heights: vec![(0.0, points[0].z)], length: 0.0 };
        for i in 1..points.len() {
            let (a, b) = (points[i - 1].truncate(), points[i].truncate());
            let chord = a.distance(b);
            if chord < 1e-6 {
                continue;
            }
            let along = (b - a) / chord;
            let bend = |direction: DVec2| along.perp_dot(direction).abs();
            let turn = bend(directions[i - 1]) + bend(directions[i]);
            let straight = turn * chord * 0.15 < STRAIGHT_M && turn < STRAIGHT_RAD;
            let heading = if straight { angle(along) } else { angle(directions[i - 1]) };
            let (sin, cos) = sin_cos(heading);
            let local = |v: DVec2| DVec2::new(cos * v.x + sin * v.y, cos * v.y - sin * v.x);
            let cubic = (!straight).then(|| hermite(chord, local(b - a), local(directions[i])));
            let length = cubic.as_ref().map_or(chord, arc_length);
            line.pieces.push(FittedPiece { s: line.length, start: a, heading, length, cubic });
            line.length += length;
            line.heights.push((line.length, points[i].z));
        }
        line
    }

    /// The point nearest to a place, seen from above.
    pub(super) fn nearest(&self, place: DVec2) -> NearestPoint {
        let mut best = (f64::INFINITY, 0.0, DVec2::ZERO, 0.0);
        for piece in &self.pieces {
            let n = if piece.cubic.is_some() { 16 } else { 1 };
            let share_at = |k: usize| k as f64 / f64::from(n as u32);
            for k in 0..n {
                let (a, b) = (piece.point(share_at(k)), piece.point(share_at(k + 1)));
                let along = b - a;
                let share = share_along(place, a, b);
                let there = a + along * share;
                let distance = place.distance_squared(there);
                if distance < best.0 {
                    let p = (k as f64 + share) / f64::from(n as u32);
                    best = (distance, piece.s + piece.length * p, there, piece.heading_at(p));
                }
            }
        }
        let (_, s, there, heading) = best;
        let (z, grade) = self.height(s);
        NearestPoint { s, place: there.extend(z), heading, grade }
    }

    /// Height and rise over run at `s`.
    fn height(&self, s: f64) -> (f64, f64) {
        let after = self.heights.partition_point(|&(at, _)| at <= s).clamp(1, self.heights.len().max(2) - 1);
        let [(s0, z0), (s1, z1)] = [after - 1, after].map(|i| self.heights.get(i).copied().unwrap_or((s, 0.0)));
        let grade = if s1 > s0 { (z1 - z0) / (s1 - s0) } else { 0.0 };
        (z0 + (s - s0) * grade, grade)
    }
}

impl FittedPiece {
    /// The point at a share of its length.
    fn point(&self, share: f64) -> DVec2 {
        let (sin, cos) = sin_cos(self.heading);
        let local = match &self.cubic {
            Some([u, v]) => DVec2::new(value(u, share), value(v, share)),
            None => DVec2::new(share * self.length, 0.0),
        };
        self.start + DVec2::new(cos * local.x - sin * local.y, sin * local.x + cos * local.y)
    }

    /// Its direction at a share of its length, radians.
    fn heading_at(&self, share: f64) -> f64 {
        let Some(cubic) = &self.cubic else { return self.heading };
        let [du, dv] = cubic.map(|[_, b, c, d]| b + share * (2.0 * c + share * 3.0 * d));
        wrap_angle(self.heading + atan2(dv, du))
    }
}

/// Directions at the points of a line: at each the mean of its two sides, the longer counting more, so that long
/// straight pieces stay straight.
pub(super) fn directions(points: &[DVec3]) -> Vec<DVec2> {
    let side = |i: usize| (points[i + 1] - points[i]).truncate();
    let last = points.len() - 1;
    (0..points.len())
        .map(|i| {
            let sum = if i > 0 { side(i - 1) } else { DVec2::ZERO } + if i < last { side(i) } else { DVec2::ZERO };
            sum.normalize_or(DVec2::X)
        })
        .collect()
}

/// The same points with more beside those where a curve through them would leave the chain: there the curve bends within
/// a short way and is straight before and behind. Returns them with their directions.
pub(super) fn tightened(points: &[DVec3], directions: &[DVec2]) -> (Vec<DVec3>, Vec<DVec2>) {
    let (mut out, mut along) = (Vec::new(), Vec::new());
    for i in 0..points.len() {
        let side = |j: usize| {
            let way = points[j] - points[i];
            let bend = (way.truncate().normalize_or_zero().perp_dot(directions[i])).abs();
            let off = HERMITE_OFF * bend * way.truncate().length();
            // Where the curve begins to bend, and the direction there.
            let share = (0.5 * MOST_OFF_M / off).min(0.3);
            (off > MOST_OFF_M).then(|| (points[i] + way * share, way.truncate().normalize_or(DVec2::X)))
        };
        if let Some((p, back)) = (i > 0).then(|| side(i - 1)).flatten() {
            out.push(p);
            along.push(-back);
        }
        out.push(points[i]);
        along.push(directions[i]);
        if let Some((p, forward)) = (i + 1 < points.len()).then(|| side(i + 1)).flatten() {
            out.push(p);
            along.push(forward);
        }
    }
    (out, along)
}

fn angle(v: DVec2) -> f64 {
    wrap_angle(atan2(v.y, v.x))
}

/// From the origin along u to `end` with direction `leaving`.
fn hermite(chord: f64, end: DVec2, leaving: DVec2) -> [[f64; 4]; 2] {
    let (m0, m1) = (DVec2::new(chord, 0.0), leaving * chord);
    let c = 3.0 * end - 2.0 * m0 - m1;
    let d = -2.0 * end + m0 + m1;
    [[0.0, m0.x, c.x, d.x], [0.0, m0.y, c.y, d.y]]
}

fn value(c: &[f64; 4], p: f64) -> f64 {
    c[0] + p * (c[1] + p * (c[2] + p * c[3]))
}

/// Simpson's rule on the speed.
fn arc_length(cubic: &[[f64; 4]; 2]) -> f64 {
    let speed = |p: f64| {
        let d = |c: &[f64; 4]| c[1] + p * (2.0 * c[2] + p * 3.0 * c[3]);
        DVec2::new(d(&cubic[0]), d(&cubic[1])).length()
    };
    let n = 32;
    let step = 1.0 / f64::from(n);
    let sum: f64 = (0..=n)
        .map(|i| {
            let weight = if i == 0 || i == n {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            };
            weight * speed(f64::from(i) * step)
        })
        .sum();
    sum * step / 3.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_stay_on_chains_with_sharp_bends() {
        let bend = |turn: f64| {
            let (sin, cos) = sin_cos(turn);
            [DVec3::ZERO, DVec3::new(2.0, 0.0, 0.1), DVec3::new(2.0 + 3.0 * cos, 3.0 * sin, 0.2)]
        };
        for turn in [0.01, 0.1, 0.5, 1.2] {
            let chain = bend(turn);
            let (points, along) = tightened(&chain, &directions(&chain));
            let line = FittedLine::new(&points, &along);
            for piece in &line.pieces {
                for k in 0..=20 {
                    let at = piece.point(f64::from(k) / 20.0);
                    let off = chain.windows(2).map(|w| {
                        let (a, way) = (w[0].truncate(), (w[1] - w[0]).truncate());
                        let t = ((at - a).dot(way) / way.length_squared()).clamp(0.0, 1.0);
                        at.distance(a + way * t)
                    });
                    let off = off.fold(f64::INFINITY, f64::min);
                    assert!(off < 0.006, "turn {turn}: {off} m");
                }
            }
        }
    }
}
