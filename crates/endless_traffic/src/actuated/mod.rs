//! Signals that follow traffic: isolated, fully actuated control with phases that are skipped, as the Signal Timing Manual has it
//! (FHWA 2008, chapters 4 and 5; NCHRP Report 812, 2015), much as SUMO's `actuated` programs do.
//!
//! ```text
//! program of a junction ─► stage      what is green together, and the intervals after it (once)
//! vehicles, crossings ───► detector   who calls for which signal (each step)
//!                                └──► controller   which interval is shown
//! ```
//!
//! Yellow, all-red and people's clearance are those of the fixed plan. A stage is green for its least time, on while vehicles come
//! one after another (passage time), and no longer than its most once somebody else calls; who does not call is passed over. With no
//! call anywhere the first stage with vehicles, the main road's, is green.

mod controller;
mod detector;
mod stage;

use crate::crossing::CrossingState;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use controller::Controller;
use detector::Calls;
use endless_world::{SignalAspect, SignalId, SignalState};
use stage::stages;

/// The signals of a map whose junctions are controlled by who comes.
#[derive(Debug, Clone)]
pub(crate) struct ActuatedSignals {
    controllers: Vec<Controller>,
    calls: Calls,
    /// For how long each signal has been red, seconds.
    red_s: Vec<f64>,
}

impl ActuatedSignals {
    pub(crate) fn new(roads: &Roads) -> Self {
        let network = &roads.network;
        let is_walk = |signal: SignalId| network.crossings.iter().any(|crossing| crossing.signal == Some(signal));
        let programs = network.junctions.iter().filter_map(|junction| junction.program.as_ref());
        let controllers = programs.filter_map(|program| stages(program, &is_walk)).map(Controller::new).collect();
        let red_s = vec![0.0; usize::from(network.signal_groups)];
        Self { controllers, calls: Calls::new(network), red_s }
    }

    /// Moves all junctions on and writes what they show over what their fixed plans do.
    pub(crate) fn step(
        &mut self,
        roads: &Roads,
        vehicles: &[Vehicle],
        crossings: &[CrossingState],
        step_s: f64,
        into: &mut [SignalState],
    ) {
        self.calls.take(roads, vehicles, crossings);
        for controller in &mut self.controllers {
            controller.step(&self.calls, step_s);
        }
        self.show(into);
        for (red_s, shown) in self.red_s.iter_mut().zip(into) {
            *red_s = if shown.aspect == SignalAspect::Red { *red_s + step_s } else { 0.0 };
        }
    }

    /// Writes what these junctions show now.
    pub(crate) fn show(&self, into: &mut [SignalState]) {
        for controller in &self.controllers {
            for &(signal, aspect) in controller.shown() {
                into[usize::from(signal.0)].aspect = aspect;
            }
        }
    }

    /// Whether a signal was red so many seconds ago and ever since, as far as is known; of what is to come, whether it is red now.
    pub(crate) fn is_red(&self, signal: SignalId, after_s: f64) -> bool {
        let red_s = self.red_s[usize::from(signal.0)];
        red_s > 0.0 && red_s >= -after_s
    }
}

#[cfg(test)]
mod tests;
