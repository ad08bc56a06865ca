//! The line of `frames.jsonl` of the built-in city.

use endless_annotate::{Happenings, LightState, SceneFrame, SignalRecord, WeatherState, count_by_class};
use endless_road::RoadNetwork;
use endless_traffic::{SignalCountdown, signal_countdowns};
use endless_world::{Actor, ObjectClass, SceneWeather, SignalControl, SignalId, SignalState, WorldState};

/// Scene time is summed up before frame 0: a signal that changes in that very instant may be a rounding error early or late.
const ROUNDING_S: f64 = 1e-9;

/// The scene at an instant, with those who stand parked.
pub(super) fn scene_frame(
    weather: &SceneWeather,
    network: &RoadNetwork,
    parked: &[Actor],
    state: &WorldState,
    control: SignalControl,
) -> SceneFrame {
    let riders = state.actors.iter().filter(|actor| actor.rider_id.is_some()).map(|_| ObjectClass::Rider);
    SceneFrame {
        frame: state.frame,
        time_s: state.time_s,
        weather: WeatherState::new(weather),
        light: LightState::new(weather),
        signals: match control {
            SignalControl::Fixed => signals(network, state),
            SignalControl::Actuated => shown(state),
        },
        counts: count_by_class(state.actors.iter().chain(parked).map(|actor| actor.class).chain(riders)),
        // Whoever sees all frames in their order tells of it.
        happenings: Happenings::default(),
    }
}

/// Signals that follow traffic: nobody knows when they change.
fn shown(state: &WorldState) -> Vec<SignalRecord> {
    (0..).zip(&state.signals).map(|(id, signal)| SignalRecord::new(SignalId(id), signal.aspect, None)).collect()
}

fn signals(network: &RoadNetwork, state: &WorldState) -> Vec<SignalRecord> {
    let at = |late_s: f64| signal_countdowns(network, state.time_s + late_s);
    let agrees = |(shown, counted): (&SignalState, &SignalCountdown)| shown.aspect == counted.aspect;
    let mut countdowns = at(0.0);
    if !state.signals.iter().zip(&countdowns).all(agrees) {
        let nearby = [at(-ROUNDING_S), at(ROUNDING_S)];
        for (group, shown) in state.signals.iter().enumerate() {
            let fitting = nearby.iter().map(|other| other[group]).find(|other| agrees((shown, other)));
            countdowns[group] = fitting.filter(|_| !agrees((shown, &countdowns[group]))).unwrap_or(countdowns[group]);
        }
    }
    let record =
        |(id, countdown): (u16, &SignalCountdown)| SignalRecord::new(SignalId(id), countdown.aspect, countdown.change);
    (0..).zip(&countdowns).map(record).collect()
}
