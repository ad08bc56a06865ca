use super::*;
use crate::driver::Driver;
use crate::focus::Focus;
use crate::roads::TrafficMap;
use crate::settings::DrivingCondition;
use endless_road::{Junction, Lane, Polyline, RoadNetwork};
use endless_world::{SignalId, Stream, VehicleModelId, VehicleRef, VehicleSpec};
use glam::DVec3;

/// A way through a junction (lanes 0, 1), a piece of 30 m beyond it (2), through a second one (3) and on (4). At the second one
/// another street comes to the same lane (5, 6), and one crosses the way to it (7, 8, 9).
///
/// ```text
///             8 9
///   0 ─ 1 ─ 2 ─ 3 ─ 4
///             7 ╱6
///              5
/// ```
fn streets() -> Roads {
    let line = |points: &[[f64; 2]]| Polyline::new(points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)));
    type Way<'a> = (&'a [[f64; 2]], Option<u16>, Option<u32>);
    let ways: [Way<'_>; 10] = [
        (&[[0.0, 0.0], [100.0, 0.0]], None, Some(1)),
        (&[[100.0, 0.0], [115.0, 0.0]], Some(0), Some(2)),
        (&[[115.0, 0.0], [145.0, 0.0]], None, Some(3)),
        (&[[145.0, 0.0], [175.0, 0.0]], Some(1), Some(4)),
        (&[[175.0, 0.0], [275.0, 0.0]], None, None),
        (&[[155.0, -100.0], [155.0, -20.0]], None, Some(6)),
        (
            &[[155.0, -20.0], [155.4, -15.0], [158.0, -8.0], [163.0, -3.0], [170.0, -0.4], [175.0, 0.0]],
            Some(1),
            Some(4),
        ),
        (&[[150.0, -100.0], [150.0, -20.0]], None, Some(8)),
        (&[[150.0, -20.0], [150.0, 20.0]], Some(1), Some(9)),
        (&[[150.0, 20.0], [150.0, 100.0]], None, None),
    ];
    let mut network = RoadNetwork { signal_groups: 1, ..RoadNetwork::default() };
    for (k, (points, junction, next)) in ways.into_iter().enumerate() {
        let mut lane = Lane::new(LaneId(k as u32), line(points), 3.5, 13.9);
        (lane.junction, lane.successors) = (junction.map(JunctionId), next.map(LaneId).into_iter().collect());
        network.lanes.push(lane);
    }
    for lanes in [vec![1], vec![3, 6, 8]] {
        let lanes = lanes.into_iter().map(LaneId).collect();
        network.junctions.push(Junction { lanes, ..Junction::default() });
    }
    // At the first one there is a light, and the way is a turn to the left.
    network.lanes[0].end_control = TrafficControl::Signal(SignalId(0));
    network.lanes[1].turn = Turn::Left;
    let spec = VehicleSpec::default();
    let network = network.finish().expect("streets");
    Roads::new(&TrafficMap::new(network, std::slice::from_ref(&spec)), &Focus::default(), &[])
}

/// Who stands so far before the end of a lane.
fn stands(roads: &Roads, lane: u32, to_end_m: f64) -> Vehicle {
    let spec = VehicleSpec::default();
    let mut stream = Stream::named(1, "test.junction_controller", &[lane.into(), to_end_m as u64]);
    let driver = Driver::new(&spec, &DrivingCondition::default(), 0.5, &mut stream);
    let asset = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
    let s = roads.table(LaneId(lane)).length - to_end_m - 0.5 * f64::from(spec.length_m);
    let mut vehicle = Vehicle::new(&spec, asset, driver, LaneId(lane), s, stream);
    vehicle.plan(roads);
    vehicle
}

fn occupied(roads: &Roads, vehicles: &[Vehicle]) -> Occupancy {
    let mut occupancy = Occupancy::default();
    occupancy.rebuild(roads, vehicles);
    occupancy
}

