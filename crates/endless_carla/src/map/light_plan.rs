//! Which lights share a junction, and which of these are green together.

use endless_road::{RoadNetwork, TrafficControl};
use endless_world::{SignalAspect, SignalId};
use std::collections::BTreeMap;

/// Group (the junction) and stage of each signal for vehicles.
#[derive(Debug, Clone, Default)]
pub(super) struct LightPlan {
    places: BTreeMap<SignalId, (u32, u32)>,
}

impl LightPlan {
    /// Signals that our own programs show green together are of one stage; all others take turns. Groups are numbered as
    /// junctions are, stages as the programs have them.
    pub(super) fn new(network: &RoadNetwork) -> Self {
        let mut junction_of: BTreeMap<SignalId, usize> = BTreeMap::new();
        for lane in &network.lanes {
            let TrafficControl::Signal(signal) = lane.end_control else { continue };
            let entered = lane.successors.iter().find_map(|&next| network.lane(next).junction);
            let entered =
                entered.map_or(network.junctions.len() + usize::from(signal.0), endless_road::JunctionId::index);
            junction_of.entry(signal).or_insert(entered);
        }
        let mut by_junction: BTreeMap<usize, Vec<SignalId>> = BTreeMap::new();
        for (&signal, &junction) in &junction_of {
            by_junction.entry(junction).or_default().push(signal);
        }
        let mut places = BTreeMap::new();
        for (group, (junction, signals)) in (0..).zip(by_junction) {
            let program = network.junctions.get(junction).and_then(|junction| junction.program.as_ref());
            let mut stages: Vec<Vec<SignalId>> = Vec::new();
            for phase in program.iter().flat_map(|program| &program.phases) {
                let green = phase.aspects.iter().filter(|(_, aspect)| *aspect == SignalAspect::Green);
                let new: Vec<SignalId> = green
                    .map(|&(signal, _)| signal)
                    .filter(|signal| signals.contains(signal) && !stages.iter().flatten().any(|s| s == signal))
                    .collect();
                if !new.is_empty() {
                    stages.push(new);
                }
            }
            for signal in signals {
                if !stages.iter().flatten().any(|&s| s == signal) {
                    stages.push(vec![signal]);
                }
            }
            for (stage, signals) in (0..).zip(stages) {
                places.extend(signals.into_iter().map(|signal| (signal, (group, stage))));
            }
        }
        Self { places }
    }

    /// Group and stage of a signal.
    pub(super) fn place_of(&self, signal: SignalId) -> (u32, u32) {
        self.places.get(&signal).copied().unwrap_or_default()
    }
}
