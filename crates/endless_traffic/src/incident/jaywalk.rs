//! Jaywalking: somebody leaves the sidewalk and goes straight over the road, away from crossings; drivers brake.

use super::moment::{Candidate, Moment};
use super::road_walk::RoadWalk;
use crate::walker::Walker;
use endless_road::{Lane, WalkKind};
use endless_world::math::segment::share_along;
use glam::DVec2;

/// Slower than this people have something else in mind, m/s.
const LEAST_MPS: f64 = 0.5;
/// The road begins within this, metres, and the other sidewalk is within these.
const ROAD_M: f64 = 7.0;
const ACROSS_M: [f64; 2] = [6.0, 26.0];
/// Crossings are further away than this, metres.
const FROM_CROSSING_M: f64 = 9.0;
/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 2.0;

/// Those on a sidewalk with another one on the other side of the road.
pub(super) fn candidates(moment: &Moment<'_>) -> Vec<Candidate> {
    let walks = |(i, walker): (usize, &Walker)| {
        let walk = road_walk(moment, walker)?;
        Some(Candidate { roles: Vec::new(), walk: Some((i, walk)), junction: None, ahead_m: 0.0 })
    };
    moment.watched_walkers().filter_map(walks).collect()
}

fn road_walk(moment: &Moment<'_>, walker: &Walker) -> Option<RoadWalk> {
    let network = &moment.roads.network;
    let (edge, _) = *walker.way.front()?;
    let on_sidewalk = network.walk.edges[edge.index()].kind == WalkKind::Sidewalk;
    if !on_sidewalk || walker.velocity.length() < LEAST_MPS || walker.road_walk.is_some() {
        return None;
    }
    let at = walker.position;
    let level = |z: f64| (z - walker.height).abs() < STOREY_M;
    // The nearest lane tells where the road is.
    let beside = |lane: &Lane| {
        let (s, _) = lane.centerline.project(at);
        let on = lane.centerline.position(s);
        let apart = (on.truncate() - at).length() - 0.5 * lane.width_m;
        (level(on.z) && lane.junction.is_none()).then_some((apart, on.truncate(), lane.centerline.direction(s)))
    };
    let (apart, on, along) = network.lanes.iter().filter_map(beside).min_by(|a, b| a.0.total_cmp(&b.0))?;
    if !(0.0..ROAD_M).contains(&apart) {
        return None;
    }
    let across = along.perp() * along.perp_dot(on - at).signum();
    let clear = |point: DVec2| {
        network.crossings.iter().all(|crossing| {
            let [a, b] = crossing.ends.map(glam::DVec3::truncate);
            let u = share_along(point, a, b);
            point.distance(a.lerp(b, u)) > FROM_CROSSING_M + 0.5 * crossing.width_m
        })
    };
    // The first sidewalk that the way across comes to.
    let mut best: Option<(f64, usize)> = None;
    for (number, other) in network.walk.edges.iter().enumerate() {
        let [a, b] = other.nodes.map(|node| network.walk.nodes[node.index()]);
        if other.kind != WalkKind::Sidewalk || number == edge.index() || !level(a.z) {
            continue;
        }
        let side = (b - a).truncate();
        let turn = across.perp_dot(side);
        if turn.abs() < 0.5 * side.length() {
            continue;
        }
        let from = a.truncate() - at;
        let (way_m, u) = (from.perp_dot(side) / turn, from.perp_dot(across) / turn);
        let fits = (ACROSS_M[0]..ACROSS_M[1]).contains(&way_m) && (0.05..0.95).contains(&u) && way_m > apart + 2.0;
        if fits && best.is_none_or(|(nearest, _)| way_m < nearest) {
            best = Some((way_m, number));
        }
    }
    let (way_m, number) = best?;
    let lanes = crossed(moment, at, across, way_m)?;
    let road_m = lanes.iter().fold([f64::INFINITY, 0.0f64], |[first, last], cut| {
        [first.min(cut.along_m - cut.half_width_m), last.max(cut.along_m + cut.half_width_m)]
    });
    let inside = road_m[0] > 0.3 && road_m[1] < way_m - 0.3;
    let ends_clear = [0.0, 0.5, 1.0].iter().all(|u| clear(at + across * (u * way_m)));
    (inside && ends_clear).then(|| RoadWalk::new(walker.pace, across, way_m, number, lanes, road_m))
}

/// The lanes on the way; `None` if one is a junction's, or none is crossed.
fn crossed(moment: &Moment<'_>, from: DVec2, across: DVec2, way_m: f64) -> Option<Vec<super::road_walk::CrossedLane>> {
    let mut found = Vec::new();
    for lane in &moment.roads.network.lanes {
        for pair in lane.centerline.points().windows(2) {
            let (a, side) = (pair[0].truncate() - from, (pair[1] - pair[0]).truncate());
            let turn = across.perp_dot(side);
            if turn.abs() < 1e-6 {
                continue;
            }
            let (along_m, u) = (a.perp_dot(side) / turn, a.perp_dot(across) / turn);
            if !(0.0..way_m).contains(&along_m) || !(0.0..1.0).contains(&u) {
                continue;
            }
            if lane.junction.is_some() {
                return None;
            }
            let (s, _) = lane.centerline.project(from + across * along_m);
            let height_m = lane.centerline.position(s).z;
            found.push(super::road_walk::CrossedLane {
                lane: lane.id,
                s,
                along_m,
                half_width_m: 0.5 * lane.width_m,
                height_m,
            });
        }
    }
    (!found.is_empty()).then_some(found)
}

/// While somebody is on the road.
pub(super) fn happens(walker: &Walker) -> bool {
    walker.road_walk.as_ref().is_some_and(RoadWalk::is_on_road)
}
