use super::*;
use crate::driver::Driver;
use crate::focus::Focus;
use crate::incident::Drift;
use crate::occupancy::Occupancy;
use crate::roads::Roads;
use crate::roads::TrafficMap;
use crate::settings::DrivingCondition;
use crate::vehicle::{LaneChange, RightOfWay};
use endless_road::swept::OrientedRectangle;
use endless_road::{Junction, JunctionId, Lane, LaneId, Polyline, RoadNetwork, TrafficControl};
use endless_world::{
    ObjectClass, Region, Side, SignalAspect, SignalId, SignalState, Stream, VehicleModelId, VehicleRef, VehicleSpec,
};
use glam::{DVec2, DVec3};

/// A line 200 m ahead, and a lane over the junction beyond for each lane before it.
const LINE_M: f64 = 200.0;

fn spec(class: ObjectClass, [length_m, width_m]: [f32; 2]) -> VehicleSpec {
    let (front_axle_m, rear_axle_m) = (0.3 * length_m, -0.3 * length_m);
    VehicleSpec { class, length_m, width_m, front_axle_m, rear_axle_m, ..VehicleSpec::default() }
}

/// Motorcycle, car, bus.
fn specs() -> Vec<VehicleSpec> {
    vec![
        spec(ObjectClass::Motorcycle, [2.0, 0.8]),
        spec(ObjectClass::Car, [4.4, 1.8]),
        spec(ObjectClass::Bus, [12.0, 2.55]),
    ]
}

/// Lanes of this width, the left one first, each with a light of its own.
fn street(lanes: u32, width_m: f64) -> Roads {
    let line = |from: f64, to: f64, y: f64| Polyline::new([DVec3::new(from, y, 0.0), DVec3::new(to, y, 0.0)]);
    let mut network = RoadNetwork { signal_groups: lanes as u16, ..RoadNetwork::default() };
    for k in 0..lanes {
        let y = -f64::from(k) * width_m;
        let mut before = Lane::new(LaneId(k), line(0.0, LINE_M, y), width_m, 13.9);
        before.left = k.checked_sub(1).map(LaneId);
        before.right = (k + 1 < lanes).then_some(LaneId(k + 1));
        before.end_control = TrafficControl::Signal(SignalId(k as u16));
        before.successors = vec![LaneId(lanes + k)];
        network.lanes.push(before);
    }
    for (pieces, from) in [(1, LINE_M), (2, LINE_M + 30.0)] {
        for k in 0..lanes {
            let y = -f64::from(k) * width_m;
            let mut lane = Lane::new(LaneId(pieces * lanes + k), line(from, from + 30.0, y), width_m, 13.9);
            lane.junction = (pieces == 1).then_some(JunctionId(0));
            lane.successors = if pieces == 1 { vec![LaneId(2 * lanes + k)] } else { Vec::new() };
            network.lanes.push(lane);
        }
    }
    let inside = (lanes..2 * lanes).map(LaneId).collect();
    network.junctions.push(Junction { lanes: inside, ..Junction::default() });
    let network = network.finish().expect("a street");
    Roads::new(&TrafficMap::new(network, &specs()), &Focus::default(), &[])
}

fn vehicle(roads: &Roads, model: usize, lane: u32, s: f64, speed: f64) -> Vehicle {
    let mut stream = Stream::named(1, "test.filtering", &[lane.into(), s as u64]);
    let spec = &specs()[model];
    let driver = Driver::new(spec, &DrivingCondition::default(), 0.5, &mut stream);
    let driver = Driver { lateral_m: 0.0, ..driver };
    let asset = VehicleRef { model: VehicleModelId::from_index(model), variant: 0 };
    let mut vehicle = Vehicle::new(spec, asset, driver, LaneId(lane), s, stream);
    (vehicle.speed, vehicle.rides_past_queues) = (speed, model == 0);
    vehicle.plan(roads);
    crate::kinematics::settle(&mut vehicle, roads);
    vehicle
}

const RED: [SignalAspect; 3] = [SignalAspect::Red; 3];

/// How the first of these, a rider, gets past the others.
fn way(roads: &Roads, vehicles: &[Vehicle], lights: [SignalAspect; 3]) -> Option<Filtering> {
    way_past(roads, vehicles, lights, &[])
}

/// The same beside these parked vehicles.
fn way_past(
    roads: &Roads,
    vehicles: &[Vehicle],
    lights: [SignalAspect; 3],
    parked: &[OrientedRectangle],
) -> Option<Filtering> {
    let mut occupancy = Occupancy::default();
    occupancy.rebuild(roads, vehicles);
    let signals = lights.map(|aspect| SignalState { aspect });
    start::look(&RiderView { roads, occupancy: &occupancy, signals: &signals, parked }, vehicles, 0)
}

