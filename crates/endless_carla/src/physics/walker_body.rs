//! A person on foot.

use super::footing::height;
use super::sane::{at_most, vector, within, within_f32};
use super::vehicle_body::direction;
use super::{FASTEST_MPS, GRAVITY_MPS2, Ground, Place, substeps};
use crate::wire::WalkerControl;
use endless_world::math::f64::{atan2, wrap_angle};
use glam::{DVec2, DVec3};

/// How fast the velocity changes, m/s².
const ACCELERATION: f64 = 10.0;
/// How fast a walker turns to where it goes, rad/s.
const TURNING: f64 = 8.0;
/// Upwards at the beginning of a jump, m/s: CARLA's walkers jump about a metre.
const JUMP_MPS: f64 = 4.2;
/// Higher than this is no step but a fall, metres.
const STEP_M: f64 = 0.5;
/// Friction of one who was pushed, m/s².
const SLIDING: f64 = 4.0;
/// No walker runs faster, m/s.
const FASTEST_WALK: f64 = 20.0;
/// Within this height over the ground a walker that was put somewhere is let down at once, metres.
const LET_DOWN_M: f64 = 1.2;

/// A person on foot: walks where a [`WalkerControl`] says, or is put from place to place, as clients with a crowd of their
/// own do. The origin is between the feet, on the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct WalkerBody {
    half_width_m: f64,
    height_m: f64,
    mass_kg: f64,
    position: DVec3,
    yaw_rad: f64,
    /// Of walking, in the plane.
    walking: DVec2,
    /// Of having been pushed, in the plane.
    pushed: DVec2,
    climb_mps: f64,
    grounded: bool,
    fresh: bool,
    walked_m: f64,
    /// Speed that it was put somewhere with: it does not walk by itself.
    carried_mps: Option<f64>,
    acceleration: DVec3,
    turn_rate: f64,
    began: (DVec3, f64),
    goal: DVec2,
    jumps: bool,
    simulated: bool,
    gravity: bool,
    collides: bool,
}

impl WalkerBody {
    /// One that stands: of a height and half a width, metres.
    pub fn new(height_m: f64, half_width_m: f64, place: Place) -> Self {
        let height_m = within(height_m, 0.3, 3.0, 1.75);
        let mut body = Self {
            half_width_m: within(half_width_m, 0.05, 1.0, 0.25),
            height_m,
            // A body mass index of 23.5.
            mass_kg: 23.5 * height_m * height_m,
            position: DVec3::ZERO,
            yaw_rad: 0.0,
            walking: DVec2::ZERO,
            pushed: DVec2::ZERO,
            climb_mps: 0.0,
            grounded: false,
            fresh: true,
            walked_m: 0.0,
            carried_mps: None,
            acceleration: DVec3::ZERO,
            turn_rate: 0.0,
            began: (DVec3::ZERO, 0.0),
            goal: DVec2::ZERO,
            jumps: false,
            simulated: true,
            gravity: true,
            collides: true,
        };
        body.put(place);
        body
    }

    /// Goes on by `dt_s`, as [`super::VehicleBody::step`] does.
    pub fn step(&mut self, control: &WalkerControl, dt_s: f64, ground: &Ground<'_>) {
        let (count, each_s) = substeps(dt_s);
        self.begin(control);
        for _ in 0..count {
            self.substep(each_s, ground);
        }
        self.end(f64::from(count) * each_s);
    }

    pub(super) fn begin(&mut self, control: &WalkerControl) {
        let speed = within_f32(control.speed, 0.0, FASTEST_WALK, 0.0);
        // CARLA's y is to the south.
        let towards = DVec3::new(control.direction.x.into(), -f64::from(control.direction.y), 0.0);
        let towards = vector(towards, 1e6).truncate();
        self.goal = towards.try_normalize().unwrap_or_default() * speed;
        self.jumps = control.jump;
        if speed > 0.0 || control.jump {
            self.carried_mps = None;
        }
        self.began = (self.velocity(), self.yaw_rad);
    }

    pub(super) fn end(&mut self, dt_s: f64) {
        if dt_s > 0.0 {
            self.acceleration = (self.velocity() - self.began.0) / dt_s;
            self.turn_rate = wrap_angle(self.yaw_rad - self.began.1) / dt_s;
        }
    }

    /// Goes on by a hundredth of a second or less.
    pub(super) fn substep(&mut self, dt_s: f64, ground: &Ground<'_>) {
        if !self.simulated {
            return;
        }
        let floor = height(ground, self.position);
        if let (true, true, Some(floor)) = (self.fresh, self.gravity, floor)
            && (self.position.z - floor).abs() <= LET_DOWN_M
        {
            (self.position.z, self.climb_mps, self.grounded) = (floor, 0.0, true);
        }
        self.fresh = false;
        if self.carried_mps.is_none() {
            self.walk(dt_s);
        }
        let slower = (self.pushed.length() - SLIDING * dt_s).max(0.0);
        self.pushed = self.pushed.clamp_length_max(slower.max(1e-12));
        if slower == 0.0 {
            self.pushed = DVec2::ZERO;
        }
        let walking = if self.carried_mps.is_none() { self.walking } else { DVec2::ZERO };
        let moved = (walking + self.pushed) * dt_s;
        self.walked_m = (self.walked_m + (walking * dt_s).length()).min(1e9);
        self.position = vector(self.position + moved.extend(0.0), 1e6);
        self.follow(ground, dt_s);
    }

