//! A vehicle that is driven by its pedals.

use super::bicycle::{AxleState, Planar};
use super::drive_train::DriveTrain;
use super::footing::Footing;
use super::input::Input;
use super::parameters::Parameters;
use super::sane::{at_most, vector, within};
use super::suspension::Suspension;
use super::{FASTEST_MPS, Ground, Place, VehicleShape, defaults, substeps};
use crate::wire::{VehicleControl, VehiclePhysicsControl};
use endless_world::math::f64::{sin_cos, wrap_angle};
use glam::{DVec2, DVec3};

/// Fastest turn that a client can ask for, rad/s.
const FASTEST_TURN: f64 = 20.0;
/// Largest impulse per mass and force per mass, m/s and m/s².
const LARGEST_PUSH: f64 = 500.0;

/// A vehicle that is driven by its pedals, in this workspace's world: metres, radians, x east, y north, z up.
///
/// It moves as a dynamic bicycle in the plane, follows the ground under its wheels, falls where there is none, and nods and
/// leans by its accelerations. It never overturns.
#[derive(Debug, Clone, PartialEq)]
pub struct VehicleBody {
    pub(super) shape: VehicleShape,
    pub(super) described: VehiclePhysicsControl,
    pub(super) friction_here: Option<f64>,
    pub(super) p: Parameters,

    /// The origin.
    pub(super) position: DVec3,
    pub(super) yaw_rad: f64,
    /// Of the plane of the wheels: pitch and roll.
    pub(super) tilt: DVec2,
    pub(super) suspension: Suspension,
    /// Of the centre of mass.
    pub(super) planar: Planar,
    pub(super) climb_mps: f64,
    pub(super) drive_train: DriveTrain,
    /// Of the front wheels, to the left.
    pub(super) steer_rad: f64,
    pub(super) rolled_m: f64,
    pub(super) grounded: bool,
    /// Just put somewhere: it may be let down.
    pub(super) fresh: bool,
    /// In the first step after that it stays tilted as it was put.
    pub(super) keeps_tilt: bool,

    pub(super) input: Input,
    pub(super) axles: [AxleState; 2],
    /// Forwards and to the left, smoothed.
    pub(super) felt: DVec2,
    /// Of the last whole step.
    pub(super) acceleration: DVec3,
    pub(super) tilt_rates: DVec2,
    pub(super) footing: Option<(DVec3, Option<Footing>)>,
    began: DVec3,

    pub(super) simulated: bool,
    pub(super) gravity: bool,
    collides: bool,
    pub(super) constant_velocity: Option<DVec3>,
    pub(super) force_n: DVec3,
    pub(super) torque_nm: DVec3,
}

impl VehicleBody {
    /// One that stands; it is let down to the ground in the first step if that is within a metre.
    pub fn new(shape: VehicleShape, place: Place) -> Self {
        let described = defaults::physics_control(&shape);
        let p = Parameters::new(&shape, &described, None);
        let mut body = Self {
            shape,
            described,
            friction_here: None,
            p,
            position: DVec3::ZERO,
            yaw_rad: 0.0,
            tilt: DVec2::ZERO,
            suspension: Suspension::default(),
            planar: Planar::default(),
            climb_mps: 0.0,
            drive_train: DriveTrain::default(),
            steer_rad: 0.0,
            rolled_m: 0.0,
            grounded: false,
            fresh: true,
            keeps_tilt: false,
            input: Input::default(),
            axles: [AxleState::default(); 2],
            felt: DVec2::ZERO,
            acceleration: DVec3::ZERO,
            tilt_rates: DVec2::ZERO,
            footing: None,
            began: DVec3::ZERO,
            simulated: true,
            gravity: true,
            collides: true,
            constant_velocity: None,
            force_n: DVec3::ZERO,
            torque_nm: DVec3::ZERO,
        };
        body.put(place);
        body.rolled_m = 0.0;
        body
    }

    /// Goes on by `dt_s` in steps of at most a hundredth of a second. Nothing happens where that is no positive number;
    /// more than [`super::LONGEST_STEP_S`] is as much as that.
    pub fn step(&mut self, control: &VehicleControl, dt_s: f64, ground: &Ground<'_>) {
        let (count, each_s) = substeps(dt_s);
        self.begin(control);
        for _ in 0..count {
            self.substep(each_s, ground);
        }
        self.end(f64::from(count) * each_s);
    }

