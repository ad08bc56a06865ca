//! Room for somebody who comes to a stand on a lane, out of the way of junctions and crossings.

use super::moment::Moment;
use crate::vehicle::Vehicle;
use endless_road::LaneId;
use endless_world::math::f64::sin_cos;
use glam::DVec2;

/// Slower than this a vehicle stands, m/s.
const STANDS_MPS: f64 = 0.05;
/// Nobody stands nearer to the beginning and to the end of a lane than that, metres.
const FROM_ENDS_M: [f64; 2] = [6.0, 14.0];
/// Nor to a crossing, metres.
const FROM_CROSSING_M: f64 = 10.0;
/// Who stands nearer to the one ahead stands in a queue, metres.
const QUEUE_M: f64 = 9.0;
/// Others are in the same queue no further beside than this, metres, nor further above or below.
const BESIDE_M: f64 = 2.2;
const STOREY_M: f64 = 3.0;
/// Nobody else is ahead within this beyond the place, metres, but who drives on at some speed, m/s.
const ALONE_M: f64 = 12.0;
const DRIVES_ON_MPS: f64 = 3.0;

/// How far a vehicle gets until it stands if it begins to brake so, metres; it takes a moment until brakes are felt.
pub(super) fn stop_m(vehicle: &Vehicle, braking_mps2: f64) -> f64 {
    vehicle.speed * vehicle.speed / (2.0 * braking_mps2) + 0.2 * vehicle.speed + 0.5
}

/// The lane on which a vehicle would stand, and its place there, if that is out of the way and nobody is close ahead of it.
pub(super) fn place(moment: &Moment<'_>, i: usize, ahead_m: f64) -> Option<(LaneId, f64)> {
    let vehicle = &moment.vehicles[i];
    if vehicle.shift.is_some() || vehicle.order.is_some() {
        return None;
    }
    let inside = |lane: LaneId| moment.roads.table(lane).junction;
    let goes_on = |lane: LaneId| inside(lane).is_none_or(|junction| vehicle.right_of_way_at(junction).is_some());
    let way = vehicle.ahead(moment.roads).take_while(|(lane, base)| *base <= ahead_m && goes_on(*lane));
    let (lane, base) = way.last().filter(|(lane, _)| inside(*lane).is_none())?;
    let (s, table) = (ahead_m - base, moment.roads.table(lane));
    let (rear, front) = (s - vehicle.half_length, s + vehicle.half_length);
    let off_crossings = table.cuts.iter().all(|cut| cut.range.1 < rear - 2.0 || cut.range.0 > front + FROM_CROSSING_M);
    let reach = ahead_m + vehicle.half_length + ALONE_M;
    let leader = moment.occupancy.leader(moment.roads, moment.vehicles, i, reach);
    let alone = leader.is_none_or(|leader| leader.speed > DRIVES_ON_MPS || leader.gap > ahead_m + ALONE_M);
    let clear = rear > FROM_ENDS_M[0] && front < table.length - FROM_ENDS_M[1];
    (clear && off_crossings && alone).then_some((lane, s))
}

/// Whether somebody is close ahead, as in a queue.
pub(super) fn is_held(moment: &Moment<'_>, actors: &[usize]) -> bool {
    let me = &moment.vehicles[actors[0]];
    let (sin, cos) = sin_cos(me.yaw);
    let ahead = DVec2::new(cos, sin);
    moment.vehicles.iter().enumerate().any(|(i, other)| {
        let apart = (other.pose.position - me.pose.position).as_dvec3();
        let (along, across) = (apart.truncate().dot(ahead), apart.truncate().perp_dot(ahead));
        let gap = along - me.half_length - other.half_length;
        i != actors[0] && along > 0.0 && gap < QUEUE_M && across.abs() < BESIDE_M && apart.z.abs() < STOREY_M
    })
}

/// While the first of them stands.
pub(super) fn happens(moment: &Moment<'_>, actors: &[usize]) -> bool {
    moment.vehicles[actors[0]].speed < STANDS_MPS
}
