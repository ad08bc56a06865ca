//! Paint on the road: marks of the map, crossings and stop lines.

use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::pavement::crossing;
use crate::dressing::pavement::surface::{PAINT_M, quad};
use crate::palette::{WHITE_PAINT, YELLOW_PAINT};
use endless_road::{Crossing, Lane, MarkingColor, Polyline, RoadMap, RoadMarking, TrafficControl};
use endless_scene::{Material, MeshBuilder};
use glam::{DVec2, DVec3, Vec2};

/// No shorter piece of a line is painted, metres.
const SHORTEST_M: f64 = 0.02;
/// Longest piece of a painted line, metres.
const STEP_M: f64 = 3.0;
/// Bars of crossings.
const BAR_M: f64 = 0.5;
/// Between a line along the road and a crossing's bars.
pub(crate) const PAINT_APART_M: f64 = 0.3;
/// Depth of stop lines.
pub(crate) const STOP_M: f64 = 0.35;

pub(crate) fn add(mesh: &mut MeshBuilder, map: &RoadMap, pavement: &PavementIndex) {
    for mark in &map.markings {
        add_mark(mesh, mark, &map.network.crossings);
    }
    if map.markings.is_empty() {
        for lane in map.network.lanes.iter().filter(|l| l.junction.is_none()) {
            for usual in usual_lines(lane, map.left_hand) {
                for piece in usual.pieces {
                    line(mesh, &lane.centerline, piece, (usual.t, USUAL_M), WHITE_PAINT, PAINT_M);
                }
            }
        }
    }
    for crossing in &map.network.crossings {
        add_crossing(mesh, crossing, pavement);
    }
    for (_, corners) in added_stop_lines(map) {
        quad(mesh, corners, [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y], WHITE_PAINT);
    }
}

/// The stop lines of lanes for which the map has none: from back right to front right, front left, back left.
pub(crate) fn added_stop_lines(map: &RoadMap) -> impl Iterator<Item = (&Lane, [DVec3; 4])> {
    let stops = |l: &&Lane| matches!(l.end_control, TrafficControl::Signal(_) | TrafficControl::Stop);
    let lanes = map.network.lanes.iter().filter(stops);
    lanes
        .filter(|lane| !map.markings.iter().any(|mark| is_stop_line_of(mark, lane)))
        .filter_map(|lane| Some((lane, stop_line(lane)?)))
}

fn add_mark(mesh: &mut MeshBuilder, mark: &RoadMarking, crossings: &[Crossing]) {
    let paint = match mark.color {
        MarkingColor::White => WHITE_PAINT,
        MarkingColor::Yellow => YELLOW_PAINT,
    };
    for piece in painted(mark, crossings) {
        line(mesh, &mark.line, piece, (0.0, mark.width_m), paint, PAINT_M);
    }
}

/// Where a mark has paint: its unbroken pieces, from where to where along its line, metres.
pub(crate) fn painted(mark: &RoadMarking, crossings: &[Crossing]) -> Vec<(f64, f64)> {
    let mut pieces = Vec::new();
    for (from, to) in beside_crossings(mark, crossings) {
        let Some([dash, gap]) = mark.dash.filter(|[dash, gap]| *dash > 0.05 && dash + gap > 0.1) else {
            pieces.push((from, to));
            continue;
        };
        let mut s = (from / (dash + gap)).floor() * (dash + gap);
        while s < to {
            pieces.push((s.max(from), (s + dash).min(to)));
            s += dash + gap;
        }
    }
    pieces.retain(|(from, to)| to - from >= SHORTEST_M);
    pieces
}

/// The parts of a mark that lie on no crossing: where people walk, lines along the road leave off. Broad marks are
/// crossings and stop lines themselves, and stay whole.
fn beside_crossings(mark: &RoadMarking, crossings: &[Crossing]) -> Vec<(f64, f64)> {
    const BROAD_M: f64 = 0.25;
    const STEP_M: f64 = 0.2;
    let length = mark.line.length();
    let points = || mark.line.points().iter().map(|p| p.truncate());
    let low = points().fold(DVec2::INFINITY, DVec2::min);
    let high = points().fold(DVec2::NEG_INFINITY, DVec2::max);
    let near: Vec<_> = crossings.iter().filter(|crossing| crossing::reaches(crossing, low, high)).collect();
    if near.is_empty() || mark.width_m >= BROAD_M {
        return vec![(0.0, length)];
    }
    let crossed = |s: f64| {
        let p = mark.line.at(s).position;
        near.iter().any(|crossing| crossing::holds(crossing, p, PAINT_APART_M))
    };
    let steps = (length / STEP_M).ceil().clamp(1.0, 50_000.0) as usize;
    let at = |i: usize| length * i as f64 / steps as f64;
    let mut parts: Vec<(f64, f64)> = Vec::new();
    for i in (0..steps).filter(|&i| !crossed((at(i) + at(i + 1)) / 2.0)) {
        match parts.last_mut() {
            Some((_, to)) if *to >= at(i) => *to = at(i + 1),
            _ => parts.push((at(i), at(i + 1))),
        }
    }
    parts
}

/// The ends of the straight pieces in which a line is painted, metres along it.
fn stations((from, to): (f64, f64)) -> impl Iterator<Item = f64> {
    let steps = ((to - from) / STEP_M).ceil().max(1.0) as usize;
    (0..=steps).map(move |i| from + (to - from) * i as f64 / steps as f64)
}

