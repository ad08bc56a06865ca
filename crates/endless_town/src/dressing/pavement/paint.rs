//! Paint on the road: marks of the map, crossings and stop lines.

use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::pavement::crossing;
use crate::dressing::pavement::surface::{PAINT_M, quad};
use crate::palette::{WHITE_PAINT, YELLOW_PAINT};
use endless_road::{Crossing, Lane, MarkingColor, Polyline, RoadMap, RoadMarking, TrafficControl};
use endless_scene::{Material, MeshBuilder};
use glam::{DVec2, DVec3, Vec2};

/// Longest piece of a painted line, metres.
const STEP_M: f64 = 3.0;
/// Bars of crossings.
const BAR_M: f64 = 0.5;
/// Between a line along the road and a crossing's bars.
pub(crate) const PAINT_APART_M: f64 = 0.3;
/// Depth of stop lines.
const STOP_M: f64 = 0.35;

pub(crate) fn add(mesh: &mut MeshBuilder, map: &RoadMap, pavement: &PavementIndex) {
    for mark in &map.markings {
        add_mark(mesh, mark, &map.network.crossings);
    }
    if map.markings.is_empty() {
        for lane in map.network.lanes.iter().filter(|l| l.junction.is_none()) {
            usual_lines(mesh, lane, map.left_hand);
        }
    }
    for crossing in &map.network.crossings {
        add_crossing(mesh, crossing, pavement);
    }
    for lane in
        map.network.lanes.iter().filter(|l| matches!(l.end_control, TrafficControl::Signal(_) | TrafficControl::Stop))
    {
        if !map.markings.iter().any(|mark| is_stop_line_of(mark, lane)) {
            add_stop_line(mesh, lane);
        }
    }
}

fn add_mark(mesh: &mut MeshBuilder, mark: &RoadMarking, crossings: &[Crossing]) {
    let paint = match mark.color {
        MarkingColor::White => WHITE_PAINT,
        MarkingColor::Yellow => YELLOW_PAINT,
    };
    let mut draw = |from: f64, to: f64| line(mesh, &mark.line, (from, to), 0.0, mark.width_m, paint);
    for (from, to) in beside_crossings(mark, crossings) {
        let Some([dash, gap]) = mark.dash.filter(|[dash, gap]| *dash > 0.05 && dash + gap > 0.1) else {
            draw(from, to);
            continue;
        };
        let mut s = (from / (dash + gap)).floor() * (dash + gap);
        while s < to {
            draw(s.max(from), (s + dash).min(to));
            s += dash + gap;
        }
    }
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

/// Paint along a line, `t` to its left.
fn line(mesh: &mut MeshBuilder, line: &Polyline, (from, to): (f64, f64), t: f64, width: f64, paint: Material) {
    if to - from < 0.02 {
        return;
    }
    let steps = ((to - from) / STEP_M).ceil().max(1.0) as usize;
    let rails: Vec<[DVec3; 2]> = (0..=steps)
        .map(|i| {
            let place = line.at(from + (to - from) * i as f64 / steps as f64);
            let left = crate::geometry::unit(place.heading_rad).perp().extend(0.0);
            let up = DVec3::Z * PAINT_M;
            [place.position + left * (t - width / 2.0) + up, place.position + left * (t + width / 2.0) + up]
        })
        .collect();
    for pair in rails.windows(2) {
        let corners = [pair[0][0], pair[1][0], pair[1][1], pair[0][1]];
        quad(mesh, corners, corners.map(|p| p.truncate().as_vec2()), paint);
    }
}

/// What nearly every road has, for files that say nothing of paint.
fn usual_lines(mesh: &mut MeshBuilder, lane: &Lane, left_hand: bool) {
    let (length, half) = (lane.centerline.length(), lane.width_m / 2.0);
    let inner = if left_hand { -1.0 } else { 1.0 };
    let (inwards, outwards) = if left_hand { (lane.right, lane.left) } else { (lane.left, lane.right) };
    let mut s = 1.0;
    if inwards.is_some() {
        while s < length - 2.0 {
            line(mesh, &lane.centerline, (s, (s + 3.0).min(length)), inner * half, 0.12, WHITE_PAINT);
            s += 9.0;
        }
    }
    if outwards.is_none() && lane.speed_limit_mps > 15.0 {
        line(mesh, &lane.centerline, (0.0, length), -inner * (half - 0.1), 0.12, WHITE_PAINT);
    }
}

/// Bars along the direction of travel, from kerb to kerb.
fn add_crossing(mesh: &mut MeshBuilder, crossing: &Crossing, pavement: &PavementIndex) {
    let [a, b] = crossing.ends;
    let across = (b - a).truncate();
    let length = across.length();
    let Some(way) = across.try_normalize() else { return };
    let along = way.perp() * (crossing.width_m / 2.0);
    let bars = ((length - 0.4) / (2.0 * BAR_M)).floor().max(1.0) as usize;
    let margin = (length - (2 * bars - 1) as f64 * BAR_M) / 2.0;
    for k in 0..bars {
        let t = margin + 2.0 * BAR_M * k as f64;
        let z = a.z + (b.z - a.z) * t / length;
        let place = |t: f64, side: f64| {
            let p = a.truncate() + way * t + along * side;
            let z = pavement.height(p, z + 0.1).unwrap_or(z).max(z - 0.3);
            p.extend(z + PAINT_M + 0.001)
        };
        let corners = [place(t, 1.0), place(t, -1.0), place(t + BAR_M, -1.0), place(t + BAR_M, 1.0)];
        quad(mesh, corners, corners.map(|p| p.truncate().as_vec2()), WHITE_PAINT);
    }
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

fn add_stop_line(mesh: &mut MeshBuilder, lane: &Lane) {
    let length = lane.centerline.length();
    if length < 6.0 {
        return;
    }
    let end = lane.centerline.at(length - 0.3);
    let forward = crate::geometry::unit(end.heading_rad);
    let half = forward.perp() * (lane.width_m / 2.0 - 0.1);
    let lift = DVec3::Z * (PAINT_M + 0.002);
    let at = |back: f64, side: f64| -> DVec3 {
        let p: DVec2 = half * side - forward * back;
        end.position + p.extend(-end.grade * back) + lift
    };
    let corners = [at(STOP_M, -1.0), at(0.0, -1.0), at(0.0, 1.0), at(STOP_M, 1.0)];
    quad(mesh, corners, [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y], WHITE_PAINT);
}