/// The right of way over a lane of a junction.
fn right_of_way(junction: u16, order: u64, lane: u32, exit: u32, stood_s: f64) -> RightOfWay {
    let (junction, lanes, exit) = (JunctionId(junction), vec![LaneId(lane)], LaneId(exit));
    RightOfWay { junction, order, lanes, exit, entered: false, stood_s }
}

#[test]
fn who_turns_left_and_creeps_before_the_line_stops_at_red() {
    let roads = streets();
    let goes_on = |aspect: SignalAspect, speed: f64, to_line_m: f64| {
        let mut vehicles = [stands(&roads, 0, to_line_m)];
        vehicles[0].speed = speed;
        vehicles[0].rights_of_way.push(right_of_way(0, 1, 1, 2, 0.0));
        let occupancy = occupied(&roads, &vehicles);
        release(&roads, &occupancy, &[SignalState { aspect }], &mut vehicles, 0.1);
        !vehicles[0].rights_of_way.is_empty()
    };
    assert!(goes_on(SignalAspect::Green, 0.7, 2.0));
    assert!(goes_on(SignalAspect::Yellow, 0.7, 2.0), "it has waited for those who come towards it");
    assert!(!goes_on(SignalAspect::Red, 0.7, 2.0));
    assert!(!goes_on(SignalAspect::Yellow, 0.7, 4.0), "it is not at the line yet");
    assert!(goes_on(SignalAspect::Red, 3.0, 1.0), "it cannot stop");
}

#[test]
fn who_waits_for_one_that_passes_keeps_the_right_of_way() {
    let roads = streets();
    // One at the line, and one in the junction on the street that crosses theirs.
    let keeps = |speed: f64, theirs: u64, entered: bool, inside_m: f64| {
        let mut vehicles = [stands(&roads, 2, 1.0), stands(&roads, 7, -inside_m)];
        vehicles[0].rights_of_way.push(right_of_way(1, 2, 3, 4, HELD_UP_S));
        vehicles[1].rights_of_way.push(RightOfWay { entered, ..right_of_way(1, theirs, 8, 9, 0.0) });
        vehicles[1].speed = speed;
        let occupancy = occupied(&roads, &vehicles);
        release(&roads, &occupancy, &[SignalState { aspect: SignalAspect::Green }], &mut vehicles, 0.1);
        !vehicles[0].rights_of_way.is_empty()
    };
    assert!(keeps(3.0, 1, true, 8.0));
    assert!(!keeps(0.0, 1, true, 8.0), "it stands, and may wait for others");
    assert!(!keeps(3.0, 3, true, 8.0), "it goes last");
    assert!(!keeps(3.0, 1, false, -8.0), "it is not in the junction yet");
    assert!(!keeps(3.0, 1, true, 33.0), "it has passed");
}

#[test]
fn who_stands_behind_one_who_got_the_right_of_way_later_is_shut_in() {
    let roads = streets();
    // One behind the other before the line, and somebody on the street that crosses theirs.
    let shut_in = |stood_s: f64, later: [u64; 2], inside_m: f64| {
        let length_m = f64::from(VehicleSpec::default().length_m);
        let mut vehicles =
            vec![stands(&roads, 2, -inside_m), stands(&roads, 2, -inside_m - length_m - 2.0), stands(&roads, 7, 1.0)];
        vehicles[0].rights_of_way.push(right_of_way(1, 2, 3, 4, stood_s));
        vehicles[1].rights_of_way.push(right_of_way(1, later[0], 3, 4, stood_s));
        vehicles[2].rights_of_way.push(right_of_way(1, later[1], 8, 9, 0.0));
        let occupancy = occupied(&roads, &vehicles);
        let controller = JunctionController { holders: vec![vec![], vec![0, 1, 2]], ..JunctionController::default() };
        controller.is_shut_in(&roads, &occupancy, &vehicles, JunctionId(1), 0)
    };
    let before_line_m = -10.0;
    assert!(shut_in(SHUT_IN_S + 1.0, [3, 4], before_line_m));
    assert!(!shut_in(SHUT_IN_S - 1.0, [3, 4], before_line_m), "not for long");
    assert!(!shut_in(SHUT_IN_S + 1.0, [1, 4], before_line_m), "the one ahead goes first anyway");
    let in_the_way_m = 5.0;
    assert!(!shut_in(SHUT_IN_S + 1.0, [3, 4], in_the_way_m), "it stands where somebody has to pass");
    assert!(shut_in(SHUT_IN_S + 1.0, [3, 1], in_the_way_m), "who goes first anyway");
}

