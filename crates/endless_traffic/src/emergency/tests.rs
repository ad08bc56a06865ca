use super::*;
use crate::driver::Driver;
use crate::focus::Focus;
use crate::occupancy::Occupancy;
use crate::roads::TrafficMap;
use crate::settings::DrivingCondition;
use endless_asset::Catalogue;
use endless_road::{Lane, Polyline, RoadNetwork};
use endless_world::{VehicleModelId, VehicleRef, VehicleSpec};
use glam::DVec3;

/// A street of two lanes, the left one first.
fn street(specs: &[VehicleSpec]) -> Roads {
    let lane = |id: u32, y: f64| {
        let line = Polyline::new([DVec3::new(0.0, y, 0.0), DVec3::new(300.0, y, 0.0)]);
        Lane::new(LaneId(id), line, 3.5, 13.9)
    };
    let mut lanes = vec![lane(0, 3.5), lane(1, 0.0)];
    (lanes[0].right, lanes[1].left) = (Some(LaneId(1)), Some(LaneId(0)));
    let network = RoadNetwork { lanes, ..RoadNetwork::default() }.finish().expect("a street");
    Roads::new(&TrafficMap::new(network, specs), &Focus::default(), &[])
}

fn vehicle(roads: &Roads, lane: u32, s: f64, on_call: bool) -> Vehicle {
    let mut stream = Stream::named(1, "test.emergency", &[]);
    let spec = &roads.specs[0];
    let driver = Driver::new(spec, &DrivingCondition::default(), 0.5, &mut stream);
    let asset = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
    let mut vehicle = Vehicle::new(spec, asset, driver, LaneId(lane), s, stream);
    vehicle.on_call = on_call;
    vehicle.plan(roads);
    vehicle
}

#[test]
fn those_with_beacons_are_the_catalogue_s_emergency_vehicles() {
    let catalogue = Catalogue::builtin();
    let has_beacons = |name: &str| ["police", "ambulance", "fire"].iter().any(|what| name.contains(what));
    let specs = catalogue.vehicle_specs();
    assert!(specs.iter().all(|spec| is_emergency(spec.name) == has_beacons(spec.name)));
    assert!(DESIGNS.iter().all(|design| specs.iter().any(|spec| spec.name == *design)));
}

#[test]
fn both_halves_of_a_beacon_flash_in_turn_on_call_alone() {
    let roads = street(&[VehicleSpec::default()]);
    let police = vehicle(&roads, 0, 50.0, true);
    let lit = [0.0, 0.25, 0.5].map(|time_s| beacons(&police, 0.1, time_s));
    assert_eq!(lit, [VehicleLights::SPECIAL1, VehicleLights::SPECIAL2, VehicleLights::SPECIAL1]);
    assert!(beacons(&vehicle(&roads, 0, 50.0, false), 0.1, 0.0).is_empty());
}

#[test]
fn who_has_one_on_call_behind_moves_over_and_nobody_moves_before_it() {
    let roads = street(&[VehicleSpec::default()]);
    let vehicles = [vehicle(&roads, 1, 50.0, true), vehicle(&roads, 1, 90.0, false), vehicle(&roads, 0, 90.0, false)];
    let mut occupancy = Occupancy::default();
    occupancy.rebuild(&roads, &vehicles);
    let worth = |i: usize, target: u32, s: f64| incentive(&occupancy.coming, &vehicles[i], LaneId(target), s);
    assert_eq!(worth(1, 0, 90.0), Some(LETS_PASS_MPS2));
    assert_eq!(worth(2, 1, 90.0), None);
    assert_eq!(worth(2, 1, 40.0), Some(0.0), "behind it");
    assert_eq!(worth(0, 0, 50.0), Some(0.0), "it goes where it likes");
    assert!(gives_up_turn(&vehicles[1], &vehicles[0], 1.0) && !gives_up_turn(&vehicles[1], &vehicles[0], 20.0));
    assert!(!gives_up_turn(&vehicles[0], &vehicles[0], 1.0));
}
