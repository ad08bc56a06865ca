//! Sensors of rigs: on vehicles, people, drones and poles, beside cameras or without any.

use crate::{
    city::city,
    fake::{assert_same, options},
};
use endless_dataset::{
    CameraLayout, DatasetLayout, FrameFolder, Layer, PoseLine, RecipeDraft, RgbFormat, SensorSpec, VideoLayout, check,
    decode_pixel_events, depth_from_rgb, detections_from_csv, instance_from_rgb, point_labels, points_from_bin,
    points_from_ply, read_lines, read_objects, read_rgb,
};
use endless_pipeline::{Generated, Plan, SilentProgress, generate, resolve_recipe};
use endless_world::math::f64::{ln, sin_cos};
use endless_world::{
    ClassTag, Image, ImageSize, ImuRecord, InstancePixel, ObjectClass, PinholeCamera, SensorPose, rotation_from_vector,
    rotation_vector,
};
use glam::{DVec2, DVec3, UVec2};
use serde_json::json;
use std::{fs, path::Path};

const TOWN: &str = "Town02";
const SIZE: ImageSize = ImageSize { width: 160, height: 90 };

fn rig(sensors: serde_json::Value) -> Vec<SensorSpec> {
    serde_json::from_value(sensors).expect("a rig")
}

pub(crate) fn draft(sensors: serde_json::Value) -> RecipeDraft {
    let words = |words: &[&str]| Some(words.iter().map(|&word| word.to_owned()).collect());
    RecipeDraft {
        videos: Some(1),
        maps: words(&[TOWN]),
        weathers: words(&["cloudy"]),
        times: words(&["afternoon"]),
        size: Some(SIZE.to_string()),
        fps: Some(20.0),
        duration: Some(0.4),
        vehicles: Some(12),
        pedestrians: Some(8),
        cameras_per_scene: Some(0),
        sensor: Some(rig(sensors)),
        min_pixels: Some(1),
        layers: words(&["rgb", "depth", "instance"]),
        camera_look: Some("clean".to_owned()),
        ..RecipeDraft::default()
    }
}

fn make(draft: RecipeDraft, out: &Path, threads: usize) -> Generated {
    let recipe = resolve_recipe(draft, city()).expect("a recipe");
    generate(city(), &recipe, out, &options(threads), &SilentProgress).expect("a dataset")
}

fn video(out: &Path, made: &Generated) -> VideoLayout {
    DatasetLayout::new(out).video(&made.plan.scenes[0])
}

/// One of every type, in every way of being carried.
pub(crate) fn everything() -> serde_json::Value {
    let car = |at: [f64; 3]| json!({"on": "vehicle", "class": "car", "at": at});
    json!([
        {"name": "front", "type": "camera", "mount": car([0.4, 0.0, 1.45]), "rate": 10, "fov": 80.0},
        {"name": "lorry", "type": "camera", "mount": {"on": "vehicle", "class": "truck", "at": [5.0, 0.0, 2.5]}, "layers": ["rgb"]},
        {"name": "walker", "type": "camera", "mount": {"on": "pedestrian", "at": [0.2, 0.0, 1.6]}, "mp4": [],
            "layers": ["rgb", "depth", "instance", "normals", "shadow", "flow", "flow_backward"]},
        {"name": "drone", "type": "camera", "size": "96x54", "rate": 5,
            "mount": {"on": "orbit", "from": "junction", "radius": 30.0, "height": 40.0, "period": 20.0}},
        {"name": "pole", "type": "camera", "mount": {"on": "junction", "corner": 2, "height": 6.0}, "layers": ["semantic", "instance"]},
        {"name": "ptz", "type": "camera", "mount": {"on": "pan_tilt_zoom", "from": "junction", "at": [8.0, 8.0, 9.0], "keys": [
            {"time": 0.0, "yaw": 200.0, "pitch": -20.0, "fov": 80.0}, {"time": 0.4, "yaw": 240.0, "pitch": -30.0, "fov": 30.0}]}},
        {"name": "velodyne", "type": "lidar", "preset": "vlp_16", "rate": 10, "formats": ["pcd", "kitti", "ply"],
            "mount": car([0.0, 0.0, 1.8])},
        {"name": "radar", "type": "radar", "mount": car([2.2, 0.0, 0.6])},
        {"name": "events", "type": "event_camera", "size": "64x36", "mount": car([0.4, 0.0, 1.45])},
        {"name": "imu", "type": "imu", "mount": car([0.0, 0.0, 0.9]), "noise_accel_stddev_x": 0.02},
        {"name": "gnss", "type": "gnss", "mount": car([0.0, 0.0, 1.5]), "rate": 10},
        {"name": "bumper", "type": "collision", "mount": car([0.0, 0.0, 0.0])},
        {"name": "lanes", "type": "lane_invasion", "mount": car([0.0, 0.0, 0.0])},
    ])
}

