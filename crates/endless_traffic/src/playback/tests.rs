use super::*;
use crate::{DrivingCondition, Fleet, Simulation, TrafficMap, TrafficSettings};
use endless_road::{Lane, LaneId, Polyline};
use endless_world::{TrackPoint, TrackSample, VehicleLights};
use glam::DVec3;
use std::f64::consts::FRAC_PI_2;

/// One lane to the east, 400 m long, which rises by a metre every fifty.
fn road() -> RoadNetwork {
    let line = Polyline::new([DVec3::ZERO, DVec3::new(400.0, 0.0, 8.0)]);
    let lanes = vec![Lane::new(LaneId(0), line, 3.5, 13.9)];
    RoadNetwork { lanes, ..RoadNetwork::default() }.finish().expect("a road")
}

fn car() -> VehicleSpec {
    VehicleSpec::default()
}

fn bicycle() -> VehicleSpec {
    VehicleSpec { name: "bicycle.city", class: ObjectClass::Bicycle, length_m: 1.8, ridden: true, ..car() }
}

fn track(name: &str, class: ObjectClass, samples: impl IntoIterator<Item = (f64, f64, f64, f64)>) -> Track {
    let sample = |(time_s, x, y, yaw_rad)| TrackSample {
        time_s,
        position: DVec2::new(x, y),
        height_m: None,
        yaw_rad,
        speed_mps: None,
    };
    Track {
        name: name.into(),
        kind: "any".into(),
        class,
        length_m: None,
        point: TrackPoint::Front,
        pieces: vec![samples.into_iter().map(sample).collect()],
    }
}

const PLAYBACK: TrackPlayback = TrackPlayback { begin_s: 100.0, offset_m: [0.0, 0.0], seed: 7 };

fn simulation(tracks: &[Track], playback: TrackPlayback, fps: f64) -> Simulation {
    let specs = [car(), bicycle()];
    let fleet = Fleet { vehicles: &specs, pedestrian: &|_| PedestrianSpec::default() };
    let settings = TrafficSettings {
        vehicles: 0,
        pedestrians: 0,
        fps,
        condition: DrivingCondition { headlights_on: 1.0, ..DrivingCondition::default() },
        ..TrafficSettings::default()
    };
    let played = PlayedTracks { tracks, playback, duration_s: 10.0 };
    Simulation::playing(&TrafficMap::new(road(), &specs), &fleet, &[], &settings, Some(&played)).expect("few")
}

/// From 100 s on to the east at 10 m/s, then braking at 2 m/s² until it stands.
fn braking() -> Track {
    let at = |t: f64| if t < 3.0 { 50.0 + 10.0 * t } else { 80.0 + 10.0 * (t - 3.0) - (t - 3.0) * (t - 3.0) };
    track("car", ObjectClass::Car, (0..=80).map(|k| 0.1 * f64::from(k)).map(|t| (100.0 + t, at(t), 0.0, 0.0)))
}

#[test]
fn a_vehicle_is_where_its_track_says_in_every_frame() {
    for fps in [10.0, 7.0, 30.0] {
        let mut simulation = simulation(&[braking()], PLAYBACK, fps);
        assert_eq!(simulation.population().vehicles_spawned, 1);
        for frame in 0..(8.0 * fps) as u32 {
            let state = simulation.state();
            let [actor] = &state.actors[..] else { panic!("frame {frame}: {} actors", state.actors.len()) };
            let t = f64::from(frame) / fps;
            let at = |t: f64| if t < 3.0 { 50.0 + 10.0 * t } else { 80.0 + 10.0 * (t - 3.0) - (t - 3.0) * (t - 3.0) };
            let front = f64::from(actor.pose.position.x) + 0.5 * f64::from(car().length_m);
            assert!((front - at(t)).abs() < 0.01, "frame {frame} at {fps}: {front} not {}", at(t));
            assert!((actor.pose.position.z - 0.02 * actor.pose.position.x).abs() < 0.01, "on the road");
            assert!((actor.pose.pitch_rad - 0.02).abs() < 1e-3);
            let Motion::Vehicle(motion) = actor.motion else { panic!("a vehicle") };
            if (0.5..2.5).contains(&t) {
                assert!((motion.speed_mps - 10.0).abs() < 0.01 && !motion.lights.contains(VehicleLights::BRAKE));
                assert!((f64::from(motion.rolled_m) - 10.0 * t).abs() < 0.01 && motion.steer_rad.abs() < 1e-4);
            }
            if (3.5..7.8).contains(&t) {
                assert!((actor.behaviour.acceleration_mps2 + 2.0).abs() < 0.05, "{:?}", actor.behaviour);
                assert!(motion.lights.contains(VehicleLights::BRAKE | VehicleLights::LOW_BEAM));
            }
            assert_eq!(actor.behaviour.lane.map(|place| place.lane), Some(0));
            simulation.tick();
        }
    }
}

