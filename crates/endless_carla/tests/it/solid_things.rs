//! Things that stop vehicles, and are seen.

use crate::client::{Client, Stream, serve};
use endless_carla::rpc::read_value;
use endless_carla::wire::{Actor, EnvironmentObject, Location, MapInfo, Rotation, Transform, Vector3D, Wire};
use endless_world::math::sin_cos;
use rmpv::Value;

/// A place ahead of another, metres.
pub(crate) fn ahead(of: &Transform, forward_m: f32, up_m: f32) -> Transform {
    let (sin_yaw, cos_yaw) = sin_cos(of.rotation.yaw.to_radians());
    let Location { x, y, z } = of.location;
    let location = Location { x: x + forward_m * cos_yaw, y: y + forward_m * sin_yaw, z: z + up_m };
    Transform { location, rotation: Rotation { pitch: 0.0, roll: 0.0, ..of.rotation.clone() } }
}

/// Drives a car against something; gives who it met, and how far it came.
pub(crate) fn crash(client: &mut Client, from: &Transform, speed_mps: f32) -> (Option<Actor>, f32) {
    let car = client.description("vehicle.tesla.model3", &[]);
    let car = client.spawn(&car, from);
    let sensor = client.description("sensor.other.collision", &[]);
    let no_offset = Transform::default().to_value();
    let on_car = [sensor.to_value(), no_offset, car.id.into(), 0.into(), "".into()];
    let sensor: Actor = client.get("spawn_actor_with_parent", &on_car);
    let mut stream = client.listen(&sensor.stream_token);
    client.tick();
    let (sin_yaw, cos_yaw) = sin_cos(from.rotation.yaw.to_radians());
    let velocity = Vector3D { x: speed_mps * cos_yaw, y: speed_mps * sin_yaw, z: 0.0 };
    client.call("set_actor_target_velocity", &[car.id.into(), velocity.to_value()]).expect("pushed");
    for _ in 0..40 {
        client.tick();
    }
    let there: Transform = place(client, car.id);
    let moved = (there.location.x - from.location.x).hypot(there.location.y - from.location.y);
    let met = first_met(&mut stream);
    client.call("destroy_actor", &[sensor.id.into()]).expect("gone");
    client.call("destroy_actor", &[car.id.into()]).expect("gone");
    (met, moved)
}

/// Where an actor is.
fn place(client: &mut Client, id: u32) -> Transform {
    let components: Value =
        client.call("get_actor_component_world_transform", &[id.into(), "VehicleMesh".into()]).expect("one");
    Transform::from_value(&components).expect("a transform")
}

fn first_met(stream: &mut Stream) -> Option<Actor> {
    stream.0.set_read_timeout(Some(std::time::Duration::from_secs(2))).expect("a timeout");
    let mut length = [0; 4];
    std::io::Read::read_exact(&mut stream.0, &mut length).ok()?;
    let mut bytes = vec![0; u32::from_le_bytes(length) as usize];
    std::io::Read::read_exact(&mut stream.0, &mut bytes).expect("all of it");
    let event = read_value(&mut &bytes[48..]).expect("an event");
    Some(Actor::from_value(&event[1]).expect("an actor"))
}

#[test]
fn cars_stop_at_what_stands_in_a_town() {
    let mut client = Client::new(serve());
    client.synchronous();
    const CAR: u8 = 14;
    let parked: Vec<EnvironmentObject> = client.get("get_environment_objects", &[CAR.into()]);
    let (met, moved) = crash(&mut client, &ahead(&parked[0].transform, -9.0, 0.3), 12.0);
    let met = met.expect("it met something");
    assert_eq!(met.id, 0);
    assert!(met.description.id.starts_with("static."), "{}", met.description.id);
    assert!(moved < 9.0, "{moved} m");
}

