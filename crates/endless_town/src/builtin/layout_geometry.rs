//! Geometry of town layouts: points, smooth lines, outlines, hills.

use crate::geometry::unit;
use endless_world::math::segment::share_along;
use glam::DVec2;

/// Distance between points of a smooth line, metres.
const STEP_M: f64 = 9.0;

/// Points from pairs.
pub(super) fn points(pairs: &[(f64, f64)]) -> Vec<DVec2> {
    pairs.iter().map(|&(x, y)| DVec2::new(x, y)).collect()
}

/// A smooth line through points (Catmull and Rom 1974), which all stay on it.
pub(super) fn smooth(pairs: &[(f64, f64)]) -> Vec<DVec2> {
    let p = points(pairs);
    let n = p.len();
    let get = |i: i64| {
        if i < 0 {
            p[0] * 2.0 - p[1]
        } else if i as usize >= n {
            p[n - 1] * 2.0 - p[n - 2]
        } else {
            p[i as usize]
        }
    };
    let mut out = vec![p[0]];
    for i in 0..n - 1 {
        let k = i as i64;
        let (a, b, c, d) = (get(k - 1), get(k), get(k + 1), get(k + 2));
        let steps = (b.distance(c) / STEP_M).ceil().max(1.0) as usize;
        out.extend((1..=steps).map(|j| {
            let t = j as f64 / steps as f64;
            if j == steps {
                return c;
            }
            0.5 * (2.0 * b
                + (c - a) * t
                + (2.0 * a - 5.0 * b + 4.0 * c - d) * (t * t)
                + (3.0 * b - a - 3.0 * c + d) * (t * t * t))
        }));
    }
    out
}

/// A closed smooth line through points: the first is also the last.
pub(super) fn smooth_ring(pairs: &[(f64, f64)]) -> Vec<DVec2> {
    let n = pairs.len();
    let around: Vec<(f64, f64)> = (0..n + 5).map(|k| pairs[(k + n - 2) % n]).collect();
    let line = smooth(&around);
    let from = line.iter().position(|p| *p == DVec2::new(pairs[0].0, pairs[0].1)).unwrap_or(0);
    let length = line[from + 1..].iter().position(|p| *p == line[from]).map_or(line.len() - from - 1, |k| k + 1);
    line[from..=from + length].to_vec()
}

/// The same line moved to its left, metres.
pub(super) fn beside(line: &[DVec2], left: f64) -> Vec<DVec2> {
    let n = line.len();
    let closed = line[0].distance(line[n - 1]) < 1e-6;
    let direction = |i: usize| {
        let (a, b) = if closed {
            (line[(i + n - 2) % (n - 1)], line[(i + 1) % (n - 1)])
        } else {
            (line[i.saturating_sub(1)], line[(i + 1).min(n - 1)])
        };
        (b - a).normalize_or(DVec2::X)
    };
    let mut out: Vec<DVec2> = (0..n).map(|i| line[i] + direction(i).perp() * left).collect();
    if closed {
        out[n - 1] = out[0];
    }
    out
}

/// The same line from its other end.
pub(super) fn turned(line: &[DVec2]) -> Vec<DVec2> {
    line.iter().rev().copied().collect()
}

/// A band around a line as an outline.
pub(super) fn band(line: &[DVec2], half: f64) -> Vec<DVec2> {
    let mut ring = beside(line, -half);
    ring.extend(turned(&beside(line, half)));
    ring
}

/// A rectangle: its middle, its size, and its turn in degrees.
pub(super) fn rect((x, y): (f64, f64), (width, depth): (f64, f64), turn_deg: f64) -> Vec<DVec2> {
    let axis = unit(turn_deg.to_radians());
    let (u, v) = (axis * (width / 2.0), axis.perp() * (depth / 2.0));
    let centre = DVec2::new(x, y);
    vec![centre - u - v, centre + u - v, centre + u + v, centre - u + v]
}

