//! The sensors of one car agree on what is around it: in several towns, lights and weathers, each with traffic of its own, and
//! as exactly as they measure, before anything is stored.

use crate::{city::city, seen::Seen};
use endless_dataset::RecipeDraft;
use endless_pipeline::{MapUse, Plan, RenderTask, SensorReading, Simulator, resolve_recipe};
use endless_world::math::f64::{asin, atan2, sin_cos};
use endless_world::{
    ClassTag, InstanceId, InstancePixel, LidarSweep, Motion, RadarScan, SceneSettings, SensorLayers, SensorPose,
    WorldState,
};
use glam::{DVec2, DVec3};
use serde_json::json;
use std::{collections::BTreeMap, f64::consts::TAU};

/// Maps, weathers, times of day and seeds.
const SCENES: [(&str, &str, &str, u64); 4] = [
    ("Town02", "clear_sky", "afternoon", 1),
    ("Town02", "rainy", "night", 2),
    ("Town02", "rainy", "night", 5),
    ("Altstadt", "foggy", "morning", 4),
];
/// Pixels around the panorama, and directions of the LiDAR: 2 degrees each.
const AROUND: u32 = 180;

fn recipe_of((map, weather, time, seed): (&str, &str, &str, u64)) -> RecipeDraft {
    let words = |words: &[&str]| Some(words.iter().map(|&word| word.to_owned()).collect());
    let on = |at: [f64; 3], yaw: f64| json!({"on": "vehicle", "class": "car", "at": at, "yaw": yaw});
    let (roof, beside) = (on([0.5, 0.0, 1.9], 0.0), on([0.5, 0.5, 2.1], 20.0));
    let sensors = json!([
        // The middles of its pixels are the directions of the LiDAR.
        {"name": "panorama", "type": "camera", "lens": "equirectangular", "size": "180x90", "mount": roof},
        {"name": "lidar", "type": "lidar", "mount": roof, "channels": 32, "lower_fov": -45.0, "upper_fov": 17.0,
            "horizontal_fov": 360.0, "rotation_frequency": 0.0, "points_per_second": 32 * AROUND * 20, "range": 100.0,
            "range_10_percent": 0.0, "min_range": 0.0, "noise_stddev": 0.0, "motion_distortion": false,
            "weather_effects": false, "dropoff_general_rate": 0.0, "dropoff_intensity_limit": 0.0,
            "dropoff_zero_intensity": 0.0},
        {"name": "fisheye", "type": "camera", "lens": "fisheye", "fov": 180.0, "size": "181x181", "mount": beside},
        {"name": "pinhole", "type": "camera", "fov": 90.0, "size": "181x121", "mount": beside},
        {"name": "radar", "type": "radar", "horizontal_fov": 120.0, "points_per_second": 20_000,
            "mount": on([2.2, 0.0, 0.6], 0.0)},
    ]);
    RecipeDraft {
        videos: Some(1),
        seed: Some(seed),
        maps: words(&[map]),
        weathers: words(&[weather]),
        times: words(&[time]),
        fps: Some(20.0),
        duration: Some(0.1),
        vehicles: Some(60),
        pedestrians: Some(30),
        cameras_per_scene: Some(0),
        sensor: serde_json::from_value(sensors).ok(),
        layers: words(&["depth", "instance"]),
        camera_look: Some("clean".to_owned()),
        ..RecipeDraft::default()
    }
}

/// What the rig measured at one instant.
struct Measured {
    state: WorldState,
    /// Its carrier, which the LiDAR looks through.
    carrier: InstanceId,
    cameras: BTreeMap<String, Seen>,
    lidar: (SensorPose, LidarSweep),
    radar: (SensorPose, RadarScan),
}

