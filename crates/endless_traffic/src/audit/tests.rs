use super::*;
use crate::driver::MOST_LIMIT_FACTOR;
use endless_road::{
    Crossing, Junction, Lane, LaneId, Polyline, SignalPhase, SignalProgram, TrafficControl, WalkEdge, WalkKind,
    WalkNetwork, WalkNodeId,
};
use endless_world::{
    Behaviour, BenchSeat, Gait, InstanceId, LanePlace, Motion, ObjectClass, Outfit, Parking, ParkingBay, PersonRef,
    Pose, SignalAspect, SignalId, SignalState, VehicleModelId, VehicleMotion, VehicleRef, WalkerMotion,
};
use glam::{DVec3, Vec3};

const FPS: f64 = 10.0;
const CAR: u32 = 0;
const BICYCLE: u32 = 1;
const BUS: u32 = 2;

fn specs() -> Vec<VehicleSpec> {
    let bicycle = VehicleSpec {
        name: "bicycle.city",
        class: ObjectClass::Bicycle,
        length_m: 1.8,
        width_m: 0.6,
        front_axle_m: 0.55,
        rear_axle_m: -0.55,
        ..VehicleSpec::default()
    };
    let bus = VehicleSpec {
        name: "bus.city",
        class: ObjectClass::Bus,
        length_m: 12.0,
        width_m: 2.5,
        front_axle_m: 3.3,
        rear_axle_m: -2.6,
        ..VehicleSpec::default()
    };
    vec![VehicleSpec::default(), bicycle, bus]
}

/// A street of 400 m to the east with a signal half way, a stop sign after 300 m, and a sidewalk to its south that a crossing
/// with a signal of its own goes on from at x = 50. Before the signal there is a second lane to the left.
fn street() -> RoadNetwork {
    let line = |from: f64, to: f64| Polyline::new([from, 0.5 * (from + to), to].map(|x| DVec3::new(x, 0.0, 0.0)));
    let lane = |id: u32, from: f64, to: f64, next: &[u32], end_control| Lane {
        successors: next.iter().map(|&next| LaneId(next)).collect(),
        end_control,
        ..Lane::new(LaneId(id), line(from, to), 3.5, 10.0)
    };
    let signal = SignalId(0);
    let beside = Polyline::new([100.0, 200.0].map(|x| DVec3::new(x, 3.5, 0.0)));
    let before_signal = lane(1, 100.0, 200.0, &[2], TrafficControl::Signal(signal));
    let phase = SignalPhase { duration_s: 10.0, aspects: vec![(signal, SignalAspect::Red)] };
    let node = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let edge = |a: u32, b: u32, kind| WalkEdge { nodes: [WalkNodeId(a), WalkNodeId(b)], width_m: 2.0, kind };
    let over = WalkKind::Crossing(endless_road::CrossingId(0));
    RoadNetwork {
        lanes: vec![
            lane(0, 0.0, 100.0, &[1], TrafficControl::Free),
            Lane { left: Some(LaneId(4)), ..before_signal },
            lane(2, 200.0, 300.0, &[3], TrafficControl::Stop),
            lane(3, 300.0, 400.0, &[], TrafficControl::Free),
            Lane { right: Some(LaneId(1)), ..Lane::new(LaneId(4), beside, 3.5, 10.0) },
        ],
        junctions: vec![Junction {
            program: Some(SignalProgram { phases: vec![phase], offset_s: 0.0 }),
            ..Junction::default()
        }],
        crossings: vec![Crossing {
            ends: [node(50.0, -3.0), node(50.0, 3.0)],
            width_m: 3.0,
            signal: Some(SignalId(1)),
            cuts: Vec::new(),
        }],
        walk: WalkNetwork {
            nodes: vec![node(0.0, -4.0), node(50.0, -4.0), node(50.0, 4.0), node(100.0, -4.0)],
            edges: vec![edge(0, 1, WalkKind::Sidewalk), edge(1, 2, over), edge(1, 3, WalkKind::Sidewalk)],
        },
        signal_groups: 2,
        ..RoadNetwork::default()
    }
    .finish()
    .expect("a sound network")
}

