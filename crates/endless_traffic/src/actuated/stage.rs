//! Stages of a program: what is green together, apart from the durations of the fixed plan.

use endless_road::{SignalPhase, SignalProgram};
use endless_world::{SignalAspect, SignalId};

/// What signals show.
pub(super) type Aspects = Vec<(SignalId, SignalAspect)>;

/// Vehicles or people, or both, that are green together, with what comes before and after.
#[derive(Debug, Clone)]
pub(super) struct Stage {
    /// Before anything is green.
    pub(super) lead: Vec<SignalPhase>,
    /// While people may set out.
    pub(super) walk: Option<SignalPhase>,
    /// While they clear the road.
    pub(super) clearance: Option<SignalPhase>,
    /// While vehicles alone are green; nothing in a stage of people.
    pub(super) green: Option<Aspects>,
    /// Yellow, then all red.
    pub(super) tail: Vec<SignalPhase>,
    /// Signals that are green, vehicles' and people's.
    pub(super) vehicles: Vec<SignalId>,
    pub(super) people: Vec<SignalId>,
}

fn shows(phase: &SignalPhase, wanted: SignalAspect) -> impl Iterator<Item = SignalId> {
    phase.aspects.iter().filter(move |(_, aspect)| *aspect == wanted).map(|(signal, _)| *signal)
}

fn is_red(phase: &SignalPhase) -> bool {
    phase.aspects.iter().all(|(_, aspect)| *aspect == SignalAspect::Red)
}

/// The stages of a program, in its order; `None` where it has fewer than two, or green changes within one.
pub(super) fn stages(program: &SignalProgram, is_walk: &dyn Fn(SignalId) -> bool) -> Option<Vec<Stage>> {
    let phases: Vec<&SignalPhase> = program.phases.iter().filter(|phase| phase.duration_s > 0.0).collect();
    // A stage ends with the last phase in which all is red.
    let ends = |k: usize| is_red(phases[k]) && !is_red(phases[(k + 1) % phases.len()]);
    let first = (0..phases.len()).rfind(|&k| ends(k))? + 1;
    let mut of_stages: Vec<Vec<&SignalPhase>> = vec![Vec::new()];
    for k in (0..phases.len()).map(|later| (first + later) % phases.len()) {
        of_stages.last_mut()?.push(phases[k]);
        if ends(k) {
            of_stages.push(Vec::new());
        }
    }
    of_stages.pop();
    let stages: Option<Vec<Stage>> = of_stages.iter().map(|phases| stage(phases, is_walk)).collect();
    stages.filter(|stages| stages.len() > 1 && stages.iter().any(|stage| stage.green.is_some()))
}

fn stage(phases: &[&SignalPhase], is_walk: &dyn Fn(SignalId) -> bool) -> Option<Stage> {
    let has_green = |phase: &&SignalPhase| shows(phase, SignalAspect::Green).next().is_some();
    // In the last part of a stage of people alone they clear the road.
    let first = phases.iter().position(has_green)?;
    let last = phases.iter().rposition(has_green)?;
    let greens = &phases[first..=last];
    let of = |phase: &SignalPhase, people: bool| -> Vec<SignalId> {
        shows(phase, SignalAspect::Green).filter(|signal| is_walk(*signal) == people).collect()
    };
    let [vehicles, people] = [false, true].map(|people| of(greens[0], people));
    let walk = (!people.is_empty()).then(|| greens[0].clone());
    let (clearance, tail) = match (&walk, greens) {
        (Some(_), [_]) if vehicles.is_empty() && phases.len() > last + 2 => {
            (Some(phases[last + 1].clone()), &phases[last + 2..])
        }
        (Some(_), [_, clearance]) => (Some((*clearance).clone()), &phases[last + 1..]),
        (Some(_), [_, clearance, _]) => (Some((*clearance).clone()), &phases[last + 1..]),
        (_, [_]) => (None, &phases[last + 1..]),
        _ => return None,
    };
    let alike = greens.iter().all(|phase| of(phase, false) == vehicles);
    let no_more_people = greens[1..].iter().all(|phase| of(phase, true).is_empty());
    let stands = |(signal, aspect): &(SignalId, SignalAspect)| {
        (*signal, if is_walk(*signal) { SignalAspect::Red } else { *aspect })
    };
    let green = (!vehicles.is_empty()).then(|| greens[0].aspects.iter().map(stands).collect());
    let own = |phases: &[&SignalPhase]| phases.iter().map(|phase| (*phase).clone()).collect();
    let lead = own(&phases[..first]);
    (alike && no_more_people).then(|| Stage { lead, walk, clearance, green, tail: own(tail), vehicles, people })
}
