//! Stop positions before crossings, and the stop lines painted there.

use crate::{Crossing, Lane, LaneId, MarkingColor, Polyline, RoadMarking, TrafficControl};
use endless_world::math::f64::sin_cos;
use glam::DVec3;

/// A crossing this near to the end of a lane belongs to the junction there, metres.
const NEAR_END_M: f64 = 14.0;
/// From the stop line to the crossing.
const BEFORE_CROSSING_M: f64 = 1.2;
/// A lane is not made shorter than this, metres.
const SHORTEST_M: f64 = 6.0;
/// Cosine of the bend allowed where a lane is cut: 2 degrees.
const STRAIGHT: f64 = 0.999_4;
/// Stop lines and give-way lines, metres.
const STOP_LINE_M: f64 = 0.4;
const YIELD_DASH_M: [f64; 2] = [0.6, 0.4];
/// A painted line this near to a lane's end is its stop line already, metres.
const PAINTED_M: f64 = 4.0;

/// Ends lanes before crossings that lie between them and their junction: what is cut off becomes the beginning of
/// the ways through it.
pub(super) fn end_before_crossings(lanes: &mut [Lane], crossings: &[Crossing]) {
    let mut predecessors = vec![0; lanes.len()];
    for next in lanes.iter().flat_map(|lane| &lane.successors) {
        predecessors[next.index()] += 1;
    }
    for i in 0..lanes.len() {
        let lane = &lanes[i];
        let into_junction = |next: &LaneId| lanes[next.index()].junction.is_some() && predecessors[next.index()] == 1;
        if lane.junction.is_some() || lane.successors.is_empty() || !lane.successors.iter().all(into_junction) {
            continue;
        }
        let length = lane.centerline.length();
        let cuts = crossings.iter().filter_map(|crossing| crate::cut::cut_range(crossing, lane));
        let first = cuts.filter(|cut| length - cut.1 < NEAR_END_M).map(|cut| cut.0).fold(f64::INFINITY, f64::min);
        let hold = first - BEFORE_CROSSING_M;
        if hold < SHORTEST_M || hold > length - 0.5 {
            continue;
        }
        // Not in a bend: the lane's end and what follows have one direction.
        let holds = [hold, hold - 0.7, hold - 1.4, hold - 2.1];
        let cuts = holds.into_iter().filter(|&hold| hold >= SHORTEST_M).map(|hold| split(&lane.centerline, hold));
        let Some((kept, rest)) = cuts.into_iter().find(|(kept, rest)| is_straight(kept, rest)) else { continue };
        let following = lane.successors.clone();
        lanes[i].centerline = kept;
        for next in following {
            let way = &mut lanes[next.index()].centerline;
            *way = Polyline::new(rest.points().iter().chain(way.points()).copied());
        }
    }
}

fn is_straight(kept: &Polyline, rest: &Polyline) -> bool {
    kept.direction(kept.length()).dot(rest.direction(0.0)) > STRAIGHT
}

fn split(line: &Polyline, at: f64) -> (Polyline, Polyline) {
    let middle = line.at(at).position;
    let (mut before, mut after): (Vec<DVec3>, Vec<DVec3>) = (Vec::new(), vec![middle]);
    let mut s = 0.0;
    for (i, &point) in line.points().iter().enumerate() {
        if i > 0 {
            s += point.distance(line.points()[i - 1]);
        }
        // No tiny pieces at the cut: their direction would be noise.
        if s < at - 0.05 {
            before.push(point);
        } else if s > at + 0.05 {
            after.push(point);
        }
    }
    before.push(middle);
    (Polyline::new(before), Polyline::new(after))
}

/// Stop and give-way lines at lane ends where the file paints none.
pub(super) fn stop_lines(lanes: &[Lane], marks: &[RoadMarking]) -> Vec<RoadMarking> {
    let painted: Vec<DVec3> = marks
        .iter()
        .filter(|mark| mark.width_m > 0.2 && mark.line.length() < 30.0)
        .map(|mark| mark.line.at(0.5 * mark.line.length()).position)
        .collect();
    let mut lines = Vec::new();
    for lane in lanes {
        let dash = match lane.end_control {
            TrafficControl::Free => continue,
            TrafficControl::Signal(_) | TrafficControl::Stop => None,
            TrafficControl::Yield => Some(YIELD_DASH_M),
        };
        let end = lane.centerline.at(lane.centerline.length() - 0.5 * STOP_LINE_M);
        let (sin, cos) = sin_cos(end.heading_rad);
        let half = DVec3::new(-sin, cos, 0.0) * (0.5 * lane.width_m);
        let along = DVec3::new(cos, sin, 0.0);
        // One painted over several lanes counts for all of them: what matters is how far ahead it is.
        let has_one = painted.iter().any(|p| {
            let to = *p - end.position;
            to.dot(along).abs() < PAINTED_M && to.length() < 12.0
        });
        if !has_one {
            lines.push(RoadMarking {
                line: Polyline::new([end.position + half, end.position - half]),
                width_m: STOP_LINE_M,
                dash,
                color: MarkingColor::White,
            });
        }
    }
    lines
}