#[test]
fn every_sensor_is_recorded_the_same_by_any_number_of_threads_and_after_a_kill() {
    let out = [(); 2].map(|()| tempfile::tempdir().expect("temp"));
    let one_camera = || RecipeDraft { cameras_per_scene: Some(1), ..draft(everything()) };
    let made = make(one_camera(), out[0].path(), 2);
    let report = check(out[0].path()).expect("readable");
    assert_eq!(report.findings, []);
    let [of, again] = [&out[0], &out[1]].map(|out| video(out.path(), &made));
    let images = |name: &str| fs::read_dir(of.sensor(name).layer(Layer::Rgb)).expect("images").count();
    assert_eq!([images("front"), images("lorry"), images("drone")], [4, 8, 2], "each at its own rate");
    let carrier = |name: &str| {
        let text = fs::read_to_string(of.sensor(name).sensor()).expect("a record");
        serde_json::from_str::<serde_json::Value>(&text).expect("JSON")["carrier_id"].as_u64()
    };
    assert_eq!(carrier("front"), carrier("velodyne"), "they ride together");
    assert!(carrier("lorry").is_some() && carrier("lorry") != carrier("front") && carrier("drone").is_none());

    make(one_camera(), out[1].path(), 1);
    assert_same(out[0].path(), out[1].path());
    // As a kill leaves it: not all files are there, and none says that it is complete.
    fs::remove_file(again.scene()).expect("complete");
    for name in ["imu/imu.jsonl", "front/poses.jsonl", "velodyne/points/000006.bin", "events/events/000003.npy"] {
        fs::remove_file(again.folder().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
    }
    fs::write(again.sensor("radar").frame_file(FrameFolder::Scans, 2), "spoilt").expect("writable");
    make(one_camera(), out[1].path(), 2);
    assert_same(out[0].path(), out[1].path());
}

#[test]
fn stored_sweeps_are_taken_over_and_damage_is_noticed() {
    let sensors = || {
        json!([
            {"name": "lidar", "type": "lidar", "preset": "vlp_16", "mount": {"on": "junction", "corner": 0, "height": 4.0, "pitch": 0.0}},
            {"name": "pole", "type": "camera", "mount": {"on": "junction", "corner": 0, "height": 6.0}},
        ])
    };
    let out = [(); 2].map(|()| tempfile::tempdir().expect("temp"));
    let made = make(draft(sensors()), out[0].path(), 2);
    make(draft(sensors()), out[1].path(), 2);
    let again = video(out[1].path(), &made);
    let lidar = again.sensor("lidar");
    let finding = |spoil: &dyn Fn(&Path), folder, part: &str| {
        let path = lidar.frame_file(folder, 3);
        let kept = fs::read(&path).expect("there");
        spoil(&path);
        let findings = check(out[1].path()).expect("readable").findings;
        assert!(findings.iter().any(|f| f.to_string().contains(part)), "{part}: {findings:?}");
        fs::write(&path, kept).expect("writable");
    };
    let cut = |path: &Path| fs::write(path, &fs::read(path).expect("there")[16..]).expect("writable");
    finding(&cut, FrameFolder::Points, "000003.bin: has not as many points");
    finding(&|path| fs::write(path, "odd").expect("writable"), FrameFolder::Labels, "000003.label");
    finding(&|path| fs::remove_file(path).expect("there"), FrameFolder::Points, "cannot read");
    // Without its last lines, the video is completed from what is stored.
    fs::remove_file(again.scene()).expect("complete");
    fs::remove_file(lidar.poses()).expect("there");
    fs::write(lidar.frame_file(FrameFolder::Labels, 5), "odd").expect("writable");
    make(draft(sensors()), out[1].path(), 2);
    assert_same(out[0].path(), out[1].path());
}

#[test]
fn an_imu_leads_back_to_the_poses() {
    let sensors =
        json!([{"name": "imu", "type": "imu", "mount": {"on": "vehicle", "at": [0.3, 0.2, 1.0], "yaw": 20.0}}]);
    let long = RecipeDraft { fps: Some(50.0), duration: Some(10.0), ..draft(sensors) };
    let out = tempfile::tempdir().expect("temp");
    let made = make(long, out.path(), 2);
    let imu = video(out.path(), &made).sensor("imu");
    let poses: Vec<SensorPose> =
        read_lines::<PoseLine>(&imu.poses()).expect("poses").iter().map(PoseLine::pose).collect();
    let lines: Vec<ImuRecord> = read_lines(&imu.folder().join("imu.jsonl")).expect("lines");
    assert_eq!((poses.len(), lines.len()), (500, 500));
    let period_s = 0.02;
    let (mut position, mut rotation) = (poses[0].position, poses[0].world_from_sensor);
    let mut velocity = DVec3::from(lines[0].velocity_mps);
    let (mut off_m, mut off_deg) = (0.0f64, 0.0f64);
    for (line, pose) in lines.iter().zip(&poses).skip(1) {
        // As docs/imu.md says.
        rotation *= rotation_from_vector(DVec3::from(line.measurement.gyroscope_radps) * period_s);
        let force = rotation * DVec3::from(line.measurement.accelerometer_mps2);
        velocity += (force - DVec3::Z * 9.81) * period_s;
        position += velocity * period_s;
        off_m = off_m.max(position.distance(pose.position));
        off_deg = off_deg.max(rotation_vector(rotation.conjugate() * pose.world_from_sensor).length().to_degrees());
    }
    let driven_m = poses[0].position.distance(poses[499].position);
    println!("after {driven_m:.1} m: {:.2} mm and {off_deg:.5} degrees off", 1000.0 * off_m);
    assert!(driven_m > 30.0 && off_m < 0.01 && off_deg < 0.1, "{driven_m} m driven, {off_m} m, {off_deg} degrees off");
}

/// A camera's frame: the camera, depth in metres, and whose each pixel is.
fn seen(files: &CameraLayout, frame: u32) -> (PinholeCamera, Image<f32>, Image<InstancePixel>) {
    let line = read_lines::<PoseLine>(&files.poses()).expect("poses").into_iter().find(|line| line.frame == frame);
    let camera = line.and_then(|line| line.camera(SIZE)).expect("a camera");
    let layer = |layer: Layer| read_rgb(&files.frame(layer, frame, RgbFormat::Png), layer.format(RgbFormat::Png));
    let depth = depth_from_rgb(layer(Layer::Depth).expect("depth").rgb8().expect("8 bit"));
    let instance = instance_from_rgb(layer(Layer::Instance).expect("ids").rgb8().expect("8 bit")).expect("ids");
    (camera, depth, instance)
}

#[test]
fn lidar_points_meet_the_same_objects_in_all_cameras() {
    let car = |at: [f64; 3], yaw: f64| json!({"on": "vehicle", "class": "car", "at": at, "yaw": yaw});
    let sensors = json!([
        {"name": "front", "type": "camera", "mount": car([0.5, 0.0, 1.9], 0.0), "fov": 90.0},
        {"name": "left", "type": "camera", "mount": car([0.5, 0.3, 1.9], 60.0), "fov": 90.0},
        {"name": "lidar", "type": "lidar", "preset": "hdl_64e", "mount": car([0.5, 0.0, 1.9], 0.0), "formats": ["kitti", "ply"],
            "noise_stddev": 0.0, "motion_distortion": false, "weather_effects": false, "points_per_second": 600_000},
    ]);
    let out = tempfile::tempdir().expect("temp");
    let made = make(RecipeDraft { vehicles: Some(40), ..draft(sensors) }, out.path(), 2);
    let of = video(out.path(), &made);
    let lidar = of.sensor("lidar");
    let poses: Vec<PoseLine> = read_lines(&lidar.poses()).expect("poses");
    let (mut asked, mut other, mut objects) = (0u32, 0u32, 0u32);
    for line in &poses {
        let bytes = |folder| fs::read(lidar.frame_file(folder, line.frame)).expect("there");
        let points = points_from_ply(&bytes(FrameFolder::Ply)).expect("points");
        let plain = points_from_bin(&bytes(FrameFolder::Points)).expect("points");
        let labels = point_labels(&bytes(FrameFolder::Labels)).expect("labels");
        assert_eq!((plain.len(), labels.len()), (points.len(), points.len()));
        for name in ["front", "left"] {
            let (camera, depth, instance) = seen(&of.sensor(name), line.frame);
            for (point, label) in points.iter().zip(&labels) {
                let world = line.pose().world_from_sensor_point(point.position.as_dvec3());
                let Some((at, z)) = camera.project(world.as_vec3()) else { continue };
                let pixel = at.floor().as_ivec2();
                let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [pixel.x + dx, pixel.y + dy]));
                let inside =
                    |[x, y]: &[i32; 2]| (0..SIZE.width as i32).contains(x) && (0..SIZE.height as i32).contains(y);
                if !around.clone().all(|p| inside(&p)) {
                    continue;
                }
                let UVec2 { x, y } = pixel.as_uvec2();
                let (here, shown_m) = (*instance.at(x, y), *depth.at(x, y));
                let same = around.clone().all(|[x, y]| *instance.at(x as u32, y as u32) == here);
                let flat = around.clone().all(|[x, y]| (depth.at(x as u32, y as u32) - shown_m).abs() < 0.15 * shown_m);
                // What lies behind what the camera shows is hidden from it.
                // A pole or a line of paint may be narrower than a pixel, and lie between what is shown.
                let is_thin = matches!(point.tag, ClassTag::Poles | ClassTag::RoadLines) && here.tag != point.tag;
                if !same || !flat || is_thin || z > 1.15 * shown_m {
                    continue;
                }
                asked += 1;
                objects += u32::from(here.id.0 > 0);
                other += u32::from(here.id != point.id || here.tag != point.tag || label.id != here.id);
            }
        }
    }
    println!("{asked} points, {objects} of objects, {other} meet another");
    assert!(asked > 20_000 && objects > 100 && f64::from(other) < 0.001 * f64::from(asked), "{other} of {asked}");
}