/// A vehicle on the street, `x` metres from its beginning and `y` metres to the left of its middle.
fn vehicle(id: u16, model: u32, [x, y]: [f64; 2], speed_mps: f64) -> Actor {
    let lane = ((x / 100.0) as u32).min(3);
    Actor {
        id: InstanceId(id),
        rider_id: None,
        class: specs()[model as usize].class,
        asset: VehicleRef { model: VehicleModelId(model), variant: 0 }.into(),
        pose: Pose::level(Vec3::new(x as f32, y as f32, 0.0), 0.0),
        velocity_mps: Vec3::X * speed_mps as f32,
        motion: Motion::Vehicle(VehicleMotion { speed_mps: speed_mps as f32, ..VehicleMotion::default() }),
        behaviour: Behaviour {
            lane: Some(LanePlace { lane, s_m: (x - 100.0 * f64::from(lane)) as f32 }),
            ..Behaviour::default()
        },
        parked: false,
    }
}

fn person(id: u16, [x, y]: [f64; 2]) -> Actor {
    Actor {
        class: ObjectClass::Pedestrian,
        asset: PersonRef { outfit: Outfit::Fair, seed: 0 }.into(),
        motion: Motion::Walker(WalkerMotion::default()),
        behaviour: Behaviour::default(),
        ..vehicle(id, CAR, [x, y], 0.0)
    }
}

/// The audit of so many seconds in which somebody is where these functions of time say; all signals are `aspect`.
fn audit(seconds: f64, aspect: SignalAspect, parked: &[Actor], actors: impl Fn(f64) -> Vec<Actor>) -> AuditReport {
    let (network, specs) = (street(), specs());
    let mut audit = TrafficAudit::new(&network, &specs, parked, FPS);
    for frame in 0..=(seconds * FPS) as u32 {
        let time_s = f64::from(frame) / FPS;
        audit.look(&WorldState {
            frame,
            time_s,
            actors: actors(time_s),
            signals: vec![SignalState { aspect }; usize::from(network.signal_groups)],
        });
    }
    audit.report()
}

/// The checks that failed.
fn failed(report: &AuditReport) -> Vec<AuditCheck> {
    report.lines.iter().filter(|line| !line.passed()).map(|line| line.check).collect()
}

/// What fails where all signals are green and nobody is parked.
fn fails(seconds: f64, actors: impl Fn(f64) -> Vec<Actor>) -> Vec<AuditCheck> {
    failed(&audit(seconds, SignalAspect::Green, &[], actors))
}

/// A car that goes along the street with this speed from a place.
fn goes(id: u16, from_x: f64, speed_mps: f64, time_s: f64) -> Actor {
    vehicle(id, CAR, [from_x + speed_mps * time_s, 0.0], speed_mps)
}

/// A car that begins at `x` with a speed that changes with time.
fn drives(x: f64, speed: impl Fn(f64) -> f64) -> impl Fn(f64) -> Vec<Actor> {
    move |time_s| {
        let steps = (time_s * FPS).round() as u32;
        let way_m: f64 = (0..steps).map(|step| speed(f64::from(step) / FPS) / FPS).sum();
        vec![vehicle(1, CAR, [x + way_m, 0.0], speed(time_s))]
    }
}

#[test]
fn sound_traffic_passes_and_is_measured() {
    let report = audit(10.0, SignalAspect::Green, &[], |t| {
        vec![goes(1, 110.0, 8.0, t), goes(2, 130.0, 8.0, t), person(3, [10.0 + 1.3 * t, -4.0])]
    });
    assert_eq!(failed(&report), [], "{report}");
    assert_eq!(report.lines.iter().map(|line| line.check).collect::<Vec<_>>(), AuditCheck::ALL);
    assert!((report.driven_m - 160.0).abs() < 0.1 && (report.walked_m - 13.0).abs() < 0.1 && report.seconds == 10.0);
    assert_eq!(report.to_string().lines().filter(|line| line.starts_with("PASS")).count(), AuditCheck::ALL.len());
}

