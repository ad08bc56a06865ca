//! Episodes, time, actors and snapshots.

use crate::client::{Client, MAP, serve};
use endless_carla::wire::{Actor, EpisodeInfo, MapInfo, Transform, Wire};

/// Of the header of an episode, and of a record, bytes.
const HEADER: usize = 36;
const RECORD: usize = 119;

#[test]
fn a_client_finds_the_world_and_lets_time_pass() {
    let mut client = Client::new(serve());
    assert_eq!(client.get::<String>("version", &[]), "0.9.16");
    let map: MapInfo = client.get("get_map_info", &[]);
    assert_eq!(map.name, format!("Carla/Maps/{MAP}"));
    assert!(map.recommended_spawn_points.len() > 50);
    assert!(client.get::<String>("get_map_data", &[]).contains("<OpenDRIVE"));
    let episode: EpisodeInfo = client.get("get_episode_info", &[]);
    let mut snapshots = client.listen(&episode.token[0]);
    client.synchronous();
    let first = client.tick();
    assert_eq!(client.tick(), first + 1);
    let message = snapshots.of_frame(first + 1);
    assert_eq!(message.type_id, 17);
    assert_eq!(message.payload[..8], episode.id.to_le_bytes());
    assert_eq!(message.payload[16..20], 0.05f32.to_le_bytes());
    // The car comes down to the road, is there in the next snapshot, and gone in the one after it is destroyed.
    let description = client.description("vehicle.tesla.model3", &[]);
    let place = &map.recommended_spawn_points[0];
    let car = client.spawn(&description, place);
    let there = client.call("spawn_actor", &[description.to_value(), place.to_value()]);
    assert_eq!(there, Err("Spawn failed because of collision at spawn position".to_owned()));
    let with_car = snapshots_ids(&snapshots.of_frame(client.tick()).payload);
    assert!(with_car.contains(&car.id));
    let known: Vec<Actor> = client.get("get_actors_by_id", &[vec![car.id, 60_000].to_value()]);
    assert_eq!(known, std::slice::from_ref(&car));
    assert!(client.get::<bool>("destroy_actor", &[car.id.into()]));
    assert!(!client.get::<bool>("destroy_actor", &[car.id.into()]));
    let without = snapshots_ids(&snapshots.of_frame(client.tick()).payload);
    assert!(!without.contains(&car.id) && without.len() + 1 == with_car.len());
    // Another episode: another number, frames go on, and nobody is left.
    client.call("load_new_episode", &["".into(), false.into(), 65535.into()]).expect("the same map");
    let next: EpisodeInfo = client.get("get_episode_info", &[]);
    assert!(next.id != episode.id && next.token == episode.token, "those who listen already hear of it, too");
    let frame = client.tick();
    assert!(frame > first);
    let message = snapshots.of_frame(frame);
    assert_eq!(message.payload[..8], next.id.to_le_bytes());
    assert_eq!(message.payload[32..36], 1u32.to_le_bytes(), "the first snapshot tells of the map");
}

#[test]
fn the_same_drive_is_the_same_motion() {
    let drive = || {
        let mut client = Client::new(serve());
        client.synchronous();
        // However long the clock ran before.
        client.call("load_new_episode", &["".into(), false.into(), 65535.into()]).expect("the same map");
        let episode: EpisodeInfo = client.get("get_episode_info", &[]);
        let mut snapshots = client.listen(&episode.token[0]);
        let map: MapInfo = client.get("get_map_info", &[]);
        for (id, place) in ["vehicle.audi.tt", "vehicle.yamaha.yzf"].iter().zip(&map.recommended_spawn_points) {
            let description = client.description(id, &[]);
            let car = client.spawn(&description, place);
            let control = rmpv::Value::Array(vec![0.7f32.into(), (-0.1f32).into(), 0.0f32.into()]);
            client.call("apply_control_to_vehicle", &[car.id.into(), control]).expect("a car");
        }
        let frames: Vec<u64> = (0..40).map(|_| client.tick()).collect();
        let payload = snapshots.of_frame(frames[39]).payload;
        // The clock of the machine is left out.
        [&payload[..8], &payload[16..]].concat()
    };
    let first = drive();
    assert_eq!(first, drive());
}

fn snapshots_ids(payload: &[u8]) -> Vec<u32> {
    assert_eq!((payload.len() - HEADER) % RECORD, 0);
    let id = |record: &[u8]| u32::from_le_bytes(record[..4].try_into().expect("four bytes"));
    payload[HEADER..].chunks(RECORD).map(id).collect()
}

#[test]
fn what_hangs_on_another_goes_with_it() {
    let mut client = Client::new(serve());
    client.synchronous();
    let map: MapInfo = client.get("get_map_info", &[]);
    let description = client.description("vehicle.tesla.model3", &[]);
    let car = client.spawn(&description, &map.recommended_spawn_points[3]);
    let gnss = client.description("sensor.other.gnss", &[]);
    let offset = Transform::default().to_value();
    let sensor: Actor =
        client.get("spawn_actor_with_parent", &[gnss.to_value(), offset, car.id.into(), 0.into(), "".into()]);
    let mut stream = client.listen(&sensor.stream_token);
    let frame = client.tick();
    assert_eq!(stream.of_frame(frame).type_id, 4);
    assert!(client.get::<bool>("destroy_actor", &[car.id.into()]));
    assert_eq!(client.get::<Vec<Actor>>("get_actors_by_id", &[vec![sensor.id].to_value()]), []);
}
