//! A LiDAR in scenes of which the distances are known.

use super::*;
use crate::test_scene::{box_street, distance_past, scene_of};
use endless_render::{CameraBake, FrameDescription, FrameScene, RenderSettings, StaticScene};
use endless_world::{
    CameraSite, ClassTag, ImageSize, InstanceId, LensModel, LidarPreset, Mount, ScanPattern, SensorPose, TimeOfDay,
    Weather,
};
use glam::{DVec2, Vec3};
use proptest::prelude::*;

/// Without anything random.
fn exact(preset: LidarPreset) -> LidarSettings {
    LidarSettings {
        range_10_percent: 0.0,
        dropoff_general_rate: 0.0,
        dropoff_intensity_limit: 0.0,
        noise_stddev: 0.0,
        weather_effects: false,
        ..LidarSettings::of(preset)
    }
}

fn tilted(position: DVec3, yaw: f64, pitch: f64) -> SensorPose {
    SensorPose::still(position, DQuat::from_rotation_z(yaw) * DQuat::from_rotation_y(pitch))
}

fn sweep(settings: &LidarSettings, scene: &(StaticScene, FrameScene), interval: &SweepInterval) -> LidarSweep {
    Lidar::new(settings, 1).sweep(&RayCaster::new(&scene.0, &scene.1), &Atmosphere::VACUUM, interval)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn points_lie_on_surfaces_to_the_millimetre(
        x in -400.0..400.0f64, y in -4.0..4.0f64, yaw in -3.0..3.0f64, pitch in -0.3..0.3f64,
    ) {
        let scene = box_street();
        // Far from the origin of the world single precision is coarsest.
        let pose = tilted(DVec3::new(500.0 + x, y, 1.9), yaw, pitch);
        let settings = LidarSettings { points_per_second: 200_000, ..exact(LidarPreset::Hdl64e) };
        let found = sweep(&settings, &scene, &SweepInterval::standing(pose, 0.1, 0));
        prop_assert!(found.points.len() > 5_000);
        for point in &found.points {
            let world = pose.world_from_sensor_point(point.position.as_dvec3());
            let direction = (pose.world_from_sensor * point.position.as_dvec3()).normalize();
            let measured = (world - pose.position).length();
            // Out there single precision tells places to 0.03 mm: more along a ray that grazes a wall, or misses its edge.
            let at = |margin_m| distance_past(pose.position, direction, margin_m);
            let nearest = at(-1e-4).expect("something is there") - 1e-3;
            let farthest = at(1e-4).map_or(f64::INFINITY, |expected| expected + 1e-3);
            prop_assert!((nearest..=farthest).contains(&measured), "{measured} instead of {nearest} to {farthest}");
        }
    }
}

#[test]
fn points_agree_with_a_cameras_depth() {
    let scene = box_street();
    let site = CameraSite {
        name: "pole".to_owned(),
        position: [3.0, -2.0, 2.5],
        yaw_rad: 0.3,
        down_tilt_rad: 0.2,
        horizontal_fov_rad: 1.2,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
        roll_rad: 0.0,
    };
    let size = ImageSize { width: 640, height: 360 };
    let settings = RenderSettings::new(Weather::ClearSky, TimeOfDay::Afternoon, 0, size);
    let depth = CameraBake::bake(&scene.0, &settings, &site).render(&scene.0, &scene.1).depth;
    let focal = 320.0 / endless_world::math::f64::tan(0.6);
    let pose = tilted(DVec3::new(3.0, -2.0, 2.5), 0.3, 0.2);
    let points = sweep(&exact(LidarPreset::Hdl64e), &scene, &SweepInterval::standing(pose, 0.1, 0)).points;
    let mut compared = 0;
    for point in points.iter().map(|point| point.position.as_dvec3()).filter(|point| point.x > 0.0) {
        // x forward, y left, z up: the camera's depth is x.
        let pixel = DVec2::new(320.0 - focal * point.y / point.x, 180.0 - focal * point.z / point.x);
        let (column, row) = (pixel.x.floor(), pixel.y.floor());
        // The depth of a pixel is that at its centre: those that the point hits to a 50th.
        let off = (pixel - DVec2::new(column, row) - 0.5).abs().max_element();
        if off > 0.02 || !(0.0..640.0).contains(&column) || !(0.0..360.0).contains(&row) {
            continue;
        }
        let seen = f64::from(depth.data[row as usize * 640 + column as usize]);
        // On the ground depth changes within a pixel: by its square over height and focal length.
        let slack = 1e-3 + 0.02 * seen * seen / (2.5 * focal);
        assert!((seen - point.x).abs() < slack, "{seen} {point}");
        compared += 1;
    }
    assert!(compared > 10, "{compared}");
}

