//! From a place on a lane to a pose: a point a little behind the front axle follows the lane, the rear axle follows
//! that point without slipping sideways, as with a trailer's drawbar (the tractrix). Heading and steering angle are
//! smooth by construction, and a long body swings out in bends about as far as it cuts in.

use crate::incident::impact;
use crate::roads::Roads;
use crate::vehicle::{LaneChange, LaneTail, Vehicle};
use endless_road::LaneId;
use endless_road::swept::{DRAWBAR, towed_heading};
use endless_world::Pose;
use endless_world::math::f64::{atan, atan2, sin_cos, tan, wrap_angle};
use glam::DVec3;

const GRAVITY: f64 = 9.81;
/// A two-wheeler that lies on its side lies on what stands out, at this share of half its width.
const LIES_ON: f64 = 0.9;

/// Offset from the lane's middle and its slope after as many metres more as were travelled, and whether a lane change has ended.
fn lateral(vehicle: &Vehicle, travelled: f64) -> (f64, f64, bool) {
    let Some(shift) = vehicle.shift else {
        let (aside_m, slope) = vehicle.order.map_or((0.0, 0.0), |order| order.aside(vehicle.rolled));
        let (kerb_m, kerb_slope) = vehicle.kerb_halt.map_or((0.0, 0.0), |halt| halt.aside(vehicle.rolled + travelled));
        let (past_m, past_slope) = vehicle.filtering.map_or((0.0, 0.0), |way| way.aside(vehicle.rolled + travelled));
        return (vehicle.driver.lateral_m + aside_m + kerb_m + past_m, slope + kerb_slope + past_slope, false);
    };
    let u = ((vehicle.s - shift.begin_s) / shift.length_m).clamp(0.0, 1.0);
    let rise = LaneChange::rise(u);
    let slope = 30.0 * u * u * (1.0 - u) * (1.0 - u) / shift.length_m;
    (vehicle.driver.lateral_m + shift.offset_m * (1.0 - rise), -shift.offset_m * slope, u >= 1.0)
}

/// How far the point that follows the lane is ahead of the origin, metres.
pub(crate) fn pivot_ahead_m(vehicle: &Vehicle) -> f64 {
    DRAWBAR * vehicle.wheelbase - vehicle.rear_axle
}

/// Puts a vehicle at rest on its lane.
pub(crate) fn settle(vehicle: &mut Vehicle, roads: &Roads) {
    vehicle.yaw = roads.network.lane(vehicle.lane()).centerline.at(vehicle.s).heading_rad;
    place(vehicle, roads, 0.0, 0.0);
}

/// Moves a vehicle on by one step.
pub(crate) fn advance(vehicle: &mut Vehicle, roads: &Roads, step_s: f64) {
    if let Some(order) = &mut vehicle.order {
        order.age_s += step_s;
        if order.crash.is_some() {
            impact::slide(vehicle, roads, step_s);
            return;
        }
    }
    let before = vehicle.speed;
    vehicle.speed = (before + vehicle.acceleration * step_s).max(0.0);
    let travelled = 0.5 * (before + vehicle.speed) * step_s;
    let (_, slope, _) = lateral(vehicle, 0.0);
    vehicle.s += travelled / (1.0 + slope * slope).sqrt();
    while vehicle.s > roads.table(vehicle.lane()).length && vehicle.here + 1 < vehicle.route.len() {
        vehicle.s -= roads.table(vehicle.lane()).length;
        vehicle.here += 1;
    }
    if vehicle.here > 0 {
        // Drop the lanes that the tail has left.
        let mut behind = vehicle.s;
        let mut keep = vehicle.here;
        while keep > 0 && behind < vehicle.half_length + 1.0 {
            keep -= 1;
            behind += roads.table(vehicle.route[keep]).length;
        }
        vehicle.route.drain(..keep);
        vehicle.here -= keep;
    }
    if lateral(vehicle, 0.0).2 {
        vehicle.tail = vehicle.shift.take().and_then(|change| LaneTail::of(vehicle, change));
    }
    vehicle.tail = vehicle.tail.filter(|tail| tail.is_there(vehicle));
    place(vehicle, roads, travelled, step_s);
}

/// The place this far ahead of the origin on the route.
fn ahead_by(vehicle: &Vehicle, roads: &Roads, distance: f64) -> (LaneId, f64) {
    let mut place = (vehicle.lane(), vehicle.s + distance);
    for (lane, base) in vehicle.ahead(roads) {
        place = (lane, distance - base);
        if place.1 <= roads.table(lane).length {
            break;
        }
    }
    place
}

fn place(vehicle: &mut Vehicle, roads: &Roads, travelled: f64, step_s: f64) {
    let drawbar = DRAWBAR * vehicle.wheelbase;
    let pivot_x = pivot_ahead_m(vehicle);
    let (lane, s) = ahead_by(vehicle, roads, pivot_x);
    let on = roads.network.lane(lane).centerline.at(s);
    let (t, slope, _) = lateral(vehicle, travelled);
    let course = on.heading_rad + atan(slope);
    let (sin, cos) = sin_cos(on.heading_rad);
    let pivot = on.position + DVec3::new(-sin, cos, 0.0) * t;
    let way = (pivot - vehicle.pivot).truncate();
    let moved = step_s > 0.0 && way.length_squared() > 1e-12;
    let pull = if moved { atan2(way.y, way.x) } else { course };
    let yaw = towed_heading(vehicle.yaw, pull, way.length() * f64::from(u8::from(moved)), drawbar);
    let angle = wrap_angle(course - yaw).clamp(-1.2, 1.2);
    vehicle.pivot = pivot;
    let (sin, cos) = sin_cos(yaw);
    let position = pivot - DVec3::new(cos, sin, on.grade) * pivot_x;
    let turned = wrap_angle(yaw - vehicle.yaw);
    vehicle.yaw = yaw;
    if let Some(trailer) = &mut vehicle.trailer {
        if step_s > 0.0 {
            trailer.follow(position.truncate(), yaw);
        } else {
            trailer.settle(position.truncate(), yaw);
        }
    }
    vehicle.steer = atan(tan(angle) / DRAWBAR).clamp(-0.8, 0.8);
    vehicle.rolled += travelled * sin_cos(angle).1;
    if step_s > 0.0 && vehicle.class.two_wheeled() {
        // Two-wheelers lean into the bend.
        let lean = -atan(vehicle.speed * turned / step_s / GRAVITY).clamp(-0.6, 0.6);
        vehicle.roll += (lean - vehicle.roll) * (step_s / 0.25).min(1.0);
    }
    let mut lifted_m = 0.0;
    if let Some((fall, age_s)) = vehicle.order.and_then(|order| Some((order.fall?, order.age_s))) {
        vehicle.roll = fall.roll(age_s);
        let half_width_m = 0.5 * f64::from(roads.specs[vehicle.asset.model.index()].width_m);
        lifted_m = LIES_ON * half_width_m * sin_cos(vehicle.roll).0.abs();
    }
    let (sin, cos) = sin_cos(course);
    vehicle.velocity = (DVec3::new(cos, sin, on.grade) * vehicle.speed).as_vec3();
    // The road's rise along the vehicle's heading.
    let pitch = atan(on.grade * sin_cos(wrap_angle(yaw - on.heading_rad)).1);
    vehicle.pose = Pose {
        position: (position + DVec3::Z * lifted_m).as_vec3(),
        yaw_rad: yaw as f32,
        pitch_rad: pitch as f32,
        roll_rad: vehicle.roll as f32,
    };
}

#[cfg(test)]
mod tests;
