//! People who walk together.

use crate::watch::watch;
use endless_asset::Catalogue;
use endless_town::Town;
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::{Actor, Gait, Motion};
use glam::Vec3;

const FPS: f64 = 30.0;

fn simulation(catalogue: &Catalogue, town: &Town, groups: f64) -> Simulation {
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let settings =
        TrafficSettings { vehicles: 30, pedestrians: 60, seed: 1, fps: FPS, groups, ..TrafficSettings::default() };
    Simulation::new(&town.network, &fleet, &town.parked, &settings).expect("few enough")
}

fn people(traffic: &Simulation) -> Vec<Actor> {
    let walks = |actor: &Actor| matches!(actor.motion, Motion::Walker(_));
    traffic.state().actors.into_iter().filter(walks).collect()
}

/// Share of people with somebody within two metres.
fn accompanied(people: &[Actor]) -> f64 {
    let near = |one: &&Actor| {
        let others = people.iter().filter(|other| other.id != one.id);
        others.map(|other| other.pose.position.distance(one.pose.position)).fold(f32::INFINITY, f32::min) < 2.0
    };
    people.iter().filter(near).count() as f64 / people.len() as f64
}

#[test]
fn groups_stay_together_over_crossings_and_nobody_is_touched() {
    let catalogue = Catalogue::builtin();
    for name in ["Town02", "Town10HD", "Altstadt"] {
        let town = endless_town::load(name, &catalogue).expect("a town");
        let mean = |groups: f64| {
            let mut traffic = simulation(&catalogue, &town, groups);
            let mut sum = 0.0;
            let report = watch(&mut traffic.clone(), &town.network, &catalogue.vehicle_specs(), 120.0, FPS);
            assert!(report.passed(), "{name}: {report}");
            for _ in 0..30 {
                (0..120).for_each(|_| traffic.tick());
                sum += accompanied(&people(&traffic)) / 30.0;
            }
            sum
        };
        let (alone, half, all) = (mean(0.0), mean(0.5), mean(1.0));
        assert!(alone < 0.4 && half > alone + 0.15 && all > 0.75, "{name}: {alone:.2} {half:.2} {all:.2}");
    }
}

#[test]
fn groups_stand_and_talk_and_children_come_with_grown_ups() {
    let catalogue = Catalogue::builtin();
    let town = endless_town::load("Town10HD", &catalogue).expect("a town");
    let mut traffic = simulation(&catalogue, &town, 0.8);
    let height =
        |actor: &Actor| actor.asset.person().map_or(0.0, |person| Catalogue::pedestrian_spec(person.seed).height_m);
    let is_child = |actor: &Actor| height(actor) < 1.4;
    let talks = |actor: &&Actor| matches!(actor.motion, Motion::Walker(motion) if motion.gait == Gait::Talk);
    let (mut talking, mut seen, mut alone) = (0, 0, 0);
    for _ in 0..120 {
        (0..30).for_each(|_| traffic.tick());
        let people = people(&traffic);
        talking += people.iter().filter(talks).count();
        let position = |actor: &Actor| -> Vec3 { actor.pose.position };
        for child in people.iter().filter(|actor| is_child(actor)) {
            let near = |other: &Actor| !is_child(other) && position(other).distance(position(child)) < 12.0;
            seen += 1;
            alone += usize::from(!people.iter().any(near));
        }
    }
    assert!(talking > 20, "{talking} seconds of talk in two minutes");
    // Where the light changes between them, one waits for the other across the road.
    assert!(seen > 240 && alone * 25 < seen, "children are alone in {alone} of {seen} seconds");
}
