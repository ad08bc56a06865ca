//! Lights and signs beside the road.

use super::class::RoadClass;
use super::curve::angle;
use super::graph::StreetSegmentEnd;
use super::lane::inside;
use super::plan::StreetPlan;
use super::surface::KERB_HEIGHT_M;
use crate::{MapObject, MapObjectKind, RoadMap, TrafficControl};
use glam::DVec3;

/// From the kerb to a post, metres.
const POST_M: f64 = 0.7;
/// Streets shorter than this get no sign with their limit, metres.
const LIMIT_M: f64 = 140.0;

/// Adds them all.
pub(super) fn add(plan: &StreetPlan, map: &mut RoadMap) {
    for intersection in &plan.intersections {
        for &arm in &intersection.arms {
            approach(plan, arm, map);
            walk_lights(plan, arm, map);
        }
    }
    limits(plan, map);
}

/// Beside the stop line, on the driver's right; over several lanes of a one-way road on the left too.
fn approach(plan: &StreetPlan, arm: StreetSegmentEnd, map: &mut RoadMap) {
    let street = plan.street(arm);
    let lanes = plan.lanes_in(arm).len();
    if lanes == 0 {
        return;
    }
    let kind = match street.control[arm.end] {
        TrafficControl::Signal(id) => MapObjectKind::TrafficLight(id),
        TrafficControl::Stop => MapObjectKind::Stop,
        TrafficControl::Yield => MapObjectKind::Yield,
        TrafficControl::Free => return,
    };
    let section = plan.arm_section(arm);
    let d = plan.stop(arm);
    let heading_rad = angle(-plan.arm_direction(arm, d));
    let lit = matches!(kind, MapObjectKind::TrafficLight(_));
    let mut post = |t: f64| {
        let position = plan.arm_point(arm, d, t) + DVec3::Z * KERB_HEIGHT_M;
        map.objects.push(MapObject { kind: kind.clone(), position, heading_rad });
    };
    // Looking outwards, the driver's right is on the left.
    post(section.kerbs[0] + POST_M);
    if lit && lanes > 1 && plan.lanes_out(arm).is_empty() {
        post(section.kerbs[1] - POST_M);
    }
}

fn walk_lights(plan: &StreetPlan, arm: StreetSegmentEnd, map: &mut RoadMap) {
    let street = plan.street(arm);
    for crossing in street.crossings.iter().filter(|c| c.end == Some(arm.end)) {
        let Some(signal) = crossing.signal else { continue };
        for side in 0..2 {
            let out = if side == 0 { POST_M } else { -POST_M };
            // Beside the crossing, on the side away from the junction.
            let s = crossing.s + if arm.end == 0 { 1.9 } else { -1.9 };
            let position = street.point(s, street.section.kerbs[side] + out) + DVec3::Z * KERB_HEIGHT_M;
            let across = street.direction(crossing.s).perp() * out.signum();
            map.objects.push(MapObject {
                kind: MapObjectKind::WalkLight(signal),
                position,
                heading_rad: angle(across),
            });
        }
    }
}

fn limits(plan: &StreetPlan, map: &mut RoadMap) {
    for (street, hidden) in plan.streets.iter().zip(inside(plan)) {
        if hidden || street.class < RoadClass::Tertiary || street.length() < LIMIT_M {
            continue;
        }
        let kmh = (street.speed_mps * 3.6 / 5.0).round() as u16 * 5;
        for forward in [true, false] {
            if street.section.lanes(forward).is_empty() {
                continue;
            }
            let (s, t, along) = if forward {
                (street.stops[0] + 22.0, street.section.kerbs[1] - POST_M, street.direction(22.0))
            } else {
                let s = street.length() - street.stops[1] - 22.0;
                (s, street.section.kerbs[0] + POST_M, -street.direction(s))
            };
            let position = street.point(s, t) + DVec3::Z * KERB_HEIGHT_M;
            map.objects.push(MapObject { kind: MapObjectKind::SpeedLimit(kmh), position, heading_rad: angle(along) });
        }
    }
}
