//! Sensors of vehicle events that real traffic carries: nobody collides, and who changes lanes crosses paint.

use endless_annotate::{BodySize, CollisionSensor, LaneInvasionSensor, MarkAttributes, MarkFeature, PaintColor};
use endless_asset::Catalogue;
use endless_road::MarkingColor;
use endless_town::Town;
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::{Actor, InstanceId, Motion};
use glam::Vec2;
use std::collections::BTreeMap;

const FPS: f64 = 10.0;
const SECONDS: u32 = 180;

fn marks(town: &Town) -> Vec<MarkFeature> {
    let feature = |(id, mark): (u32, &endless_town::PaintedMark)| MarkFeature {
        attributes: MarkAttributes {
            id,
            broken: mark.broken,
            color: if mark.color == MarkingColor::White { PaintColor::White } else { PaintColor::Yellow },
            width_m: mark.width_m,
        },
        pieces: mark.pieces.clone(),
    };
    (0..).zip(&town.streets.marks).map(feature).collect()
}

#[test]
fn lane_changes_cross_paint_and_nobody_collides() {
    let catalogue = Catalogue::builtin();
    let town = endless_town::load("Town05", &catalogue).expect("a town");
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let settings = TrafficSettings { vehicles: 120, pedestrians: 10, seed: 5, fps: FPS, ..TrafficSettings::default() };
    let mut simulation = Simulation::new(&town.network, &fleet, &town.parked, &settings).expect("few enough");
    let size = |actor: &Actor| match actor.asset.vehicle() {
        Some(vehicle) => BodySize::of(&specs[vehicle.model.index()]),
        None => BodySize::rigid(Vec2::new(0.2, 0.25)),
    };
    let (parked, everybody) = (simulation.parked().to_vec(), simulation.everybody(0, |_| settings.condition));
    let sizes: BTreeMap<InstanceId, BodySize> =
        parked.iter().chain(&everybody).map(|actor| (actor.id, size(actor))).collect();
    let marks = marks(&town);
    let vehicles: Vec<&Actor> = everybody.iter().filter(|actor| matches!(actor.motion, Motion::Vehicle(_))).collect();
    let mut sensors: Vec<_> = vehicles
        .iter()
        .map(|actor| {
            let collisions = CollisionSensor::new(actor.id, sizes.clone(), parked.clone());
            (actor.id, collisions, LaneInvasionSensor::new(actor.id, size(actor), &marks))
        })
        .collect();
    // Frames in which a vehicle changes lanes, and in which it comes over paint.
    let mut changes: BTreeMap<InstanceId, Vec<u32>> = BTreeMap::new();
    let mut invasions: BTreeMap<InstanceId, Vec<u32>> = BTreeMap::new();
    let mut collisions = Vec::new();
    for _ in 0..SECONDS * FPS as u32 {
        simulation.tick();
        let state = simulation.state();
        for actor in state.actors.iter().filter(|actor| actor.behaviour.lane_left.is_some()) {
            changes.entry(actor.id).or_default().push(state.frame);
        }
        for (id, collision, invasion) in &mut sensors {
            collisions.extend(collision.observe(&state));
            invasions.entry(*id).or_default().extend(invasion.observe(&state).map(|event| event.frame));
        }
    }
    let (mut whole, mut seen) = (0, 0);
    for (id, frames) in &changes {
        // Those that end in the last frame may not be over.
        let over = |change: &&[u32]| change.last().is_some_and(|last| last + 1 < SECONDS * FPS as u32);
        for change in frames.chunk_by(|a, b| b - a == 1).filter(over) {
            whole += 1;
            seen += usize::from(invasions[id].iter().any(|frame| change.contains(frame)));
        }
    }
    assert!(whole > 10 && seen * 10 >= whole * 9, "{seen} of {whole} lane changes were told");
    assert_eq!(collisions, [], "nobody touches anybody");
}
