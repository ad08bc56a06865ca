//! Lights: brake, indicators, headlights, cabins.

use crate::emergency;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::Turn;
use endless_world::{ObjectClass, Side, VehicleLights};

/// Indicators blink this often a second.
const BLINK_HZ: f64 = 1.5;

pub(crate) fn update(vehicle: &mut Vehicle, roads: &Roads, headlights_on: f32, time_s: f64, step_s: f64) {
    if vehicle.kerb_halt.is_some_and(|halt| halt.is_dark()) {
        (vehicle.lights, vehicle.indicating, vehicle.brake_hold_s) = (VehicleLights::empty(), None, 0.0);
        return;
    }
    let warns = vehicle.kerb_halt.is_some_and(|halt| halt.warns());
    let hazards = warns || vehicle.order.is_some_and(|order| vehicle.speed < order.hazards_below_mps);
    if vehicle.class != ObjectClass::Bicycle {
        let braking = brakes(vehicle.acceleration, vehicle.speed);
        vehicle.brake_hold_s = brake_hold_s(vehicle.brake_hold_s, braking, step_s);
        vehicle.indicating = if hazards { None } else { indicated(vehicle, roads) };
    }
    let lamps = Lamps {
        class: vehicle.class,
        own: own_share(vehicle.asset.variant),
        braking: vehicle.brake_hold_s > 0.0,
        indicating: vehicle.indicating,
    };
    vehicle.lights = lamps.lit(headlights_on, time_s);
    vehicle.lights |= emergency::beacons(vehicle, lamps.own, time_s);
    if hazards && lamps.flashes(time_s) {
        vehicle.lights |= VehicleLights::LEFT_BLINKER | VehicleLights::RIGHT_BLINKER;
    }
}

/// What decides which lamps of a vehicle are lit.
pub(crate) struct Lamps {
    pub(crate) class: ObjectClass,
    /// What sets it apart from others, 0 to 1.
    pub(crate) own: f64,
    pub(crate) braking: bool,
    pub(crate) indicating: Option<Side>,
}

/// Every vehicle's relay has its own beat, and every driver thinks it dark at another time.
pub(crate) fn own_share(variant: u64) -> f64 {
    (variant % 1000) as f64 / 1000.0
}

/// Whether the brake pedal is pressed.
pub(crate) fn brakes(acceleration: f64, speed: f64) -> bool {
    acceleration < -0.7 || speed < 0.05
}

/// How much longer brake lights are lit, seconds, after a step.
pub(crate) fn brake_hold_s(before: f64, braking: bool, step_s: f64) -> f64 {
    if braking { 0.3 } else { before - step_s }
}

impl Lamps {
    /// Whether the relay of the indicators is on.
    fn flashes(&self, time_s: f64) -> bool {
        (time_s * BLINK_HZ + self.own).rem_euclid(1.0) < 0.5
    }

    /// The lamps that are lit at a scene time.
    pub(crate) fn lit(&self, headlights_on: f32, time_s: f64) -> VehicleLights {
        let mut lit = VehicleLights::empty();
        if f64::from(headlights_on) > self.own {
            lit |= VehicleLights::POSITION | VehicleLights::LOW_BEAM;
            // Passengers sit in the light; drivers of cars see better in the dark.
            if self.class == ObjectClass::Bus {
                lit |= VehicleLights::INTERIOR;
            }
        }
        if self.class == ObjectClass::Bicycle {
            return lit;
        }
        if self.braking {
            lit |= VehicleLights::BRAKE;
        }
        if self.flashes(time_s) {
            lit |= match self.indicating {
                Some(Side::Left) => VehicleLights::LEFT_BLINKER,
                Some(Side::Right) => VehicleLights::RIGHT_BLINKER,
                None => VehicleLights::empty(),
            };
        }
        lit
    }
}

/// The side to which the driver is about to go.
fn indicated(vehicle: &Vehicle, roads: &Roads) -> Option<Side> {
    if let Some(halt) = &vehicle.kerb_halt
        && (halt.stands() || halt.indicates().is_some())
    {
        return halt.indicates();
    }
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
