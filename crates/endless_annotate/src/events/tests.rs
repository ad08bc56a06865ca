//! Small scenes whose relations and events are known.

use super::{Event, EventDetector, LaneCrossing, LaneFacts, Relation, RoadFacts, relations};
use endless_world::{
    Actor, Behaviour, InstanceId, LanePlace, Motion, ObjectClass, Outfit, PersonRef, Pose, SignalAspect, SignalId,
    SignalState, VehicleModelId, VehicleMotion, VehicleRef, WalkerMotion, WorldState,
};
use glam::{Vec2, Vec3};
use std::collections::BTreeMap;

const LIGHT: SignalId = SignalId(0);

/// A road to the east of 50 m with a crossing and a light at its end, and the road behind it.
fn road() -> RoadFacts {
    let crossing = LaneCrossing { crossing: 3, range_m: (44.0, 48.0) };
    let before = LaneFacts { length_m: 50.0, signal: Some(LIGHT), successors: vec![1], crossings: vec![crossing] };
    let after = LaneFacts { length_m: 80.0, ..LaneFacts::default() };
    let half_sizes = (1..10).map(|id| (InstanceId(id), Vec2::new(2.0, 0.9))).collect();
    RoadFacts { lanes: vec![before, after], half_sizes }
}

/// A car on a lane, whose place is that of the lanes one after the other.
fn car(id: u16, lane: u32, s_m: f32, speed_mps: f32) -> Actor {
    let x = s_m + if lane == 0 { 0.0 } else { 50.0 };
    Actor {
        id: InstanceId(id),
        rider_id: None,
        class: ObjectClass::Car,
        asset: VehicleRef { model: VehicleModelId(0), variant: 0 }.into(),
        pose: Pose::level(Vec3::new(x, 0.0, 0.0), 0.0),
        velocity_mps: Vec3::new(speed_mps, 0.0, 0.0),
        motion: Motion::Vehicle(VehicleMotion { speed_mps, ..VehicleMotion::default() }),
        behaviour: Behaviour { lane: Some(LanePlace { lane, s_m }), ..Behaviour::default() },
        parked: false,
    }
}

fn person(id: u16, at: Vec2, velocity: Vec2, crossing: Option<u16>) -> Actor {
    Actor {
        class: ObjectClass::Pedestrian,
        asset: PersonRef { outfit: Outfit::Fair, seed: 0 }.into(),
        pose: Pose::level(at.extend(0.0), 1.57),
        velocity_mps: velocity.extend(0.0),
        motion: Motion::Walker(WalkerMotion::default()),
        behaviour: Behaviour { crossing, ..Behaviour::default() },
        ..car(id, 0, 0.0, 0.0)
    }
}

fn state(frame: u32, aspect: SignalAspect, actors: Vec<Actor>) -> WorldState {
    WorldState { frame, time_s: 0.1 * f64::from(frame), actors, signals: vec![SignalState { aspect }] }
}

