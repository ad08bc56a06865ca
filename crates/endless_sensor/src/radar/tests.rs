//! A radar in scenes of which distances and velocities are known.

use super::*;
use crate::test_scene::{box_street, distance, scene_of};
use endless_render::RigidVelocity;
use endless_world::{ClassTag, InstanceId};
use glam::{DQuat, Vec3A};
use proptest::prelude::*;

const VAN: [[f64; 3]; 2] = [[20.0, -1.0, 0.0], [24.0, 1.0, 2.0]];

fn direction_of(detection: &RadarDetection) -> DVec3 {
    let (sin, cos) = sin_cos(f64::from(detection.azimuth_rad));
    let (up, level) = sin_cos(f64::from(detection.altitude_rad));
    DVec3::new(cos * level, sin * level, up)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn doppler_is_the_relative_velocity_along_the_ray_to_the_millimetre_a_second(
        own in prop::array::uniform3(-30.0..30.0f64), linear in prop::array::uniform3(-30.0..30.0f32),
        turn in -1.0..1.0f32, yaw in -0.2..0.2f64,
    ) {
        let velocity = RigidVelocity {
            linear_mps: Vec3A::from_array(linear),
            angular_radps: Vec3A::Z * turn,
            about: Vec3A::new(22.0, 0.0, 0.0),
        };
        let scene = scene_of(&[], &[(VAN, InstanceId(9), velocity)]);
        let pose = SensorPose {
            velocity_mps: DVec3::from_array(own),
            ..SensorPose::still(DVec3::new(0.0, 0.0, 0.6), DQuat::from_rotation_z(yaw))
        };
        let scan = Radar::new(&RadarSettings::default(), 1)
            .scan(&RayCaster::new(&scene.0, &scene.1), &SweepInterval::standing(pose, 0.05, 0));
        let van: Vec<_> = scan.detections.iter().filter(|d| d.id == InstanceId(9)).collect();
        prop_assert!(!van.is_empty());
        for detection in van {
            let direction = pose.world_from_sensor * direction_of(detection);
            let point = pose.position + direction * f64::from(detection.depth_m);
            let arm = point - DVec3::new(22.0, 0.0, 0.0);
            let target = DVec3::from_array(linear.map(f64::from)) + DVec3::Z.cross(arm) * f64::from(turn);
            let expected = (target - pose.velocity_mps).dot(direction);
            prop_assert!((f64::from(detection.velocity_mps) - expected).abs() < 1e-3);
        }
        // What stands still comes nearer as the radar moves.
        for detection in scan.detections.iter().filter(|d| d.id == InstanceId::STUFF) {
            let expected = -pose.velocity_mps.dot(pose.world_from_sensor * direction_of(detection));
            prop_assert!((f64::from(detection.velocity_mps) - expected).abs() < 1e-3);
        }
    }
}

fn street_scan(settings: &RadarSettings, seed: u64, frame: u32) -> RadarScan {
    let scene = box_street();
    let pose = SensorPose::still(DVec3::new(0.0, 0.0, 0.6), DQuat::IDENTITY);
    Radar::new(settings, seed).scan(&RayCaster::new(&scene.0, &scene.1), &SweepInterval::standing(pose, 0.05, frame))
}

#[test]
fn detections_lie_on_surfaces_strongest_first() {
    let scan = street_scan(&RadarSettings::default(), 1, 0);
    assert!(scan.detections.len() > 10 && scan.detections.len() <= 75);
    for detection in &scan.detections {
        let expected = distance(DVec3::new(0.0, 0.0, 0.6), direction_of(detection)).expect("something");
        assert!((f64::from(detection.depth_m) - expected).abs() < 2e-3, "{detection:?} {expected}");
        assert!(detection.power_db >= -75.0);
        assert!(detection.azimuth_rad.abs() <= 15.01f32.to_radians());
    }
    assert!(scan.detections.windows(2).all(|pair| pair[0].power_db >= pair[1].power_db));
    // The back of a metal box 12 m ahead is the strongest there is, and moves away.
    let first = scan.detections[0];
    assert_eq!((first.tag, first.id), (ClassTag::Car, InstanceId(7)));
    assert!((first.depth_m - 12.0).abs() < 0.3 && first.velocity_mps > 9.0);
}

#[test]
fn a_larger_area_and_a_nearer_one_reflect_more() {
    let power = |body: [[f64; 3]; 2]| {
        let scene = scene_of(&[], &[(body, InstanceId(1), RigidVelocity::ZERO)]);
        let pose = SensorPose::still(DVec3::new(0.0, 0.0, 0.6), DQuat::IDENTITY);
        // One cell for all.
        let settings = RadarSettings {
            azimuth_resolution: 90.0,
            altitude_resolution: 90.0,
            range_resolution: 100.0,
            points_per_second: 200_000,
            ..RadarSettings::default()
        };
        let scan =
            Radar::new(&settings, 1).scan(&RayCaster::new(&scene.0, &scene.1), &SweepInterval::standing(pose, 0.05, 0));
        let of_body = scan.detections.iter().filter(|d| d.id == InstanceId(1));
        let sum: f64 = of_body.map(|d| endless_world::math::f64::pow(10.0, f64::from(d.power_db) / 10.0)).sum();
        10.0 / std::f64::consts::LN_10 * ln(sum)
    };
    // A metre of a plate, two of it, and one twice as far away.
    let plate = power([[40.0, -0.5, 0.0], [40.1, 0.5, 1.0]]);
    let double = power([[40.0, -1.0, 0.0], [40.1, 1.0, 1.0]]);
    let far = power([[80.0, -0.5, 0.0], [80.1, 0.5, 1.0]]);
    assert!((double - plate - 3.0).abs() < 0.5, "{plate} {double}");
    assert!((plate - far - 12.0).abs() < 0.7, "{plate} {far}");
    // Metal that faces the radar has about twelve times its area.
    assert!((plate + 40.0 * std::f64::consts::LOG10_2 * 5.3219 - 11.0).abs() < 1.5, "{plate}");
}

#[test]
fn noise_and_seeds_matter_and_threads_do_not() {
    let noisy = RadarSettings { noise_depth_stddev: 0.2, noise_velocity_stddev: 0.1, ..RadarSettings::default() };
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let one = pool(1).install(|| street_scan(&noisy, 3, 4));
    assert_eq!(one, pool(3).install(|| street_scan(&noisy, 3, 4)));
    assert_ne!(one, street_scan(&noisy, 3, 5));
    assert_ne!(one, street_scan(&noisy, 4, 4));
    let clean = street_scan(&RadarSettings::default(), 3, 4);
    let errors: Vec<f32> = one.detections.iter().zip(&clean.detections).map(|(a, b)| a.depth_m - b.depth_m).collect();
    let spread = (errors.iter().map(|e| e * e).sum::<f32>() / errors.len() as f32).sqrt();
    assert!(errors.len() > 10 && (0.1..0.3).contains(&spread), "{spread}");
}