#[test]
fn who_turns_indicates_and_leans() {
    // To the east, then a bend of 90 degrees to the left with a radius of 12 m, at 6 m/s.
    let at = |t: f64| {
        let angle = ((6.0 * t - 30.0) / 12.0).clamp(0.0, FRAC_PI_2);
        let (sin, cos) = endless_world::math::f64::sin_cos(angle);
        let beyond = (6.0 * t - 30.0 - 12.0 * FRAC_PI_2).max(0.0);
        let along = (6.0 * t).min(30.0);
        (100.0 + t, 20.0 + along + 12.0 * sin, 12.0 * (1.0 - cos) + beyond, angle)
    };
    let tracks = [ObjectClass::Car, ObjectClass::Bicycle]
        .map(|class| track(class.name(), class, (0..=100).map(|k| at(0.1 * f64::from(k)))));
    let mut simulation = simulation(&tracks, PLAYBACK, 10.0);
    for frame in 0..80 {
        let state = simulation.state();
        let [car, bicycle] = &state.actors[..] else { panic!("frame {frame}: {} actors", state.actors.len()) };
        assert_eq!((bicycle.rider_id, car.rider_id), (Some(InstanceId(3)), None));
        let [Motion::Vehicle(motion), Motion::Vehicle(leaning)] = [car.motion, bicycle.motion] else {
            panic!("vehicles")
        };
        if !(15..=75).contains(&frame) {
            assert_eq!(car.behaviour.indicating, None, "frame {frame}");
        } else if (30..60).contains(&frame) {
            assert_eq!(car.behaviour.indicating, Some(endless_world::Side::Left), "frame {frame}");
        }
        if (60..68).contains(&frame) {
            assert!((motion.steer_rad - 0.213).abs() < 0.02, "frame {frame}: {}", motion.steer_rad);
            assert!(bicycle.pose.roll_rad < -0.2, "to the inside: {}", bicycle.pose.roll_rad);
            assert!(!leaning.lights.intersects(VehicleLights::LEFT_BLINKER | VehicleLights::BRAKE));
        }
        simulation.tick();
    }
}

#[test]
fn people_walk_and_come_and_go_as_the_file_says() {
    let walk = track(
        "p",
        ObjectClass::Pedestrian,
        (0..=20).map(|k| {
            let t = 0.1 * f64::from(k);
            (101.0 + t, 30.0 + 1.3 * t, 3.0, 0.0)
        }),
    );
    let early = track("gone", ObjectClass::Car, [(10.0, 0.0, 0.0, 0.0), (99.0, 0.0, 0.0, 0.0)]);
    let mut simulation = simulation(&[early, walk], PLAYBACK, 10.0);
    assert_eq!((simulation.population().vehicles_spawned, simulation.population().pedestrians_spawned), (0, 1));
    assert_eq!(simulation.track_names().collect::<Vec<_>>(), [(InstanceId(1), "p")]);
    let mut walked = 0.0;
    for frame in 0..40 {
        let state = simulation.state();
        assert_eq!(state.actors.len(), usize::from((10..=30).contains(&frame)), "frame {frame}");
        if let [person] = &state.actors[..] {
            let Motion::Walker(motion) = person.motion else { panic!("a person") };
            assert!((motion.speed_mps - 1.3).abs() < 0.01 && (person.velocity_mps.x - 1.3).abs() < 0.01);
            walked = motion.walked_m;
        }
        simulation.tick();
    }
    assert!((walked - 2.6).abs() < 0.05, "{walked} m");
}

