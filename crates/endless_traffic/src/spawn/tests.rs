use super::*;
use crate::{Focus, TrafficMap, View};
use endless_asset::Catalogue;
use endless_town::Town;
use endless_world::{ObjectClass, Pose, VehicleModelId, VehicleRef};
use glam::Vec3;
use std::collections::{BTreeMap, BTreeSet};

struct TestTown {
    catalogue: Catalogue,
    town: Town,
}

impl TestTown {
    fn new(name: &str) -> Self {
        let catalogue = Catalogue::builtin();
        let town = endless_town::load(name, &catalogue).expect("a town");
        Self { catalogue, town }
    }

    fn specs(&self) -> Vec<VehicleSpec> {
        self.catalogue.vehicle_specs()
    }

    fn roads(&self, focus: &Focus) -> Roads {
        Roads::new(&TrafficMap::new(self.town.network.clone(), &self.specs()), focus, &[])
    }
}

/// So many vehicles or people, evenly spread.
fn asked(number: u32, seed: u64) -> TrafficSettings {
    TrafficSettings { vehicles: number, pedestrians: number, seed, ..TrafficSettings::default() }
}

fn pedestrian(_: u64) -> PedestrianSpec {
    PedestrianSpec { walk_mps: 1.3, ..PedestrianSpec::default() }
}

fn at(vehicle: &Vehicle) -> DVec2 {
    vehicle.pose.position.as_dvec3().truncate()
}

#[test]
fn vehicles_begin_clear_of_parked_ones() {
    let place = TestTown::new("Town02");
    let (specs, roads) = (place.specs(), place.roads(&Focus::default()));
    let car = specs.iter().position(|s| s.parks).expect("something parks");
    // Parked so badly that every other spawn point is taken.
    let parked: Vec<ParkedVehicle> = roads
        .network
        .spawn_points
        .iter()
        .step_by(2)
        .map(|p| {
            let on = roads.network.lane(p.lane).centerline.at(p.s);
            let pose = Pose::level(on.position.as_vec3(), on.heading_rad as f32 + 0.4);
            ParkedVehicle { vehicle: VehicleRef { model: VehicleModelId::from_index(car), variant: 0 }, pose }
        })
        .collect();
    let print = |vehicle: VehicleRef, pose: &Pose| {
        let spec = &specs[vehicle.model.index()];
        OrientedRectangle::new(spec, pose.position.as_dvec3().truncate(), f64::from(pose.yaw_rad), 0.0)
    };
    let placed = vehicles(&roads, &specs, &standing(&specs, &parked), &asked(60, 3));
    assert!(placed.len() > 10, "{} vehicles", placed.len());
    for vehicle in &placed {
        let body = print(vehicle.asset, &vehicle.pose);
        assert!(parked.iter().all(|p| !body.overlaps(&print(p.vehicle, &p.pose))), "at {:.1}", at(vehicle));
    }
}

#[test]
fn a_design_more_changes_only_the_vehicles_that_it_takes_the_place_of() {
    let place = TestTown::new("Town06");
    let all = place.specs();
    for added in ["car.taxi", "van.panel"] {
        let fewer: Vec<VehicleSpec> = all.iter().filter(|s| s.name != added).cloned().collect();
        let [of_fewer, of_all] = [&fewer, &all].map(|specs| TrafficMap::new(place.town.network.clone(), specs));
        let spawn = |map: &TrafficMap, specs: &[VehicleSpec], seed| {
            vehicles(&Roads::new(map, &Focus::default(), &[]), specs, &[], &asked(25, seed))
        };
        let mut taken = 0;
        for seed in 0..6 {
            let (before, after) = (spawn(&of_fewer, &fewer, seed), spawn(&of_all, &all, seed));
            assert_eq!(before.len(), after.len());
            for (slot, (b, a)) in before.iter().zip(&after).enumerate() {
                let [b_spec, a_spec] = [(&fewer, b), (&all, a)].map(|(specs, v)| &specs[v.asset.model.index()]);
                if a_spec.name == added {
                    taken += 1;
                } else {
                    assert_eq!((b_spec.key(), b.asset.variant), (a_spec.key(), a.asset.variant), "slot {slot}");
                }
            }
        }
        assert!((1..40).contains(&taken), "{taken} of 150 are {added}");
    }
}

#[test]
fn looks_come_back_in_other_videos_and_never_twice_in_one() {
    let place = TestTown::new("Town05");
    let (specs, roads) = (place.specs(), place.roads(&Focus::default()));
    let graph = WalkGraph::new(&roads.network.walk);
    let mut seen: [BTreeMap<(usize, u64), usize>; 2] = Default::default();
    let mut drawn = [0, 0];
    for seed in 0..30 {
        let cars = vehicles(&roads, &specs, &[], &asked(60, seed));
        let people = walkers(&roads, &graph, &pedestrian, &asked(120, seed));
        let cars: Vec<_> = cars.iter().map(|v| (v.asset.model.index(), v.asset.variant)).collect();
        let people: Vec<_> = people.iter().map(|w| (0, w.variant)).collect();
        for ((looks, seen), drawn) in [cars, people].into_iter().zip(&mut seen).zip(&mut drawn) {
            let distinct: BTreeSet<_> = looks.iter().collect();
            assert_eq!(distinct.len(), looks.len(), "seed {seed}: twins");
            *drawn += looks.len();
            looks.into_iter().for_each(|look| *seen.entry(look).or_default() += 1);
        }
    }
    // Of n draws among m looks, m (1 − e^(−n/m)) are met: the pools are about as large as they say.
    for (seen, drawn) in seen.iter().zip(drawn) {
        let again = drawn - seen.len();
        assert!(again * 4 > drawn && seen.len() > 900, "{} looks in {drawn} draws", seen.len());
    }
}

