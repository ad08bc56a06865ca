//! Recordings that are written, read and told.

use super::*;
use crate::wire::{GearPhysicsControl, VehiclePhysicsControl, WheelPhysicsControl};
use proptest::prelude::*;
use std::io::Cursor;

fn frame(id: u64, elapsed_s: f64, packets: Vec<Packet>) -> Vec<Packet> {
    let start = Packet::FrameStart(FrameStart { id, duration_s: 20.0, elapsed_s });
    std::iter::once(start).chain(packets).chain([Packet::FrameEnd]).collect()
}

fn actor(id: u32, kind: RecordedActorType, blueprint: &str, role: &str) -> RecordedActor {
    let role = RecordedAttribute { kind: 4, id: "role_name".to_owned(), value: role.to_owned() };
    RecordedActor {
        id,
        kind: kind as u8,
        blueprint: blueprint.to_owned(),
        attributes: vec![role],
        ..RecordedActor::default()
    }
}

fn position(actor: u32, x: f32) -> RecordedPosition {
    RecordedPosition { actor, location: [x, 0.0, 0.5], rotation: [0.0, 0.0, 90.0] }
}

fn packets() -> Vec<Packet> {
    let physics = VehiclePhysicsControl {
        forward_gears: vec![GearPhysicsControl::default()],
        wheels: vec![WheelPhysicsControl::default(); 4],
        ..VehiclePhysicsControl::default()
    };
    let car = actor(24, RecordedActorType::of("vehicle.audi.tt"), "vehicle.audi.tt", "hero");
    let light = actor(2, RecordedActorType::of("traffic.traffic_light"), "traffic.traffic_light", "");
    let collision = RecordedCollision { id: 0, first: 24, second: 0, first_is_hero: true, second_is_hero: false };
    let bounds = RecordedBox { actor: 24, origin: [0.0; 3], extent: [200.0, 90.0, 70.5] };
    let mut all = frame(
        1,
        0.0,
        vec![
            Packet::Created(vec![car, light]),
            Packet::Destroyed(vec![]),
            Packet::Collisions(vec![collision.clone()]),
            Packet::Parents(vec![RecordedParent { child: 25, parent: 24 }]),
            Packet::Positions(vec![position(24, 1000.0)]),
            Packet::LightStates(vec![RecordedLightState { actor: 2, frozen: true, elapsed_s: 1.5, state: 2 }]),
            Packet::Vehicles(vec![RecordedVehicle {
                actor: 24,
                gear: -1,
                throttle: 0.25,
                ..RecordedVehicle::default()
            }]),
            Packet::Walkers(vec![]),
            Packet::VehicleLights(vec![RecordedVehicleLights { actor: 24, lights: 8 | 128 }]),
            Packet::SceneLights(vec![RecordedSceneLight { light: 3, active: true, ..RecordedSceneLight::default() }]),
            Packet::Kinematics(vec![RecordedKinematics { actor: 24, ..RecordedKinematics::default() }]),
            Packet::Boxes(vec![bounds.clone()]),
            Packet::Triggers(vec![bounds]),
            Packet::PlatformTime(0.005),
            Packet::Physics(vec![RecordedPhysics { actor: 24, physics }]),
            Packet::LightTimes(vec![RecordedLightTimes { actor: 2, green_s: 10.0, yellow_s: 3.0, red_s: 2.0 }]),
        ],
    );
    all.extend(frame(
        2,
        20.0,
        vec![Packet::Collisions(vec![collision]), Packet::Positions(vec![position(24, 1001.0)])],
    ));
    all.extend(frame(3, 40.0, vec![Packet::Positions(vec![position(24, 1002.0)])]));
    all
}

fn file(packets: &[Packet]) -> Vec<u8> {
    let mut bytes = Vec::new();
    LogHeader::new("Town02", 1_637_676_528).write(&mut bytes);
    packets.iter().for_each(|packet| packet.write(&mut bytes));
    bytes
}

fn reader(bytes: &[u8]) -> LogReader<Cursor<&[u8]>> {
    LogReader::new(Cursor::new(bytes)).expect("a recording")
}