#[test]
fn points_know_what_they_are_on() {
    let scene = box_street();
    let pose = tilted(DVec3::new(0.0, 0.0, 1.8), 0.0, 0.0);
    let points = sweep(&exact(LidarPreset::Hdl64e), &scene, &SweepInterval::standing(pose, 0.1, 0)).points;
    let of = |tag| points.iter().filter(move |point| point.tag == tag);
    assert!(of(ClassTag::Roads).all(|point| point.id == InstanceId::STUFF && !point.moving));
    assert!(of(ClassTag::Car).all(|point| point.id == InstanceId(7) && point.moving));
    assert!(of(ClassTag::Roads).count() > 1000 && of(ClassTag::Car).count() > 500);
    assert!(points.iter().all(|point| (0.0..=1.0).contains(&point.intensity) && !point.is_false_return()));
    assert!(points.windows(2).all(|pair| pair[0].time_s <= pair[1].time_s));
    assert!(points.iter().all(|point| point.time_s > 0.0 && point.time_s <= 0.1 && point.channel < 64));
}

#[test]
fn motion_moves_points_by_the_way_that_is_still_to_come() {
    let scene = scene_of(&[], &[]);
    let now = tilted(DVec3::new(10.0, 0.0, 2.0), 0.0, 0.0);
    let before = tilted(DVec3::new(8.0, 0.0, 2.0), -0.05, 0.0);
    let interval = SweepInterval { before, now, sweep_s: 0.1, frame: 0 };
    for scan in ScanPattern::ALL {
        let settings = LidarSettings { scan: *scan, points_per_second: 300_000, ..exact(LidarPreset::Hdl64e) };
        let moved = sweep(&settings, &scene, &interval).points;
        assert!(moved.len() > 3000);
        for point in &moved {
            // Where the sensor was then, the point is on the ground.
            let share = f64::from(point.time_s) / 0.1;
            let (position, turn) = interval.place_at(share);
            let world = position + turn * point.position.as_dvec3();
            assert!(world.z.abs() < 1e-3, "{world}");
        }
        let still = LidarSettings { motion_distortion: false, ..settings };
        let unmoved = sweep(&still, &scene, &interval).points;
        let standing = sweep(&settings, &scene, &SweepInterval::standing(now, 0.1, 0)).points;
        assert_eq!(unmoved, standing);
        assert_eq!(moved == unmoved, *scan == ScanPattern::Flash);
    }
}

#[test]
fn noise_is_that_of_the_settings_and_lies_along_the_ray() {
    let scene = box_street();
    let interval = SweepInterval::standing(tilted(DVec3::new(0.0, 0.0, 1.8), 0.0, 0.0), 0.1, 3);
    let clean = exact(LidarPreset::Hdl64e);
    let noisy = LidarSettings { noise_stddev: 0.05, ..clean.clone() };
    let [clean, noisy] = [clean, noisy].map(|settings| sweep(&settings, &scene, &interval).points);
    assert_eq!(clean.len(), noisy.len());
    let errors: Vec<f64> = clean
        .iter()
        .zip(&noisy)
        .map(|(clean, noisy)| {
            let aside = clean.position.normalize().cross(noisy.position.normalize()).length();
            assert!(aside < 1e-5);
            f64::from(noisy.position.length() - clean.position.length())
        })
        .collect();
    let count = errors.len() as f64;
    let mean = errors.iter().sum::<f64>() / count;
    let stddev = (errors.iter().map(|e| (e - mean) * (e - mean)).sum::<f64>() / count).sqrt();
    let large = errors.iter().filter(|e| e.abs() > 0.1).count() as f64 / count;
    assert!(mean.abs() < 1e-3 && (stddev - 0.05).abs() < 1e-3 && (large - 0.0455).abs() < 0.005);
}

