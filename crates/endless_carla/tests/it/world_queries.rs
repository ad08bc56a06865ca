//! What clients ask of things, lamps, bones and arms.

use crate::client::{Client, serve};
use endless_carla::wire::{
    Actor, BoundingBox, EnvironmentObject, EpisodeInfo, LightState, Location, MapInfo, Rotation, Transform,
    WalkerBones, WalkerBonesControl, WeatherParameters, Wire,
};

#[test]
fn things_and_lamps_of_a_town_are_told() {
    let mut client = Client::new(serve());
    client.synchronous();
    let all: Vec<EnvironmentObject> = client.get("get_environment_objects", &[255.into()]);
    for (label, least) in [(3u8, 20), (9, 100), (6, 50), (14, 10)] {
        let of_class: Vec<EnvironmentObject> = client.get("get_environment_objects", &[label.into()]);
        assert!(of_class.len() > least && of_class.iter().all(|thing| thing.label == label), "{label}");
        let boxes: Vec<BoundingBox> = client.get("get_all_level_BBs", &[label.into()]);
        assert_eq!(boxes.len(), of_class.len());
    }
    let names: Vec<String> = client.get("get_names_of_all_objects", &[]);
    assert_eq!(names.len(), all.len());
    client.call("enable_environment_objects", &[vec![all[0].id].to_value(), false.into()]).expect("accepted");

    let episode: EpisodeInfo = client.get("get_episode_info", &[]);
    let mut snapshots = client.listen(&episode.token[0]);
    let mut news = |client: &mut Client| {
        let frame = client.tick();
        snapshots.of_frame(frame).payload[32] & 2 != 0
    };
    let lamps: Vec<LightState> = client.get("query_lights_state", &["".into()]);
    assert!(lamps.len() > 20 && lamps.iter().all(|lamp| lamp.group == 2 && !lamp.active));
    assert!(!news(&mut client));
    let lit = LightState { active: true, ..lamps[3].clone() };
    client.call("update_lights_state", &["".into(), vec![lit.clone()].to_value(), false.into()]).expect("set");
    assert!(news(&mut client) && !news(&mut client));
    let told: Vec<LightState> = client.get("query_lights_state", &["".into()]);
    assert_eq!((&told[3], &told[4]), (&lit, &lamps[4]));
    let night = WeatherParameters { sun_altitude_angle: -30.0, ..WeatherParameters::default() };
    client.call("set_weather_parameters", &[night.to_value()]).expect("night");
    assert!(news(&mut client));
    let told: Vec<LightState> = client.get("query_lights_state", &["".into()]);
    assert!(told.iter().all(|lamp| lamp.active));
}