#[test]
fn riders_go_between_lanes_at_a_red_light_alone() {
    let roads = street(2, 3.3);
    let queue = [
        vehicle(&roads, 0, 1, 150.0, 7.0),
        vehicle(&roads, 1, 1, 197.0, 0.0),
        vehicle(&roads, 1, 1, 190.0, 0.0),
        vehicle(&roads, 1, 0, 197.0, 0.0),
    ];
    let found = way(&roads, &queue, RED).expect("room between the lanes");
    assert_eq!(found.straddles, Some(Side::Left));
    assert!((found.goal_m() - 1.65).abs() < 1e-6 && found.drift.length_m < 30.0, "{found:?}");
    let green = [SignalAspect::Green, SignalAspect::Green, SignalAspect::Red];
    assert!(way(&roads, &queue, green).is_none(), "the queue will go");
    let beside = [SignalAspect::Green, SignalAspect::Red, SignalAspect::Red];
    assert!(way(&roads, &queue, beside).is_none(), "those beside will go");
}

#[test]
fn riders_stay_behind_who_stands_aslant() {
    let roads = street(2, 3.3);
    let mut queue = [vehicle(&roads, 0, 1, 150.0, 7.0), vehicle(&roads, 1, 1, 190.0, 0.0)];
    assert!(way(&roads, &queue, RED).is_some());
    // It stopped where a change of lanes ended.
    queue[1].steer = -0.1;
    assert!(way(&roads, &queue, RED).is_none(), "its rear would be touched");
}

#[test]
fn riders_stay_behind_who_leaves_no_room() {
    let roads = street(2, 3.3);
    let rider = || vehicle(&roads, 0, 1, 150.0, 7.0);
    let bus = [rider(), vehicle(&roads, 2, 1, 193.0, 0.0)];
    assert!(way(&roads, &bus, RED).is_none(), "too broad");
    let beside = [rider(), vehicle(&roads, 1, 1, 197.0, 0.0), vehicle(&roads, 2, 0, 193.0, 0.0)];
    assert!(way(&roads, &beside, RED).is_none(), "too broad beside");
    let near = [vehicle(&roads, 0, 1, 192.0, 0.0), vehicle(&roads, 1, 1, 197.5, 0.0)];
    assert!(way(&roads, &near, RED).is_none(), "too near to get out");
    let alone = street(1, 3.3);
    let single = |roads: &Roads| [vehicle(roads, 0, 0, 150.0, 7.0), vehicle(roads, 1, 0, 197.0, 0.0)];
    assert!(way(&alone, &single(&alone), RED).is_none(), "a narrow lane");
    let broad = street(1, 4.2);
    let found = way(&broad, &single(&broad), RED).expect("a broad lane");
    assert!(found.straddles.is_none() && (found.goal_m().abs() - 1.6).abs() < 1e-6, "{found:?}");
}

#[test]
fn riders_at_the_edge_look_for_parked_vehicles_as_far_as_the_line() {
    let roads = street(1, 4.2);
    let queue = [vehicle(&roads, 0, 0, 120.0, 7.0), vehicle(&roads, 1, 0, 160.0, 0.0)];
    let parked = |x: f64| [-1.9, 1.9].map(|y| OrientedRectangle::new(&specs()[1], DVec2::new(x, y), 0.0, 0.0));
    assert!(way(&roads, &queue, RED).is_some());
    assert!(way_past(&roads, &queue, RED, &parked(150.0)).is_none(), "beside the queue");
    assert!(way_past(&roads, &queue, RED, &parked(185.0)).is_none(), "the queue gets on, and the rider with it");
    assert!(way_past(&roads, &queue, RED, &parked(206.0)).is_some(), "beyond the line");
}

