//! The line of `frames.jsonl` of the built-in city.

use endless_annotate::{Happenings, LightState, SceneFrame, SignalRecord, SunState, WeatherState, count_by_class};
use endless_render::SceneWeather;
use endless_road::RoadNetwork;
use endless_traffic::{SignalCountdown, signal_countdowns};
use endless_world::{Actor, Condition, ObjectClass, SceneSettings, SignalId, SignalState, WorldState};

/// Scene time is summed up before frame 0: a signal that changes in that very instant may be a rounding error early or late.
const ROUNDING_S: f64 = 1e-9;

/// The scene at an instant, with those who stand parked.
pub(super) fn scene_frame(
    settings: &SceneSettings,
    network: &RoadNetwork,
    parked: &[Actor],
    state: &WorldState,
) -> SceneFrame {
    let usual = Condition::of(settings.weather, settings.time_of_day);
    let light = settings.randomised.as_ref().and_then(|randomised| randomised.light);
    let condition = &light.map_or(*usual, |light| light.of(usual));
    let drawn = SceneWeather::new(condition, settings.seed);
    let riders = state.actors.iter().filter(|actor| actor.rider_id.is_some()).map(|_| ObjectClass::Rider);
    SceneFrame {
        frame: state.frame,
        time_s: state.time_s,
        weather: WeatherState::new(condition, drawn.visibility_m, drawn.scale_height_m),
        light: LightState {
            time_of_day: settings.time_of_day,
            sun: SunState::new(drawn.sun_azimuth_rad, drawn.sun_altitude_rad, condition.sun_share),
            street_lamps_on: condition.lamps_lit,
            headlights_on: condition.headlights_on,
        },
        signals: signals(network, state),
        counts: count_by_class(state.actors.iter().chain(parked).map(|actor| actor.class).chain(riders)),
        // Whoever sees all frames in their order tells of it.
        happenings: Happenings::default(),
    }
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