#[test]
fn bodies_that_touch_count_once() {
    let through = |t: f64| vec![goes(1, 110.0, 8.0, t), goes(2, 130.0, 4.0, t)];
    let report = audit(9.0, SignalAspect::Green, &[], through);
    assert_eq!(failed(&report), [AuditCheck::Collisions]);
    assert_eq!(report.measured(AuditCheck::Collisions), 1.0);
    assert!(report.to_string().contains("car 1") && report.to_string().contains("and car 2"), "{report}");
    let parked = [Actor { parked: true, ..vehicle(7, CAR, [150.0, 1.9], 0.0) }];
    let report = audit(8.0, SignalAspect::Green, &parked, |t| vec![goes(8, 110.0, 8.0, t)]);
    assert_eq!((failed(&report), report.measured(AuditCheck::Collisions)), (vec![], 0.0), "beside it");
    let parked = [Actor { parked: true, ..vehicle(7, CAR, [150.0, 1.7], 0.0) }];
    let report = audit(8.0, SignalAspect::Green, &parked, |t| vec![goes(8, 110.0, 8.0, t)]);
    assert_eq!((failed(&report), report.measured(AuditCheck::Collisions)), (vec![AuditCheck::Collisions], 1.0));
}

#[test]
fn people_are_touched_by_vehicles_and_by_one_another() {
    let beside = |y: f64| move |t: f64| vec![goes(1, 10.0, 8.0, t), person(2, [50.0, y])];
    assert_eq!(fails(6.0, beside(-1.1)), [AuditCheck::PeopleHit]);
    assert_eq!(fails(6.0, beside(-1.2)), []);
    // On a bridge above.
    let above = |t: f64| {
        let mut person = person(2, [50.0, -1.0]);
        person.pose.position.z = 5.0;
        vec![goes(1, 10.0, 8.0, t), person]
    };
    assert_eq!(fails(6.0, above), []);
    let meet = |aside: f64| move |t: f64| vec![person(1, [10.0 + t, -4.0]), person(2, [20.0, -4.0 - aside])];
    assert_eq!(fails(12.0, meet(0.3)), [AuditCheck::PeopleTouch]);
    assert_eq!(fails(12.0, meet(0.4)), []);
}

#[test]
fn standing_counts_unless_a_signal_holds() {
    let stand = |_| vec![vehicle(1, CAR, [180.0, 0.0], 0.0)];
    assert_eq!(fails(190.0, stand), [AuditCheck::VehicleStands]);
    assert_eq!(failed(&audit(190.0, SignalAspect::Red, &[], stand)), []);
    // Creeping is standing, too; beyond the signal there is none to wait for.
    let creep = |t: f64| vec![vehicle(1, CAR, [250.0 + 0.002 * t, 0.0], 0.002)];
    assert_eq!(failed(&audit(190.0, SignalAspect::Red, &[], creep)), [AuditCheck::VehicleStands]);
    let waits = |waiting: bool| {
        move |_| {
            let mut person = person(1, [49.0, -4.0]);
            person.behaviour.waiting = waiting;
            vec![person]
        }
    };
    assert_eq!(failed(&audit(190.0, SignalAspect::Red, &[], waits(true))), []);
    assert_eq!(failed(&audit(190.0, SignalAspect::Red, &[], waits(false))), [AuditCheck::PersonStands]);
    assert_eq!(fails(190.0, waits(true)), [AuditCheck::PersonStands]);
}