#[test]
fn echoes_are_dropped_as_the_settings_say() {
    let scene = box_street();
    let interval = SweepInterval::standing(tilted(DVec3::new(0.0, 0.0, 1.8), 0.0, 0.0), 0.1, 3);
    let all = sweep(&exact(LidarPreset::Hdl64e), &scene, &interval).points;
    let general = LidarSettings { dropoff_general_rate: 0.45, ..exact(LidarPreset::Hdl64e) };
    let kept = sweep(&general, &scene, &interval).points.len() as f64 / all.len() as f64;
    assert!((kept - 0.55).abs() < 0.01, "{kept}");
    let weak =
        LidarSettings { dropoff_intensity_limit: 0.3, dropoff_zero_intensity: 0.6, ..exact(LidarPreset::Hdl64e) };
    let kept = sweep(&weak, &scene, &interval).points;
    let expected: f32 = all.iter().map(|point| 1.0 - 0.6 * (1.0 - point.intensity / 0.3).max(0.0)).sum();
    assert!((kept.len() as f32 - expected).abs() < 0.01 * expected);
    // Only near surfaces are found by a weak laser, bright ones from farther away than dark ones.
    let short = LidarSettings { range_10_percent: 10.0, ..exact(LidarPreset::Hdl64e) };
    let near = sweep(&short, &scene, &interval).points;
    let farthest = |tag| near.iter().filter(|p| p.tag == tag).map(|p| p.position.length()).fold(0.0, f32::max);
    assert!(near.len() < all.len() && farthest(ClassTag::Buildings) > farthest(ClassTag::Roads));
    assert!(near.iter().all(|point| point.intensity / point.position.length_squared() > 0.99 * 0.1 / 100.0));
}

#[test]
fn rain_and_fog_take_points_away_and_add_false_ones() {
    let scene = box_street();
    let settings = LidarSettings { noise_stddev: 0.0, ..LidarSettings::of(LidarPreset::Hdl64e) };
    let interval = SweepInterval::standing(tilted(DVec3::new(0.0, 0.0, 1.8), 0.0, 0.0), 0.1, 0);
    let lidar = Lidar::new(&settings, 5);
    let caster = RayCaster::new(&scene.0, &scene.1);
    let counts = |air: &Atmosphere| {
        let points = lidar.sweep(&caster, air, &interval).points;
        let drops: Vec<f32> =
            points.iter().filter(|p| p.is_false_return()).map(|point| point.position.length()).collect();
        assert!(drops.iter().all(|distance| (0.9..30.0).contains(distance)));
        (points.len() - drops.len(), drops.len())
    };
    let clear = counts(&Atmosphere::VACUUM);
    let rain = counts(&Atmosphere { visibility_m: 1200.0, rain_mm_per_h: 10.0, wetness: 1.0 });
    let fog = counts(&Atmosphere { visibility_m: 150.0, rain_mm_per_h: 0.0, wetness: 0.1 });
    let thick = counts(&Atmosphere { visibility_m: 50.0, rain_mm_per_h: 0.0, wetness: 0.1 });
    assert_eq!(clear.1, 0);
    assert!(rain.0 < clear.0 && rain.1 > 300 && rain.1 < clear.0 / 10, "{clear:?} {rain:?}");
    assert!(fog.0 < clear.0 && fog.1 > 1000, "{clear:?} {fog:?}");
    assert!(thick.0 < fog.0 && thick.1 > fog.1, "{fog:?} {thick:?}");
    let off = LidarSettings { weather_effects: false, ..settings };
    let air = Atmosphere { visibility_m: 50.0, rain_mm_per_h: 10.0, wetness: 1.0 };
    assert_eq!(Lidar::new(&off, 5).sweep(&caster, &air, &interval).points.len(), clear.0);
}

#[test]
fn points_do_not_depend_on_threads_and_differ_by_seed_and_frame() {
    let scene = box_street();
    let pose = tilted(DVec3::new(0.0, 0.0, 1.8), 0.0, 0.0);
    let air = Atmosphere { visibility_m: 1200.0, rain_mm_per_h: 5.0, wetness: 1.0 };
    let with = |threads: usize, seed: u64, frame: u32| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let lidar = Lidar::new(&LidarSettings::of(LidarPreset::Vlp16), seed);
        let interval = SweepInterval::standing(pose, 0.1, frame);
        pool.install(|| lidar.sweep(&RayCaster::new(&scene.0, &scene.1), &air, &interval))
    };
    let one = with(1, 5, 2);
    assert_eq!(one, with(3, 5, 2));
    assert_ne!(one, with(1, 6, 2));
    assert_ne!(one, with(1, 5, 3));
}

#[test]
fn nothing_is_nothing() {
    let empty = StaticScene::new(Vec::new(), &[]);
    let moving = FrameScene::new(FrameDescription::default());
    let interval = SweepInterval::standing(SensorPose::still(DVec3::ZERO, DQuat::IDENTITY), 0.1, 0);
    let settings = LidarSettings::of(LidarPreset::Vlp16);
    let found = Lidar::new(&settings, 0).sweep(&RayCaster::new(&empty, &moving), &Atmosphere::VACUUM, &interval);
    assert_eq!(found.points.iter().map(|point| point.position).collect::<Vec<Vec3>>(), []);
}
