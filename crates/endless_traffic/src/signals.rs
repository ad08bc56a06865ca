//! Traffic lights.

use endless_road::RoadNetwork;
use endless_world::{SignalAspect, SignalState};

/// What every signal group shows at a scene time (seconds, may be negative); groups without a program show red.
pub(crate) fn aspects_at(network: &RoadNetwork, time_s: f64, into: &mut Vec<SignalState>) {
    into.clear();
    into.resize(usize::from(network.signal_groups), SignalState { aspect: SignalAspect::Red });
    for program in network.junctions.iter().filter_map(|j| j.program.as_ref()) {
        let cycle: f64 = program.phases.iter().map(|p| p.duration_s).sum();
        let mut left = (time_s + program.offset_s).rem_euclid(cycle);
        let mut showing = &program.phases[program.phases.len() - 1];
        for phase in &program.phases {
            if left < phase.duration_s {
                showing = phase;
                break;
            }
            left -= phase.duration_s;
        }
        for &(signal, aspect) in &showing.aspects {
            into[usize::from(signal.0)].aspect = aspect;
        }
    }
}
