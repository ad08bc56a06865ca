//! What clients do to vehicles and sensors, and what they read of it in the next frames.

use crate::client::{Client, MAP, Stream, serve};
use endless_carla::stream::{ActorRecord, RecordKind, read_snapshot};
use endless_carla::wire::{
    Actor, EpisodeInfo, Location, MapInfo, Transform, Vector3D, VehicleControl, VehiclePhysicsControl, Wire,
};

fn spawn_points(client: &mut Client) -> Vec<Transform> {
    client.get::<MapInfo>("get_map_info", &[]).recommended_spawn_points
}

fn snapshots(client: &mut Client) -> Stream {
    let episode: EpisodeInfo = client.get("get_episode_info", &[]);
    client.listen(&episode.token[0])
}

/// A frame later.
fn record(client: &mut Client, snapshots: &mut Stream, actor: &Actor) -> ActorRecord {
    let frame = client.tick();
    let payload = snapshots.of_frame(frame).payload;
    let (_, records) = read_snapshot(&payload, |_| RecordKind::Other).expect("a snapshot");
    records.into_iter().find(|record| record.id == actor.id).expect("it is there")
}

fn drive(client: &mut Client, car: &Actor, control: &VehicleControl) {
    client.call("apply_control_to_vehicle", &[car.id.into(), control.to_value()]).expect("a vehicle");
}

#[test]
fn a_pose_on_the_road_is_kept_in_the_first_frame() {
    let mut client = Client::new(serve());
    client.synchronous();
    let mut snapshots = snapshots(&mut client);
    let description = client.description("vehicle.tesla.model3", &[]);
    let mut lowered_m: f32 = 0.0;
    for place in spawn_points(&mut client).into_iter().step_by(9) {
        let car = client.spawn(&description, &place);
        let there = record(&mut client, &mut snapshots, &car).transform;
        let (told, set) = (&there.rotation, &place.rotation);
        let turned = [told.pitch - set.pitch, told.yaw - set.yaw, told.roll - set.roll];
        assert!(turned.iter().all(|degrees| degrees.abs() < 0.005), "{told:?} in place of {set:?}");
        let gone_m = (there.location.x - place.location.x).hypot(there.location.y - place.location.y);
        assert!(gone_m < 0.005, "{gone_m}");
        lowered_m = lowered_m.max(place.location.z - there.location.z);
        client.get::<bool>("destroy_actor", &[car.id.into()]);
    }
    assert!(lowered_m > 0.2, "they stand on the road: {lowered_m}");
}

#[test]
fn a_control_that_does_not_stick_holds_for_a_frame() {
    let mut client = Client::new(serve());
    client.synchronous();
    let mut snapshots = snapshots(&mut client);
    let place = spawn_points(&mut client)[0].clone();
    let full = VehicleControl { throttle: 1.0, ..VehicleControl::default() };
    let mut speed = |sticky: &str, again: bool| {
        let description = client.description("vehicle.tesla.model3", &[("sticky_control", sticky)]);
        let car = client.spawn(&description, &place);
        client.tick();
        drive(&mut client, &car, &full);
        for _ in 0..20 {
            client.tick();
            if again {
                drive(&mut client, &car, &full);
            }
        }
        let Vector3D { x, y, .. } = record(&mut client, &mut snapshots, &car).velocity;
        client.get::<bool>("destroy_actor", &[car.id.into()]);
        x.hypot(y)
    };
    let kept = speed("true", false);
    assert!(kept > 2.0, "{kept}");
    assert_eq!([speed("true", true), speed("false", true)], [kept; 2]);
    assert!(speed("false", false) < 0.5 * kept);
}

#[test]
fn tyres_grip_otherwise_in_a_friction_trigger() {
    let mut client = Client::new(serve());
    client.synchronous();
    let points = spawn_points(&mut client);
    let car = client.description("vehicle.tesla.model3", &[]);
    let (inside, outside) = (client.spawn(&car, &points[0]), client.spawn(&car, &points[20]));
    let attributes = [("friction", "0.25"), ("extent_x", "1500"), ("extent_y", "1500"), ("extent_z", "300")];
    let trigger = client.description("static.trigger.friction", &attributes);
    let trigger = client.spawn(&trigger, &points[0]);
    assert_eq!(trigger.bounding_box.extent, Vector3D { x: 15.0, y: 15.0, z: 3.0 });
    let frictions = |client: &mut Client| {
        client.tick();
        [&inside, &outside].map(|car| {
            let control: VehiclePhysicsControl = client.get("get_physics_control", &[car.id.into()]);
            control.wheels[0].tire_friction
        })
    };
    let [wet, dry] = frictions(&mut client);
    assert!(wet == 0.25 && dry > 1.0, "{wet} {dry}");
    let away = Location { z: points[0].location.z + 50.0, ..points[0].location.clone() };
    client.call("set_actor_location", &[trigger.id.into(), away.to_value()]).expect("moved");
    assert_eq!(frictions(&mut client), [dry; 2]);
}

#[test]
fn noise_is_the_same_after_the_world_was_loaded_again() {
    let mut client = Client::new(serve());
    client.synchronous();
    let measured = |client: &mut Client, seed: &str| {
        client.call("load_new_episode", &["".into(), false.into(), 65535.into()]).expect("the same map");
        let place = spawn_points(client)[0].clone();
        let attributes = [("noise_seed", seed), ("noise_lat_stddev", "0.001"), ("noise_lon_stddev", "0.001")];
        let gnss = client.description("sensor.other.gnss", &attributes);
        let gnss = client.spawn(&gnss, &place);
        let mut stream = client.listen(&gnss.stream_token);
        (0..3)
            .map(|_| {
                let frame = client.tick();
                stream.of_frame(frame).payload
            })
            .collect::<Vec<_>>()
    };
    for seed in ["0", "17"] {
        let first = measured(&mut client, seed);
        assert_ne!(first[0], first[1]);
        assert_eq!(measured(&mut client, seed), first);
        assert_ne!(measured(&mut client, "18"), first);
    }
}

#[test]
fn a_map_in_layers_keeps_its_name() {
    let mut client = Client::new(serve());
    client.synchronous();
    let mut name_of = |map: &str| {
        client.call("load_new_episode", &[map.into(), true.into(), 65535.into()]).expect("a map");
        client.get::<MapInfo>("get_map_info", &[]).name
    };
    let layered = format!("{MAP}_Opt");
    assert_eq!(name_of(&layered), format!("Carla/Maps/{layered}"));
    assert_eq!(name_of(""), format!("Carla/Maps/{layered}"), "the same again");
    assert_eq!(name_of(&format!("/Game/Carla/Maps/{MAP}")), format!("Carla/Maps/{MAP}"));
}
