//! A dataset of two videos, small enough to count by hand.
//!
//! The first has two cameras and three frames: a parked car, and somebody on foot who is hidden in the second frame of
//! camera a and seen by camera b once. The second has one camera, and a map with a name that no page must take for script:
//! a bicycle with its rider, and the person of the first video, while morning becomes afternoon.

use endless_dataset::LabelSchema;
use serde_json::{Value, json};
use std::{fs, path::Path};
use tempfile::TempDir;

pub(crate) const HOSTILE: &str = "</script><script>alert(1)</script><img src=x onerror=alert(2)>\u{1b}[2J\"'&";

fn object(id: u32, class: &str, bbox: [u32; 4], more: &Value) -> Value {
    let mut object = json!({
        "id": id, "class": class, "bbox": bbox, "pixels": bbox[2] * bbox[3] / 2, "truncated": bbox[0] == 0,
        "parked": false, "position": [0.0, 0.0, 0.0], "yaw_rad": 0.0, "speed_mps": 0.0,
        "distance_m": 25.0, "visibility": 0.5, "truncation": 0.0, "occluders": [],
    });
    for (key, value) in more.as_object().expect("fields") {
        object[key] = value.clone();
    }
    object
}

fn car(pixels_from_left: u32) -> Value {
    object(1, "car", [pixels_from_left, 10, 40, 30], &json!({"parked": true}))
}

fn walker(id: u32) -> Value {
    object(id, "pedestrian", [80, 40, 4, 8], &json!({"speed_mps": 1.25, "visibility": 1.0, "distance_m": 40.0}))
}

fn video(number: u32, name: &str, map: &str, condition: [&str; 2], cameras: &[&str], boxes: &[u64]) -> Value {
    json!({"video": number, "name": name, "state": "complete", "map": map, "weather": condition[0],
           "time_of_day": condition[1], "cameras": cameras, "frames": 3, "boxes": boxes, "builds": [0]})
}

pub(crate) fn write(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().expect("a folder")).expect("writable");
    fs::write(path, text).expect("writable");
}

fn write_lines(path: &Path, lines: &[Value]) {
    write(path, &lines.iter().map(|line| format!("{line}\n")).collect::<String>());
}

fn write_camera(folder: &Path, frames: [Vec<Value>; 3]) {
    write(&folder.join("camera.json"), &json!({"size": {"width": 100, "height": 50}, "fps": 10.0}).to_string());
    let frames = frames.into_iter().enumerate();
    let lines: Vec<Value> = frames
        .map(|(frame, objects)| json!({"frame": frame, "time_s": 0.1 * frame as f64, "objects": objects}))
        .collect();
    write_lines(&folder.join("objects.jsonl"), &lines);
}

fn write_scene(folder: &Path, vehicles: u32, times: [&str; 3], weather: &str) {
    let scene = json!({"fps": 10.0, "spawned": {"vehicles": vehicles, "pedestrians": 2, "parked": 1},
        "incidents": [{"kind": "near_miss", "actors": [2]}], "missed_events": ["collision"]});
    write(&folder.join("scene.json"), &scene.to_string());
    let line = |(frame, time): (usize, &&str)| {
        let events = if frame == 1 { json!([{"kind": "stop", "id": 1}]) } else { json!([]) };
        json!({"frame": frame, "time_s": 0.1, "weather": {"name": weather}, "light": {"time_of_day": time},
               "signals": [], "counts": {}, "events": events})
    };
    let lines: Vec<Value> = times.iter().enumerate().map(line).collect();
    write_lines(&folder.join("frames.jsonl"), &lines);
}

fn person(id: u32, class: &str, reid: &str, tone: u8) -> Value {
    json!({"id": id, "class": class, "parked": false, "reid": reid, "person": {"identity": "00000000000000aa",
        "age_years": 37, "age_group": "adult", "sex": "female", "height_m": 1.7, "skin_tone": tone}})
}

/// The folder of the dataset.
pub(crate) fn dataset() -> TempDir {
    let folder = tempfile::tempdir().expect("temp");
    let root = folder.path();
    let recipe = json!({"videos": 2, "vehicles": 3, "pedestrians": 2, "maps": ["Town01", HOSTILE], "cameras_per_scene": 2,
        "weathers": ["rainy", "clear_sky"], "times": ["morning", "night"], "size": "100x50", "fps": 10.0, "duration": 0.3,
        "seed": 0, "layers": ["rgb"], "rgb_format": "png", "min_pixels": 1, "mp4": [], "simulator": "builtin",
        "camera_look": "clean"});
    let videos = [
        video(0, "first", "Town01", ["rainy", "night"], &["mast", "wall"], &[5, 1]),
        video(1, "second", HOSTILE, ["clear_sky", "morning"], &["mast"], &[7]),
    ];
    let build = json!({"version": "0", "commit": "0", "sources": "0"});
    let manifest = json!({"format": 2, "tool": "endless", "builds": [build], "seed": 0, "recipe": recipe,
        "labels": LabelSchema::current(), "videos": videos});
    write(&root.join("dataset.json"), &manifest.to_string());

    let first = root.join("videos/first");
    write_scene(&first, 3, ["night"; 3], "rainy");
    write_camera(&first.join("camera_a"), [vec![car(0), walker(2)], vec![car(0)], vec![car(0), walker(2)]]);
    write_camera(&first.join("camera_b"), [vec![walker(2)], vec![], vec![]]);
    let cars = [1, 9].map(|id| {
        json!({"id": id, "class": "car", "parked": true, "reid": "0000000000000001",
               "vehicle": {"model": "car.city", "subclass": "city", "color": {"name": "white", "rgb": [9, 9, 9]}}})
    });
    let actors = json!([cars[0], person(2, "pedestrian", "00000000000000bb", 7), cars[1]]);
    write(&first.join("actors.json"), &actors.to_string());

    let second = root.join("videos/second");
    write_scene(&second, 5, ["morning", "morning", "afternoon"], "clear_sky");
    let ridden = |x: u32| {
        let moves = json!({"speed_mps": 5.5, "visibility": 1.0});
        vec![object(3, "bicycle", [x, 20, 20, 10], &moves), object(4, "rider", [x, 10, 10, 20], &moves)]
    };
    let last = [ridden(70), vec![walker(5)]].concat();
    write_camera(&second.join("camera_a"), [ridden(10), ridden(40), last]);
    let actors = json!([person(4, "rider", "00000000000000cc", 2), person(5, "pedestrian", "00000000000000bb", 7)]);
    write(&second.join("actors.json"), &actors.to_string());
    folder
}
