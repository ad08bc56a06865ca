//! An IMU that drives along: its measurements, integrated, give the ways of real traffic back.

use endless_asset::Catalogue;
use endless_sensor::Imu;
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::{Actor, ImuSettings, SensorPose, carried, moving_to, rotation_from_vector, rotation_vector};
use glam::DVec3;

const SECONDS: f64 = 10.0;
const GRAVITY: DVec3 = DVec3::new(0.0, 0.0, 9.81);
/// On the roof of a car, turned a little.
const AT_M: [f64; 3] = [0.6, -0.3, 1.6];
const TURNED_RAD: [f64; 3] = [0.4, -0.1, 0.05];

/// The largest errors of position and orientation, metres and radians, over the way of one actor.
fn errors(poses: &[SensorPose], period_s: f64) -> (f64, f64) {
    let mut imu = Imu::new(&ImuSettings::default(), period_s, 0);
    imu.measure(&poses[0]);
    let (mut rotation, mut position) = (poses[0].world_from_sensor, poses[0].position);
    let mut velocity = DVec3::from_array(imu.velocity_mps());
    let mut worst = (0.0f64, 0.0f64);
    for pose in &poses[1..] {
        let measured = imu.measure(pose);
        rotation *= rotation_from_vector(DVec3::from_array(measured.gyroscope_radps) * period_s);
        velocity += (rotation * DVec3::from_array(measured.accelerometer_mps2) - GRAVITY) * period_s;
        position += velocity * period_s;
        worst.0 = worst.0.max((position - pose.position).length());
        worst.1 = worst.1.max(rotation_vector(rotation.conjugate() * pose.world_from_sensor).length());
    }
    worst
}

/// Spread of the accelerometer along its axes in seconds in which the mean acceleration is next to nothing, m/s²: the median.
fn steady_noise(poses: &[SensorPose], fps: usize, found: &mut Vec<f64>) {
    let mut imu = Imu::new(&ImuSettings::default(), 1.0 / fps as f64, 0);
    let accelerations: Vec<DVec3> = poses
        .iter()
        .map(|pose| pose.world_from_sensor * DVec3::from_array(imu.measure(pose).accelerometer_mps2) - GRAVITY)
        .collect();
    for (second, poses) in accelerations.chunks_exact(fps).zip(poses.chunks_exact(fps)) {
        let mean = second.iter().sum::<DVec3>() / fps as f64;
        let moves = (poses[fps - 1].position - poses[0].position).length() > 2.0;
        if moves && mean.length() < 0.1 {
            let square = second.iter().map(|a| (*a - mean).length_squared()).sum::<f64>() / fps as f64;
            found.push((square / 3.0).sqrt());
        }
    }
}

fn rides_along(town: &str, fps: usize, most_noise_mps2: f64) {
    let catalogue = Catalogue::builtin();
    let town = endless_town::load(town, &catalogue).expect("a town");
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let settings =
        TrafficSettings { vehicles: 30, pedestrians: 10, seed: 3, fps: fps as f64, ..TrafficSettings::default() };
    let mut simulation = Simulation::new(&town.network, &fleet, &town.parked, &settings).expect("few enough");
    let frames = (SECONDS * fps as f64) as usize + 1;
    let mut ways: Vec<Vec<SensorPose>> = Vec::new();
    let mut before: Vec<Actor> = Vec::new();
    let period_s = 1.0 / fps as f64;
    for _ in 0..frames {
        let actors = simulation.state().actors;
        ways.resize_with(actors.len(), Vec::new);
        for (i, actor) in actors.iter().enumerate() {
            ways[i].push(carried(actor, AT_M, TURNED_RAD, before.get(i).map(|before| (before, -period_s))));
        }
        before = actors;
        simulation.tick();
    }
    let mut noise = Vec::new();
    let mut worst = (0.0f64, 0.0f64);
    for way in &mut ways {
        way[0] = moving_to(&way[0], &way[1], period_s);
        let (metres, radians) = errors(way, period_s);
        worst = (worst.0.max(metres), worst.1.max(radians));
        steady_noise(way, fps, &mut noise);
    }
    noise.sort_by(f64::total_cmp);
    let median = noise[noise.len() / 2];
    assert!(worst.0 < 0.005 && worst.1 < 1e-6, "{} at {fps} fps: {worst:?}", town.name);
    assert!(noise.len() > 10, "{} at {fps} fps: {} steady seconds", town.name, noise.len());
    assert!(median < most_noise_mps2, "{} at {fps} fps: {median} m/s²", town.name);
}

#[test]
fn an_imu_rides_along_at_10_fps() {
    rides_along("Town03", 10, 0.02);
}

#[test]
fn an_imu_rides_along_at_30_fps() {
    rides_along("Ladera", 30, 0.15);
}

#[test]
fn an_imu_rides_along_at_100_fps() {
    rides_along("Town03", 100, 0.05);
}
