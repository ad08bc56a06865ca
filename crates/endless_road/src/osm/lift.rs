//! From a line in the plane to one in space: bends are drawn in the plane, where the whole of a straight street is
//! room for them, and take their heights afterwards.

use super::curve::simplified;
use crate::Polyline;
use glam::{DVec2, DVec3};

/// The line may leave the heights given by this much, metres.
const TOLERANCE_M: f64 = 0.02;
/// Distance between places of the profile, metres.
const STEP_M: f64 = 2.0;
/// How far a vertex may lie along the line from where its share of the length puts it, metres.
const SLIP_M: f64 = 30.0;

/// The line `flat` at the heights of the vertices it was drawn through, smooth between them; `flat` begins and ends
/// where they do.
pub(super) fn lifted(flat: &Polyline, vertices: &[DVec3]) -> Polyline {
    let intersections = stations(flat, vertices);
    let (low, high) =
        intersections.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), k| (l.min(k.1), h.max(k.1)));
    if high - low < 1e-9 {
        return Polyline::new(flat.points().iter().map(|p| p.with_z(low)));
    }
    let n = (flat.length() / STEP_M).ceil().max(1.0) as usize;
    let places = (0..=n).map(|k| flat.length() * k as f64 / n as f64);
    let drawn: Vec<DVec3> = places.map(|s| DVec3::new(s, 0.0, height(&intersections, s))).collect();
    let profile: Vec<(f64, f64)> = simplified(&drawn, TOLERANCE_M).iter().map(|p| (p.x, p.z)).collect();
    let mut along: Vec<f64> = (0..flat.points().len()).map(|i| flat.station(i)).collect();
    along.extend(profile.iter().map(|p| p.0));
    along.sort_by(f64::total_cmp);
    // Places of the profile beside points of a bend would make tiny segments.
    along.dedup_by(|b, a| *b - *a < 0.05);
    if let Some(last) = along.last_mut() {
        *last = flat.length();
    }
    Polyline::new(along.into_iter().map(|s| flat.position(s).with_z(linear(&profile, s))))
}

/// Where along the line each vertex is, and its height; in order.
fn stations(flat: &Polyline, vertices: &[DVec3]) -> Vec<(f64, f64)> {
    let steps: Vec<f64> = vertices.windows(2).map(|w| w[0].truncate().distance(w[1].truncate())).collect();
    let scale = flat.length() / steps.iter().sum::<f64>().max(1e-9);
    let mut intersections = vec![(0.0, vertices[0].z)];
    let mut walked = 0.0;
    for (step, vertex) in steps.iter().zip(&vertices[1..]) {
        walked += step * scale;
        let s = nearest(flat, vertex.truncate(), walked);
        if s > intersections[intersections.len() - 1].0 + 1e-3 {
            intersections.push((s, vertex.z));
        }
    }
    let last = intersections.len() - 1;
    let end = (flat.length(), vertices[vertices.len() - 1].z);
    if last > 0 && end.0 - intersections[last].0 < 0.5 {
        intersections[last] = end;
    } else {
        intersections.push(end);
    }
    intersections
}

/// Arc length of the place nearest to a point, among those not far from where it is expected.
fn nearest(flat: &Polyline, p: DVec2, expected: f64) -> f64 {
    let mut best = (f64::INFINITY, expected);
    for (i, pair) in flat.points().windows(2).enumerate() {
        let (from, to) = (flat.station(i), flat.station(i + 1));
        if to < expected - SLIP_M || from > expected + SLIP_M {
            continue;
        }
        let (a, way) = (pair[0].truncate(), (pair[1] - pair[0]).truncate());
        let t = ((p - a).dot(way) / way.length_squared().max(1e-12)).clamp(0.0, 1.0);
        let distance = p.distance_squared(a + way * t);
        if distance < best.0 {
            best = (distance, from + t * (to - from));
        }
    }
    best.1
}

/// Between intersections: a cubic whose slopes are those to the neighbours of both (Catmull and Rom 1974).
fn height(intersections: &[(f64, f64)], s: f64) -> f64 {
    let i = intersections.partition_point(|k| k.0 <= s).clamp(1, intersections.len() - 1);
    let (a, b) = (intersections[i - 1], intersections[i]);
    let slope = |j: usize| {
        let (before, after) = (intersections[j.saturating_sub(1)], intersections[(j + 1).min(intersections.len() - 1)]);
        (after.1 - before.1) / (after.0 - before.0)
    };
    let (span, t) = (b.0 - a.0, ((s - a.0) / (b.0 - a.0)).clamp(0.0, 1.0));
    let (m, n) = (slope(i - 1) * span, slope(i) * span);
    let (t2, t3) = (t * t, t * t * t);
    a.1 * (2.0 * t3 - 3.0 * t2 + 1.0) + m * (t3 - 2.0 * t2 + t) + b.1 * (3.0 * t2 - 2.0 * t3) + n * (t3 - t2)
}

fn linear(profile: &[(f64, f64)], s: f64) -> f64 {
    let i = profile.partition_point(|k| k.0 <= s).clamp(1, profile.len() - 1);
    let (a, b) = (profile[i - 1], profile[i]);
    a.1 + (b.1 - a.1) * ((s - a.0) / (b.0 - a.0)).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::super::curve::rounded;
    use super::*;

    #[test]
    fn a_bend_on_a_slope_is_as_round_as_in_the_plain() {
        let climb = |k: usize| {
            let s = 8.0 * k as f64;
            let at = if s <= 80.0 { DVec2::new(s, 0.0) } else { DVec2::new(80.0, s - 80.0) };
            at.extend(0.05 * s + 0.4 * (s / 30.0) * (s / 30.0))
        };
        let vertices: Vec<DVec3> = (0..=20).map(climb).collect();
        let plain: Vec<DVec3> = vertices.iter().map(|v| v.with_z(0.0)).collect();
        let flat = Polyline::new(rounded(&simplified(&plain, 0.1), 25.0));
        let line = lifted(&flat, &vertices);
        for pair in line.points().windows(3) {
            let turn = (pair[1] - pair[0]).truncate().angle_to((pair[2] - pair[1]).truncate()).abs();
            assert!(turn < 0.04, "{turn}");
        }
        for v in &vertices {
            let (s, off) = line.project(v.truncate());
            assert!(off.abs() > 1.0 || (line.position(s).z - v.z).abs() < 0.05, "{v}");
        }
        assert_eq!(line.points()[0], vertices[0]);
        assert!(line.points()[line.points().len() - 1].distance(vertices[20]) < 1e-9);
    }
}