#[test]
fn what_is_written_is_read() {
    let bytes = file(&packets());
    assert!(is_recording(&bytes));
    let mut log = reader(&bytes);
    assert_eq!(log.header(), &LogHeader { version: 1, date_s: 1_637_676_528, map: "Town02".to_owned() });
    assert_eq!(log.total_s().unwrap(), 40.0);
    let mut read = Vec::new();
    while let Some(packet) = log.packet().unwrap() {
        read.push(packet);
    }
    assert_eq!(read, packets());
    // A recorder that was stopped by force leaves a file that ends somewhere.
    let mut cut = reader(&bytes[..bytes.len() - 3]);
    assert_eq!(std::iter::from_fn(|| cut.packet().unwrap()).count(), packets().len() - 1);
    assert!(LogReader::new(Cursor::new(b"PK\x03\x04 something else")).is_err());
}

#[test]
fn more_than_a_packet_counts_goes_into_the_next() {
    let many: Vec<u32> = (0..70_000).collect();
    let bytes = file(&[Packet::Destroyed(many.clone())]);
    let mut log = reader(&bytes);
    let mut read = Vec::new();
    while let Some(Packet::Destroyed(some)) = log.packet().unwrap() {
        read.extend(some);
    }
    assert_eq!(read, many);
}

#[test]
fn the_text_is_as_carla_writes_it() {
    let bytes = file(&packets());
    let events = file_info(&mut reader(&bytes), false).unwrap();
    let expected = "Version: 1\nMap: Town02\nDate: 11/23/21 14:08:48\n\n\
        Frame 1 at 0 seconds\n Create 24: vehicle.audi.tt (1) at (0, 0, 0)\n  role_name = hero\n \
        Create 2: traffic.traffic_light (3) at (0, 0, 0)\n  role_name = \n \
        Collision id 0 between 24 (hero)  with 0\n Parenting 25 with 24 (parent)\n\
        Frame 2 at 20 seconds\n Collision id 0 between 24 (hero)  with 0\n\nFrames: 3\nDuration: 40 seconds\n";
    assert_eq!(events, expected);
    let all = file_info(&mut reader(&bytes), true).unwrap();
    for line in [
        " Positions: 1\n  Id: 24 Location: (1000, 0, 0.5) Rotation (0, 0, 90)\n",
        "  Id: 2 state: 2 frozen: 1 elapsedTime: 1.5\n",
        "  Id: 24 Steering: 0 Throttle: 0.25 Brake 0 Handbrake: 0 Gear: -1\n",
        " Walker animations: 0\n",
        "  Id: 24 Brake Fog\n",
        "  Id: 24 origin: (0, 0, 0) extension: (200, 90, 70.5)\n",
        " Current platform time: 0.005\n",
        "   torque_curve = (0, 500) (5000, 500)\n",
        "    gear 0: ratio 1 down_ratio 0.5 up_ratio 0.65\n",
        "Frame 3 at 40 seconds\n",
    ] {
        assert!(all.contains(line), "{line}\n{all}");
    }
}

#[test]
fn who_met_and_who_waited_is_told() {
    let bytes = file(&packets());
    let met = |first, second| collisions(&mut reader(&bytes), first, second).unwrap().lines().count();
    // Six lines are about the file; the second frame's collision goes on from the first.
    assert_eq!([met('a', 'a'), met('v', 'o'), met('h', 'a')], [9, 9, 9]);
    assert_eq!([met('w', 'a'), met('v', 'v'), met('a', 'h')], [8, 8, 8]);
    let waited = |seconds, cm| blocked_actors(&mut reader(&bytes), seconds, cm).unwrap();
    assert!(waited(30.0, 100.0).contains("      20     24 vehicle.audi.tt                             40\n"));
    assert!(!waited(50.0, 100.0).contains("audi") && !waited(30.0, 0.5).contains("audi"));
}

proptest! {
    #[test]
    fn any_bytes_are_a_recording_or_an_error(cut in 0usize..2000, at in 0usize..2000, byte in any::<u8>()) {
        let mut bytes = file(&packets());
        let at = at % bytes.len();
        bytes[at] = byte;
        bytes.truncate(cut.max(1));
        if let Ok(mut log) = LogReader::new(Cursor::new(&bytes[..])) {
            let _ = log.total_s();
            let _ = file_info(&mut log, true);
        }
    }
}
