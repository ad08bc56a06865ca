//! What a traffic light shows in turn.

use endless_road::RoadNetwork;
use endless_world::{SignalAspect, SignalId};
use serde_json::{Value, json};
use std::collections::VecDeque;

/// What a signal group shows from scene time 0 on, for ever again: aspects, each with its seconds. The first may be the rest of
/// one that had begun before, which then ends the cycle, too. Null where it has no program.
pub(crate) fn signal_cycle(network: &RoadNetwork, signal: SignalId) -> Option<Value> {
    let programs = network.junctions.iter().filter_map(|junction| junction.program.as_ref());
    let program = { programs }.find(|p| p.phases.iter().any(|phase| phase.aspects.iter().any(|a| a.0 == signal)))?;
    let shown = program.phases.iter().map(|phase| {
        let aspect = phase.aspects.iter().rev().find(|a| a.0 == signal).map_or(SignalAspect::Red, |a| a.1);
        (aspect, phase.duration_s)
    });
    let mut shown: VecDeque<(SignalAspect, f64)> = shown.filter(|phase| phase.1 > 0.0).collect();
    let whole: f64 = shown.iter().map(|phase| phase.1).sum();
    let mut begun_s = program.offset_s.rem_euclid(whole);
    while let Some((aspect, seconds)) = shown.pop_front() {
        if begun_s < seconds {
            shown.push_front((aspect, seconds - begun_s));
            shown.push_back((aspect, begun_s));
            break;
        }
        begun_s -= seconds;
        shown.push_back((aspect, seconds));
    }
    let mut joined: Vec<(SignalAspect, f64)> = Vec::new();
    for (aspect, seconds) in shown {
        match joined.last_mut() {
            Some(last) if last.0 == aspect => last.1 += seconds,
            _ => joined.push((aspect, seconds)),
        }
    }
    joined.retain(|phase| phase.1 > 1e-9);
    let told =
        joined.iter().map(|(aspect, seconds)| json!({ "aspect": aspect, "seconds": (seconds * 1e3).round() / 1e3 }));
    Some(told.collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_asset::Catalogue;
    use endless_traffic::signal_countdowns;

    #[test]
    fn the_cycle_is_what_traffic_sees() {
        let town = endless_town::load("Town03", &Catalogue::builtin()).expect("a town");
        for signal in (0..town.network.signal_groups).map(SignalId) {
            let Some(cycle) = signal_cycle(&town.network, signal) else { continue };
            let phases = cycle.as_array().expect("a list");
            let mut begin_s = 0.0;
            for _ in 0..2 {
                for phase in phases {
                    let seconds = phase["seconds"].as_f64().expect("a number");
                    for share in [0.01, 0.5, 0.99] {
                        let seen = signal_countdowns(&town.network, begin_s + share * seconds);
                        let aspect = json!(seen[usize::from(signal.0)].aspect);
                        assert_eq!(aspect, phase["aspect"], "{signal:?} at {begin_s} s");
                    }
                    begin_s += seconds;
                }
            }
            assert!(begin_s > 20.0);
        }
    }
}
