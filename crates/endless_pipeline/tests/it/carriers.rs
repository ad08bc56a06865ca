//! Who carries the sensors of a rig: vehicles out of whose bodies these look.

use crate::{city::city, fake::options};
use endless_dataset::RecipeDraft;
use endless_pipeline::{
    BuiltinMap, MapUse, Plan, SensorReading, SilentProgress, Simulator, SimulatorError, generate, resolve_recipe,
};
use endless_world::{InstanceId, SensorFrame, SensorLayers};
use serde_json::{Value, json};

const TOWN: &str = "Town02";

fn draft(seed: u64, sensors: &Value) -> RecipeDraft {
    let words = |words: &[&str]| Some(words.iter().map(|&word| word.to_owned()).collect());
    RecipeDraft {
        videos: Some(1),
        seed: Some(seed),
        maps: words(&[TOWN]),
        weathers: words(&["cloudy"]),
        times: words(&["afternoon"]),
        fps: Some(20.0),
        duration: Some(0.1),
        vehicles: Some(20),
        pedestrians: Some(0),
        cameras_per_scene: Some(0),
        sensor: serde_json::from_value(sensors.clone()).ok(),
        layers: words(&["depth", "instance"]),
        camera_look: Some("clean".to_owned()),
        ..RecipeDraft::default()
    }
}

fn sensor(name: &str, kind: &str, class: &str, at: [f64; 3], more: Value) -> Value {
    let mut sensor = json!({"name": name, "type": kind, "mount": {"on": "vehicle", "class": class, "at": at}});
    if let (Value::Object(own), Value::Object(more)) = (&mut sensor, more) {
        own.extend(more);
    }
    sensor
}

fn camera(class: &str, at: [f64; 3]) -> Value {
    sensor("eye", "camera", class, at, json!({"size": "64x36", "fov": 81.4}))
}

/// Who carries the first sensor, and what that shows at frame 0 if it is a camera.
fn carried(
    town: &BuiltinMap,
    seed: u64,
    sensors: &Value,
    renders: bool,
) -> Result<(InstanceId, Option<SensorFrame>), SimulatorError> {
    let recipe = resolve_recipe(draft(seed, sensors), city()).expect("a recipe");
    let plan = Plan::new(&recipe, city()).expect("a plan");
    let mut session = city().open_session(town, &plan.scenes[0], SensorLayers::default())?;
    let carrier = session.carrier(0).expect("carried");
    if !renders {
        return Ok((carrier, None));
    }
    let step = session.tick()?;
    match step.task.sense(&step.state, 0)? {
        SensorReading::Camera(frame) => Ok((carrier, Some(*frame))),
        _ => panic!("the first sensor is a camera"),
    }
}

#[test]
fn cameras_ride_on_vehicles_whose_bodies_they_look_out_of() {
    let town = city().load_map(&MapUse { name: TOWN, cameras: &[], videos: &[] }).expect("a town");
    // Above the roofs of low cars, with an IMU, which may be anywhere.
    let imu = |class: &str| sensor("imu", "imu", class, [-0.81, 0.32, 0.93], json!({}));
    let mut others = 0;
    for (seed, class) in [(1, "car"), (2, "any"), (3, "car"), (4, "car"), (5, "any"), (6, "car"), (7, "any")] {
        let (farthest, _) = carried(&town, seed, &json!([imu(class)]), false).expect("somebody drives");
        let rig = json!([camera(class, [0.27, 0.06, 1.55]), imu(class)]);
        let (carrier, seen) = carried(&town, seed, &rig, seed % 3 == 0).expect("somebody is low enough");
        others += u32::from(carrier != farthest);
        println!("seed {seed}, {class}: {carrier} in place of {farthest}");
        let Some(seen) = seen else { continue };
        let own = seen.instance.data.iter().filter(|pixel| pixel.id == carrier).count();
        assert!(own * 10 < seen.instance.data.len() * 3, "seed {seed}: its carrier covers {own} pixels");
    }
    assert!(others > 0, "whoever gets farthest can carry all of these");
}

#[test]
fn sensors_that_no_body_lets_see_are_told_before_anything_is_rendered() {
    let told = |sensors: &Value| {
        let recipe = resolve_recipe(draft(1, sensors), city()).expect("a recipe");
        let out = tempfile::tempdir().expect("temp");
        let error =
            generate(city(), &recipe, out.path(), &options(1), &SilentProgress).expect_err("refused").to_string();
        assert_eq!(error.lines().count(), 1, "{error}");
        let images = walk(out.path()).into_iter().filter(|name| name.ends_with(".png")).count();
        assert_eq!(images, 0, "{error}");
        error
    };
    let inside = told(&json!([camera("car", [0.0, 0.0, 0.8])]));
    assert!(
        inside.contains("sensor eye rides on a car, and of") && inside.contains("only 0 have it outside"),
        "{inside}"
    );
    let lidar = told(&json!([sensor("lidar", "lidar", "car", [0.0, 0.0, 0.8], json!({"preset": "vlp_16"}))]));
    assert!(lidar.contains("sensor lidar rides on a car"), "{lidar}");
    // Above the roof, but towards it.
    let mut down = camera("car", [0.0, 0.0, 2.2]);
    down["mount"]["pitch"] = json!(-80.0);
    assert!(told(&json!([down])).contains("sensor eye rides on a car"), "it sees the roof");
}

/// The names of all files.
fn walk(folder: &std::path::Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    entries
        .flat_map(|entry| match entry.path().is_dir() {
            true => walk(&entry.path()),
            false => vec![entry.file_name().to_string_lossy().into_owned()],
        })
        .collect()
}