/// Depth along the optical axis where a plane is seen at a place in the picture, of the nine pixels around it: the inverse of
/// a plane's depth is linear in the picture. `None` where these see no plane.
fn plane_depth_m(depth: &Image<f32>, at: DVec2) -> Option<f64> {
    let (x, y) = (at.x.floor() as u32, at.y.floor() as u32);
    let near = |dx: i64, dy: i64| 1.0 / f64::from(*depth.at((i64::from(x) + dx) as u32, (i64::from(y) + dy) as u32));
    let middle = near(0, 0);
    // What depth is rounded to moves its inverse by so much.
    let step = 6e-5 * middle * middle;
    let flat = (-1..=1)
        .flat_map(|dy| (-1..=1).map(move |dx| (dx, dy)))
        .all(|(dx, dy)| (near(dx, dy) + near(-dx, -dy) - 2.0 * middle).abs() < 4.0 * step);
    let off = at - at.floor() - 0.5;
    let tilt = DVec2::new(near(1, 0) - near(-1, 0), near(0, 1) - near(0, -1)) * 0.5;
    flat.then(|| 1.0 / (middle + tilt.dot(off)))
}

#[test]
fn lidar_points_lie_where_a_camera_sees_the_surface_to_the_millimetre() {
    let car = json!({"on": "vehicle", "class": "car", "at": [0.5, 0.0, 1.9]});
    let sensors = json!([
        {"name": "front", "type": "camera", "mount": car, "fov": 60.0, "size": "640x360", "layers": ["depth"], "mp4": []},
        {"name": "lidar", "type": "lidar", "preset": "hdl_64e", "mount": car, "noise_stddev": 0.0, "motion_distortion": false,
            "weather_effects": false, "dropoff_general_rate": 0.0, "dropoff_intensity_limit": 0.0},
    ]);
    let out = tempfile::tempdir().expect("temp");
    // A scene whose walls and roads are flat around the car.
    let made = make(RecipeDraft { duration: Some(0.2), seed: Some(1), ..draft(sensors) }, out.path(), 2);
    let of = video(out.path(), &made);
    let (mut worst_m, mut asked, mut thin) = (0.0f64, 0u32, 0u32);
    for line in read_lines::<PoseLine>(&of.sensor("front").poses()).expect("poses") {
        let path = of.sensor("front").frame(Layer::Depth, line.frame, RgbFormat::Png);
        let image = read_rgb(&path, RgbFormat::Png).expect("an image");
        let depth = depth_from_rgb(image.rgb8().expect("8 bit"));
        let lens = line.intrinsics.expect("a camera");
        let bytes = fs::read(of.sensor("lidar").frame_file(FrameFolder::Points, line.frame)).expect("there");
        for [x, y, z, _] in points_from_bin(&bytes).expect("points") {
            // Both look ahead from one place.
            let [right, down, ahead] = [-y, -z, x].map(f64::from);
            let at = DVec2::new(f64::from(lens.fx) * right, f64::from(lens.fy) * down) / ahead
                + DVec2::new(f64::from(lens.cx), f64::from(lens.cy));
            let inside = DVec2::ONE.cmplt(at).all() && at.cmplt(DVec2::new(639.0, 359.0)).all();
            if ahead < 1.0 || !inside {
                continue;
            }
            let Some(expected) = plane_depth_m(&depth, at).filter(|depth| *depth < 60.0) else { continue };
            // Along the ray, which is longer than its part along the optical axis.
            let off_m = (ahead - expected).abs() * DVec3::new(right, down, ahead).length() / ahead;
            asked += 1;
            // A wire or a leaf between the pixels' centres.
            if off_m > 0.01 {
                thin += 1;
            } else {
                worst_m = worst_m.max(off_m);
            }
        }
    }
    println!(
        "{asked} points on planes, {thin} on what is thinner than a pixel, others at most {:.3} mm off",
        1000.0 * worst_m
    );
    assert!(
        asked > 5000 && thin < asked / 1000 && worst_m < 1e-3,
        "{worst_m} m, {asked} points, {thin} on other things"
    );
}

