//! Traffic lights.

use endless_road::{RoadNetwork, SignalPhase, SignalProgram};
use endless_world::{SignalAspect, SignalId, SignalState};
use std::collections::BTreeSet;

/// What every signal group shows at a scene time (seconds, may be negative); groups without a program show red.
pub(crate) fn aspects_at(network: &RoadNetwork, time_s: f64, into: &mut Vec<SignalState>) {
    into.clear();
    into.resize(usize::from(network.signal_groups), SignalState { aspect: SignalAspect::Red });
    for program in network.junctions.iter().filter_map(|j| j.program.as_ref()) {
        let (showing, _) = phase_at(program, time_s);
        for &(signal, aspect) in &program.phases[showing].aspects {
            into[usize::from(signal.0)].aspect = aspect;
        }
    }
}

/// The phase that a program shows at a scene time, and seconds since it began.
fn phase_at(program: &SignalProgram, time_s: f64) -> (usize, f64) {
    let cycle: f64 = program.phases.iter().map(|p| p.duration_s).sum();
    let mut left = (time_s + program.offset_s).rem_euclid(cycle);
    for (place, phase) in program.phases.iter().enumerate() {
        if left < phase.duration_s {
            return (place, left);
        }
        left -= phase.duration_s;
    }
    let last = program.phases.len() - 1;
    (last, program.phases[last].duration_s)
}

/// What a signal group shows, and what comes next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SignalCountdown {
    /// What it shows.
    pub aspect: SignalAspect,
    /// Seconds until it shows something else, and what; `None` if it never does.
    pub change: Option<(f64, SignalAspect)>,
}

/// The countdown of every signal group at a scene time, by group, by the programs that [`crate::Simulation`] runs.
pub fn signal_countdowns(network: &RoadNetwork, time_s: f64) -> Vec<SignalCountdown> {
    let dark = SignalCountdown { aspect: SignalAspect::Red, change: None };
    let mut countdowns = vec![dark; usize::from(network.signal_groups)];
    for program in network.junctions.iter().filter_map(|j| j.program.as_ref()) {
        let (showing, since_s) = phase_at(program, time_s);
        let groups: BTreeSet<SignalId> = program.phases.iter().flat_map(|p| p.aspects.iter().map(|a| a.0)).collect();
        for group in groups {
            countdowns[usize::from(group.0)] = countdown(program, group, showing, since_s);
        }
    }
    countdowns
}

fn countdown(program: &SignalProgram, group: SignalId, showing: usize, since_s: f64) -> SignalCountdown {
    let phases = &program.phases;
    let aspect = aspect_in(&phases[showing], group);
    let mut remaining_s = phases[showing].duration_s - since_s;
    for later in 1..phases.len() {
        let phase = &phases[(showing + later) % phases.len()];
        // A phase of no length is never seen.
        let next = aspect_in(phase, group);
        if next != aspect && phase.duration_s > 0.0 {
            return SignalCountdown { aspect, change: Some((remaining_s, next)) };
        }
        remaining_s += phase.duration_s;
    }
    SignalCountdown { aspect, change: None }
}

/// Red where the phase does not name the group, as [`aspects_at`] has it.
fn aspect_in(phase: &SignalPhase, group: SignalId) -> SignalAspect {
    phase.aspects.iter().rev().find(|a| a.0 == group).map_or(SignalAspect::Red, |a| a.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::Junction;
    use proptest::prelude::*;

    fn aspects() -> impl Strategy<Value = SignalAspect> {
        use SignalAspect::{Green, Red, RedYellow, Yellow};
        prop_oneof![Just(Red), Just(Yellow), Just(Green), Just(RedYellow)]
    }

    fn programs() -> impl Strategy<Value = SignalProgram> {
        let phase = (0.5..20.0f64, prop::collection::vec(aspects(), 3)).prop_map(|(duration_s, aspects)| SignalPhase {
            duration_s,
            aspects: (0..).map(SignalId).zip(aspects).collect(),
        });
        let phases = prop::collection::vec(phase, 1..7);
        (phases, -50.0..50.0f64).prop_map(|(phases, offset_s)| SignalProgram { phases, offset_s })
    }

    proptest! {
        #[test]
        fn the_light_changes_when_the_countdown_ends(program in programs(), time_s in -30.0..100.0f64) {
            let junction = Junction { program: Some(program), ..Junction::default() };
            let network = RoadNetwork { junctions: vec![junction], signal_groups: 4, ..RoadNetwork::default() };
            let at = |time_s: f64| {
                let mut aspects = Vec::new();
                aspects_at(&network, time_s, &mut aspects);
                aspects
            };
            for (group, countdown) in signal_countdowns(&network, time_s).into_iter().enumerate() {
                prop_assert_eq!(countdown.aspect, at(time_s)[group].aspect);
                let (until_s, next) = countdown.change.unwrap_or((200.0, countdown.aspect));
                prop_assert!(until_s > 0.0);
                for share in [0.1, 0.5, 0.9] {
                    prop_assert_eq!(at(time_s + until_s * share)[group].aspect, countdown.aspect);
                }
                prop_assert_eq!(at(time_s + until_s - 1e-6)[group].aspect, countdown.aspect);
                prop_assert_eq!(at(time_s + until_s + 1e-6)[group].aspect, next);
            }
        }
    }
}