#[test]
fn everybody_keeps_to_their_surface() {
    let aside = |model: u32, y: f64| move |t: f64| vec![vehicle(1, model, [110.0 + 5.0 * t, y], 5.0)];
    let errors = [AuditCheck::LaneError, AuditCheck::LaneErrorShare];
    assert_eq!(fails(5.0, aside(CAR, 0.4)), []);
    assert_eq!(fails(5.0, aside(CAR, 0.9)), [AuditCheck::LaneErrorShare]);
    assert_eq!(fails(5.0, aside(CAR, -1.3)), errors);
    assert_eq!(fails(5.0, aside(CAR, 1.8)), [&[AuditCheck::OffLane], &errors[..]].concat());
    // Two-wheelers keep to the side, but to their lane.
    assert_eq!(fails(5.0, aside(BICYCLE, -1.4)), []);
    assert_eq!(fails(5.0, aside(BICYCLE, -1.5)), [AuditCheck::TwoWheelersOut]);
    // Or between their lane and one beside it.
    assert_eq!(fails(5.0, aside(BICYCLE, 2.0)), []);
    assert_eq!(fails(5.0, aside(BICYCLE, 2.2)), [AuditCheck::OffLane, AuditCheck::TwoWheelersOut]);
    let changes = |t: f64| {
        let mut car = vehicle(1, CAR, [110.0 + 5.0 * t, 1.2], 5.0);
        car.behaviour.lane_left = Some(0);
        vec![car]
    };
    assert_eq!(fails(5.0, changes), []);
    let walks = |y: f64| move |t: f64| vec![person(1, [20.0 + t, y])];
    assert_eq!(fails(5.0, walks(-4.9)), []);
    assert_eq!(fails(5.0, walks(-5.2)), [AuditCheck::OffSidewalkShare]);
    assert_eq!(fails(5.0, walks(-5.6)), [AuditCheck::OffSidewalk, AuditCheck::OffSidewalkShare]);
    assert_eq!(fails(5.0, |t| vec![person(1, [49.5, -4.0 + t])]), [], "on the crossing");
}

#[test]
fn nobody_jumps_or_rolls_back_or_slips() {
    let jump = |t: f64| vec![goes(1, if t < 2.0 { 110.0 } else { 112.0 }, 5.0, t)];
    assert_eq!(fails(4.0, jump), [AuditCheck::Jumps]);
    let back = |t: f64| vec![vehicle(1, CAR, [190.0 - 0.2 * t, 0.0], 0.2)];
    assert_eq!(fails(4.0, back), [AuditCheck::Jumps]);
    assert_eq!(fails(4.0, |t| vec![person(1, [10.0 + 5.0 * t, -4.0])]), [AuditCheck::Jumps]);
    let slip = |t: f64| vec![vehicle(1, CAR, [110.0 + 5.0 * t, 0.4 * t - 0.4], 5.0)];
    assert_eq!(fails(2.0, slip), [AuditCheck::Slip]);
    let spin = |t: f64| {
        let mut bicycle = vehicle(1, BICYCLE, [150.0, 0.0], 0.0);
        bicycle.pose.yaw_rad = 2.5 * t as f32;
        vec![bicycle]
    };
    assert!(fails(0.5, spin).contains(&AuditCheck::YawRate));
}

#[test]
fn who_comes_and_goes_does_so_at_an_end() {
    let leaves = |x: f64| move |t: f64| if t < 2.0 { vec![goes(1, x, 5.0, t)] } else { Vec::new() };
    assert_eq!(fails(4.0, leaves(150.0)), [AuditCheck::Vanishings]);
    assert_eq!(fails(4.0, leaves(380.0)), []);
    let comes = |x: f64| move |t: f64| if t > 2.0 { vec![goes(1, x, 5.0, t - 2.0)] } else { Vec::new() };
    assert_eq!(fails(4.0, comes(150.0)), [AuditCheck::Vanishings]);
    assert_eq!(fails(4.0, comes(5.0)), []);
    let on_foot = |x: f64| move |t: f64| if t < 2.0 { vec![person(1, [x, -4.0])] } else { Vec::new() };
    assert_eq!(fails(4.0, on_foot(50.0)), [AuditCheck::Vanishings]);
    assert_eq!(fails(4.0, on_foot(97.0)), []);
}

