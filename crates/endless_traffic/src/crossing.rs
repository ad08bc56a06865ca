//! Pedestrian crossings: how drivers and pedestrians yield to one another.

use crate::roads::{CrossingCut, Roads};
use crate::vehicle::Vehicle;
use endless_road::CrossingId;

/// A pedestrian on a crossing.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CrossingPedestrian {
    /// Metres from the crossing's first end.
    pub(crate) along_m: f64,
    /// +1 towards the second end, −1 back.
    pub(crate) direction: f64,
    /// m/s.
    pub(crate) speed: f64,
}

/// One crossing at this instant.
#[derive(Debug, Clone, Default)]
pub(crate) struct CrossingState {
    /// Pedestrians on it.
    pub(crate) people: Vec<CrossingPedestrian>,
    /// A pedestrian waits at the kerb and may go as soon as drivers yield.
    pub(crate) wanted: bool,
    /// A vehicle is on it, or at its very edge.
    pub(crate) occupied: bool,
    /// A vehicle is on it or too close to stop.
    pub(crate) danger: bool,
    /// Lanes with a vehicle on the crossing or too close to stop: metres along it, and how far beside the lane's
    /// middle it sweeps at most.
    pub(crate) taken: Vec<(f64, f64)>,
    /// A vehicle stands before it.
    pub(crate) waits: bool,
    /// People wait so that drivers get past for once.
    pub(crate) lets_drivers_go: bool,
}

/// Vehicles closer than this to a crossing stand on it in people's eyes, metres.
const CLEAR_M: f64 = 0.3;
/// Walkers closer than this to a lane's middle are in a car's way, metres.
const IN_THE_WAY_M: f64 = 2.5;
/// A long vehicle sweeps this much more in turns, metres.
const LONG_SWEEPS_M: f64 = 1.2;
/// Deceleration of pedestrians who stop, m/s².
const HALT_MPS2: f64 = 2.0;
/// A vehicle this near before a crossing waits for it, metres.
const WAITS_M: f64 = 3.0;
/// Drivers stop for people that walk towards their lane from this far, metres.
const NOTICED_M: f64 = 7.0;

impl CrossingState {
    /// Begins another look at people, after a step.
    pub(crate) fn look_again(&mut self) {
        self.people.clear();
        self.wanted = false;
    }

    /// Whether a pedestrian on it blocks a vehicle on a lane, or soon will.
    pub(crate) fn blocks(&self, cut: &CrossingCut, vehicle: &Vehicle) -> bool {
        self.people.iter().any(|p| blocks_lane((cut.along_m - p.along_m) * p.direction, vehicle))
    }

    /// Whether a pedestrian on it has still to pass a lane.
    pub(crate) fn awaits(&self, cut: &CrossingCut, vehicle: &Vehicle) -> bool {
        self.people.iter().any(|p| (cut.along_m - p.along_m) * p.direction > -in_the_way_m(vehicle))
    }

    /// Whether a pedestrian at this position who walks in this direction would step in front of a vehicle.
    pub(crate) fn step_is_unsafe(&self, person: CrossingPedestrian) -> bool {
        self.taken.iter().any(|&taken| step_is_unsafe(taken, person))
    }
}

/// Whether somebody would step in front of a vehicle on a lane: its place along the way over the road, and how far beside its
/// middle the vehicle sweeps.
pub(crate) fn step_is_unsafe((along_m, beside_m): (f64, f64), person: CrossingPedestrian) -> bool {
    let halt_m = person.speed * person.speed / (2.0 * HALT_MPS2);
    let to_lane = (along_m - person.along_m) * person.direction;
    to_lane > 1.0 && to_lane < beside_m + 0.2 + halt_m
}

/// Whether somebody so far before the middle of a lane, metres, is in a vehicle's way there, or soon will be.
pub(crate) fn blocks_lane(to_lane_m: f64, vehicle: &Vehicle) -> bool {
    to_lane_m > -in_the_way_m(vehicle) && to_lane_m < NOTICED_M
}

/// Whether they may be in the way of some vehicle.
pub(crate) fn nears_lane(to_lane_m: f64) -> bool {
    to_lane_m > -(IN_THE_WAY_M + LONG_SWEEPS_M) && to_lane_m < NOTICED_M
}

/// People closer than this to the middle of a vehicle's lane are in its way, metres.
pub(crate) fn in_the_way_m(vehicle: &Vehicle) -> f64 {
    IN_THE_WAY_M + if vehicle.long() { LONG_SWEEPS_M } else { 0.0 }
}

/// Comfortable distance to stop from a speed, metres.
pub(crate) fn comfortable_stop_m(speed: f64) -> f64 {
    speed * speed / (2.0 * 2.4) + 0.3 * speed + CLEAR_M
}

/// Notes the crossings that each vehicle is on or can no longer stop for.
pub(crate) fn note_vehicles(roads: &Roads, vehicles: &[Vehicle], crossings: &mut [CrossingState]) {
    for crossing in crossings.iter_mut() {
        crossing.danger = false;
        crossing.occupied = false;
        crossing.waits = false;
        crossing.taken.clear();
    }
    for vehicle in vehicles {
        let reach = vehicle.half_length + comfortable_stop_m(vehicle.speed);
        let mut note = |cut: &CrossingCut, base: f64| {
            let (low, high) = (base + cut.range.0, base + cut.range.1);
            if vehicle.speed < 0.3 && low > vehicle.half_length && low < vehicle.half_length + WAITS_M {
                crossings[cut.crossing.index()].waits = true;
            }
            if low < reach && high > -vehicle.half_length - CLEAR_M {
                let state = &mut crossings[cut.crossing.index()];
                state.danger = true;
                state.occupied |= low < vehicle.half_length + CLEAR_M;
                state.taken.push((cut.along_m, in_the_way_m(vehicle)));
            }
        };
        let mut base = -vehicle.s;
        for i in (0..vehicle.here).rev() {
            base -= roads.table(vehicle.route[i]).length;
            roads.table(vehicle.route[i]).cuts.iter().for_each(|cut| note(cut, base));
        }
        for (lane, base) in vehicle.ahead(roads) {
            if base > reach.max(vehicle.half_length + WAITS_M) {
                break;
            }
            roads.table(lane).cuts.iter().for_each(|cut| note(cut, base));
        }
    }
}

/// The signal of a crossing, as an index.
pub(crate) fn signal_of(roads: &Roads, crossing: CrossingId) -> Option<usize> {
    roads.network.crossings[crossing.index()].signal.map(|s| usize::from(s.0))
}
