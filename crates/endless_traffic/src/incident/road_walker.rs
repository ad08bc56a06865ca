//! Those who walk straight over a road, and how drivers notice them: as something that stands on the lane, or soon will.

use super::road_walk::CrossedLane;
use crate::occupancy::Occupancy;
use crate::roads::Roads;
use crate::vehicle::LaneCover;
use crate::walk_strip::BODY_M;
use crate::walker::Walker;
use endless_world::math::f64::{atan2, wrap_angle};
use endless_world::math::segment::share_along;

/// How fast people turn, rad/s, and get going, m/s².
const TURN_RATE: f64 = 3.5;
const ACCELERATION: f64 = 2.0;
/// Drivers notice somebody who will be on their lane so soon, seconds.
const NOTICED_S: f64 = 2.2;
/// Room that drivers leave around people, metres.
const ROOM_M: f64 = 0.9;
/// Seconds in which somebody is up on a kerb or down from it.
const KERB_S: f64 = 0.3;

/// Moves all of them on by one step.
pub(crate) fn step(walkers: &mut [Walker], roads: &Roads, step_s: f64) {
    for walker in walkers.iter_mut().filter(|walker| walker.road_walk.is_some()) {
        advance(walker, roads, step_s);
    }
}

/// Moves somebody on who goes over a road; on the other side they walk on as usual.
fn advance(walker: &mut Walker, roads: &Roads, step_s: f64) {
    let Some(mut walk) = walker.road_walk.take() else { return };
    let off = wrap_angle(atan2(walk.across.y, walk.across.x) - walker.yaw);
    walker.yaw = wrap_angle(walker.yaw + (off * 6.0).clamp(-TURN_RATE, TURN_RATE) * step_s);
    // Nobody walks sideways: first they turn.
    let wanted = if off.abs() < 0.6 { walk.pace_mps } else { 0.0 };
    let change = (wanted - walk.speed_mps).clamp(-ACCELERATION * step_s, ACCELERATION * step_s);
    walk.speed_mps += change;
    walker.velocity = walk.across * walk.speed_mps;
    let moved_m = walk.speed_mps * step_s;
    walk.gone_m += moved_m;
    walker.position += walk.across * moved_m;
    walker.walked += moved_m;
    walker.steps.advance(walker.position, walker.yaw, walker.velocity, step_s);
    walker.gait = walker.steps.gait(walk.speed_mps, false);
    let ground = |lane: &CrossedLane| (lane.along_m - walk.gone_m).abs() - lane.half_width_m;
    let nearest = walk.lanes.iter().min_by(|a, b| ground(a).total_cmp(&ground(b)));
    let walks = &roads.network.walk;
    let [a, b] = walks.edges[walk.edge.index()].nodes.map(|node| walks.nodes[node.index()]);
    let kerb_m = |walker: &Walker| {
        let along = share_along(walker.position, a.truncate(), b.truncate());
        a.z + (b.z - a.z) * along
    };
    let beyond = walk.gone_m > walk.road_m[1];
    let level_m = match nearest {
        _ if beyond => kerb_m(walker),
        Some(lane) if walk.gone_m > walk.road_m[0] => lane.height_m,
        _ => walker.height,
    };
    walker.height += (level_m - walker.height) * (step_s / KERB_S).min(1.0);
    if walk.gone_m < walk.way_m {
        walker.road_walk = Some(walk);
        return;
    }
    // On along the sidewalk, the way that turns less.
    let edge = &walks.edges[walk.edge.index()];
    let [first, second] = edge.nodes;
    let along = (b - a).truncate();
    let (from, to) =
        if walker.stream.chance(0.5) || along.length() < 2.0 * BODY_M { (first, second) } else { (second, first) };
    walker.from = from;
    walker.way = [(walk.edge, to)].into();
}

/// Puts those who are on a lane, or soon will be, in the way of its drivers.
pub(crate) fn occupy(walkers: &[Walker], occupancy: &mut Occupancy) {
    for walk in walkers.iter().filter_map(|walker| walker.road_walk.as_ref()) {
        for lane in &walk.lanes {
            let reach_m = lane.half_width_m + BODY_M;
            let enters_m = lane.along_m - reach_m - walk.gone_m;
            let soon = enters_m < NOTICED_S * walk.pace_mps;
            if soon && walk.gone_m < lane.along_m + reach_m {
                let cover = LaneCover { lane: lane.lane, rear: lane.s - ROOM_M, front: lane.s + ROOM_M };
                occupancy.put(usize::MAX, cover, 0.0);
            }
        }
    }
}
