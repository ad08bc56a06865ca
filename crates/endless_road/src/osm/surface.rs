//! What lies on the ground: bands of streets, sidewalks, the asphalt of junctions and the corners around them.

use super::connector::{is_back, loop_radius};
use super::crossing::has_walk;
use super::curve::{area, corner, crosses_itself, hull, line_through, segments_cross, unfolded};
use super::graph::StreetSegmentEnd;
use super::import_context::ImportContext;
use super::lane::inside;
use super::movement::Movement;
use super::near::SegmentIndex;
use super::plan::{Street, StreetPlan};
use super::section::{KERB_M, LaneUse};
use super::street_segment::StreetSegment;
use crate::{Lane, LaneSurface, LaneType, RoadMap};
use endless_world::math::f64::sin_cos;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// Height of sidewalks above the road, metres.
pub(super) const KERB_HEIGHT_M: f64 = 0.13;
const STEP_M: f64 = 4.0;
/// Points on a corner's curve.
const CORNER_POINTS: usize = 10;
/// Width of the path around a corner where no sidewalk arrives, metres.
pub(super) const STUB_M: f64 = 1.6;

/// Adds the strips of all streets.
pub(super) fn streets(plan: &StreetPlan, map: &mut RoadMap) {
    let hidden = inside(plan);
    for (street, hidden) in plan.streets.iter().zip(hidden) {
        if !hidden {
            street_strips(street, map);
        }
    }
}

fn street_strips(street: &Street, map: &mut RoadMap) {
    let (from, to) = (street.cuts[0], street.length() - street.cuts[1]);
    let stations = street.stations(from, to, STEP_M);
    let section = &street.section;
    median(street, &stations, map);
    let mut add = lane_surfaces(street, &stations, map);
    for (i, band) in section.bands.iter().enumerate() {
        let (kind, reversed) = match band.what {
            LaneUse::Lane { forward, .. } => (LaneType::Driving, !forward),
            LaneUse::Bike => (LaneType::Biking, false),
            LaneUse::Parking => (LaneType::Parking, false),
            LaneUse::Shoulder => (LaneType::Shoulder, false),
        };
        add(kind, section.edges(i), 0.0, reversed);
    }
    for side in 0..2 {
        if section.sidewalks[side] <= 0.0 {
            continue;
        }
        let kerb = section.kerbs[side];
        let sign = if side == 0 { 1.0 } else { -1.0 };
        let (stone, back) = (kerb + sign * KERB_M, section.back(side));
        let pair = |a: f64, b: f64| if side == 0 { [b, a] } else { [a, b] };
        add(LaneType::Curb, pair(kerb, stone), KERB_HEIGHT_M, side == 0);
        add(LaneType::Sidewalk, pair(stone, back), KERB_HEIGHT_M, side == 0);
    }
}

/// What adds strips along a street: kind, left and right edge, height above the road, and whether they run against it.
fn lane_surfaces<'a>(
    street: &'a Street,
    stations: &'a [f64],
    map: &'a mut RoadMap,
) -> impl FnMut(LaneType, [f64; 2], f64, bool) + 'a {
    move |kind, edges, height, reversed| {
        // One strip a level, so that bridges are told from the ground.
        let mut start = 0;
        while start + 1 < stations.len() {
            let bridge = street.level(0.5 * (stations[start] + stations[start + 1])).bridge;
            let mut end = start + 1;
            while end + 1 < stations.len() && street.level(0.5 * (stations[end] + stations[end + 1])).bridge == bridge {
                end += 1;
            }
            let along: Vec<DVec3> = stations[start..=end].iter().map(|&s| street.point(s, 0.0)).collect();
            let line = |t: f64| -> Vec<DVec3> {
                let raw: Vec<DVec3> =
                    stations[start..=end].iter().map(|&s| street.point(s, t) + DVec3::Z * height).collect();
                unfolded(&raw, &along)
            };
            let (mut left, mut right) = (line(edges[0]), line(edges[1]));
            if reversed {
                left.reverse();
                right.reverse();
                std::mem::swap(&mut left, &mut right);
            }
            map.lane_surfaces.push(LaneSurface {
                kind,
                left,
                right,
                in_junction: false,
                unpaved: street.section.unpaved,
                bridge,
            });
            start = end;
        }
    }
}

