//! Events that a recipe asks for: a session tells of them beforehand, and what is seen frame by frame agrees.

use crate::city::{city, town as shared};
use endless_annotate::{Event, SceneObserver};
use endless_pipeline::{MapCatalog, Simulator};
use endless_world::{
    ActorDensity, CameraLook, ImageSize, Incident, IncidentKind, SceneCamera, SceneSettings, SensorLayers,
    StagedIncidents, TimeOfDay, TrafficProfile, Weather,
};

const FPS: f64 = 10.0;

fn settings(town: &str, kind: IncidentKind, seed: u64) -> SceneSettings {
    let sites = city().cameras(town).expect("a town");
    SceneSettings {
        video: 0,
        map: town.to_owned(),
        town_seed: None,
        drawn_sites: false,
        weather: Weather::Rainy,
        time_of_day: TimeOfDay::Afternoon,
        sun_elevation_deg: None,
        changing_to: None,
        sensors: Vec::new(),
        cameras: vec![SceneCamera { site: sites[0].clone(), look: CameraLook::CLEAN }],
        vehicles: 60,
        pedestrians: 20,
        density: ActorDensity::default(),
        focus: 0.8,
        profile: TrafficProfile::default(),
        jaywalking: 0.0,
        groups: 0.0,
        events: vec![kind],
        size: ImageSize { width: 64, height: 36 },
        fps: FPS,
        frames: 200,
        seed,
        randomised: None,
        playback: None,
    }
}

/// The first draw that has one, with the events that an observer sees, by frame.
fn first(town: &'static str, kind: IncidentKind) -> (Incident, Vec<(u32, Event)>) {
    for seed in 0..12 {
        let settings = settings(town, kind, seed);
        let mut session = city().open_session(shared(town), &settings, SensorLayers::default()).expect("a scene");
        let StagedIncidents { incidents, missed } = session.incidents();
        assert_eq!(incidents.len() + missed.len(), 1);
        let [incident] = &incidents[..] else { continue };
        let actors = session.actors().expect("the city knows its actors");
        for id in &incident.actors {
            assert!(actors.iter().any(|actor| actor.id == *id), "{id} is in actors.json");
        }
        let mut observer = SceneObserver::new(session.road_facts(), Vec::new());
        let mut seen = Vec::new();
        for frame in 0..settings.frames {
            let state = session.tick().expect("a frame").state;
            if frame == incident.begin_frame {
                let cause = state.actors.iter().find(|actor| actor.id == incident.actors[0]).expect("it is there");
                assert_eq!(cause.pose.position.to_array(), incident.position);
            }
            seen.extend(observer.observe(&state).events.into_iter().map(|event| (frame, event)));
        }
        return (incident.clone(), seen);
    }
    panic!("{town}: no {kind} in twelve draws");
}

#[test]
fn a_collision_is_seen_when_its_label_says() {
    let (incident, seen) = first("Town03", IncidentKind::Collision);
    let mut ids = [incident.actors[0], incident.actors[1]];
    ids.sort_unstable();
    let touches = |(frame, event): &(u32, Event)| match event {
        Event::Collision { ids: touching } => Some((*frame, *touching)),
        _ => None,
    };
    let collisions: Vec<_> = seen.iter().filter_map(touches).collect();
    assert!(collisions.iter().all(|(_, touching)| *touching == ids), "nobody else touches: {collisions:?}");
    assert!(collisions.first().is_some_and(|(frame, _)| frame.abs_diff(incident.begin_frame) <= 1), "{collisions:?}");
}

#[test]
fn who_stalls_comes_to_a_stop_when_the_label_says() {
    let (incident, seen) = first("Altstadt", IncidentKind::Stalled);
    let stops = |(frame, event): &(u32, Event)| {
        *event == Event::Stop { id: incident.actors[0] } && frame.abs_diff(incident.begin_frame) <= 3
    };
    assert!(seen.iter().any(stops), "{incident:?}");
    assert_eq!(incident.end_frame, 199);
}