impl Measured {
    fn new<'m>(
        settings: &SceneSettings,
        carrier: InstanceId,
        state: WorldState,
        task: &(impl RenderTask<'m> + ?Sized),
    ) -> Self {
        let (mut cameras, mut lidar, mut radar) = (BTreeMap::new(), None, None);
        for (place, sensor) in settings.sensors.iter().enumerate() {
            let pose = task.sensor_pose(&state, place).expect("carried");
            match task.sense(&state, place).expect("measured") {
                SensorReading::Camera(frame) => {
                    let camera = sensor.model.camera().expect("a lens").at(&sensor.mount, &pose, state.time_s);
                    cameras.insert(sensor.name.clone(), Seen::new(camera, *frame));
                }
                SensorReading::Lidar(sweep) => lidar = Some((pose, sweep)),
                SensorReading::Radar(scan) => radar = Some((pose, scan)),
            }
        }
        Self { state, carrier, cameras, lidar: lidar.expect("of the rig"), radar: radar.expect("of the rig") }
    }
}

/// What points of the LiDAR are asked of the picture of the same place, whose pixels' rays are theirs.
#[derive(Debug, Default)]
struct AlongTheRay {
    asked: u32,
    objects: u32,
    /// Nearer or farther by more than a millimetre, or something else: where a ray meets an edge.
    edges: u32,
}

impl AlongTheRay {
    fn ask(&mut self, of: &Measured) {
        let panorama = &of.cameras["panorama"];
        for point in &of.lidar.1.points {
            let [x, y, z] = point.position.as_dvec3().to_array();
            let distance = DVec3::new(x, y, z).length();
            let across = (0.5 - atan2(y, x) / TAU) * f64::from(AROUND) - 0.5;
            let down = (0.25 - asin(z / distance) / TAU) * f64::from(AROUND) - 0.5;
            let (column, row) = (across.round() as i64, down.round() as i64);
            let off = DVec2::new(across - column as f64, down - row as f64);
            assert!(off.length() < 1e-3, "the direction of {point:?} is that of no pixel");
            let column = column.rem_euclid(i64::from(AROUND)) as u32;
            let seen = *panorama.instance.at(column, row as u32);
            if seen.id == of.carrier {
                continue;
            }
            let off_m = (f64::from(*panorama.depth.at(column, row as u32)) - distance).abs();
            self.asked += 1;
            self.objects += u32::from(seen.id != InstanceId::STUFF);
            self.edges += u32::from(off_m > 1e-3 || seen != InstancePixel { tag: point.tag, id: point.id });
        }
    }
}

/// What points of the LiDAR are asked of the picture of a camera beside it, away from edges.
#[derive(Debug, Default)]
struct FromAside {
    asked: u32,
    other: u32,
}

impl FromAside {
    fn ask(&mut self, of: &Measured) {
        let pinhole = &of.cameras["pinhole"];
        let forward = pinhole.camera.world_from_camera.z_axis;
        for point in &of.lidar.1.points {
            let world = of.lidar.0.world_from_sensor_point(point.position.as_dvec3()).as_vec3();
            let Some((at, depth)) = pinhole.camera.project(world) else { continue };
            let Some((shown_m, seen)) = pinhole.inner(at.x.floor() as i32, at.y.floor() as i32) else { continue };
            let cosine = pinhole.camera.ray(at.x, at.y).map_or(1.0, |ray| ray.direction.dot(forward));
            let distance = depth / cosine;
            // What lies behind what the camera shows is hidden from it, and what is narrower than a pixel lies between what
            // it shows.
            let is_thin = matches!(point.tag, ClassTag::Poles | ClassTag::RoadLines) && seen.tag != point.tag;
            if is_thin || distance > 1.15 * shown_m {
                continue;
            }
            self.asked += 1;
            self.other += u32::from(seen != InstancePixel { tag: point.tag, id: point.id });
        }
    }
}

/// Pixels of two lenses at one place, away from edges.
#[derive(Debug, Default)]
struct TwoLenses {
    asked: u32,
    objects: u32,
    unlike: u32,
    apart: u32,
}

impl TwoLenses {
    fn ask(&mut self, one: &Seen, other: &Seen) {
        let [asked, objects, unlike, apart] = one.compare(other);
        self.asked += asked;
        self.objects += objects;
        self.unlike += unlike;
        self.apart += apart;
    }
}

