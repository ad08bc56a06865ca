//! Relations and events in the traffic of built-in towns, which knows how to drive.

use crate::city::{city, town as shared};
use endless_annotate::{CountingLine, Event, Happenings, Relation, SceneObserver};
use endless_pipeline::{MapCatalog, Simulator};
use endless_world::{
    ActorDensity, CameraLook, ImageSize, SceneCamera, SceneSettings, SensorLayers, TimeOfDay, TrafficProfile, Weather,
    WorldState,
};
use glam::Vec3Swizzles as _;
use std::collections::BTreeSet;

/// Half a minute of a town's traffic, seen ten times a second.
fn watch(town: &'static str, mut see: impl FnMut(&WorldState, &Happenings)) {
    const FPS: f64 = 10.0;
    let sites = city().cameras(town).expect("a town");
    let settings = SceneSettings {
        video: 0,
        map: town.to_owned(),
        town_seed: None,
        drawn_sites: false,
        weather: Weather::Cloudy,
        time_of_day: TimeOfDay::Afternoon,
        sun_elevation_deg: None,
        changing_to: None,
        sensors: Vec::new(),
        cameras: vec![SceneCamera { site: sites[0].clone(), look: CameraLook::CLEAN }],
        vehicles: 60,
        pedestrians: 60,
        density: ActorDensity::default(),
        focus: 0.8,
        profile: TrafficProfile::default(),
        jaywalking: 0.0,
        groups: 0.0,
        events: Vec::new(),
        size: ImageSize { width: 64, height: 36 },
        fps: FPS,
        frames: 300,
        seed: 7,
        randomised: None,
        playback: None,
    };
    let mut session = city().open_session(shared(town), &settings, SensorLayers::default()).expect("a scene");
    let [x, y, _] = sites[0].position.map(f64::from);
    let line =
        |name: &str, from: [f64; 2], to: [f64; 2]| CountingLine { map: town.into(), name: name.into(), from, to };
    let lines = vec![
        line("west to east", [x - 3000.0, y], [x + 3000.0, y]),
        line("south to north", [x, y - 300.0], [x, y + 300.0]),
    ];
    let mut observer = SceneObserver::new(session.road_facts(), lines);
    for _ in 0..settings.frames {
        let state = session.tick().expect("a frame").state;
        let happenings = observer.observe(&state);
        see(&state, &happenings);
    }
}

#[test]
fn traffic_that_knows_how_to_drive_hits_nobody_and_passes_no_red_light() {
    let mut all_kinds = BTreeSet::new();
    for town in ["Town03", "Altstadt"] {
        let (mut stops, mut changes, mut near, mut passed) = (0, 0, 0, 0);
        let mut kinds = BTreeSet::new();
        watch(town, |state, happenings| {
            for event in &happenings.events {
                match event {
                    Event::Stop { .. } => stops += 1,
                    Event::LaneChange { from, to, .. } => {
                        assert_ne!(from, to);
                        changes += 1;
                    }
                    Event::NearMiss { .. } | Event::Encroachment { .. } => near += 1,
                    Event::HardBraking { .. } => {}
                    Event::RedLightRun { .. } | Event::Collision { .. } => {
                        panic!("{town}, frame {}: {event:?}", state.frame);
                    }
                }
            }
            for relation in &happenings.relations {
                let kind = match relation {
                    Relation::Rides { .. } => "rides",
                    Relation::Follows { gap_m, .. } => {
                        assert!(*gap_m > -0.5, "{town}, frame {}: {relation:?}", state.frame);
                        "follows"
                    }
                    Relation::WaitsAt { .. } => "waits at",
                    Relation::Crosses { .. } => "crosses",
                    Relation::YieldsTo { .. } => "yields to",
                };
                kinds.insert(kind);
            }
            let counts = happenings.counting_lines.iter().flat_map(|line| [&line.to_left, &line.to_right]);
            passed = counts.flat_map(|counts| counts.values()).sum::<u32>();
        });
        println!(
            "{town}: {stops} stops, {changes} lane changes, {near} near misses, {passed} passed a line; {kinds:?}"
        );
        assert!(stops > 5 && passed > 5, "{town}: {stops} stops, {passed} passed a line");
        all_kinds.extend(kinds);
    }
    assert_eq!(all_kinds.len(), 5, "{all_kinds:?}");
}

#[test]
fn what_is_counted_is_what_changes_sides() {
    let mut sides: Vec<(u16, bool)> = Vec::new();
    let mut before = 0;
    let line_y = std::cell::Cell::new(0.0);
    watch("Altstadt", |state, happenings| {
        if state.frame == 0 {
            line_y.set(city().cameras("Altstadt").expect("a town")[0].position[1]);
        }
        let counts = &happenings.counting_lines[0];
        let now: u32 = counts.to_left.values().chain(counts.to_right.values()).sum();
        let places: Vec<(u16, bool)> =
            state.actors.iter().map(|actor| (actor.id.0, actor.pose.position.xy().y >= line_y.get())).collect();
        // The line is longer than the town, so whoever changes sides passes it.
        let changed = sides.iter().zip(&places).filter(|(was, is)| was.1 != is.1).count() as u32;
        assert_eq!(now - before, changed, "frame {}", state.frame);
        (sides, before) = (places, now);
    });
    assert!(before > 5, "{before} passed");
}