    pub(super) fn begin(&mut self, control: &VehicleControl) {
        self.input = Input::from(control);
        self.began = self.velocity();
        self.footing = None;
    }

    pub(super) fn end(&mut self, dt_s: f64) {
        if dt_s > 0.0 {
            self.keeps_tilt = false;
            self.acceleration = (self.velocity() - self.began) / dt_s;
            (self.force_n, self.torque_nm) = (DVec3::ZERO, DVec3::ZERO);
        }
    }

    /// Where its origin is, and how it is turned.
    pub fn place(&self) -> Place {
        let angles = self.tilt + self.suspension.angles;
        Place { position: self.position, yaw_rad: self.yaw_rad, pitch_rad: angles.x, roll_rad: angles.y }
    }

    /// Puts it somewhere; it keeps its velocity. Within a metre of the ground it is let down at once,
    /// nearly as tilted as that as it is put. The wheels roll
    /// along if it is not simulated and did not go far.
    pub fn put(&mut self, place: Place) {
        let place = place.sane();
        let moved = place.position - self.position;
        if !self.simulated && moved.length() < 5.0 {
            self.rolled_m += moved.truncate().dot(direction(place.yaw_rad));
        }
        self.position = place.position;
        self.yaw_rad = place.yaw_rad;
        self.tilt = DVec2::new(place.pitch_rad, place.roll_rad);
        self.suspension = Suspension::default();
        self.tilt_rates = DVec2::ZERO;
        self.grounded = false;
        self.fresh = true;
        self.keeps_tilt = false;
        self.footing = None;
    }

    /// Of the centre of mass, m/s.
    pub fn velocity(&self) -> DVec3 {
        self.planar.velocity.extend(self.climb_mps)
    }

    /// Forwards, m/s.
    pub fn speed_mps(&self) -> f64 {
        self.planar.velocity.dot(direction(self.yaw_rad))
    }

    /// Mean of the last step, m/s².
    pub fn acceleration(&self) -> DVec3 {
        self.acceleration
    }

    /// In the world, rad/s.
    pub fn angular_velocity(&self) -> DVec3 {
        let forward = direction(self.yaw_rad);
        let rates = self.tilt_rates + self.suspension.rates;
        (forward * rates.y - forward.perp() * rates.x).extend(self.planar.yaw_rate)
    }

    /// Of the wheels in the order of [`VehiclePhysicsControl::wheels`], radians to the left.
    pub fn wheel_angles_rad(&self) -> [f64; 4] {
        let [left, right] = self.p.wheel_angles(self.steer_rad);
        [left, right, 0.0, 0.0]
    }

    /// Way that the wheels have rolled since it was made, backwards is negative, metres.
    pub fn rolled_m(&self) -> f64 {
        self.rolled_m
    }

    /// How far the wheels have turned, radians in [0, 2π).
    pub fn wheel_turn_rad(&self) -> f64 {
        (self.rolled_m / self.p.wheel_radius_m).rem_euclid(std::f64::consts::TAU)
    }

    /// Turns of the engine a minute.
    pub fn engine_rpm(&self) -> f64 {
        self.drive_train.rpm
    }

    /// -1 backwards, 0 neutral, from 1 on forwards.
    pub fn gear(&self) -> i32 {
        self.drive_train.gear
    }

    /// Whether it stands or rolls on the ground.
    pub fn grounded(&self) -> bool {
        self.grounded
    }

    /// Its measures.
    pub fn shape(&self) -> &VehicleShape {
        &self.shape
    }

    /// Kilograms.
    pub fn mass_kg(&self) -> f64 {
        self.p.mass_kg
    }

    /// Largest angle of the front wheels that a client reckons with, radians: CARLA's `max_steer_angle`.
    pub fn max_steer_rad(&self) -> f64 {
        self.p.max_steer_rad
    }

    /// Whether it moves by itself; otherwise it stands wherever it is put, and nothing pushes it.
    pub fn simulated(&self) -> bool {
        self.simulated
    }

    /// See [`Self::simulated`].
    pub fn set_simulated(&mut self, simulated: bool) {
        if self.simulated != simulated {
            self.fresh = true;
            self.planar = Planar::default();
            self.climb_mps = 0.0;
            self.felt = DVec2::ZERO;
        }
        self.simulated = simulated;
    }