#[test]
fn who_is_waited_for_by_the_last_one_beyond_a_junction_moves_on_without_room() {
    let roads = streets();
    // One before the second junction, whose rear still stands in another one, and the last one on the road beyond, which would
    // have to pass there, too.
    let moves_on = |waited_s: f64, theirs: u64| {
        let mut vehicles = [stands(&roads, 0, 1.0), stands(&roads, 2, 20.0)];
        vehicles[0].rights_of_way.push(RightOfWay { entered: true, ..right_of_way(1, 2, 3, 4, 0.0) });
        vehicles[1].rights_of_way.push(right_of_way(1, theirs, 8, 9, 0.0));
        let occupancy = occupied(&roads, &vehicles);
        let signals = [SignalState { aspect: SignalAspect::Green }];
        let request = request(&roads, &signals, &vehicles[0], 0).expect("before a junction");
        is_waited_for(&roads, &occupancy, &vehicles, &EntryRequest { waited_s, ..request })
    };
    assert!(moves_on(CHANCE_S + 1.0, 3));
    assert!(!moves_on(CHANCE_S - 1.0, 3), "not for long");
    assert!(!moves_on(CHANCE_S + 1.0, 1), "they go first");
}

/// A queue on the short piece, and one before it who has waited so long for room there; the first of it has just come to the line,
/// where one from the other street has waited longer for the room beyond, which is enough for one.
fn behind_a_short_piece(roads: &Roads, behind_s: f64) -> Vec<Vehicle> {
    let mut vehicles: Vec<Vehicle> = [(2, 0.5), (5, 0.5), (2, 7.5), (2, 14.5), (2, 21.5), (0, 0.5), (4, 85.5)]
        .map(|(lane, to_end_m)| stands(roads, lane, to_end_m))
        .into();
    for (i, waited_s) in [(0, 4.0), (1, 60.0), (5, behind_s)] {
        (vehicles[i].waited_s, vehicles[i].stands_s) = (waited_s, waited_s);
    }
    vehicles
}

#[test]
fn who_waits_behind_a_short_piece_is_waited_for_at_its_end() {
    let roads = streets();
    let signals = [SignalState { aspect: SignalAspect::Green }];
    let pressures = |vehicles: &[Vehicle]| {
        let asks = |i: usize| request(&roads, &signals, &vehicles[i], i).expect("before a junction");
        pressures_s(&roads, &occupied(&roads, vehicles), vehicles, &[0, 1, 5].map(asks))
    };
    let mut vehicles = behind_a_short_piece(&roads, 100.0);
    assert_eq!(pressures(&vehicles), [100.0, 60.0, 100.0]);
    vehicles[4].speed = 5.0;
    assert_eq!(pressures(&vehicles), [4.0, 60.0, 100.0], "the queue moves already");
}

#[test]
fn the_room_beyond_is_for_the_queue_that_has_waited_longest() {
    let roads = streets();
    let signals = [SignalState { aspect: SignalAspect::Green }];
    let goes = |behind_s: f64| {
        let mut vehicles = behind_a_short_piece(&roads, behind_s);
        let occupancy = occupied(&roads, &vehicles);
        JunctionController::default().step(&roads, &occupancy, &signals, &mut vehicles, 0.1);
        [0, 1].map(|i| vehicles[i].right_of_way_at(JunctionId(1)).is_some())
    };
    assert_eq!(goes(30.0), [false, true]);
    assert_eq!(goes(100.0), [true, false]);
}

