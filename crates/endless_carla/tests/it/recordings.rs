//! What was recorded is told and replayed.

use crate::client::{Client, serve, serve_recording};
use endless_carla::wire::{EpisodeInfo, MapInfo, Transform, VehicleControl, Wire};
use rmpv::Value;

/// Of the header of an episode, and of a record, bytes.
const HEADER: usize = 36;
const RECORD: usize = 119;

/// Place and speed of each actor in a snapshot.
fn places(payload: &[u8]) -> Vec<(u32, [f32; 3], f32)> {
    let place = |record: &[u8]| {
        let number = |at: usize| f32::from_le_bytes(record[at..at + 4].try_into().expect("four bytes"));
        let speed = [29, 33, 37].map(number).iter().map(|v| v * v).sum::<f32>().sqrt();
        (u32::from_le_bytes(record[..4].try_into().expect("four bytes")), [5, 9, 13].map(number), speed)
    };
    payload[HEADER..].chunks(RECORD).map(place).collect()
}

fn begin_anew(client: &mut Client) -> crate::client::Stream {
    client.call("load_new_episode", &["".into(), false.into(), 65535.into()]).expect("the same map");
    let episode: EpisodeInfo = client.get("get_episode_info", &[]);
    client.listen(&episode.token[0])
}

fn replay(client: &mut Client, start_s: f64, follow: u32) -> String {
    let offset = Transform::default().to_value();
    let arguments = ["drive.log".into(), start_s.into(), 0.0.into(), follow.into(), Value::Boolean(false), offset];
    client.get("replay_file", &arguments)
}

#[test]
fn a_drive_is_recorded_told_and_replayed() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut client = Client::new(serve_recording(Some(folder.path().to_owned())));
    client.synchronous();
    let mut snapshots = begin_anew(&mut client);
    let map: MapInfo = client.get("get_map_info", &[]);
    let description = client.description("vehicle.tesla.model3", &[("role_name", "hero")]);
    let car = client.spawn(&description, &map.recommended_spawn_points[0]);
    let control = VehicleControl { throttle: 0.7, ..VehicleControl::default() };
    client.call("apply_control_to_vehicle", &[car.id.into(), control.to_value()]).expect("a car");
    let path: String = client.get("start_recorder", &["drive.log".into(), true.into()]);
    assert!(path.ends_with("drive.log") && folder.path().join("drive.log").exists());
    let mut driven = Vec::new();
    for _ in 0..60 {
        let frame = client.tick();
        let there = places(&snapshots.of_frame(frame).payload);
        driven.push(there.into_iter().find(|(id, ..)| *id == car.id).expect("the car"));
    }
    client.call("stop_recorder", &[]).expect("stopped");
    let way = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f32>().sqrt();
    assert!(way(driven[0].1, driven[59].1) > 5.0);

    let text: String = client.get("show_recorder_file_info", &["drive.log".into(), true.into()]);
    assert!(text.contains("Map: Town02\n") && text.contains("  role_name = hero\n"));
    assert!(text.contains("Frame 60 at 2.95 seconds\n") && text.ends_with("\nFrames: 60\nDuration: 2.95 seconds\n"));
    let events: String = client.get("show_recorder_file_info", &["./drive.log".into(), false.into()]);
    assert!(events.contains("Frame 1 at 0 seconds") && !events.contains("Frame 2 at"));
    let met: String = client.get("show_recorder_collisions", &["drive.log".into(), 97.into(), 97.into()]);
    assert!(met.contains("Actor 1"));
    let blocked: String = client.get("show_recorder_actors_blocked", &["drive.log".into(), 1.0.into(), 10.0.into()]);
    assert!(blocked.contains("Duration"));
    let missing: String = client.get("show_recorder_file_info", &["none.log".into(), true.into()]);
    assert!(missing.contains("not found on server"));

    // In another episode the car comes by itself, goes the same way, and is let go at the end.
    let mut snapshots = begin_anew(&mut client);
    let said = replay(&mut client, 0.0, car.id);
    assert!(said.contains("Total time recorded: 2.95") && said.contains("at 1.0x"), "{said}");
    let spectator: endless_carla::wire::Actor = client.get("get_spectator", &[]);
    for (step, (_, place, speed)) in driven.iter().enumerate().skip(1).take(50) {
        let frame = client.tick();
        let there = places(&snapshots.of_frame(frame).payload);
        let nearest = there
            .iter()
            .filter(|(id, ..)| *id != spectator.id)
            .min_by(|a, b| way(a.1, *place).total_cmp(&way(b.1, *place)))
            .expect("actors");
        assert!(way(nearest.1, *place) < 0.01, "step {step}: {nearest:?} {place:?}");
        assert!((nearest.2 - speed).abs() < 0.6, "step {step}: {} {speed}", nearest.2);
        let follows = there.iter().find(|(id, ..)| *id == spectator.id).expect("the spectator");
        assert!(way(follows.1, *place) < 0.01);
    }
    client.call("stop_replayer", &[false.into()]).expect("stopped");
    let frame = client.tick();
    let left = places(&snapshots.of_frame(frame).payload);
    assert!(left.iter().all(|(id, place, _)| *id == spectator.id || way(*place, driven[51].1) > 0.5));

    // Twice as fast, and from one second before the end.
    let mut snapshots = begin_anew(&mut client);
    client.call("set_replayer_time_factor", &[2.0.into()]).expect("a factor");
    assert!(replay(&mut client, -1.0, 0).contains("from 1.95 s - 2.95 s (2.95 s) at 2.0x"));
    for _ in 0..5 {
        client.tick();
    }
    let frame = client.tick();
    let there = places(&snapshots.of_frame(frame).payload);
    assert!(there.iter().any(|(_, place, _)| way(*place, driven[51].1) < 0.02), "{there:?} {:?}", driven[51]);
}

#[test]
fn recordings_stay_in_their_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut client = Client::new(serve_recording(Some(folder.path().join("recordings"))));
    for name in ["../a.log", "/tmp/a.log", "a/../../b.log", ""] {
        let refused = client.call("start_recorder", &[name.into(), false.into()]).expect_err(name);
        assert!(refused.contains("--recordings"), "{refused}");
        assert!(client.call("show_recorder_file_info", &[name.into(), true.into()]).is_err());
    }
    let files = std::fs::read_dir(folder.path().join("recordings")).expect("made").count();
    assert_eq!(files, 0);
    std::fs::write(folder.path().join("recordings/notes.txt"), "something else").expect("written");
    assert!(client.call("start_recorder", &["notes.txt".into(), false.into()]).is_err());
    let told: String = client.get("show_recorder_file_info", &["notes.txt".into(), true.into()]);
    assert_eq!(told, "File is not a CARLA recorder\n");
    let mut other = Client::new(serve());
    assert!(other.call("start_recorder", &["a.log".into(), false.into()]).expect_err("no folder").contains("folder"));
}