    fn walk(&mut self, dt_s: f64) {
        if self.grounded {
            let change = self.goal - self.walking;
            self.walking += change.clamp_length_max(ACCELERATION * dt_s);
        }
        if self.goal.length() > 0.05 {
            let wanted = wrap_angle(atan2(self.goal.y, self.goal.x) - self.yaw_rad);
            self.yaw_rad = wrap_angle(self.yaw_rad + wanted.clamp(-TURNING * dt_s, TURNING * dt_s));
        }
        if self.jumps && self.grounded {
            self.climb_mps = JUMP_MPS;
            self.grounded = false;
            // One jump for one frame: nobody hops on while a frame lasts.
            self.jumps = false;
        }
    }

    fn follow(&mut self, ground: &Ground<'_>, dt_s: f64) {
        if !self.gravity || self.carried_mps.is_some() {
            self.position.z += self.climb_mps * dt_s;
            return;
        }
        let floor = height(ground, self.position);
        match floor {
            Some(floor) if self.grounded && (self.position.z - floor) <= STEP_M => self.position.z = floor,
            _ => {
                self.climb_mps = (self.climb_mps - GRAVITY_MPS2 * dt_s).max(-FASTEST_MPS);
                self.position.z += self.climb_mps * dt_s;
                let landed = floor.filter(|&floor| self.position.z <= floor && self.climb_mps <= 0.0);
                self.grounded = landed.is_some();
                if let Some(floor) = landed {
                    (self.position.z, self.climb_mps) = (floor, 0.0);
                }
            }
        }
        self.position = vector(self.position, 1e6);
    }

    /// Puts it somewhere; within a little more than a metre of the ground it is let down at once.
    pub fn put(&mut self, place: Place) {
        let place = place.sane();
        self.position = place.position;
        self.yaw_rad = place.yaw_rad;
        self.grounded = false;
        self.climb_mps = 0.0;
        self.fresh = true;
    }

    /// Puts it somewhere, walking at a speed (m/s): CARLA's `ApplyWalkerState`. It stays there until it is put elsewhere
    /// or a control makes it walk; its legs go by the way that it was moved.
    pub fn put_walking(&mut self, place: Place, speed_mps: f64) {
        let speed_mps = within(speed_mps, 0.0, FASTEST_WALK, 0.0);
        let moved = place.sane().position - self.position;
        // Who comes from farther off, or from above, has not walked there.
        if moved.length() < 2.0 {
            self.walked_m += moved.truncate().length();
        }
        self.put(place);
        self.carried_mps = Some(speed_mps);
        self.walking = direction(self.yaw_rad) * speed_mps;
        self.pushed = DVec2::ZERO;
    }

    /// Whether [`Self::put_walking`] put it where it is.
    pub(super) fn is_carried(&self) -> bool {
        self.carried_mps.is_some()
    }

    /// Where it is.
    pub fn place(&self) -> Place {
        Place::level(self.position, self.yaw_rad)
    }

    /// m/s.
    pub fn velocity(&self) -> DVec3 {
        (self.walking + self.pushed).extend(self.climb_mps)
    }

    /// Mean of the last step, m/s².
    pub fn acceleration(&self) -> DVec3 {
        self.acceleration
    }

    /// Mean of the last step, rad/s.
    pub fn angular_velocity(&self) -> DVec3 {
        DVec3::Z * self.turn_rate
    }

    /// Speed of its legs, m/s.
    pub fn walking_mps(&self) -> f64 {
        self.walking.length()
    }

    /// Way that it has walked since it was made, metres: which step its legs are at.
    pub fn walked_m(&self) -> f64 {
        self.walked_m
    }

    /// Whether its feet are on the ground.
    pub fn grounded(&self) -> bool {
        self.grounded
    }

    /// Kilograms.
    pub fn mass_kg(&self) -> f64 {
        self.mass_kg
    }

    /// Metres.
    pub fn height_m(&self) -> f64 {
        self.height_m
    }

    /// Half of its width, metres.
    pub fn half_width_m(&self) -> f64 {
        self.half_width_m
    }

    /// Whether it moves by itself and is pushed.
    pub fn simulated(&self) -> bool {
        self.simulated
    }

    /// See [`Self::simulated`].
    pub fn set_simulated(&mut self, simulated: bool) {
        self.simulated = simulated;
    }

    /// Whether it falls.
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

    /// Gives it a velocity, m/s, of which nothing is walking.
    pub fn set_target_velocity(&mut self, velocity: DVec3) {
        let velocity = at_most(velocity, FASTEST_MPS);
        (self.walking, self.pushed, self.climb_mps) = (DVec2::ZERO, velocity.truncate(), velocity.z);
        self.grounded &= velocity.z <= 0.0;
    }

    /// Knocks it, N s.
    pub fn add_impulse(&mut self, impulse: DVec3) {
        let change = at_most(vector(impulse, 1e9) / self.mass_kg, FASTEST_MPS);
        self.pushed = at_most((self.pushed + change.truncate()).extend(0.0), FASTEST_MPS).truncate();
        self.climb_mps = within(self.climb_mps + change.z, -FASTEST_MPS, FASTEST_MPS, 0.0);
        self.grounded &= change.z <= 0.0;
    }

    /// Moves it in the plane without a step.
    pub(super) fn shift(&mut self, by: DVec2) {
        self.position += by.extend(0.0);
    }
}
