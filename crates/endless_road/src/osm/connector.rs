//! Lanes through junctions.

use super::curve::{angle, kerb_radius, line_through, way_through};
use super::graph::StreetSegmentEnd;
use super::movement::Movement;
use super::plan::StreetPlan;
use crate::{JunctionId, Lane, LaneId, Polyline, RoadNetwork, TrafficControl, Turn};
use endless_world::math::f64::{sin_cos, wrap_angle};
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// Sideways acceleration in turns, m/s²: the limit on connectors.
const TURN_MPS2: f64 = 2.6;

/// Adds the connector of every movement of an intersection; returns them with their movements.
pub(super) fn add(
    plan: &StreetPlan,
    network: &mut RoadNetwork,
    junction: JunctionId,
    movements: &[Movement],
) -> Vec<LaneId> {
    let mut added = Vec::new();
    for movement in movements {
        let lane_of = |arm: StreetSegmentEnd, band: usize| plan.street(arm).lanes[band];
        let Some((before, after)) =
            lane_of(movement.from, movement.lane_in).zip(lane_of(movement.to, movement.lane_out))
        else {
            continue;
        };
        let id = LaneId(network.lanes.len() as u32);
        let (a, b) = (network.lane(before), network.lane(after));
        let line = line(plan, movement);
        let limit = a.speed_limit_mps.min(b.speed_limit_mps).min(comfortable(&line));
        let lane = Lane {
            id,
            width_m: a.width_m.min(b.width_m),
            centerline: line,
            speed_limit_mps: limit.max(2.0),
            successors: vec![after],
            predecessors: Vec::new(),
            left: None,
            right: None,
            junction: Some(junction),
            turn: movement.turn,
            end_control: TrafficControl::Free,
        };
        network.lanes.push(lane);
        network.lanes[before.index()].successors.push(id);
        network.junctions[junction.index()].lanes.push(id);
        added.push(id);
    }
    added
}

/// A way that winds by this much more than it turns is none, radians.
const WINDING_RAD: f64 = 1.3;

/// The movements that can be driven: where the ends of arms lie side by side or behind one another, ways between them
/// would loop. They stay only where a lane has no other.
pub(super) fn sensible(plan: &StreetPlan, movements: &[Movement]) -> Vec<Movement> {
    let winds: Vec<bool> = movements.iter().map(|m| m.from != m.to && winding(plan, m) > WINDING_RAD).collect();
    let other =
        |m: &Movement| movements.iter().zip(&winds).any(|(o, w)| !w && o.from == m.from && o.lane_in == m.lane_in);
    movements.iter().zip(&winds).filter(|(m, winds)| !**winds || !other(m)).map(|(m, _)| *m).collect()
}

/// By how much the direction changes along a way beyond what its ends ask for, radians.
fn winding(plan: &StreetPlan, m: &Movement) -> f64 {
    let line = line(plan, m);
    let headings: Vec<f64> = line.points().windows(2).map(|w| angle((w[1] - w[0]).truncate())).collect();
    let total: f64 = headings.windows(2).map(|h| wrap_angle(h[1] - h[0]).abs()).sum();
    total - wrap_angle(headings[headings.len() - 1] - headings[0]).abs()
}

fn comfortable(line: &Polyline) -> f64 {
    let length = line.length();
    let n = (length / 2.0).ceil() as usize;
    let heading = |s: f64| line.at(s.clamp(0.0, length)).heading_rad;
    let bend = (0..=n)
        .map(|k| {
            let s = length * k as f64 / n as f64;
            let (low, high) = ((s - 2.0).max(0.0), (s + 2.0).min(length));
            wrap_angle(heading(high) - heading(low)).abs() / (high - low).max(0.5)
        })
        .fold(1e-4, f64::max);
    (TURN_MPS2 / bend).sqrt()
}