#[test]
fn buses_and_lorries_are_as_frequent_as_in_the_catalogue_where_streets_have_several_lanes() {
    const SEEDS: u64 = 60;
    for name in ["Town05", "Town06", "Town10HD"] {
        let place = TestTown::new(name);
        let (specs, roads) = (place.specs(), place.roads(&Focus::default()));
        let total: f64 = specs.iter().map(|s| s.frequency).sum();
        let mut counts = [0.0; 2];
        for seed in 0..SEEDS {
            for vehicle in vehicles(&roads, &specs, &[], &asked(30, seed)) {
                counts[0] += f64::from(u8::from(vehicle.class == ObjectClass::Bus));
                counts[1] += f64::from(u8::from(vehicle.class == ObjectClass::Truck));
            }
        }
        for (count, class) in counts.into_iter().zip([ObjectClass::Bus, ObjectClass::Truck]) {
            let share: f64 = specs.iter().filter(|s| s.class == class).map(|s| s.frequency).sum::<f64>() / total;
            let expected = share * 30.0 * SEEDS as f64;
            assert!(count > 0.7 * expected && count < 1.4 * expected, "{name}: {count} of {expected:.0} {class}");
        }
    }
}

#[test]
fn vehicles_and_people_are_spread_over_the_map() {
    let place = TestTown::new("Town03");
    let (specs, roads) = (place.specs(), place.roads(&Focus::default()));
    let graph = WalkGraph::new(&roads.network.walk);
    let places = || roads.network.lanes.iter().flat_map(|l| l.centerline.points()).map(|p| p.truncate());
    let (low, high) = (places().fold(DVec2::INFINITY, DVec2::min), places().fold(DVec2::NEG_INFINITY, DVec2::max));
    for seed in 0..6 {
        let cars: Vec<DVec2> = vehicles(&roads, &specs, &[], &asked(30, seed)).iter().map(at).collect();
        let people: Vec<DVec2> =
            walkers(&roads, &graph, &pedestrian, &asked(30, seed)).iter().map(|w| w.position).collect();
        for points in [&cars, &people] {
            assert_eq!(points.len(), 30);
            // Each ninth of the map has its share, and nobody has a neighbour close by.
            let cell = |share: f64| (3.0 * share).clamp(0.0, 2.0) as usize;
            let mut counts = [0; 9];
            points.iter().map(|p| (*p - low) / (high - low)).for_each(|p| counts[3 * cell(p.y) + cell(p.x)] += 1);
            assert!(counts.iter().all(|&n| (1..=8).contains(&n)), "{counts:?}");
            let near = |p: &DVec2| points.iter().filter(|q| q != &p).map(|q| q.distance(*p)).fold(1e9, f64::min);
            let mean = points.iter().map(near).sum::<f64>() / 30.0;
            assert!(mean > 35.0, "{mean:.0} m to the nearest other");
        }
    }
}

#[test]
fn more_begin_near_the_places_looked_at() {
    let place = TestTown::new("Town04");
    let specs = place.specs();
    let focus: Vec<Vec3> = place.town.cameras.iter().take(2).map(|c| Vec3::from_array(c.position)).collect();
    let near = |looked_at: &[Vec3]| {
        let views: Vec<View> = looked_at.iter().map(|&at| View::around(at)).collect();
        let roads = place.roads(&Focus::new(&place.town.network, &views, 1.0, &|_, _| true));
        let graph = WalkGraph::new(&roads.network.walk);
        let mut count = [0, 0];
        for seed in 0..5 {
            let close = |p: DVec2| focus.iter().any(|f| f.as_dvec3().truncate().distance(p) < 150.0);
            let cars = vehicles(&roads, &specs, &[], &asked(30, seed));
            count[0] += cars.iter().filter(|v| close(at(v))).count();
            let close = |p: DVec2| focus.iter().any(|f| f.as_dvec3().truncate().distance(p) < 60.0);
            count[1] +=
                walkers(&roads, &graph, &pedestrian, &asked(20, seed)).iter().filter(|w| close(w.position)).count();
        }
        count
    };
    let (even, focused) = (near(&[]), near(&focus));
    assert!(focused[0] > even[0] * 5 / 4 && focused[1] > 2 * even[1], "{even:?} {focused:?}");
}

#[test]
fn vehicles_are_placed_after_a_class_of_which_none_can_be() {
    let place = TestTown::new("Town02");
    let (mut specs, roads) = (place.specs(), place.roads(&Focus::default()));
    let classes = |specs: &[VehicleSpec], first: &[ObjectClass]| -> Vec<ObjectClass> {
        let settings = TrafficSettings { first: first.to_vec(), ..asked(12, 5) };
        vehicles(&roads, specs, &[], &settings).iter().map(|v| v.class).collect()
    };
    let (bus, van) = (ObjectClass::Bus, ObjectClass::Van);
    // No bus drives here.
    specs.iter_mut().filter(|s| s.class == bus).for_each(|s| s.frequency = 0.0);
    let without = classes(&specs, &[van]);
    assert_eq!((without.len(), without[0]), (12, van));
    assert_eq!(classes(&specs, &[bus, van, bus]), without);
    // One that is too long for every lane finds no room.
    for s in specs.iter_mut().filter(|s| s.class == bus) {
        (s.frequency, s.length_m) = (1.0, 4000.0);
    }
    let crowded = classes(&specs, &[bus, van]);
    assert!(crowded.len() > 6 && crowded[0] == van, "{crowded:?}");
}