#[test]
fn bones_and_components_are_told() {
    let mut client = Client::new(serve());
    client.synchronous();
    let map: MapInfo = client.get("get_map_info", &[]);
    let person = client.description("walker.pedestrian.0001", &[]);
    let person = client.spawn(&person, &map.recommended_spawn_points[0]);
    let car = client.description("vehicle.tesla.model3", &[]);
    let car = client.spawn(&car, &map.recommended_spawn_points[4]);
    client.tick();
    let bones: WalkerBones = client.get("get_bones_transform", &[person.id.into()]);
    let head = bones.bones.iter().position(|bone| bone.name == "crl_Head__C").expect("a head");
    let place = &map.recommended_spawn_points[0].location;
    let above = &bones.bones[head].world.location;
    assert!((above.x - place.x).hypot(above.y - place.y) < 0.4 && (1.2..1.8).contains(&(above.z - place.z + 0.4)));
    let turned =
        Transform { rotation: Rotation { roll: 60.0, ..Rotation::default() }, ..bones.bones[head].relative.clone() };
    let pose = WalkerBonesControl { bones: vec![("crl_Head__C".to_owned(), turned)] };
    client.call("set_bones_transform", &[person.id.into(), pose.to_value()]).expect("set");
    client.call("blend_pose", &[person.id.into(), 1.0.into()]).expect("seen");
    let posed: WalkerBones = client.get("get_bones_transform", &[person.id.into()]);
    assert!((posed.bones[head].relative.rotation.roll - 60.0).abs() < 0.01);
    let names: Vec<String> = client.get("get_actor_bone_names", &[person.id.into()]);
    assert_eq!(names.len(), bones.bones.len());
    assert!(client.call("get_bones_transform", &[car.id.into()]).is_err());
    for call in ["open_vehicle_door", "close_vehicle_door"] {
        client.call(call, &[car.id.into(), 6.into()]).expect("accepted");
        assert!(client.call(call, &[person.id.into(), 0.into()]).is_err());
        assert!(client.call(call, &[car.id.into(), 7.into()]).is_err());
    }

    let wheels: Vec<Transform> = client.get("get_vehicle_bone_world_transforms", &[car.id.into()]);
    assert_eq!(client.get::<Vec<String>>("get_actor_bone_names", &[car.id.into()]).len(), wheels.len());
    let apart = |a: &Transform, b: &Transform| (a.location.x - b.location.x).hypot(a.location.y - b.location.y);
    assert!((2.5..3.2).contains(&apart(&wheels[1], &wheels[3])) && (1.3..2.0).contains(&apart(&wheels[1], &wheels[2])));
    let parts: Vec<String> = client.get("get_actor_component_names", &[car.id.into()]);
    for part in parts {
        let own: Transform =
            client.get("get_actor_component_relative_transform", &[car.id.into(), part.as_str().into()]);
        assert!(own.location.x.abs() < 3.0);
    }
    assert!(client.call("get_actor_component_world_transform", &[car.id.into(), "wing".into()]).is_err());
    client.call("set_actor_simulate_physics", &[car.id.into(), false.into()]).expect("still");
    client.call("set_wheel_steer_direction", &[car.id.into(), 0.into(), 20.0.into()]).expect("turned");
    assert_eq!(client.get::<f32>("get_wheel_steer_angle", &[car.id.into(), 0.into()]), 20.0);
}

#[test]
fn arms_carry_cameras_level_and_look_at_their_parents() {
    let mut client = Client::new(serve());
    client.synchronous();
    let map: MapInfo = client.get("get_map_info", &[]);
    let car = client.description("vehicle.tesla.model3", &[]);
    let car = client.spawn(&car, &map.recommended_spawn_points[4]);
    let camera = client.description("sensor.other.gnss", &[]);
    let hang = |client: &mut Client, attachment: u8, location: Location| -> Actor {
        let offset = Transform { location, ..Transform::default() }.to_value();
        client.get("spawn_actor_with_parent", &[camera.to_value(), offset, car.id.into(), attachment.into(), "".into()])
    };
    let behind = Location { x: -6.0, y: 0.0, z: 6.0 };
    let [rigid, arm, ghost] = [0, 1, 2].map(|attachment| hang(&mut client, attachment, behind.clone()));
    // Through the ground goes a ghost alone.
    let under = Location { x: -3.0, y: 0.0, z: -9.0 };
    let [stopped, through] = [1, 2].map(|attachment| hang(&mut client, attachment, under.clone()));
    let episode: EpisodeInfo = client.get("get_episode_info", &[]);
    let mut snapshots = client.listen(&episode.token[0]);
    for _ in 0..10 {
        client.tick();
    }
    let frame = client.tick();
    let payload = snapshots.of_frame(frame).payload;
    let places: Vec<(u32, [f32; 6])> = payload[36..]
        .chunks(119)
        .map(|record| {
            let number = |at: usize| f32::from_le_bytes(record[at..at + 4].try_into().expect("four bytes"));
            (u32::from_le_bytes(record[..4].try_into().expect("four bytes")), [5, 9, 13, 17, 21, 25].map(number))
        })
        .collect();
    let of = |id: u32| places.iter().find(|(own, _)| *own == id).expect("there").1;
    let [_, _, z, pitch, ..] = of(ghost.id);
    assert!((pitch + 45.0).abs() < 0.1 && (z - of(car.id)[2] - 6.0).abs() < 0.05);
    assert!(of(rigid.id)[3].abs() < 5.0 && (of(arm.id)[3] + 45.0).abs() < 0.1);
    assert!(of(through.id)[2] < of(car.id)[2] - 8.5);
    assert!(of(stopped.id)[2] > of(car.id)[2] - 0.1, "{:?}", of(stopped.id));
}
