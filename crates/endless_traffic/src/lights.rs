//! Lights: brake, indicators, headlights, cabins.

use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::Turn;
use endless_world::{ObjectClass, Side, VehicleLights};

/// Indicators blink this often a second.
const BLINK_HZ: f64 = 1.5;

pub(crate) fn update(vehicle: &mut Vehicle, roads: &Roads, headlights_on: f32, time_s: f64, step_s: f64) {
    let mut lit = VehicleLights::empty();
    // Every vehicle's relay has its own beat, and every driver thinks it dark at another time.
    let own = (vehicle.asset.variant % 1000) as f64 / 1000.0;
    if f64::from(headlights_on) > own {
        lit |= VehicleLights::POSITION | VehicleLights::LOW_BEAM;
        // Passengers sit in the light; drivers of cars see better in the dark.
        if vehicle.class == ObjectClass::Bus {
            lit |= VehicleLights::INTERIOR;
        }
    }
    if vehicle.class != ObjectClass::Bicycle {
        let braking = vehicle.acceleration < -0.7 || vehicle.speed < 0.05;
        vehicle.brake_hold_s = if braking { 0.3 } else { vehicle.brake_hold_s - step_s };
        if vehicle.brake_hold_s > 0.0 {
            lit |= VehicleLights::BRAKE;
        }
        vehicle.indicating = indicated(vehicle, roads);
        if (time_s * BLINK_HZ + own).rem_euclid(1.0) < 0.5 {
            lit |= match vehicle.indicating {
                Some(Side::Left) => VehicleLights::LEFT_BLINKER,
                Some(Side::Right) => VehicleLights::RIGHT_BLINKER,
                None => VehicleLights::empty(),
            };
        }
    }
    vehicle.lights = lit;
}

/// The side to which the driver is about to go.
fn indicated(vehicle: &Vehicle, roads: &Roads) -> Option<Side> {
    if let Some(shift) = vehicle.shift {
        // Coming from the left (positive offset) means moving to the right.
        return Some(if shift.offset_m > 0.0 { Side::Right } else { Side::Left });
    }
    if let Some((target, _)) = vehicle.intent {
        let left = roads.network.lane(vehicle.lane()).left == Some(target);
        return Some(if left { Side::Left } else { Side::Right });
    }
    let reach = (vehicle.speed * 3.0).max(20.0);
    for (lane, base) in vehicle.ahead(roads) {
        if base > reach {
            break;
        }
        if let Some(side) = side_of(roads.network.lane(lane).turn) {
            return Some(side);
        }
    }
    None
}

/// The side to which a lane turns.
pub(crate) fn side_of(turn: Turn) -> Option<Side> {
    match turn {
        Turn::Left | Turn::UTurn => Some(Side::Left),
        Turn::Right => Some(Side::Right),
        Turn::Straight => None,
    }
}