/// Straight over the crossing, a smooth curve through the junction's area, and straight over the next crossing.
fn line(plan: &StreetPlan, m: &Movement) -> Polyline {
    let section_in = plan.arm_section(m.from);
    let section_out = plan.arm_section(m.to);
    let t_of = |arm: StreetSegmentEnd, band: usize, section: &super::section::CrossSection| {
        let band = if arm.end == 0 { band } else { section.bands.len() - 1 - band };
        section.middle(band)
    };
    let leg = |arm: StreetSegmentEnd, t: f64| -> Vec<DVec3> {
        let street = plan.street(arm);
        let (cut, stop) = (plan.cut(arm), plan.stop(arm));
        let stations = if arm.end == 0 {
            street.stations(cut, stop, 1.5)
        } else {
            let length = street.length();
            let mut back: Vec<f64> =
                street.stations(length - stop, length - cut, 1.5).into_iter().map(|s| length - s).collect();
            back.reverse();
            back
        };
        stations.into_iter().map(|d| plan.arm_point(arm, d, t)).collect()
    };
    let mut points = leg(m.from, t_of(m.from, m.lane_in, &section_in));
    points.reverse();
    let exit = leg(m.to, t_of(m.to, m.lane_out, &section_out));
    let (p, q) = (points[points.len() - 1], exit[0]);
    let u = -plan.arm_direction(m.from, plan.cut(m.from));
    let v = plan.arm_direction(m.to, plan.cut(m.to));
    let curve = if m.from == m.to {
        loop_back(p.truncate(), u, q.truncate(), loop_radius(plan.cut(m.from)))
    } else {
        way_through(p.truncate(), u, q.truncate(), v, widest(plan, m, wrap_angle(angle(v) - angle(u))))
    };
    let total: f64 = curve.windows(2).map(|w| w[0].distance(w[1])).sum();
    let mut s = 0.0;
    for pair in curve.windows(2).take(curve.len().saturating_sub(2)) {
        s += pair[0].distance(pair[1]);
        points.push(pair[1].extend(p.z + (q.z - p.z) * s / total.max(1e-9)));
    }
    points.extend(exit);
    line_through(points)
}

/// Radius of the centre line of a loop at a dead end with room for it, metres.
pub(super) const DEAD_END_RADIUS_M: f64 = 4.2;

/// Radius of the loop at a dead end that is cut back by `cut` metres.
pub(super) fn loop_radius(cut: f64) -> f64 {
    (cut / 2.5).clamp(1.0, DEAD_END_RADIUS_M)
}

/// Radius of the widest bend of a way that turns by an angle: to the right concentric with the kerb of the corner, or those
/// who turn would cut across it.
fn widest(plan: &StreetPlan, m: &Movement, turn: f64) -> f64 {
    if turn >= 0.0 {
        return f64::INFINITY;
    }
    let kerb = kerb_radius(plan.street(m.from).class.corner_m().min(plan.street(m.to).class.corner_m()), turn);
    let beside = |arm: StreetSegmentEnd, band: usize, side: usize| {
        let section = plan.arm_section(arm);
        let band = if arm.end == 0 { band } else { section.bands.len() - 1 - band };
        (section.middle(band) - section.kerbs[side]).abs()
    };
    // Seen outwards from the junction: who arrives keeps to the left, who leaves to the right.
    kerb + beside(m.from, m.lane_in, 0).min(beside(m.to, m.lane_out, 1))
}

/// Around at a dead end: outwards to the right, and back in a circle.
fn loop_back(p: DVec2, u: DVec2, q: DVec2, least_m: f64) -> Vec<DVec2> {
    let axis = p.midpoint(q);
    let side = (p - q).normalize_or(-u.perp());
    let radius = (0.5 * p.distance(q)).max(least_m);
    // The cut leaves room for two and a half radii; the circle's middle lies where it can be reached smoothly.
    let middle = axis + u * (1.45 * least_m);
    let at = |turn: f64| {
        let (sin, cos) = sin_cos(turn);
        middle + side * (cos * radius) + u * (sin * radius)
    };
    let ease = |from: DVec2, to: DVec2| -> Vec<DVec2> {
        let reach = (to - from).dot(u).abs() * 0.5;
        let sign = (to - from).dot(u).signum();
        (0..14)
            .map(|k| {
                let t = f64::from(k) / 14.0;
                let s = 1.0 - t;
                let (c, d) = (from + u * (sign * reach), to - u * (sign * reach));
                from * (s * s * s) + c * (3.0 * s * s * t) + d * (3.0 * s * t * t) + to * (t * t * t)
            })
            .collect()
    };
    let mut out = ease(p, at(0.0));
    let steps = 60;
    out.extend((0..steps).map(|k| at(PI * f64::from(k) / f64::from(steps))));
    out.extend(ease(at(PI), q));
    out.push(q);
    out
}

/// The turn that a connector is drawn as when it leads back.
pub(super) fn is_back(movement: &Movement) -> bool {
    movement.turn == Turn::UTurn
}