#[test]
fn speeds_change_smoothly() {
    assert_eq!(fails(6.0, drives(110.0, |t| 2.0 + 0.8 * t)), []);
    let slams = drives(110.0, |t| if t < 4.0 { 9.0 } else { (9.0 - 9.0 * (t - 4.0)).max(0.0) });
    let hard = [AuditCheck::Acceleration, AuditCheck::HardAcceleration, AuditCheck::Jerk, AuditCheck::HardJerk];
    assert_eq!(fails(6.0, slams), hard);
    // A little roughness is none in an hour: the share tells.
    let rough = drives(110.0, |t| if t < 4.0 { 5.0 } else { 5.32 });
    assert_eq!(fails(6.0, rough), [AuditCheck::HardJerk]);
}

#[test]
fn lights_and_signs_are_kept() {
    let past_light = |t: f64| vec![goes(1, 180.0, 8.0, t)];
    assert_eq!(fails(4.0, past_light), []);
    assert_eq!(failed(&audit(4.0, SignalAspect::Red, &[], past_light)), [AuditCheck::RedLights]);
    let waited = drives(197.0, |t| (t - 2.0).max(0.0));
    assert_eq!(failed(&audit(3.8, SignalAspect::Red, &[], waited)), [], "it clears the junction");
    assert_eq!(fails(14.0, |t| vec![goes(1, 195.0, 9.0, t)]), [AuditCheck::StopSigns]);
    assert_eq!(fails(4.0, |t| vec![goes(1, 280.0, 9.0, t)]), [], "nobody knows what it did before");
    let stops = |t: f64| if t < 17.0 { (15.0 - t).clamp(0.0, 9.0) } else { (t - 17.0).min(5.0) };
    assert_eq!(fails(24.0, drives(195.0, stops)), []);
    let crosses = |t: f64| {
        let mut person = person(1, [50.0, -5.0 + t]);
        person.behaviour.crossing = (t > 1.5).then_some(0);
        vec![person]
    };
    assert_eq!(fails(4.0, crosses), []);
    assert_eq!(failed(&audit(4.0, SignalAspect::Yellow, &[], crosses)), [AuditCheck::PeopleAtRed]);
    // The lane's limit is 10 m/s.
    let boldest = 10.0 * MOST_LIMIT_FACTOR + AuditCheck::Speeding.limit();
    assert_eq!(fails(4.0, |t| vec![goes(1, 110.0, boldest - 0.1, t)]), []);
    assert_eq!(fails(4.0, |t| vec![goes(1, 110.0, boldest + 0.1, t)]), [AuditCheck::Speeding]);
}

/// A bus whose front door is at x = 35, to the right at y = -1.65, and goes on this fast from `from_s` on.
fn bus(time_s: f64, from_s: f64, speed_mps: f64) -> Actor {
    let goes = time_s >= from_s;
    let way_m = speed_mps * (time_s - from_s).max(0.0);
    vehicle(1, BUS, [30.15 + way_m, -0.4], if goes { speed_mps } else { 0.0 })
}

#[test]
fn people_get_on_and_off_buses_by_the_front_door_while_these_stand() {
    let to_door = |x: f64| move |t: f64| (t < 2.5).then(|| person(2, [x, -3.2 + 0.8 * t]));
    let gets_on = |t: f64| std::iter::once(bus(t, 99.0, 0.0)).chain(to_door(34.9)(t)).collect();
    assert_eq!(fails(5.0, gets_on), []);
    let gets_off = |t: f64| {
        std::iter::once(bus(t, 99.0, 0.0)).chain((t > 1.0).then(|| person(2, [35.1, -0.4 - 0.8 * t]))).collect()
    };
    assert_eq!(fails(4.0, gets_off), []);
    // Through its side, or while it rolls.
    let by_the_side = |t: f64| std::iter::once(bus(t, 99.0, 0.0)).chain(to_door(32.0)(t)).collect();
    assert_eq!(
        fails(5.0, by_the_side),
        [AuditCheck::PeopleHit, AuditCheck::OffSidewalk, AuditCheck::OffSidewalkShare, AuditCheck::Vanishings]
    );
    let rolls = |t: f64| std::iter::once(bus(t, 2.0, 0.3)).chain(to_door(34.9)(t)).collect();
    let found = fails(5.0, rolls);
    assert!(found.contains(&AuditCheck::PeopleHit) && found.contains(&AuditCheck::Vanishings), "{found:?}");
}

