//! Surfaces of intersections: connectors, corners of sidewalks, loops at dead ends.

use super::connector::{is_back, loop_radius};
use super::crossing::has_walk;
use super::curve::{area, corner, crosses_itself, hull, segments_cross, unfolded};
use super::graph::StreetSegmentEnd;
use super::movement::Movement;
use super::plan::StreetPlan;
use super::section::KERB_M;
use super::surface::{KERB_HEIGHT_M, STUB_M};
use crate::{Lane, LaneSurface, LaneType, RoadMap};
use endless_world::math::f64::sin_cos;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// Points on a corner's curve.
const CORNER_POINTS: usize = 10;

/// Strips of the lanes through a junction.
pub(super) fn connectors(plan: &StreetPlan, lanes: &[&Lane], movements: &[Movement], map: &mut RoadMap) {
    for (lane, movement) in lanes.iter().zip(movements) {
        let half = 0.5 * lane.width_m;
        let line = &lane.centerline;
        // Between the cuts only: the streets' own strips reach that far.
        let length = line.length();
        let before = plan.stop(movement.from) - plan.cut(movement.from);
        let after = plan.stop(movement.to) - plan.cut(movement.to);
        let (from, to) = (before.max(0.0), (length - after).max(before + 0.1).min(length));
        let n = ((to - from) / 1.0).ceil().max(2.0) as usize;
        let (mut left, mut right, mut along) = (Vec::new(), Vec::new(), Vec::new());
        for k in 0..=n {
            let at = line.at(from + (to - from) * k as f64 / n as f64);
            let (sin, cos) = sin_cos(at.heading_rad);
            let out = DVec3::new(-sin, cos, 0.0) * half;
            left.push(at.position + out);
            right.push(at.position - out);
            along.push(at.position);
        }
        let bridge = plan
            .street(movement.from)
            .level(if movement.from.end == 0 { 0.0 } else { plan.street(movement.from).length() })
            .bridge
            && plan
                .street(movement.to)
                .level(if movement.to.end == 0 { 0.0 } else { plan.street(movement.to).length() })
                .bridge;
        let (left, right) = (unfolded(&left, &along), unfolded(&right, &along));
        let unpaved = plan.street(movement.from).section.unpaved && plan.street(movement.to).section.unpaved;
        map.lane_surfaces.push(LaneSurface {
            kind: LaneType::Driving,
            left,
            right,
            in_junction: true,
            unpaved,
            bridge,
        });
    }
}

/// The kerb between an arm and the next one, counter-clockwise, and a line at some distance behind it.
pub(super) fn corner_line(
    plan: &StreetPlan,
    a: StreetSegmentEnd,
    b: StreetSegmentEnd,
    behind_a: f64,
    behind_b: f64,
) -> Vec<DVec3> {
    let (sa, sb) = (plan.arm_section(a), plan.arm_section(b));
    let (cut_a, cut_b) = (plan.cut(a), plan.cut(b));
    let p = plan.arm_point(a, cut_a, sa.kerbs[0] + behind_a);
    let q = plan.arm_point(b, cut_b, sb.kerbs[1] - behind_b);
    let (u, v) = (-plan.arm_direction(a, cut_a), -plan.arm_direction(b, cut_b));
    let radius =
        (plan.street(a).class.corner_m().min(plan.street(b).class.corner_m()) - 0.7 * behind_a.min(behind_b)).max(0.4);
    let flat = corner(p.truncate(), u, q.truncate(), v, radius, CORNER_POINTS);
    let n = flat.len() - 1;
    flat.into_iter().enumerate().map(|(k, c)| c.extend(p.z + (q.z - p.z) * k as f64 / n as f64)).collect()
}

/// The asphalt of an intersection and the sidewalks around its corners.
pub(super) fn intersection(
    plan: &StreetPlan,
    intersection: usize,
    movements: &[Movement],
    lanes: &[&Lane],
    map: &mut RoadMap,
) {
    let arms = &plan.intersections[intersection].arms;
    if arms.len() == 1 {
        dead_end(plan, arms[0], movements, map);
        return;
    }
    if plan.intersections[intersection].turnaround {
        loop_area(plan, arms, lanes, map);
        return;
    }
    let mut outline: Vec<DVec3> = Vec::new();
    for (i, &arm) in arms.iter().enumerate() {
        let next = arms[(i + 1) % arms.len()];
        let section = plan.arm_section(arm);
        outline.push(plan.arm_point(arm, plan.cut(arm), section.kerbs[1]));
        outline.extend(corner_line(plan, arm, next, 0.0, 0.0).into_iter().take(CORNER_POINTS + 2));
    }
    let flat: Vec<DVec2> = outline.iter().map(|p| p.truncate()).collect();
    if area(&flat) <= 0.5 || crosses_itself(&flat) {
        // Roads that meet at odd angles: whatever covers them all.
        let z = outline.iter().map(|p| p.z).sum::<f64>() / outline.len() as f64;
        outline = hull(&flat).into_iter().map(|p| p.extend(z)).collect();
    }
    if outline.len() >= 3 {
        map.junction_areas.push(outline);
    }
    for (i, &arm) in arms.iter().enumerate() {
        let next = arms[(i + 1) % arms.len()];
        corner_strip(plan, arm, next, lanes, map);
    }
}

