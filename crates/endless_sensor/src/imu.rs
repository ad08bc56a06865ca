//! An inertial measurement unit whose measurements, integrated, give the poses back.
//!
//! # How to integrate
//! With the period T between samples, the gravity g = 9.81 m/s², and the pose R (world from sensor), p and the velocity v at
//! sample k − 1, the measurement at sample k (angular velocity ω, specific force f) leads to those at sample k:
//!
//! ```text
//! R ← R · exp(ω T)
//! v ← v + (R f − (0, 0, g)) T
//! p ← p + v T
//! ```
//!
//! This is strapdown integration by the semi-implicit (symplectic) Euler method on the rotation group. Without noise it
//! gives the orientation exactly, and positions that never leave the true ones by more than [`Imu::MOST_HELD_BACK_M`],
//! however long it goes on.
//!
//! # Why positions may be off by millimetres
//! Positions of actors are rounded to f32, 15 to 30 µm a few hundred metres from the origin, and follow polylines. Their
//! second differences at 100 Hz have a noise of 0.1 m/s², and a peak at each corner. So a smoothed path is measured, that of a
//! critically damped follower: its acceleration is the true one through a low pass of second order, and it lags behind by
//! the acceleration over the square of the follower's frequency. Where that would be more than the bound, it is the bound.
//! All is causal: a sample needs none after it.

use endless_world::math::f64::{atan2, exp};
use endless_world::{ImuMeasurement, ImuSettings, SensorPose, Stream, rotation_vector};
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// Towards which things at rest are accelerated upwards, m/s²; as in CARLA.
const GRAVITY_MPS2: DVec3 = DVec3::new(0.0, 0.0, 9.81);
/// Natural frequency of the follower, rad/s.
const FOLLOWS_RADPS: f64 = 20.0;

/// An inertial measurement unit; it is shown where it is at one sample after the other.
#[derive(Debug, Clone)]
pub struct Imu {
    settings: ImuSettings,
    period_s: f64,
    seed: u64,
    sample: u64,
    accelerometer_bias: DVec3,
    gyroscope_bias: DVec3,
    followed: Option<Followed>,
}

/// The last sample.
#[derive(Debug, Clone, Copy)]
struct Followed {
    position: DVec3,
    rotation: DQuat,
    /// Of the true positions, by differences.
    step_mps: DVec3,
    /// By how much the follower was behind the true positions at the last sample and at the one before.
    behind: [DVec3; 2],
    /// Of the follower.
    velocity_mps: DVec3,
}

impl Imu {
    /// Positions by integration are never farther from the true ones, metres.
    pub const MOST_HELD_BACK_M: f64 = 0.004;

    /// With nothing measured yet: samples follow one another in `period_s`.
    ///
    /// # Panics
    /// If the period is not positive.
    pub fn new(settings: &ImuSettings, period_s: f64, seed: u64) -> Self {
        assert!(period_s > 0.0, "the period of an IMU must be positive");
        Self {
            settings: *settings,
            period_s,
            seed,
            sample: 0,
            accelerometer_bias: settings.accel_bias().into(),
            gyroscope_bias: settings.gyro_bias().into(),
            followed: None,
        }
    }

    /// What it measures at the next sample, where it is there.
    ///
    /// The first sample has no period that ends with it: it measures gravity, and the angular velocity of the pose. Its
    /// velocity is where the integration begins, so it should be that of the positions (see [`endless_world::moving_to`]); what
    /// it is off shows as a knock in the second sample.
    pub fn measure(&mut self, pose: &SensorPose) -> ImuMeasurement {
        let now = self.followed.map_or_else(|| Followed::first(pose), |last| last.next(pose, self.period_s));
        let (acceleration, angular) = match self.followed {
            Some(last) => (
                (now.velocity_mps - last.velocity_mps) / self.period_s,
                rotation_vector(last.rotation.conjugate() * now.rotation) / self.period_s,
            ),
            None => (DVec3::ZERO, now.rotation.conjugate() * pose.angular_velocity_radps),
        };
        self.followed = Some(now);
        let force = now.rotation.conjugate() * (acceleration + GRAVITY_MPS2);
        let [force_noise, angular_noise] = self.noise();
        ImuMeasurement {
            accelerometer_mps2: (force + force_noise).to_array(),
            gyroscope_radps: (angular + angular_noise).to_array(),
            compass_rad: compass_rad(now.rotation),
        }
    }

    /// The velocity in the world at the last sample, m/s, from which an integration of those after it begins; 0 before
    /// the first.
    pub fn velocity_mps(&self) -> [f64; 3] {
        self.followed.map_or([0.0; 3], |followed| followed.velocity_mps.to_array())
    }