#[test]
fn room_is_kept_for_who_has_waited_and_is_held_by_a_light() {
    let roads = streets();
    let vehicles = behind_a_short_piece(&roads, 0.0);
    let kept_m = |waited_s: f64| {
        let mut requests = [0, 1].map(|i| request(&roads, &[], &vehicles[i], i).expect("before a junction"));
        (requests[1].pressure_s, requests[1].held) = (waited_s, true);
        kept_free_m(&vehicles, longest_starving(&requests, &requests[0]))
    };
    let length_m = f64::from(VehicleSpec::default().length_m);
    assert_eq!([STARVES_S - 1.0, STARVES_S + 1.0].map(kept_m), [0.0, length_m + SPARE_M]);
}

#[test]
fn who_has_the_right_of_way_for_a_moment_and_stands_has_waited_all_the_while() {
    let roads = streets();
    let waits_on = |speed: f64, entered: bool| {
        let mut vehicles = [Vehicle { waited_s: 10.0, speed, ..stands(&roads, 2, 1.0) }];
        vehicles[0].rights_of_way.push(RightOfWay { entered, ..right_of_way(1, 1, 3, 4, 1.0) });
        stands_with_turn(&vehicles[0])
    };
    assert!(waits_on(0.0, false));
    assert!(!waits_on(2.0, false), "it gets off");
    assert!(!waits_on(0.0, true), "it is in the junction");
}

#[test]
fn a_long_vehicle_that_has_waited_for_a_whole_cycle_has_all_the_room_kept() {
    let roads = streets();
    let mut vehicles = behind_a_short_piece(&roads, 0.0);
    let mut reserved = |length_m: f64, waited_s: f64| {
        vehicles[1].half_length = 0.5 * length_m;
        let mut requests = [0, 1].map(|i| request(&roads, &[], &vehicles[i], i).expect("before a junction"));
        (requests[1].pressure_s, requests[1].held) = (waited_s, true);
        is_reserved(&vehicles, longest_starving(&requests, &requests[0]))
    };
    assert!(reserved(7.1, RESERVES_S + 1.0));
    assert!(!reserved(7.1, RESERVES_S - 1.0), "not for long");
    assert!(!reserved(4.5, RESERVES_S + 1.0), "there will be room for a car");
}

#[test]
fn who_stands_before_a_long_queue_takes_the_room_that_one_car_leaves() {
    let roads = streets();
    let length_m = f64::from(VehicleSpec::default().length_m);
    let has_room_at = |control: TrafficControl, room_m: f64, pressure_s: f64| {
        let beyond_m = roads.table(LaneId(4)).length - length_m - room_m;
        let vehicles = [stands(&roads, 2, 0.5), stands(&roads, 4, beyond_m)];
        let asks = request(&roads, &[], &vehicles[0], 0).expect("before a junction");
        let requests = [EntryRequest { pressure_s, control, ..asks }];
        let controller = JunctionController { holders: vec![vec![]; 2], ..JunctionController::default() };
        controller.has_exit_space(&roads, &occupied(&roads, &vehicles), &vehicles, &requests, &requests[0])
    };
    let has_room = |room_m: f64, pressure_s: f64| has_room_at(TrafficControl::Free, room_m, pressure_s);
    let close_m = length_m + LEAST_SPARE_M + 0.1;
    assert!(has_room(close_m, LONG_STAND_S + 1.0));
    assert!(!has_room(close_m, LONG_STAND_S - 1.0), "nobody has stood for long");
    let light = TrafficControl::Signal(SignalId(0));
    assert!(!has_room_at(light, close_m, LONG_STAND_S + 1.0), "those who get green next have to get past");
    assert!(has_room(length_m + SPARE_M + 0.1, 0.0));
    assert!(!has_room(length_m + 1.0, LONG_STAND_S + 1.0), "it would stand in the junction");
}