#[test]
fn who_passes_sees_the_queue_as_beside_and_the_queue_lets_it_go_first() {
    let roads = street(2, 3.3);
    let mut vehicles = vec![vehicle(&roads, 0, 1, 150.0, 4.0), vehicle(&roads, 1, 1, 190.0, 0.0)];
    let started = way(&roads, &vehicles, RED).expect("room");
    let seen = |vehicles: &[Vehicle], i: usize| {
        let mut occupancy = Occupancy::default();
        occupancy.rebuild(&roads, vehicles);
        occupancy.leaders(&roads, &vehicles[i], i, 100.0)
    };
    assert!(seen(&vehicles, 0).ahead.is_some_and(|ahead| ahead.vehicle == 1));
    vehicles[0].filtering = Some(started);
    let far = seen(&vehicles, 0);
    assert!(far.ahead.is_none() && far.pace_mps.is_some_and(|pace| pace > 9.0), "{far:?}");
    // Beside it, with its middle further on.
    vehicles[0].rolled = 42.0;
    vehicles[0].s = 191.0;
    let [rider, car] = [0, 1].map(|i| seen(&vehicles, i));
    assert!(rider.ahead.is_none() && rider.beside.is_none(), "{rider:?}");
    assert!(car.ahead.is_none() && car.beside.is_some_and(|beside| beside.gap < 0.0), "{car:?}");
    // The car's front is over the line and the rider is still before it: it goes first all the same.
    (vehicles[1].s, vehicles[0].s) = (198.2, 198.8);
    let [rider, car] = [0, 1].map(|i| seen(&vehicles, i));
    assert!(rider.ahead.is_none() && rider.beside.is_none(), "{rider:?}");
    assert!(car.beside.is_some_and(|beside| beside.vehicle == 0), "{car:?}");
    (vehicles[1].s, vehicles[0].s) = (190.0, 191.0);
    // In the lane beside somebody sees it, too.
    vehicles.push(vehicle(&roads, 1, 0, 180.0, 5.0));
    assert!(seen(&vehicles, 2).ahead.is_some_and(|ahead| ahead.vehicle == 0));
    // A car that may go is passed no more.
    vehicles[0].s = 189.0;
    vehicles[1].speed = 3.0;
    let moves = seen(&vehicles, 0);
    assert!(moves.pace_mps.is_none() && moves.beside.is_some_and(|beside| beside.vehicle == 1), "{moves:?}");
}

#[test]
fn a_queue_goes_past_riders_who_wait_over_its_line_for_the_way_of_the_lane_beside() {
    let roads = street(2, 3.5);
    let mut vehicles = vec![vehicle(&roads, 0, 1, 150.0, 4.0), vehicle(&roads, 1, 1, 190.0, 0.0)];
    let started = way(&roads, &vehicles, RED).expect("room");
    assert_eq!(started.straddles, Some(Side::Left));
    let rider = Vehicle { filtering: Some(started), rolled: 42.0, s: 198.0, speed: 0.0, ..vehicles[0].clone() };
    // Somebody comes behind it, on the left lane and then on its own.
    let comes = [0, 1].map(|lane| vehicle(&roads, 1, lane, 190.0, 2.0));
    let mut seen = |lane: usize, speed: f64| {
        vehicles = vec![comes[lane].clone(), Vehicle { speed, ..rider.clone() }];
        let mut occupancy = Occupancy::default();
        occupancy.rebuild(&roads, &vehicles);
        occupancy.leaders(&roads, &vehicles[0], 0, 100.0)
    };
    let passes = seen(0, 0.0);
    assert!(passes.nearest().is_none() && passes.pace_mps.is_some(), "{passes:?}");
    assert!(seen(0, 1.0).ahead.is_some(), "it sets off");
    assert!(seen(1, 0.0).ahead.is_some(), "it is first in this queue");
}

#[test]
fn who_cannot_get_past_a_bus_goes_back_into_the_queue() {
    let roads = street(2, 3.3);
    let mut vehicles = vec![vehicle(&roads, 0, 1, 150.0, 0.0), vehicle(&roads, 1, 1, 182.0, 0.0)];
    let started = way(&roads, &vehicles, RED).expect("room");
    (vehicles[0].filtering, vehicles[0].rolled, vehicles[0].s) = (Some(started), 42.0, 170.0);
    let may_finish = |vehicles: &[Vehicle]| {
        let mut occupancy = Occupancy::default();
        occupancy.rebuild(&roads, vehicles);
        let signals = RED.map(|aspect| SignalState { aspect });
        let view = RiderView { roads: &roads, occupancy: &occupancy, signals: &signals, parked: &[] };
        finish::may(&view, vehicles, 0, started)
    };
    assert!(!may_finish(&vehicles), "there is a car to pass");
    vehicles.push(vehicle(&roads, 2, 0, 180.0, 0.0));
    assert!(may_finish(&vehicles), "the bus beside leaves no room, so the car beyond its rear does not count");
    vehicles[2] = vehicle(&roads, 2, 0, 193.0, 0.0);
    assert!(!may_finish(&vehicles), "the car comes first");
}