    /// Whether it falls; without gravity its tyres have no load, and it glides.
    pub fn set_gravity(&mut self, gravity: bool) {
        self.gravity = gravity;
    }

    /// Whether it meets other bodies.
    pub fn collides(&self) -> bool {
        self.collides
    }

    /// See [`Self::collides`].
    pub fn set_collides(&mut self, collides: bool) {
        self.collides = collides;
    }

    /// Gives it a velocity, m/s, at once.
    pub fn set_target_velocity(&mut self, velocity: DVec3) {
        let velocity = at_most(velocity, FASTEST_MPS);
        self.planar.velocity = velocity.truncate();
        self.climb_mps = velocity.z;
    }

    /// Makes it turn, rad/s, at once. On the ground it turns about the vertical only.
    pub fn set_target_angular_velocity(&mut self, angular_velocity: DVec3) {
        self.planar.yaw_rate = within(angular_velocity.z, -FASTEST_TURN, FASTEST_TURN, 0.0);
    }

    /// Keeps it at a velocity in its own frame (forward, left, up; m/s), or lets it go.
    pub fn set_constant_velocity(&mut self, velocity: Option<DVec3>) {
        self.constant_velocity = velocity.map(|velocity| at_most(velocity, FASTEST_MPS));
    }

    /// Knocks it at its centre of mass, N s.
    pub fn add_impulse(&mut self, impulse: DVec3) {
        if self.simulated {
            let change = vector(impulse / self.p.mass_kg, LARGEST_PUSH);
            self.set_target_velocity(self.velocity() + change);
        }
    }

    /// Knocks it at a point of the world, N s.
    pub fn add_impulse_at(&mut self, impulse: DVec3, point: DVec3) {
        let arm = vector(point, 1e7).truncate() - self.centre();
        self.add_impulse(impulse);
        self.add_angular_impulse(DVec3::Z * arm.perp_dot(vector(impulse, 1e9).truncate()));
    }

    /// Knocks it round about the vertical, N m s; it does not overturn.
    pub fn add_angular_impulse(&mut self, impulse: DVec3) {
        if self.simulated {
            let rate = self.planar.yaw_rate + within(impulse.z / self.p.yaw_inertia, -1e3, 1e3, 0.0);
            self.set_target_angular_velocity(DVec3::Z * rate);
        }
    }

    /// Pushes it at its centre of mass during the next step, N.
    pub fn add_force(&mut self, force: DVec3) {
        self.force_n = vector(self.force_n + vector(force, 1e12), LARGEST_PUSH * self.p.mass_kg);
    }

    /// Pushes it at a point of the world during the next step, N.
    pub fn add_force_at(&mut self, force: DVec3, point: DVec3) {
        let arm = vector(point, 1e7).truncate() - self.centre();
        self.add_force(force);
        self.add_torque(DVec3::Z * arm.perp_dot(vector(force, 1e12).truncate()));
    }

    /// Turns it about the vertical during the next step, N m; it does not overturn.
    pub fn add_torque(&mut self, torque: DVec3) {
        self.torque_nm = vector(self.torque_nm + vector(torque, 1e12), LARGEST_PUSH * self.p.yaw_inertia);
    }

    /// The centre of mass in the plane.
    pub(super) fn centre(&self) -> DVec2 {
        self.position.truncate() + direction(self.yaw_rad) * self.p.centre_m
    }

    /// Sets the motion in the plane, within bounds.
    pub(super) fn set_planar(&mut self, velocity: DVec2, yaw_rate: f64) {
        self.planar.velocity = at_most(velocity.extend(0.0), FASTEST_MPS).truncate();
        self.planar.yaw_rate = within(yaw_rate, -FASTEST_TURN, FASTEST_TURN, 0.0);
    }

    pub(super) fn turn_to(&mut self, yaw_rad: f64) {
        self.yaw_rad = wrap_angle(yaw_rad);
    }
}

/// The unit vector at an angle from east.
pub(crate) fn direction(yaw_rad: f64) -> DVec2 {
    let (sin, cos) = sin_cos(yaw_rad);
    DVec2::new(cos, sin)
}