/// Points around a centre, between two angles in degrees; all the way round the last is the first.
pub(super) fn arc(centre: DVec2, radius: f64, from_deg: f64, to_deg: f64) -> Vec<DVec2> {
    let n = ((to_deg - from_deg).abs() / 9.0).ceil().max(2.0) as usize;
    let at = |k: usize| from_deg + (to_deg - from_deg) * k as f64 / n as f64;
    let mut out: Vec<DVec2> = (0..=n).map(|k| centre + unit(at(k).to_radians()) * radius).collect();
    if (to_deg - from_deg - 360.0).abs() < 1e-9 {
        out[n] = out[0];
    }
    out
}

/// Arc length of the place on a chain that is nearest to a point.
pub(super) fn along(line: &[DVec2], p: DVec2) -> f64 {
    let (mut best, mut found, mut s) = (f64::INFINITY, 0.0, 0.0);
    for pair in line.windows(2) {
        let way = pair[1] - pair[0];
        let t = share_along(p, pair[0], pair[1]);
        let d = (pair[0] + way * t).distance(p);
        if d < best {
            (best, found) = (d, s + t * way.length());
        }
        s += way.length();
    }
    found
}

/// The place at an arc length of a chain.
pub(super) fn at(line: &[DVec2], s: f64) -> DVec2 {
    let mut left = s.max(0.0);
    for pair in line.windows(2) {
        let length = pair[0].distance(pair[1]);
        if left <= length {
            return pair[0].lerp(pair[1], left / length.max(1e-12));
        }
        left -= length;
    }
    line[line.len() - 1]
}

/// The parts of a chain between arc lengths.
pub(super) fn split_at(line: &[DVec2], cuts: &[f64]) -> Vec<Vec<DVec2>> {
    let mut parts = Vec::new();
    let mut from = 0.0;
    let length: f64 = line.windows(2).map(|w| w[0].distance(w[1])).sum();
    for &to in cuts.iter().chain([&length]) {
        parts.push(part(line, from, to));
        from = to;
    }
    parts
}

/// The part of a chain between two arc lengths.
pub(super) fn part(line: &[DVec2], from: f64, to: f64) -> Vec<DVec2> {
    let mut out = vec![at(line, from)];
    let mut s = 0.0;
    for pair in line.windows(2) {
        s += pair[0].distance(pair[1]);
        if s > from + 0.5 && s < to - 0.5 {
            out.push(pair[1]);
        }
    }
    out.push(at(line, to));
    out
}

/// Distance from a chain, metres.
pub(super) fn distance(line: &[DVec2], p: DVec2) -> f64 {
    at(line, along(line, p)).distance(p)
}

/// 0 below `from`, 1 above `to`, smooth between.
pub(super) fn rise(from: f64, to: f64, x: f64) -> f64 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A round hill: its height at a distance from its top, of a radius.
pub(super) fn hill(p: DVec2, top: (f64, f64), radius: f64, height: f64) -> f64 {
    height * rise(radius, 0.0, p.distance(DVec2::new(top.0, top.1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_lines_pass_through_their_points() {
        let given = [(0.0, 0.0), (60.0, 20.0), (90.0, 80.0)];
        let line = smooth(&given);
        assert!(points(&given).iter().all(|p| line.contains(p)));
        let ring = smooth_ring(&[(100.0, 0.0), (0.0, 100.0), (-100.0, 0.0), (0.0, -100.0)]);
        assert_eq!(ring[0], ring[ring.len() - 1]);
        let length: f64 = ring.windows(2).map(|w| w[0].distance(w[1])).sum();
        assert!((560.0..660.0).contains(&length), "{length}");
        assert!(beside(&ring, 10.0).iter().all(|p| p.length() < 100.0), "counter-clockwise: left is inside");
    }

    #[test]
    fn chains_are_cut() {
        let line = points(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)]);
        assert!((along(&line, DVec2::new(12.0, 4.0)) - 14.0).abs() < 1e-9);
        let parts = split_at(&line, &[4.0, 16.0]);
        assert_eq!(parts.len(), 3);
        assert_eq!(parts[1], points(&[(4.0, 0.0), (10.0, 0.0), (10.0, 6.0)]));
        assert!((rise(0.0, 10.0, 5.0) - 0.5).abs() < 1e-12 && rise(10.0, 0.0, 0.0) == 1.0);
    }
}