/// The half of the median that lies beside this carriageway.
fn median(street: &Street, stations: &[f64], map: &mut RoadMap) {
    let kerb = street.section.kerbs[0];
    let wide = |s: f64| street.half_median(s) > 0.3;
    let mut start = 0;
    while start < stations.len() {
        let end = (start..stations.len()).find(|&k| !wide(stations[k])).unwrap_or(stations.len());
        if end - start >= 2 {
            let part = &stations[start..end];
            let along: Vec<DVec3> = part.iter().map(|&s| street.point(s, 0.0)).collect();
            let line = |width: &dyn Fn(f64) -> f64| -> Vec<DVec3> {
                let raw: Vec<DVec3> =
                    part.iter().map(|&s| street.point(s, kerb + width(s)) + DVec3::Z * KERB_HEIGHT_M).collect();
                unfolded(&raw, &along)
            };
            let (face, stone, middle) = (line(&|_| 0.0), line(&|_| KERB_M), line(&|s| street.half_median(s)));
            let bridge = street.level(part[0]).bridge;
            let mut add = |kind, left: &[DVec3], right: &[DVec3]| {
                let (left, right) = (left.to_vec(), right.to_vec());
                map.lane_surfaces.push(LaneSurface { kind, left, right, in_junction: false, unpaved: false, bridge });
            };
            add(LaneType::Curb, &stone, &face);
            add(LaneType::Median, &middle, &stone);
        }
        start = end + 1;
    }
}

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

/// Strips of driveways and aisles, from behind the sidewalk on.
pub(super) fn yards(plan: &StreetPlan, context: &ImportContext<'_>, yards: &[StreetSegment], map: &mut RoadMap) {
    let hidden = inside(plan);
    let near =
        SegmentIndex::new(plan.streets.iter().enumerate().filter(|(i, _)| !hidden[*i]).map(|(i, s)| (i, &s.line)));
    let on_street = |p: DVec2| {
        near.at(p).iter().any(|&i| {
            let street = &plan.streets[i];
            let (_, t) = street.line.project(p);
            t.abs() < street.section.back(usize::from(t < 0.0)).abs() - 0.1
        })
    };
    for yard in yards {
        let bridge = yard.levels.iter().any(|l| l.bridge);
        let mut runs: Vec<Vec<DVec3>> = vec![Vec::new()];
        for pair in yard.vertices.windows(2) {
            let n = (pair[0].at.distance(pair[1].at) / 0.7).ceil().clamp(1.0, 5000.0) as usize;
            for k in 0..=n {
                let p = pair[0].at.lerp(pair[1].at, k as f64 / n as f64);
                if !on_street(p) {
                    runs.last_mut().expect("never empty").push(p.extend(context.ground(p)));
                } else if runs[runs.len() - 1].len() > 1 {
                    runs.push(Vec::new());
                } else {
                    runs.last_mut().expect("never empty").clear();
                }
            }
        }
        for points in runs.into_iter().filter(|r| r.len() > 1 && r[0].distance(r[r.len() - 1]) > 0.5) {
            let (left, right) = ribbon(&points, yard.section.kerbs[0], yard.section.kerbs[1], 4.0);
            let unpaved = yard.section.unpaved;
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
}

/// The borders of a ribbon along a chain of points with rounded bends.
pub(super) fn ribbon(points: &[DVec3], left: f64, right: f64, radius_m: f64) -> (Vec<DVec3>, Vec<DVec3>) {
    let line = line_through(super::curve::rounded(&super::curve::simplified(points, 0.1), radius_m));
    let along = line.points();
    let border = |t: f64| {
        let n = along.len();
        let raw: Vec<DVec3> = (0..n)
            .map(|i| {
                let before = (along[i] - along[i.saturating_sub(1)]).truncate().normalize_or_zero();
                let after = (along[(i + 1).min(n - 1)] - along[i]).truncate().normalize_or_zero();
                let normal = (before + after).perp().normalize_or_zero();
                along[i] + (normal * t).extend(0.0)
            })
            .collect();
        unfolded(&raw, along)
    };
    (border(left), border(right))
}