#[test]
fn a_radar_tells_how_fast_what_it_sees_comes_nearer() {
    let car = |at: [f64; 3]| json!({"on": "vehicle", "class": "car", "at": at});
    let sensors = json!([
        {"name": "radar", "type": "radar", "mount": car([2.2, 0.0, 0.6]), "horizontal_fov": 120.0, "points_per_second": 20_000},
        {"name": "front", "type": "camera", "mount": car([2.2, 0.0, 0.9]), "fov": 120.0, "mp4": []},
    ]);
    let out = tempfile::tempdir().expect("temp");
    // A scene in which no car turns right before the sensor.
    let made = make(RecipeDraft { vehicles: Some(60), seed: Some(2), ..draft(sensors) }, out.path(), 2);
    let of = video(out.path(), &made);
    let poses: Vec<PoseLine> = read_lines(&of.sensor("radar").poses()).expect("poses");
    let labels = read_objects(&of.sensor("front").objects()).expect("labels");
    let (mut still, mut moving) = (0u32, 0u32);
    for (line, seen) in poses.iter().zip(&labels) {
        let text = fs::read_to_string(of.sensor("radar").frame_file(FrameFolder::Scans, line.frame)).expect("there");
        let pose = line.pose();
        for found in detections_from_csv(&text).expect("detections") {
            let [azimuth, altitude] = [found.azimuth_rad, found.altitude_rad].map(f64::from);
            let (up, out) = sin_cos(altitude);
            let level = DVec2::from_angle(azimuth) * out;
            let direction = pose.world_from_sensor * DVec3::new(level.x, level.y, up);
            let of_object = seen.objects.iter().find(|object| object.id == found.id);
            let velocity = match of_object {
                None if found.id.0 == 0 => DVec3::ZERO,
                Some(object) if object.parked => DVec3::ZERO,
                // Parts of what turns have velocities of their own: see the tests of `endless_sensor`.
                Some(object) if object.class == ObjectClass::Car => DVec3::from(object.velocity_mps),
                _ => continue,
            };
            let expected = (velocity - pose.velocity_mps).dot(direction);
            let off = (f64::from(found.velocity_mps) - expected).abs();
            if velocity == DVec3::ZERO {
                still += 1;
                assert!(off < 1e-3, "{found:?}: {expected} m/s expected");
            } else {
                moving += 1;
                assert!(off < 0.5, "{found:?}: {expected} m/s expected of the whole");
            }
        }
    }
    let speed = poses[0].pose().velocity_mps.length();
    println!("at {speed:.1} m/s: {still} detections of what stands, {moving} of what drives");
    assert!(speed > 1.0 && still > 500, "{speed} m/s, {still}, {moving}");
}

