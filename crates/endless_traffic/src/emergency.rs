//! Emergency vehicles on call: beacons flash, and others let them through.
//!
//! Who has one behind changes to another lane if there is one, and nobody moves over before it. At junctions others give up
//! their turn while it comes and may go. It keeps to red lights and speed limits itself, so that all that holds of traffic
//! holds of it, too; where there is one lane it stays behind the others.

use crate::driver::MOST_LIMIT_FACTOR;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::LaneId;
use endless_world::{Stream, VehicleLights};

/// Designs with beacons.
const DESIGNS: [&str; 5] = ["car.police", "car.police_suv", "van.police", "van.ambulance", "truck.fire"];
/// Share of those on the road that are on call.
const ON_CALL: f64 = 0.5;
/// Drivers hear and see one behind them from so far, metres.
const HEARD_M: f64 = 80.0;
/// What it is worth to let one pass, m/s².
const LETS_PASS_MPS2: f64 = 1.5;
/// One that has waited for so long at a line is held up by something else: others go on, seconds.
const HELD_UP_S: f64 = 8.0;
/// Flashes a second, within the 2 to 4 of UN Regulation No. 65.
const FLASH_HZ: f64 = 2.0;

/// Whether a design has beacons.
pub(crate) fn is_emergency(design: &str) -> bool {
    DESIGNS.contains(&design)
}

/// Sends a vehicle on call, if it is one of those: always the same ones.
pub(crate) fn call(roads: &Roads, vehicle: &mut Vehicle) {
    let design = roads.specs[vehicle.asset.model.index()].name;
    let called = || Stream::named(vehicle.asset.variant, "traffic.on_call", &[]).chance(ON_CALL);
    vehicle.on_call = is_emergency(design) && called();
    if vehicle.on_call {
        vehicle.driver.limit_factor = vehicle.driver.limit_factor.max(MOST_LIMIT_FACTOR);
    }
}

/// The lamps of its beacons that are lit: both halves in turn.
pub(crate) fn beacons(vehicle: &Vehicle, own: f64, time_s: f64) -> VehicleLights {
    match vehicle.on_call {
        true if (time_s * FLASH_HZ + own).rem_euclid(1.0) < 0.5 => VehicleLights::SPECIAL1,
        true => VehicleLights::SPECIAL2,
        false => VehicleLights::empty(),
    }
}

/// Part of a lane over which somebody on call is about to come.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ComingCall {
    pub(crate) lane: LaneId,
    /// From its middle on, and up to here.
    range: (f64, f64),
}

impl ComingCall {
    /// On the lanes ahead of a vehicle.
    pub(crate) fn ahead_of<'a>(roads: &'a Roads, vehicle: &'a Vehicle) -> impl Iterator<Item = Self> + 'a {
        let lanes = vehicle.ahead(roads).take_while(|(_, base)| *base < HEARD_M);
        lanes.map(|(lane, base)| Self { lane, range: ((-base).max(0.0), HEARD_M - base) }).filter(|_| vehicle.on_call)
    }

    fn holds(&self, lane: LaneId, s: f64) -> bool {
        self.lane == lane && (self.range.0..self.range.1).contains(&s)
    }
}

/// What it is worth to somebody to change from a place to another lane for those on call, m/s²; `None` if they are to have
/// that lane.
pub(crate) fn incentive(coming: &[ComingCall], vehicle: &Vehicle, target: LaneId, target_s: f64) -> Option<f64> {
    let comes = |lane: LaneId, s: f64| coming.iter().any(|call| call.holds(lane, s));
    if coming.is_empty() || vehicle.on_call {
        return Some(0.0);
    }
    match (comes(target, target_s), comes(vehicle.lane(), vehicle.s)) {
        (true, _) => None,
        (false, true) => Some(LETS_PASS_MPS2),
        (false, false) => Some(0.0),
    }
}

/// Whether somebody who is not on call gives up their turn at a junction for another who may go and has waited there for so
/// long, seconds.
pub(crate) fn gives_up_turn(me: &Vehicle, other: &Vehicle, other_waited_s: f64) -> bool {
    other.on_call && !me.on_call && other_waited_s < HELD_UP_S
}

#[cfg(test)]
mod tests;
