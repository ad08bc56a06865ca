//! Detectors: vehicles on the last metres before a line, and people at a kerb.

use crate::crossing::CrossingState;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::{RoadNetwork, TrafficControl};
use endless_world::SignalId;

/// Length of the zone before a line in which a vehicle is detected, metres: at 14 m/s a green is held for headways of up to 3 s.
const ZONE_M: f64 = 30.0;

/// Who calls for green, by signal. Calls do not lock: they last as long as somebody is there.
#[derive(Debug, Clone, Default)]
pub(super) struct Calls {
    by_signal: Vec<bool>,
}

impl Calls {
    pub(super) fn new(network: &RoadNetwork) -> Self {
        Self { by_signal: vec![false; usize::from(network.signal_groups)] }
    }

    #[cfg(test)]
    pub(super) fn of(by_signal: Vec<bool>) -> Self {
        Self { by_signal }
    }

    pub(super) fn calls(&self, signals: &[SignalId]) -> bool {
        signals.iter().any(|signal| self.by_signal[usize::from(signal.0)])
    }

    /// Looks at everybody anew.
    pub(super) fn take(&mut self, roads: &Roads, vehicles: &[Vehicle], crossings: &[CrossingState]) {
        self.by_signal.fill(false);
        for signal in vehicles.iter().filter_map(|vehicle| called_by(roads, vehicle)) {
            self.by_signal[usize::from(signal.0)] = true;
        }
        for (crossing, state) in roads.network.crossings.iter().zip(crossings) {
            if let Some(signal) = crossing.signal.filter(|_| state.wanted) {
                self.by_signal[usize::from(signal.0)] = true;
            }
        }
    }
}

/// The signal before which a vehicle is, if it is near; who stands at the kerb on purpose does not want to get on.
fn called_by(roads: &Roads, vehicle: &Vehicle) -> Option<SignalId> {
    if vehicle.kerb_halt.is_some_and(|halt| halt.stands() || halt.is_parked()) {
        return None;
    }
    let mut ahead = vehicle.ahead(roads).peekable();
    while let Some((lane, _)) = ahead.next() {
        let line_m = ahead.peek()?.1 - vehicle.half_length;
        if line_m > ZONE_M {
            return None;
        }
        if let TrafficControl::Signal(signal) = roads.network.lane(lane).end_control {
            return Some(signal);
        }
    }
    None
}