#[test]
fn events_add_up_to_the_change_of_the_picture() {
    let car = json!({"on": "vehicle", "class": "car", "at": [0.5, 0.0, 1.5]});
    let sensors = json!([
        {"name": "events", "type": "event_camera", "size": "160x90", "fov": 90.0, "mount": car, "positive_threshold": 0.2},
        {"name": "front", "type": "camera", "fov": 90.0, "mount": car, "layers": ["rgb"], "mp4": []},
    ]);
    let out = tempfile::tempdir().expect("temp");
    let made = make(draft(sensors), out.path(), 2);
    let of = video(out.path(), &made);
    let levels = |frame: u32| {
        let image = read_rgb(&of.sensor("front").frame(Layer::Rgb, frame, RgbFormat::Png), RgbFormat::Png);
        let image = image.expect("an image").rgb8().expect("8 bit").clone();
        let level = |[r, g, b]: [u8; 3]| {
            ln(0.001 + (0.2989 * f64::from(r) + 0.587 * f64::from(g) + 0.114 * f64::from(b)) / 255.0)
        };
        image.data.iter().map(|&pixel| level(pixel)).collect::<Vec<f64>>()
    };
    let first = levels(0);
    let (mut sums, mut count) = (vec![0.0; first.len()], 0);
    for frame in 0..8 {
        let bytes = fs::read(of.sensor("events").frame_file(FrameFolder::Events, frame)).expect("there");
        for event in decode_pixel_events(&bytes).expect("events") {
            assert!(event.t_us <= i64::from(frame) * 50_000 && event.t_us > (i64::from(frame) - 1) * 50_000 - 1);
            sums[usize::from(event.y) * 160 + usize::from(event.x)] += if event.polarity { 0.2 } else { -0.3 };
            count += 1;
        }
        for ((now, then), sum) in levels(frame).iter().zip(&first).zip(&sums) {
            let missing = now - then - sum;
            assert!(missing < 0.2 + 1e-9 && missing > -0.3 - 1e-9, "{missing} in frame {frame}");
        }
    }
    assert!(count > 10_000, "{count} events");
}