#[test]
fn who_may_go_does_not_wait_for_a_rider_who_stands_beside_and_may_not() {
    let roads = street(1, 3.3);
    let (mut car, mut rider) = (vehicle(&roads, 1, 0, 197.0, 0.0), vehicle(&roads, 0, 0, 197.2, 0.0));
    assert!(lets_go_first(&car, &rider), "neither may go");
    let lanes = vec![LaneId(1)];
    let right = RightOfWay { junction: JunctionId(0), order: 1, lanes, exit: LaneId(2), entered: false, stood_s: 0.0 };
    car.rights_of_way.push(right.clone());
    assert!(!lets_go_first(&car, &rider));
    rider.speed = 1.0;
    assert!(lets_go_first(&car, &rider), "it has set off");
    rider.speed = 0.0;
    rider.rights_of_way.push(right);
    assert!(lets_go_first(&car, &rider), "it may go, too");
}

#[test]
fn the_way_back_begins_where_the_rider_is() {
    let drift = Drift { begin_m: 10.0, length_m: 8.0, left_m: 1.6, back_m: None };
    let there = Filtering { drift, straddles: Some(Side::Left) };
    for rolled_m in [12.0, 14.0, 18.0, 40.0] {
        for speed_mps in [0.0, 3.0, 9.0] {
            let back = there.back(rolled_m, speed_mps, 9.0);
            assert!((back.aside(rolled_m).0 - there.aside(rolled_m).0).abs() < 1e-9, "{rolled_m} {speed_mps}");
            assert!((back.aside(rolled_m).1 - there.aside(rolled_m).1).abs() < 1e-9, "{rolled_m} {speed_mps}");
            assert!(
                back.aside(rolled_m + 30.0).0.abs() < 1e-9 && back.is_over(rolled_m + 30.0) && back.goal_m() == 0.0
            );
        }
    }
}

#[test]
fn who_stops_aslant_on_the_way_back_still_takes_the_place_of_its_rear() {
    let roads = street(2, 3.3);
    let mut rider = vehicle(&roads, 0, 1, 190.0, 0.0);
    let drift = Drift { begin_m: 0.0, length_m: 8.0, left_m: 1.65, back_m: None };
    rider.filtering = Some(Filtering { drift, straddles: Some(Side::Left) }.back(20.0, 0.0, 9.0));
    rider.rolled = 24.0;
    let at_pivot_m = rider.filtering.expect("a way back").aside(rider.rolled).0;
    let taken = rider.across();
    assert!(at_pivot_m < 1.0 && taken.left_m > at_pivot_m + rider.half_width + 0.4, "{at_pivot_m} {taken:?}");
}

#[test]
fn a_lane_that_a_long_vehicle_has_left_is_taken_until_its_rear_has_come_over() {
    let roads = street(2, 3.3);
    let left_for = |model: usize| {
        let mut mover = vehicle(&roads, model, 0, 60.0, 5.0);
        let (from, offset_m) = (LaneId(1), -3.3);
        mover.shift = Some(LaneChange {
            from,
            from_minus_here: 0.0,
            offset_m,
            begin_s: 60.0,
            length_m: 24.0,
            clear_from_m: f64::INFINITY,
        });
        let mut covers = Vec::new();
        let mut gone_at_m = 60.0;
        for _ in 0..300 {
            crate::kinematics::advance(&mut mover, &roads, 1.0 / 30.0);
            mover.covers(&roads, &mut covers);
            if covers.iter().any(|cover| cover.lane == from) {
                gone_at_m = mover.s;
            }
        }
        gone_at_m - 84.0
    };
    assert!(left_for(1).abs() < 0.3, "a car");
    assert!((left_for(2) - 12.0).abs() < 0.4, "a bus");
}

#[test]
fn more_riders_pass_queues_where_motorcycles_are_many() {
    let roads = street(1, 3.3);
    let of = |region| {
        (0..400).filter(|k| rides_past_queues(&vehicle(&roads, 0, 0, f64::from(*k) / 2.0, 0.0), region)).count()
    };
    let [northern, european, latin] = [Region::NorthAmerican, Region::European, Region::LatinAmerican].map(of);
    assert!(northern < 120 && european > 200 && latin > european, "{northern} {european} {latin}");
    assert!(!rides_past_queues(&vehicle(&roads, 1, 0, 9.0, 0.0), Region::LatinAmerican));
}

#[test]
fn nobody_passes_much_faster_than_those_who_are_passed() {
    assert!((pace_past(0.5, -3.0) - 4.5).abs() < 1e-9);
    assert!(pace_past(0.0, 20.0) > 8.0 && pace_past(0.0, 20.0) < 9.5);
}