/// Detections of a radar.
#[derive(Debug, Default)]
struct Doppler {
    still: u32,
    moving: u32,
    /// Those of what moves that are not of its body: of wheels and limbs.
    parts: u32,
}

impl Doppler {
    fn ask(&mut self, of: &Measured) {
        let (pose, scan) = &of.radar;
        for found in &scan.detections {
            let [azimuth, altitude] = [found.azimuth_rad, found.altitude_rad].map(f64::from);
            let (up, out) = sin_cos(altitude);
            let level = DVec2::from_angle(azimuth) * out;
            let direction = pose.world_from_sensor * DVec3::new(level.x, level.y, up);
            let place = pose.position + direction * f64::from(found.depth_m);
            let actor = of.state.actors.iter().find(|a| a.id == found.id || a.rider_id == Some(found.id));
            let Some(actor) = actor else {
                // Parked or no object at all.
                let expected = -pose.velocity_mps.dot(direction);
                let off = (f64::from(found.velocity_mps) - expected).abs();
                assert!(off < 1e-3, "{found:?}: {expected} m/s expected of what stands");
                self.still += 1;
                continue;
            };
            let Motion::Vehicle(motion) = actor.motion else { continue };
            let relative = actor.velocity_mps.as_dvec3() - pose.velocity_mps;
            let off = (f64::from(found.velocity_mps) - relative.dot(direction)).abs();
            // A body that turns moves by its lever; the rim of a wheel as fast as the car, forward or back.
            let lever = (place - actor.pose.position.as_dvec3()).truncate().length();
            let turn = f64::from((motion.speed_mps * motion.steer_rad).abs()) * lever;
            let rim = f64::from(motion.speed_mps.abs()) * 1.05;
            assert!(off < 1e-3 + turn + rim, "{found:?}: off by {off} m/s of {relative} and {motion:?}");
            self.moving += 1;
            self.parts += u32::from(off > 1e-3 + turn);
        }
    }
}

#[test]
fn sensors_of_a_car_agree_in_every_scene() {
    let (mut along, mut aside, mut doppler) = (AlongTheRay::default(), FromAside::default(), Doppler::default());
    let mut lenses = TwoLenses::default();
    for of_map in SCENES.chunk_by(|a, b| a.0 == b.0) {
        let map = city().load_map(&MapUse { name: of_map[0].0, cameras: &[], videos: &[] }).expect("a town");
        for scene in of_map {
            let recipe = resolve_recipe(recipe_of(*scene), city()).expect("a recipe");
            let plan = Plan::new(&recipe, city()).expect("a plan");
            let settings = &plan.scenes[0];
            let mut session = city().open_session(&map, settings, SensorLayers::default()).expect("a scene");
            let carrier = session.carrier(0).expect("a car");
            for _ in 0..2 {
                let step = session.tick().expect("a frame");
                let of = Measured::new(settings, carrier, step.state, &*step.task);
                assert!(of.lidar.1.points.len() > 1500, "{scene:?}: {} points", of.lidar.1.points.len());
                along.ask(&of);
                aside.ask(&of);
                doppler.ask(&of);
                lenses.ask(&of.cameras["pinhole"], &of.cameras["fisheye"]);
            }
            println!("so far, with {scene:?}: {along:?} {aside:?} {lenses:?} {doppler:?}");
        }
    }
    assert!(along.asked > 15_000 && along.objects > 500 && along.edges * 1000 <= along.asked, "{along:?}");
    assert!(aside.asked > 3000 && aside.other * 1000 <= aside.asked, "{aside:?}");
    let TwoLenses { asked, objects, unlike, apart } = lenses;
    assert!(asked > 50_000 && objects > 300 && unlike * 1000 <= asked && apart * 1000 <= asked, "{lenses:?}");
    let Doppler { still, moving, parts } = doppler;
    assert!(still > 1000 && moving > 100 && parts * 2 < moving, "{doppler:?}");
}
