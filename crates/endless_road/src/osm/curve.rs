//! Curves of roads: bends made round, corners of kerbs, ways through junctions.

use crate::Polyline;
use endless_world::math::f64::{atan2, cos, tan, wrap_angle};
use glam::{DVec2, DVec3};
use std::f64::consts::FRAC_PI_2;

/// Largest change of direction from one point of a bend to the next, radians.
const STEP_RAD: f64 = 0.03;

/// Ways through junctions are not laid tighter than this where there is room, metres.
const TIGHT_M: f64 = 6.0;

/// Angle of a direction, counter-clockwise from east, radians.
pub(super) fn angle(v: DVec2) -> f64 {
    atan2(v.y, v.x)
}

/// A line through points that may all coincide, where something is too small to be drawn.
pub(super) fn line_through(points: Vec<DVec3>) -> Polyline {
    let (first, last) = (points[0], points[points.len() - 1]);
    let distinct = points.iter().any(|p| p.distance(first) > 2e-3);
    if distinct { Polyline::new(points) } else { Polyline::new([first, last + DVec3::X * 0.01]) }
}

/// Drops points that lie within a tolerance of the line through the others (Douglas and Peucker 1973).
pub(super) fn simplified(points: &[DVec3], tolerance_m: f64) -> Vec<DVec3> {
    let mut keep = vec![false; points.len()];
    let mut open = vec![(0, points.len() - 1)];
    keep[0] = true;
    keep[points.len() - 1] = true;
    while let Some((from, to)) = open.pop() {
        let (a, b) = (points[from], points[to]);
        let along = b - a;
        let off = |p: DVec3| {
            let t = ((p - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
            p.distance(a + along * t)
        };
        let worst = (from + 1..to).max_by(|&i, &j| off(points[i]).total_cmp(&off(points[j])));
        if let Some(i) = worst.filter(|&i| off(points[i]) > tolerance_m) {
            keep[i] = true;
            open.extend([(from, i), (i, to)]);
        }
    }
    points.iter().zip(keep).filter(|(_, k)| *k).map(|(p, _)| *p).collect()
}

/// The same chain with its corners rounded, with a radius of at least `radius_m` where there is room.
pub(super) fn rounded(points: &[DVec3], radius_m: f64) -> Vec<DVec3> {
    let n = points.len();
    let mut out = vec![points[0]];
    for i in 1..n - 1 {
        let (before, here, after) = (points[i - 1], points[i], points[i + 1]);
        let (u, v) = ((here - before).truncate(), (after - here).truncate());
        let turn = wrap_angle(angle(v) - angle(u));
        if turn.abs() < 0.5 * STEP_RAD {
            out.push(here);
            continue;
        }
        // Half of each neighbour at most, all of it but a little at the ends.
        let share = |k: usize| if k == 0 || k == n - 1 { 0.9 } else { 0.5 };
        let room = (u.length() * share(i - 1)).min(v.length() * share(i + 1));
        let half = tan(turn.abs().min(2.6) / 2.0);
        let tangent = room.min((radius_m * half).max(0.3 * room.min(12.0)));
        let a = here - (here - before) * (tangent / u.length().max(1e-9));
        let b = here + (after - here) * (tangent / v.length().max(1e-9));
        out.extend(arc(a, here, b, turn.abs()));
    }
    out.push(points[n - 1]);
    out
}

/// The same chain where hairpins are opened until nothing bends tighter than a radius; its ends stay where they are.
pub(super) fn relaxed(points: Vec<DVec3>, radius_m: f64) -> Vec<DVec3> {
    const PIECE_M: f64 = 0.7;
    let line = line_through(points.clone());
    let n = (line.length() / PIECE_M).ceil().clamp(4.0, 20_000.0) as usize;
    let mut chain: Vec<DVec3> = (0..=n).map(|k| line.at(line.length() * k as f64 / n as f64).position).collect();
    let mut moved = false;
    for _ in 0..400 {
        let sharp = |i: usize| {
            let (u, v) = ((chain[i] - chain[i - 2]).truncate(), (chain[i + 2] - chain[i]).truncate());
            wrap_angle(angle(v) - angle(u)).abs() * radius_m > 0.5 * (u.length() + v.length())
        };
        let mut loose = vec![false; n + 1];
        for i in (2..n.saturating_sub(1)).filter(|&i| sharp(i)) {
            loose[i.saturating_sub(8)..=(i + 8).min(n)].fill(true);
        }
        if !loose.contains(&true) {
            break;
        }
        moved = true;
        let before = chain.clone();
        for i in (1..n).filter(|&i| loose[i]) {
            chain[i] = before[i].lerp(before[i - 1].midpoint(before[i + 1]), 0.9);
        }
    }
    if moved { rounded(&chain, radius_m) } else { points }
}

/// From `a` to `b` with the tangents towards `corner`: an arc where both are equally far, a conic otherwise.
fn arc(a: DVec3, corner: DVec3, b: DVec3, turn: f64) -> Vec<DVec3> {
    let steps = (turn / STEP_RAD).ceil().clamp(2.0, 100.0) as usize;
    let weight = cos(turn.min(2.8) / 2.0).max(0.15);
    (0..=steps).map(|k| conic(a, corner, b, weight, k as f64 / steps as f64)).collect()
}

/// A rational quadratic curve: with weight cos(half the turn) and equal tangents a circle.
fn conic(a: DVec3, corner: DVec3, b: DVec3, weight: f64, t: f64) -> DVec3 {
    let s = 1.0 - t;
    let (wa, wc, wb) = (s * s, 2.0 * s * t * weight, t * t);
    (a * wa + corner * wc + b * wb) / (wa + wc + wb)
}

/// Where the rays from `p` along `u` and from `q` along `v` meet: distances along each.
pub(super) fn rays_meet(p: DVec2, u: DVec2, q: DVec2, v: DVec2) -> Option<(f64, f64)> {
    let cross = u.perp_dot(v);
    if cross.abs() < 0.05 {
        return None;
    }
    let d = q - p;
    Some((d.perp_dot(v) / cross, d.perp_dot(u) / cross))
}

/// A kerb's radius at a corner where the way turns by an angle, for a usual one of the road class. Where it turns by less than
/// a right angle, the bend begins as far before the corner as there: on a road that goes nearly straight on it is wide.
pub(super) fn kerb_radius(usual_m: f64, turn: f64) -> f64 {
    1.3 * usual_m / tan(turn.abs().clamp(1e-3, FRAC_PI_2) / 2.0)
}

/// A kerb around a corner from `p`, arriving along `u`, to `q`, leaving against `v` (both point into the junction);
/// always `n + 3` points, whatever its form.
pub(super) fn corner(p: DVec2, u: DVec2, q: DVec2, v: DVec2, radius_m: f64, n: usize) -> Vec<DVec2> {
    let mut out = vec![p];
    let gap = p.distance(q);
    let meet = rays_meet(p, u, q, v).filter(|&(a, b)| a > 0.05 && b > 0.05 && a.max(b) < 4.0 * gap + 5.0);
    if let Some((a, b)) = meet {
        let corner = p + u * a;
        let turn = wrap_angle(angle(-v) - angle(u)).abs();
        let tangent = a.min(b).min(kerb_radius(radius_m, turn) * tan(turn.min(2.8) / 2.0));
        let (from, to) = (corner - u * tangent, corner - v * tangent);
        let weight = cos(turn.min(2.8) / 2.0).max(0.15);
        let at = |t| conic(from.extend(0.0), corner.extend(0.0), to.extend(0.0), weight, t).truncate();
        out.extend((0..=n).map(|k| at(k as f64 / n as f64)));
    } else if u.dot(v) > 0.5 || gap < 2.0 {
        // Side by side: straight across.
        out.extend((0..=n).map(|k| p.lerp(q, (k as f64 + 0.5) / (n + 1) as f64)));
    } else {
        let reach = gap / 3.0;
        let (c, d) = (p + u * reach, q + v * reach);
        out.extend((0..=n).map(|k| cubic(p, c, d, q, (k as f64 + 0.5) / (n + 1) as f64)));
    }
    out.push(q);
    out
}

fn cubic(a: DVec2, b: DVec2, c: DVec2, d: DVec2, t: f64) -> DVec2 {
    let s = 1.0 - t;
    a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t)
}

/// A way through a junction from `p` in direction `u` to `q` in direction `v`, points closer than a metre or so. It bends
/// no wider than `widest_m`, where it can bend in one arc.
pub(super) fn way_through(p: DVec2, u: DVec2, q: DVec2, v: DVec2, widest_m: f64) -> Vec<DVec2> {
    let gap = p.distance(q);
    let turn = wrap_angle(angle(v) - angle(u)).abs();
    let steps = ((gap / 0.8).max(turn / STEP_RAD)).ceil().clamp(4.0, 110.0) as usize;
    if let Some((a, b)) = rays_meet(p, u, q, -v)
        && a > 0.3
        && b > 0.3
        && (0.12..2.5).contains(&turn)
        && (a.min(b) > 0.6 * a.max(b) || a.min(b) > TIGHT_M * tan(turn / 2.0))
    {
        let corner = p + u * a;
        let tangent = a.min(b).min(widest_m * tan(turn / 2.0));
        let (from, to) = (corner - u * tangent, corner + v * tangent);
        let weight = cos(turn / 2.0).max(0.15);
        let mut out = straight(p, from);
        let at = |t| conic(from.extend(0.0), corner.extend(0.0), to.extend(0.0), weight, t).truncate();
        out.extend((0..steps).map(|k| at(k as f64 / steps as f64)));
        let mut rest = straight(to, q);
        if rest.is_empty() {
            rest.push(to);
        }
        out.extend(rest);
        out.push(q);
        return eased(out);
    }
    let (near, far) = if turn > 2.0 { (gap.max(3.0) * 0.75, gap.max(3.0) * 0.75) } else { reaches(p, u, q, v) };
    let (c, d) = (p + u * near, q - v * far);
    // Points closer where it begins and ends, so that chords point as the curve does.
    eased((0..=steps).map(|k| cubic(p, c, d, q, k as f64 / steps as f64)).collect())
}

/// How far a way's handles reach at its ends: neither winding nor tighter than need be.
fn reaches(p: DVec2, u: DVec2, q: DVec2, v: DVec2) -> (f64, f64) {
    const SHARES: [f64; 6] = [0.4, 0.3, 0.2, 0.5, 0.12, 0.65];
    let gap = p.distance(q);
    let turn = wrap_angle(angle(v) - angle(u)).abs();
    let cost = |near: f64, far: f64| {
        let (c, d) = (p + u * near, q - v * far);
        let points: Vec<DVec2> = (0..=24).map(|k| cubic(p, c, d, q, f64::from(k) / 24.0)).collect();
        let (mut winding, mut tightest) = (-turn, TIGHT_M);
        for w in points.windows(3) {
            let (a, b) = (w[1] - w[0], w[2] - w[1]);
            let bend = wrap_angle(angle(b) - angle(a)).abs();
            winding += bend;
            tightest = tightest.min(0.5 * (a.length() + b.length()) / bend.max(1e-9));
        }
        winding.max(0.0) + 0.5 * (TIGHT_M / tightest.max(0.1) - 1.0)
    };
    // A symmetric way is taken unless another is clearly better.
    let mut best = (cost(0.4 * gap, 0.4 * gap) - 0.1, 0.4 * gap, 0.4 * gap);
    for near in SHARES {
        for far in SHARES {
            let found = cost(near * gap, far * gap);
            if found < best.0 {
                best = (found, near * gap, far * gap);
            }
        }
    }
    (best.1, best.2)
}

fn straight(a: DVec2, b: DVec2) -> Vec<DVec2> {
    let n = (a.distance(b) / 2.0).floor() as usize;
    if a.distance(b) < 0.05 {
        return Vec::new();
    }
    (0..=n).map(|k| a.lerp(b, k as f64 / (n + 1) as f64)).collect()
}

/// Drops points that coincide.
fn eased(points: Vec<DVec2>) -> Vec<DVec2> {
    let mut out: Vec<DVec2> = Vec::with_capacity(points.len());
    let last = points[points.len() - 1];
    for p in points {
        if out.last().is_none_or(|l| l.distance(p) > 0.02) {
            out.push(p);
        }
    }
    if out.len() > 1 && out[out.len() - 1] != last {
        out.pop();
        out.push(last);
    }
    out
}

/// A border that never runs backwards: where an offset line folds inside a tight bend, it waits.
pub(super) fn unfolded(border: &[DVec3], along: &[DVec3]) -> Vec<DVec3> {
    let mut out: Vec<DVec3> = Vec::with_capacity(border.len());
    for (i, &p) in border.iter().enumerate() {
        let Some(&last) = out.last() else {
            out.push(p);
            continue;
        };
        let forward = (along[i] - along[i - 1]).truncate();
        let folds = (p - last).truncate().dot(forward) < 0.0;
        out.push(if folds { last } else { p });
    }
    out
}

/// Signed area, positive if counter-clockwise.
pub(super) fn area(outline: &[DVec2]) -> f64 {
    (0..outline.len()).map(|k| outline[k].perp_dot(outline[(k + 1) % outline.len()])).sum::<f64>() / 2.0
}

/// Whether two segments cross, ends excluded.
pub(super) fn segments_cross(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> Option<f64> {
    let (u, v) = (b - a, d - c);
    let cross = u.perp_dot(v);
    if cross.abs() < 1e-12 {
        return None;
    }
    let t = (c - a).perp_dot(v) / cross;
    let s = (c - a).perp_dot(u) / cross;
    ((1e-9..1.0 - 1e-9).contains(&t) && (1e-9..1.0 - 1e-9).contains(&s)).then_some(t)
}

/// Whether a closed outline crosses itself.
pub(super) fn crosses_itself(outline: &[DVec2]) -> bool {
    let n = outline.len();
    let edge = |i: usize| (outline[i], outline[(i + 1) % n]);
    (0..n).any(|i| {
        let (a, b) = edge(i);
        (i + 2..n).any(|j| {
            let (c, d) = edge(j);
            (j + 1) % n != i && segments_cross(a, b, c, d).is_some()
        })
    })
}

/// The convex hull (Andrew 1979), counter-clockwise.
pub(super) fn hull(points: &[DVec2]) -> Vec<DVec2> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let half = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for p in points {
            while chain.len() >= 2
                && (chain[chain.len() - 1] - chain[chain.len() - 2]).perp_dot(p - chain[chain.len() - 1]) <= 0.0
            {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut lower = half(&mut sorted.iter().copied());
    lower.extend(half(&mut sorted.iter().rev().copied()));
    lower
}