#[test]
fn an_offset_moves_all_and_who_is_off_the_map_is_told_of() {
    let far = track("far", ObjectClass::Car, [(100.0, 60.0, 50.0, 0.0), (105.0, 60.0, 5.0, 0.0)]);
    let tracks = [braking(), far];
    let moved: Vec<Track> = tracks
        .iter()
        .map(|track| {
            let mut track = track.clone();
            track.pieces.iter_mut().flatten().for_each(|sample| sample.position += DVec2::new(340.0, -261.5));
            track
        })
        .collect();
    let offset = TrackPlayback { offset_m: [340.0, -261.5], ..PLAYBACK };
    let [a, b] = [(&tracks[..], PLAYBACK), (&moved[..], offset)]
        .map(|(tracks, playback)| simulation(tracks, playback, 10.0).state());
    assert_eq!(a.actors.len(), 1, "the other is off the map");
    assert!((a.actors[0].pose.position - b.actors[0].pose.position).length() < 1e-3);
    let fit = |tracks: &[Track], playback| PlayedTracks { tracks, playback, duration_s: 10.0 }.fit(&road());
    let well = fit(&moved, offset);
    assert_eq!((well.tracks, well.leave, well.any_on_map), (2, vec!["far".to_owned()], true));
    assert!(!fit(&moved, PLAYBACK).any_on_map);
}

#[test]
fn simulated_drivers_keep_behind_those_who_play_tracks() {
    // A ring of which half is taken by somebody who creeps.
    let half = |begin: u32| {
        Polyline::new((begin..=begin + 180).map(|i| {
            let (sin, cos) = endless_world::math::f64::sin_cos(f64::from(i).to_radians());
            DVec3::new(60.0 * cos, 60.0 * sin, 0.0)
        }))
    };
    let lane = |id: u32, begin: u32, next: u32| Lane {
        successors: vec![LaneId(next)],
        ..Lane::new(LaneId(id), half(begin), 3.5, 13.9)
    };
    let network = RoadNetwork { lanes: vec![lane(0, 0, 1), lane(1, 180, 0)], ..RoadNetwork::default() };
    let network = network.finish().expect("a ring");
    let creeps = track(
        "slow",
        ObjectClass::Car,
        (0..=700).map(|k| {
            let angle = 0.1 * f64::from(k) * 1.5 / 60.0;
            let (sin, cos) = endless_world::math::f64::sin_cos(angle);
            (60.0 + 0.1 * f64::from(k), 60.0 * cos, 60.0 * sin, angle + FRAC_PI_2)
        }),
    );
    let specs = [car()];
    let fleet = Fleet { vehicles: &specs, pedestrian: &|_| PedestrianSpec::default() };
    let settings = TrafficSettings { vehicles: 4, pedestrians: 0, ..TrafficSettings::default() };
    let tracks = [creeps];
    let played = PlayedTracks { tracks: &tracks, playback: PLAYBACK, duration_s: 20.0 };
    let mut simulation =
        Simulation::playing(&TrafficMap::new(network, &specs), &fleet, &[], &settings, Some(&played)).expect("few");
    for frame in 0..200 {
        let state = simulation.state();
        let (slow, others) = state.actors.split_last().expect("all");
        assert_eq!(others.len(), 4);
        for other in others {
            let apart = other.pose.position.distance(slow.pose.position);
            assert!(apart > 4.2, "frame {frame}: {apart} m apart");
        }
        simulation.tick();
    }
}