#[test]
fn nobody_vanishes_beside_a_bus() {
    let vanishes =
        |t: f64| std::iter::once(bus(t, 99.0, 0.0)).chain((t < 2.0).then(|| person(2, [35.0, -2.0]))).collect();
    assert_eq!(fails(4.0, vanishes), [AuditCheck::Vanishings]);
}

/// Beside the sidewalk, on a seat or not, somebody sits down after 2 s.
#[test]
fn who_sits_for_long_sits_on_a_seat() {
    let sits_at = |x: f64| {
        move |t: f64| {
            let mut person = person(1, [x, -5.8]);
            let gait = if t < 2.0 { Gait::Idle } else { Gait::Sit };
            person.motion = Motion::Walker(WalkerMotion { gait, ..WalkerMotion::default() });
            vec![person]
        }
    };
    let (network, specs) = (street(), specs());
    let seat = BenchSeat { position: Vec3::new(20.0, -5.8, 0.0), yaw_rad: 0.0 };
    let watched = |actors: &dyn Fn(f64) -> Vec<Actor>| {
        let mut audit = TrafficAudit::new(&network, &specs, &[], FPS).with_bench_seats(&[seat]);
        for frame in 0..(200.0 * FPS) as u32 {
            let time_s = f64::from(frame) / FPS;
            let signals = vec![SignalState { aspect: SignalAspect::Green }; 2];
            audit.look(&WorldState { frame, time_s, actors: actors(time_s), signals });
        }
        failed(&audit.report())
    };
    assert_eq!(watched(&sits_at(20.0)), []);
    // On the ground before the bench, for too long.
    assert_eq!(watched(&sits_at(20.5)), [AuditCheck::PersonStands, AuditCheck::BesideSeat]);
    // Where there is no bench.
    let surface = [AuditCheck::OffSidewalk, AuditCheck::OffSidewalkShare];
    assert_eq!(watched(&sits_at(40.0))[1..3], surface);
}

#[test]
fn who_parks_stands_in_a_bay_for_as_long_as_they_like() {
    let bays = [20.0, 25.9].map(|x| ParkingBay {
        position: Vec3::new(x, -2.85, 0.0),
        yaw_rad: 0.0,
        length_m: 5.7,
        width_m: 2.1,
    });
    let fails = |seconds: f64, place: [f64; 2], parking: Option<Parking>| {
        let (network, specs) = (street(), specs());
        let mut audit = TrafficAudit::new(&network, &specs, &[], FPS).with_parking_bays(&bays);
        for frame in 0..=(seconds * FPS) as u32 {
            let mut car = vehicle(1, CAR, place, 0.0);
            car.behaviour.parking = parking;
            car.behaviour.lane = car.behaviour.lane.filter(|_| parking != Some(Parking::Parked));
            let time_s = f64::from(frame) / FPS;
            audit.look(&WorldState {
                frame,
                time_s,
                actors: vec![car],
                signals: vec![SignalState { aspect: SignalAspect::Green }; 2],
            });
        }
        failed(&audit.report())
    };
    let [parked, pulls_in] = [Parking::Parked, Parking::PullingIn].map(Some);
    assert_eq!(fails(200.0, [20.0, -2.8], parked), []);
    // Over the line between two bays, beside them, or not yet there for so long.
    assert_eq!(fails(200.0, [23.0, -2.8], parked), []);
    assert_eq!(fails(1.0, [16.0, -2.8], parked), [AuditCheck::BesideBay]);
    assert_eq!(fails(200.0, [20.0, -2.0], pulls_in), [AuditCheck::VehicleStands]);
    assert_eq!(fails(1.0, [20.0, -2.0], pulls_in), []);
    assert_eq!(fails(1.0, [60.0, -2.0], pulls_in), [AuditCheck::OffLane]);
    assert_eq!(
        fails(1.0, [20.0, -2.0], None),
        [AuditCheck::OffLane, AuditCheck::LaneError, AuditCheck::LaneErrorShare]
    );
}