#[test]
fn props_stop_cars_and_are_seen_where_they_are() {
    let mut client = Client::new(serve());
    client.synchronous();
    let map: MapInfo = client.get("get_map_info", &[]);
    let start = &map.recommended_spawn_points[0];
    let prop = client.description("static.prop.container", &[]);
    let prop = client.spawn(&prop, &ahead(start, 12.0, -0.4));
    let size = [("image_size_x", "96"), ("image_size_y", "54")];
    let camera = client.description("sensor.camera.instance_segmentation", &size);
    let camera = client.spawn(&camera, &ahead(start, 6.0, 1.2));
    let mut stream = client.listen(&camera.stream_token);
    let mut seen = |client: &mut Client| {
        let frame = client.tick();
        let image = stream.of_frame(frame).payload;
        let own = |pixel: &&[u8; 4]| u32::from(pixel[1]) + 256 * u32::from(pixel[0]) == prop.id;
        image[12..].as_chunks::<4>().0.iter().filter(own).count()
    };
    let car = client.description("vehicle.tesla.model3", &[]);
    let within = [car.to_value(), ahead(start, 12.0, 0.0).to_value()];
    assert!(client.call("spawn_actor", &within).is_err_and(|error| error.contains("collision")));
    let near = seen(&mut client);
    assert!(near > 60, "{near} pixels");
    let (met, moved) = crash(&mut client, start, 12.0);
    assert_eq!(met.map(|actor| actor.id), Some(prop.id));
    assert!(moved < 11.0, "{moved} m");
    client.call("set_actor_transform", &[prop.id.into(), ahead(start, 18.0, -0.4).to_value()]).expect("moved");
    let far = seen(&mut client);
    assert!(far > 15 && far < near, "{far} of {near} pixels");
    client.call("destroy_actor", &[prop.id.into()]).expect("gone");
    assert_eq!(seen(&mut client), 0);
    let (_, moved) = crash(&mut client, start, 12.0);
    assert!(moved > 13.0, "{moved} m");
}

#[test]
fn detectors_tell_how_far_ahead_something_is() {
    let mut client = Client::new(serve());
    client.synchronous();
    let map: MapInfo = client.get("get_map_info", &[]);
    let start = &map.recommended_spawn_points[0];
    let car = client.description("vehicle.tesla.model3", &[]);
    let other = client.spawn(&car, &ahead(start, 14.0, 0.0));
    let car = client.spawn(&car, start);
    let detector = |client: &mut Client, only_dynamics: &str| {
        let attributes = [("distance", "20"), ("hit_radius", "0.3"), ("only_dynamics", only_dynamics)];
        let sensor = client.description("sensor.other.obstacle", &attributes);
        let bumper = Transform { location: Location { x: 2.5, y: 0.0, z: 0.7 }, ..Transform::default() };
        let on_car = [sensor.to_value(), bumper.to_value(), car.id.into(), 0.into(), "".into()];
        let sensor: Actor = client.get("spawn_actor_with_parent", &on_car);
        client.listen(&sensor.stream_token)
    };
    let mut streams = [detector(&mut client, "false"), detector(&mut client, "true")];
    let mut told = |client: &mut Client, stream: usize| {
        let frame = client.tick();
        let event = read_value(&mut &streams[stream].of_frame(frame).payload[..]).expect("an event");
        let actor = |at: usize| Actor::from_value(&event[at]).expect("an actor");
        (actor(0).id, actor(1), event[2].as_f64().expect("metres"))
    };
    // 14 m from middle to middle, less half of the other and the way to the bumper and the ball's own radius.
    let expected = 14.0 - 2.5 - 0.3 - f64::from(other.bounding_box.extent.x);
    for stream in 0..2 {
        let (own, met, distance_m) = told(&mut client, stream);
        assert_eq!((own, met.id), (car.id, other.id));
        assert!((distance_m - expected).abs() < 0.2, "{distance_m} m, not {expected}");
    }
    // A prop before it is met by the one that looks for everything.
    let cone = client.description("static.prop.streetbarrier", &[]);
    let cone = client.spawn(&cone, &ahead(start, 7.0, -0.4));
    let (_, met, distance_m) = told(&mut client, 0);
    assert!(met.id == cone.id && distance_m < 5.0, "{} {distance_m} m", met.description.id);
    assert_eq!(told(&mut client, 1).1.id, other.id);
}