    /// Noise of the accelerometer and of the gyroscope at the next sample: white noise, and a bias that does a random walk
    /// (the angle and rate random walks of IEEE Std 952; Woodman 2007).
    fn noise(&mut self) -> [DVec3; 2] {
        let mut random = Stream::named(self.seed, "imu", &[self.sample]);
        let mut normal = || DVec3::new(random.normal(), random.normal(), random.normal());
        let [accelerometer, gyroscope, accelerometer_step, gyroscope_step] = [(); 4].map(|()| normal());
        if self.sample > 0 {
            let root = self.period_s.sqrt();
            self.accelerometer_bias += accelerometer_step * (self.settings.accel_bias_walk * root);
            self.gyroscope_bias += gyroscope_step * (self.settings.gyro_bias_walk * root);
        }
        self.sample += 1;
        [
            self.accelerometer_bias + accelerometer * DVec3::from_array(self.settings.accel_stddev()),
            self.gyroscope_bias + gyroscope * DVec3::from_array(self.settings.gyro_stddev()),
        ]
    }
}

impl Followed {
    fn first(pose: &SensorPose) -> Self {
        Self {
            position: pose.position,
            rotation: pose.world_from_sensor,
            step_mps: pose.velocity_mps,
            behind: [DVec3::ZERO; 2],
            velocity_mps: pose.velocity_mps,
        }
    }

    fn next(self, pose: &SensorPose, period_s: f64) -> Self {
        let step_mps = (pose.position - self.position) / period_s;
        let change = (step_mps - self.step_mps) * period_s;
        // A double pole: the share of being behind that is left after a period.
        let left = exp(-FOLLOWS_RADPS * period_s);
        let behind = left * change + 2.0 * left * self.behind[0] - left * left * self.behind[1];
        let behind = behind.clamp_length_max(Imu::MOST_HELD_BACK_M);
        Self {
            position: pose.position,
            rotation: pose.world_from_sensor,
            step_mps,
            behind: [behind, self.behind[0]],
            velocity_mps: step_mps - (behind - self.behind[0]) / period_s,
        }
    }
}

