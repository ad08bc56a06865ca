//! Pedals for a speed: the controller behind CARLA's Ackermann control.
//!
//! As CARLA's documentation and that of its ROS bridge have it: a controller of speed moves the acceleration that is aimed
//! at, within what the client allows; a controller of acceleration moves the pedal; below 0.1 m/s a vehicle that shall
//! stand is braked, and only there it changes its direction. Both controllers run once a frame and their outputs add up.

use super::VehicleBody;
use super::sane::within_f32;
use crate::wire::{AckermannControllerSettings, VehicleAckermannControl, VehicleControl};

/// Slower than this is standing, m/s.
const STANDS_MPS: f64 = 0.1;
/// What is usual where the client does not say, m/s².
const ACCELERATES_MPS2: f64 = 3.0;
/// What is usual where the client does not say, m/s².
const BRAKES_MPS2: f64 = 8.0;

/// A controller with a proportional, an integral and a derivative part; its output is within ±1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Pid {
    integral: f64,
    last: f64,
}

impl Pid {
    fn run(&mut self, gains: [f64; 3], target: f64, value: f64, dt_s: f64) -> f64 {
        let [kp, ki, kd] = gains;
        let error = target - value;
        self.integral = (self.integral + ki * error * dt_s).clamp(-1.0, 1.0);
        let derivative = -kd * (value - self.last) / dt_s;
        self.last = value;
        (kp * error + self.integral + derivative).clamp(-1.0, 1.0)
    }
}

/// Finds a [`VehicleControl`] for a [`VehicleAckermannControl`]. Run it once a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct AckermannController {
    settings: AckermannControllerSettings,
    speed: Pid,
    acceleration: Pid,
    /// m/s².
    aimed_at: f64,
    /// Throttle is positive, -1 to 1.
    pedal: f64,
    last_speed_mps: f64,
    /// Smoothed, m/s².
    felt: f64,
    control: VehicleControl,
}

impl Default for AckermannController {
    /// With CARLA's gains.
    fn default() -> Self {
        let settings = AckermannControllerSettings {
            speed_kp: 0.15,
            speed_ki: 0.0,
            speed_kd: 0.25,
            accel_kp: 0.01,
            accel_ki: 0.0,
            accel_kd: 0.01,
        };
        Self {
            settings,
            speed: Pid::default(),
            acceleration: Pid::default(),
            aimed_at: 0.0,
            pedal: 0.0,
            last_speed_mps: 0.0,
            felt: 0.0,
            control: VehicleControl::default(),
        }
    }
}

impl AckermannController {
    /// Its gains.
    pub fn settings(&self) -> &AckermannControllerSettings {
        &self.settings
    }

    /// Changes its gains; those that are not finite stay as they were.
    pub fn set_settings(&mut self, settings: &AckermannControllerSettings) {
        let own = &mut self.settings;
        let gains = [
            (&mut own.speed_kp, settings.speed_kp),
            (&mut own.speed_ki, settings.speed_ki),
            (&mut own.speed_kd, settings.speed_kd),
            (&mut own.accel_kp, settings.accel_kp),
            (&mut own.accel_ki, settings.accel_ki),
            (&mut own.accel_kd, settings.accel_kd),
        ];
        gains.into_iter().filter(|(_, new)| new.is_finite()).for_each(|(old, new)| *old = new);
    }

    /// Forgets what went before, as when a vehicle is driven in another way for a while.
    pub fn reset(&mut self) {
        *self = Self { settings: self.settings.clone(), ..Self::default() };
    }

    /// The pedals for the next `dt_s` seconds; the same as before where that is no positive number.
    pub fn run(&mut self, wanted: &VehicleAckermannControl, body: &VehicleBody, dt_s: f64) -> VehicleControl {
        if !(1e-6..=super::LONGEST_STEP_S).contains(&dt_s) {
            return self.control.clone();
        }
        let speed_mps = body.speed_mps();
        self.felt = 0.8 * self.felt + 0.2 * (speed_mps - self.last_speed_mps) / dt_s;
        self.last_speed_mps = speed_mps;

        self.control.steer = self.steer(wanted, body.max_steer_rad(), dt_s) as f32;
        let target = within_f32(wanted.speed, -super::FASTEST_MPS, super::FASTEST_MPS, 0.0);
        if speed_mps.abs() < STANDS_MPS && target.abs() < STANDS_MPS {
            (self.control.throttle, self.control.brake) = (0.0, 1.0);
            return self.control.clone();
        }
        let turns_back = speed_mps * target < 0.0;
        if speed_mps.abs() < STANDS_MPS {
            self.control.reverse = target < 0.0;
        }
        let target = if turns_back && speed_mps.abs() >= STANDS_MPS { 0.0 } else { target };
        self.pedals(target, within_f32(wanted.acceleration, -100.0, 100.0, 0.0).abs(), dt_s);
        self.control.clone()
    }

    fn steer(&self, wanted: &VehicleAckermannControl, most_rad: f64, dt_s: f64) -> f64 {
        if most_rad <= 1e-6 {
            return 0.0;
        }
        let target = within_f32(wanted.steer, -most_rad, most_rad, 0.0);
        let rate = within_f32(wanted.steer_speed, -100.0, 100.0, 0.0).abs();
        let now = f64::from(self.control.steer) * most_rad;
        let next = if rate < 0.001 { target } else { now + (target - now).clamp(-rate * dt_s, rate * dt_s) };
        next / most_rad
    }

    fn pedals(&mut self, target_mps: f64, allowed: f64, dt_s: f64) {
        let s = &self.settings;
        let gain = |gain: f32| within_f32(gain, -1e6, 1e6, 0.0);
        let speed_gains = [s.speed_kp, s.speed_ki, s.speed_kd].map(gain);
        let acceleration_gains = [s.accel_kp, s.accel_ki, s.accel_kd].map(gain);
        let (least, most) = if allowed < 1e-4 { (-BRAKES_MPS2, ACCELERATES_MPS2) } else { (-allowed, allowed) };
        let change = self.speed.run(speed_gains, target_mps, self.last_speed_mps, dt_s);
        self.aimed_at = (self.aimed_at + change).clamp(least, most);
        let change = self.acceleration.run(acceleration_gains, self.aimed_at, self.felt, dt_s);
        self.pedal = (self.pedal + change).clamp(-1.0, 1.0);
        let forwards = if self.control.reverse { -self.pedal } else { self.pedal } as f32;
        (self.control.throttle, self.control.brake) = (forwards.max(0.0), (-forwards).max(0.0));
    }
}