/// Width of what people walk on along one side of an arm at the corner; `None` if nobody does.
pub(super) fn walk_width(plan: &StreetPlan, arm: StreetSegmentEnd, left: bool) -> Option<f64> {
    let section = plan.arm_section(arm);
    if has_walk(plan, arm, left) {
        return Some(section.sidewalks[usize::from(!left)]);
    }
    plan.street(arm).crossings.iter().any(|c| c.end == Some(arm.end)).then_some(STUB_M)
}

fn corner_strip(plan: &StreetPlan, a: StreetSegmentEnd, b: StreetSegmentEnd, lanes: &[&Lane], map: &mut RoadMap) {
    let (Some(wa), Some(wb)) = (walk_width(plan, a, true), walk_width(plan, b, false)) else { return };
    let raised = |line: Vec<DVec3>| -> Vec<DVec3> { line.into_iter().map(|p| p + DVec3::Z * KERB_HEIGHT_M).collect() };
    let face = raised(corner_line(plan, a, b, 0.0, 0.0));
    let stone = raised(corner_line(plan, a, b, KERB_M, KERB_M));
    let back = raised(corner_line(plan, a, b, wa, wb));
    // Between carriageways whose ends overlap there is no corner: vehicles drive there.
    if lanes.iter().any(|lane| lines_cross(lane.centerline.points(), &stone)) {
        return;
    }
    let unpaved = false;
    // Counter-clockwise around the junction the sidewalk lies to the right of its kerb.
    let mut add = |kind: LaneType, left: &[DVec3], right: &[DVec3]| {
        let (left, right) = (unfolded(left, left), unfolded(right, left));
        map.lane_surfaces.push(LaneSurface { kind, left, right, in_junction: true, unpaved, bridge: false });
    };
    add(LaneType::Curb, &face, &stone);
    add(LaneType::Sidewalk, &stone, &back);
}

fn lines_cross(a: &[DVec3], b: &[DVec3]) -> bool {
    a.windows(2).any(|p| {
        let [p, q] = [p[0].truncate(), p[1].truncate()];
        b.windows(2).any(|r| segments_cross(p, q, r[0].truncate(), r[1].truncate()).is_some())
    })
}

/// The asphalt of a loop between two carriageways.
fn loop_area(plan: &StreetPlan, arms: &[StreetSegmentEnd], lanes: &[&Lane], map: &mut RoadMap) {
    let mut points: Vec<DVec2> = Vec::new();
    for &arm in arms {
        let section = plan.arm_section(arm);
        points.extend(section.kerbs.map(|t| plan.arm_point(arm, plan.cut(arm), t).truncate()));
        let (u, cut) = (plan.arm_direction(arm, 0.0), plan.cut(arm));
        let past = |p: DVec2| (p - plan.arm_point(arm, cut, 0.0).truncate()).dot(u) < 0.0;
        for lane in lanes {
            for pair in lane.centerline.points().windows(2) {
                let out = (pair[1] - pair[0]).truncate().normalize_or_zero().perp() * (0.5 * lane.width_m + 0.3);
                let p = pair[0].truncate();
                points.extend([p + out, p - out].into_iter().filter(|&p| past(p)));
            }
        }
    }
    let z = plan.arm_point(arms[0], plan.cut(arms[0]), 0.0).z;
    map.junction_areas.push(hull(&points).into_iter().map(|p| p.extend(z)).collect());
}

fn dead_end(plan: &StreetPlan, arm: StreetSegmentEnd, movements: &[Movement], map: &mut RoadMap) {
    if !movements.iter().any(is_back) {
        return;
    }
    let cut = plan.cut(arm);
    let middle = plan.arm_point(arm, (cut - 1.45 * loop_radius(cut)).max(0.0), 0.0);
    let radius = loop_radius(cut) + 1.7;
    let section = plan.arm_section(arm);
    let mut points: Vec<DVec2> = (0..36)
        .map(|k| {
            let (sin, cos) = sin_cos(TAU * f64::from(k) / 36.0);
            middle.truncate() + DVec2::new(cos, sin) * radius
        })
        .collect();
    points.extend(section.kerbs.map(|t| plan.arm_point(arm, cut, t).truncate()));
    map.junction_areas.push(hull(&points).into_iter().map(|p| p.extend(middle.z)).collect());
}