/// Heading of the x axis clockwise from north (+y), 0 to 2π.
fn compass_rad(world_from_sensor: DQuat) -> f64 {
    let ahead = world_from_sensor * DVec3::X;
    let heading = atan2(ahead.x, ahead.y);
    if heading < 0.0 { (heading + TAU).min(TAU.next_down()) } else { heading }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::math::f64::{cos, sin};
    use endless_world::{moving_to, rotation_from_angles, rotation_from_vector};
    use proptest::prelude::*;

    /// Integrates as the documents tell, from the pose of this number on, and gives the largest errors of position and
    /// orientation.
    fn errors(poses: &[SensorPose], period_s: f64, begin: usize) -> (f64, f64) {
        let mut imu = Imu::new(&ImuSettings::default(), period_s, 7);
        for pose in &poses[..=begin] {
            imu.measure(pose);
        }
        let (mut rotation, mut position) = (poses[begin].world_from_sensor, poses[begin].position);
        let mut velocity = DVec3::from_array(imu.velocity_mps());
        let mut worst = (0.0f64, 0.0f64);
        for pose in &poses[begin + 1..] {
            let measured = imu.measure(pose);
            rotation =
                (rotation * rotation_from_vector(DVec3::from_array(measured.gyroscope_radps) * period_s)).normalize();
            velocity += (rotation * DVec3::from_array(measured.accelerometer_mps2) - GRAVITY_MPS2) * period_s;
            position += velocity * period_s;
            worst.0 = worst.0.max((position - pose.position).length());
            worst.1 = worst.1.max(rotation_vector(rotation.conjugate() * pose.world_from_sensor).length());
        }
        worst
    }

    /// A weaving, rolling way, with positions rounded as those of actors are.
    fn way(rate_hz: f64, speed: f64, sway: f64, samples: u32) -> Vec<SensorPose> {
        let at = |k: u32| {
            let t = f64::from(k) / rate_hz;
            let place = DVec3::new(300.0 + speed * t, 40.0 + sway * sin(0.7 * t), 2.0 + 0.2 * sin(1.1 * t));
            let rotation = rotation_from_angles(0.3 * sway * cos(0.7 * t), 0.05 * sin(2.0 * t), 0.2 * sin(1.3 * t));
            SensorPose::still(place.as_vec3().as_dvec3(), rotation)
        };
        let mut poses: Vec<SensorPose> = (0..samples).map(at).collect();
        poses[0] = moving_to(&poses[0], &poses[1], 1.0 / rate_hz);
        poses
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        #[test]
        fn ten_seconds_come_back(rate_hz in 5.0..400.0f64, speed in -5.0..30.0f64, sway in 0.0..6.0f64) {
            let poses = way(rate_hz, speed, sway, (10.0 * rate_hz) as u32 + 1);
            let (metres, radians) = errors(&poses, 1.0 / rate_hz, 0);
            prop_assert!(metres < Imu::MOST_HELD_BACK_M + 1e-6, "{metres} m");
            prop_assert!(radians < 1e-9, "{radians} rad");
            let (metres, _) = errors(&poses, 1.0 / rate_hz, poses.len() / 3);
            prop_assert!(metres < 2.0 * Imu::MOST_HELD_BACK_M + 1e-6, "{metres} m from later on");
        }

        #[test]
        fn even_leaps_come_back(leaps in prop::collection::vec([-0.3..0.3f64, -0.3..0.3f64, -0.3..0.3f64], 2..80)) {
            let mut position = DVec3::ZERO;
            let poses: Vec<SensorPose> = leaps.into_iter().map(|leap| {
                position += DVec3::from_array(leap);
                SensorPose::still(position, DQuat::IDENTITY)
            }).collect();
            let (metres, _) = errors(&poses, 0.01, 0);
            prop_assert!(metres < Imu::MOST_HELD_BACK_M + 1e-9, "{metres} m");
        }
    }

    #[test]
    fn rounding_is_smoothed_away() {
        // 100 Hz, straight on: what is left of the rounding of positions.
        let poses = way(100.0, 13.0, 0.0, 1000);
        let spread = |measured: &mut dyn FnMut(&SensorPose) -> f64| {
            let values: Vec<f64> = poses.iter().map(measured).skip(100).collect();
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            (values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / values.len() as f64).sqrt()
        };
        let mut imu = Imu::new(&ImuSettings::default(), 0.01, 0);
        let smoothed = spread(&mut |pose| imu_along(&mut imu, pose));
        let mut lasts = [poses[0].position.x; 2];
        let raw = spread(&mut |pose| {
            let x = pose.position.x;
            let second = (x - 2.0 * lasts[0] + lasts[1]) / 1e-4;
            lasts = [x, lasts[0]];
            second
        });
        assert!(smoothed < 0.03 && raw > 5.0 * smoothed, "{smoothed} of {raw} m/s²");
    }

    /// Acceleration along the world's x.
    fn imu_along(imu: &mut Imu, pose: &SensorPose) -> f64 {
        let measured = imu.measure(pose);
        (pose.world_from_sensor * DVec3::from_array(measured.accelerometer_mps2)).x
    }

    #[test]
    fn gravity_pushes_up_and_the_compass_is_clockwise_from_north() {
        let mut imu = Imu::new(&ImuSettings::default(), 0.01, 0);
        let nose_up = SensorPose::still(DVec3::ZERO, rotation_from_angles(0.0, 0.1, 0.0));
        let at_rest = imu.measure(&nose_up);
        let [x, y, z] = at_rest.accelerometer_mps2;
        assert!((x - 9.81 * sin(0.1)).abs() < 1e-12 && y.abs() < 1e-12 && (z - 9.81 * cos(0.1)).abs() < 1e-12);
        assert!((at_rest.compass_rad - 0.25 * TAU).abs() < 1e-12, "east");
        for (yaw, compass) in [(0.25, 0.0), (0.0, 0.25), (-0.25, 0.5), (0.5, 0.75)] {
            let heading = compass_rad(rotation_from_angles(yaw * TAU, 0.0, 0.0));
            assert!(sin(heading - compass * TAU).abs() < 1e-9 && cos(heading - compass * TAU) > 0.0, "{yaw} {heading}");
            assert!((0.0..TAU).contains(&heading));
        }
    }

    #[test]
    fn noise_is_as_large_as_asked_and_the_same_again() {
        let settings = ImuSettings {
            noise_accel_stddev_x: 0.2,
            noise_gyro_bias_z: 0.01,
            gyro_bias_walk: 0.002,
            ..ImuSettings::default()
        };
        let pose = SensorPose::still(DVec3::ZERO, DQuat::IDENTITY);
        let measured = |seed| {
            let mut imu = Imu::new(&settings, 0.01, seed);
            (0..10_000).map(|_| imu.measure(&pose)).collect::<Vec<_>>()
        };
        let once = measured(3);
        assert_eq!(once, measured(3));
        assert_ne!(once, measured(4));
        let mean_square = |value: &dyn Fn(&ImuMeasurement) -> f64| {
            once.iter().map(|m| value(m) * value(m)).sum::<f64>() / once.len() as f64
        };
        assert!((mean_square(&|m| m.accelerometer_mps2[0]).sqrt() - 0.2).abs() < 0.01);
        assert_eq!(mean_square(&|m| m.accelerometer_mps2[1]), 0.0);
        assert_eq!(once[0].gyroscope_radps[2], 0.01);
        // After 100 s the biases of many units are 0.002 · √100 apart.
        let ends = (0..200).map(|seed| {
            let mut imu = Imu::new(&settings, 1.0, seed);
            (0..=100).map(|_| imu.measure(&pose).gyroscope_radps[1]).last().unwrap_or(0.0)
        });
        let spread = (ends.map(|end| end * end).sum::<f64>() / 200.0).sqrt();
        assert!((spread - 0.02).abs() < 0.003, "{spread}");
    }
}