/// The middle of the paint along a piece of a line, `t` to its left.
pub(crate) fn middle(line: &Polyline, piece: (f64, f64), t: f64) -> Vec<DVec3> {
    let at = |s| {
        let place = line.at(s);
        let left = crate::geometry::unit(place.heading_rad).perp().extend(0.0);
        place.position + left * t + DVec3::Z * PAINT_M
    };
    stations(piece).map(at).collect()
}

/// Paint along a piece of a line, `t` to its left, of a width, so high above it.
pub(crate) fn line(
    mesh: &mut MeshBuilder,
    line: &Polyline,
    (from, to): (f64, f64),
    (t, width): (f64, f64),
    paint: Material,
    up: f64,
) {
    if to - from < SHORTEST_M {
        return;
    }
    let rails: Vec<[DVec3; 2]> = stations((from, to))
        .map(|s| {
            let place = line.at(s);
            let left = crate::geometry::unit(place.heading_rad).perp().extend(0.0);
            let up = DVec3::Z * up;
            [place.position + left * (t - width / 2.0) + up, place.position + left * (t + width / 2.0) + up]
        })
        .collect();
    for pair in rails.windows(2) {
        let corners = [pair[0][0], pair[1][0], pair[1][1], pair[0][1]];
        quad(mesh, corners, corners.map(|p| p.truncate().as_vec2()), paint);
    }
}

/// A line that a map without paint gets.
pub(crate) struct UsualLine {
    /// To the left of the lane's centre line, metres.
    pub(crate) t: f64,
    /// Its pieces along the centre line, metres.
    pub(crate) pieces: Vec<(f64, f64)>,
    pub(crate) broken: bool,
}

pub(crate) const USUAL_M: f64 = 0.12;

/// What nearly every road has, for files that say nothing of paint.
pub(crate) fn usual_lines(lane: &Lane, left_hand: bool) -> Vec<UsualLine> {
    let (length, half) = (lane.centerline.length(), lane.width_m / 2.0);
    let inner = if left_hand { -1.0 } else { 1.0 };
    let (inwards, outwards) = if left_hand { (lane.right, lane.left) } else { (lane.left, lane.right) };
    let mut lines = Vec::new();
    if inwards.is_some() {
        let mut pieces = Vec::new();
        let mut s = 1.0;
        while s < length - 2.0 {
            pieces.push((s, (s + 3.0).min(length)));
            s += 9.0;
        }
        lines.push(UsualLine { t: inner * half, pieces, broken: true });
    }
    if outwards.is_none() && lane.speed_limit_mps > 15.0 {
        lines.push(UsualLine { t: -inner * (half - 0.1), pieces: vec![(0.0, length)], broken: false });
    }
    lines
}

fn add_crossing(mesh: &mut MeshBuilder, crossing: &Crossing, pavement: &PavementIndex) {
    for corners in bars(crossing, pavement) {
        quad(mesh, corners, corners.map(|p| p.truncate().as_vec2()), WHITE_PAINT);
    }
}

/// The bars of a crossing along the direction of travel, from kerb to kerb: corners at its one side, at its other, and back
/// half a metre further across.
pub(crate) fn bars(crossing: &Crossing, pavement: &PavementIndex) -> Vec<[DVec3; 4]> {
    let [a, b] = crossing.ends;
    let across = (b - a).truncate();
    let length = across.length();
    let Some(way) = across.try_normalize() else { return Vec::new() };
    let along = way.perp() * (crossing.width_m / 2.0);
    let bars = ((length - 0.4) / (2.0 * BAR_M)).floor().max(1.0) as usize;
    let margin = (length - (2 * bars - 1) as f64 * BAR_M) / 2.0;
    let bar = |k: usize| {
        let t = margin + 2.0 * BAR_M * k as f64;
        let z = a.z + (b.z - a.z) * t / length;
        let place = |t: f64, side: f64| {
            let p = a.truncate() + way * t + along * side;
            let z = pavement.height(p, z + 0.1).unwrap_or(z).max(z - 0.3);
            p.extend(z + PAINT_M + 0.001)
        };
        [place(t, 1.0), place(t, -1.0), place(t + BAR_M, -1.0), place(t + BAR_M, 1.0)]
    };
    (0..bars).map(bar).collect()
}

/// Whether a mark lies across a lane near its end.
fn is_stop_line_of(mark: &RoadMarking, lane: &Lane) -> bool {
    let end = lane.centerline.at(lane.centerline.length());
    let points = mark.line.points();
    let near = points.iter().any(|p| p.distance(end.position) < 14.0);
    if !near || mark.line.length() > 40.0 {
        return false;
    }
    let (s, t) = mark.line.project(end.position.truncate());
    let across =
        crate::geometry::unit(mark.line.at(s).heading_rad).dot(crate::geometry::unit(end.heading_rad)).abs() < 0.5;
    across && t.abs() < 6.0 && mark.width_m > 0.18
}

fn stop_line(lane: &Lane) -> Option<[DVec3; 4]> {
    let length = lane.centerline.length();
    if length < 6.0 {
        return None;
    }
    let end = lane.centerline.at(length - 0.3);
    let forward = crate::geometry::unit(end.heading_rad);
    let half = forward.perp() * (lane.width_m / 2.0 - 0.1);
    let lift = DVec3::Z * (PAINT_M + 0.002);
    let at = |back: f64, side: f64| -> DVec3 {
        let p: DVec2 = half * side - forward * back;
        end.position + p.extend(-end.grade * back) + lift
    };
    Some([at(STOP_M, -1.0), at(0.0, -1.0), at(0.0, 1.0), at(STOP_M, 1.0)])
}