#[test]
fn a_queue_at_a_light_and_somebody_on_the_crossing() {
    let actors = vec![
        car(1, 0, 41.0, 0.0),
        car(2, 0, 34.0, 0.0),
        Actor { rider_id: Some(InstanceId(8)), ..car(3, 1, 20.0, 9.0) },
        person(5, Vec2::new(46.0, 1.0), Vec2::Y, Some(3)),
    ];
    let [one, two, three, five] = [1, 2, 3, 5].map(InstanceId);
    let found = relations(&state(0, SignalAspect::Red, actors), &road());
    let expected = [
        Relation::Follows { id: one, leader: three, gap_m: 25.0 },
        Relation::WaitsAt { id: one, signal: LIGHT },
        Relation::YieldsTo { id: one, person: five, crossing: 3 },
        Relation::Follows { id: two, leader: one, gap_m: 3.0 },
        Relation::WaitsAt { id: two, signal: LIGHT },
        Relation::Rides { id: InstanceId(8), vehicle: three },
        Relation::Crosses { id: five, crossing: 3 },
    ];
    assert_eq!(found, expected);
    let text = serde_json::to_string(&found[0]).expect("plain data");
    assert_eq!(text, r#"{"kind":"follows","id":1,"leader":3,"gap_m":25.0}"#);
}

/// Events of states one after the other.
fn events(states: impl IntoIterator<Item = WorldState>) -> Vec<Event> {
    let mut detector = EventDetector::new(road());
    states.into_iter().flat_map(|state| detector.observe(&state)).collect()
}

#[test]
fn stopping_braking_and_passing_a_light() {
    let id = InstanceId(1);
    let braking = |speed: f32, acceleration_mps2: f32| {
        let car = car(1, 0, 30.0, speed);
        Actor { behaviour: Behaviour { acceleration_mps2, ..car.behaviour }, ..car }
    };
    let states = [(8.0, 0.0), (7.0, -5.0), (3.0, -5.5), (0.5, -2.0), (0.0, 0.0), (0.05, 0.1), (0.0, 0.0)];
    let states = (0..).zip(states).map(|(i, (speed, a))| state(i, SignalAspect::Red, vec![braking(speed, a)]));
    assert_eq!(
        events(states),
        [Event::HardBraking { id, acceleration_mps2: -5.0 }, Event::Stop { id }],
        "each is told once"
    );
    for (aspect, ran) in [(SignalAspect::Red, true), (SignalAspect::Yellow, false), (SignalAspect::Green, false)] {
        let passes = vec![state(0, aspect, vec![car(1, 0, 49.5, 9.0)]), state(1, aspect, vec![car(1, 1, 0.4, 9.0)])];
        let expected = if ran { vec![Event::RedLightRun { id, signal: LIGHT }] } else { Vec::new() };
        assert_eq!(events(passes), expected);
    }
}

#[test]
fn a_lane_change_is_told_when_it_begins() {
    let changing = |lane_left: Option<u32>| {
        let car = car(1, 1, 20.0, 9.0);
        Actor { behaviour: Behaviour { lane_left, ..car.behaviour }, ..car }
    };
    let states = [None, Some(0), Some(0), None].into_iter().zip(0..);
    let states = states.map(|(left, i)| state(i, SignalAspect::Green, vec![changing(left)]));
    assert_eq!(events(states), [Event::LaneChange { id: InstanceId(1), from: 0, to: 1 }]);
}

#[test]
fn two_that_nearly_touch_and_two_that_do() {
    let ids = [1, 5].map(InstanceId);
    // The car comes nearer to who stands on the road, and brakes at the last moment.
    let at = |i: u32, x: f32, speed: f32| {
        state(i, SignalAspect::Green, vec![car(1, 0, x, speed), person(5, Vec2::new(40.0, 0.0), Vec2::ZERO, None)])
    };
    let near = vec![at(0, 15.0, 10.0), at(1, 16.0, 10.0), at(2, 25.0, 10.0), at(3, 26.0, 8.0), at(4, 27.0, 0.0)];
    let found = events(near);
    // 25 m on, half a car and half a person away.
    assert_eq!(found[0], Event::NearMiss { ids, time_to_collision_s: 1.21 });
    assert_eq!(found[1..], [Event::Stop { id: ids[0] }]);
    let hit = events(vec![at(0, 30.0, 0.9), at(1, 38.0, 0.9), at(2, 39.0, 0.9)]);
    assert_eq!(hit, [Event::Collision { ids }]);
}

#[test]
fn a_car_comes_to_where_somebody_has_just_been() {
    // Somebody runs over the road at x = 40, and the car is there a second later.
    let at = |i: u32| {
        let y = -6.0 + i as f32;
        let walker = person(5, Vec2::new(40.0, y), Vec2::new(0.0, 10.0), None);
        state(i, SignalAspect::Green, vec![car(1, 0, 20.0 + i as f32, 10.0), walker])
    };
    let found: Vec<Event> =
        events((0..24).map(at)).into_iter().filter(|e| matches!(e, Event::Encroachment { .. })).collect();
    let [Event::Encroachment { ids, post_encroachment_s }] = found[..] else { panic!("{found:?}") };
    assert_eq!(ids, [InstanceId(5), InstanceId(1)]);
    assert!((0.2..1.5).contains(&post_encroachment_s), "{post_encroachment_s}");
    let unused: BTreeMap<InstanceId, Vec2> = BTreeMap::new();
    let mut blind = EventDetector::new(RoadFacts { half_sizes: unused, ..road() });
    assert!((0..24).flat_map(|i| blind.observe(&at(i))).next().is_none(), "without sizes there are no conflicts");
}