#[test]
fn rigs_that_cannot_be_are_refused_before_anything_is_simulated() {
    let camera = |change: serde_json::Value| {
        let mut sensor = json!({"name": "a", "type": "camera", "mount": {"on": "vehicle", "at": [0.0, 0.0, 1.5]}});
        for (key, value) in change.as_object().expect("an object") {
            sensor[key] = value.clone();
        }
        sensor
    };
    let told = |sensors: serde_json::Value| {
        let error = match resolve_recipe(draft(sensors), city()) {
            Err(error) => error.to_string(),
            Ok(recipe) => Plan::new(&recipe, city()).expect_err("refused").to_string(),
        };
        assert_eq!(error.lines().count(), 1, "{error}");
        error
    };
    let one = |change: serde_json::Value| told(json!([camera(change)]));
    assert!(one(json!({"rate": 0.0})).contains("rate = 0 (a): write a divisor of the 20 frames a second"));
    assert!(one(json!({"rate": 7.0})).contains("rate = 7 (a)"));
    assert!(one(json!({"name": "camera_a"})).contains("folder of a camera of the scene"));
    assert!(one(json!({"name": "../a"})).contains("letters, digits"));
    assert!(one(json!({"size": "0x9"})).contains("size = 0x9 (a)"));
    assert!(one(json!({"layers": ["flow"], "rate": 10.0})).contains("leave out the rate"));
    assert!(one(json!({"mp4": ["normals"]})).contains("mp4 = normals (a)"));
    assert!(
        one(json!({"mount": {"on": "vehicle", "number": 12, "at": [0.0, 0.0, 1.0]}}))
            .contains("the recipe has 12 vehicles")
    );
    assert!(
        one(json!({"mount": {"on": "site", "site": "moon"}}))
            .contains("sensor a on map Town02: there is no camera site 'moon'")
    );
    assert!(
        one(json!({"mount": {"on": "pose", "from": "junction", "at": [0.0, 0.0, -2.0]}})).contains("is under ground")
    );
    assert!(one(json!({"mount": {"on": "way_points", "points": []}})).contains("points = []"));
    assert!(told(json!([camera(json!({})), camera(json!({}))])).contains("another sensor has it already"));
    let imu = json!([{"name": "imu", "type": "imu", "noise_gyro_stddev_x": -1.0, "mount": {"on": "vehicle", "at": [0.0, 0.0, 1.0]}}]);
    assert!(told(imu).starts_with("sensor imu: noise_gyro_stddev_x"));
    let lanes = json!([{"name": "lanes", "type": "lane_invasion", "mount": {"on": "pose", "at": [0.0, 0.0, 9.0]}}]);
    assert!(told(lanes).contains("mount it on a vehicle"));
    let nothing = RecipeDraft { sensor: None, ..draft(json!([])) };
    assert!(
        resolve_recipe(nothing, city()).expect_err("no cameras").to_string().contains("cameras-per-scene cannot be 0")
    );

    // Who is to carry a sensor is there, or it is told before the first frame.
    let nobody =
        json!([camera(json!({"mount": {"on": "vehicle", "class": "bus", "number": 11, "at": [0.0, 0.0, 1.5]}}))]);
    let recipe = resolve_recipe(draft(nobody), city()).expect("plausible");
    let out = tempfile::tempdir().expect("temp");
    let error = generate(city(), &recipe, out.path(), &options(1), &SilentProgress).expect_err("too many buses");
    assert!(
        error.to_string().contains("sensor a rides on bus number 11 (from 0), and there is none on Town02"),
        "{error}"
    );
}
