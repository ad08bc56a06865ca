//! A short step of a [`VehicleBody`].

use super::bicycle::{self, AxleForces};
use super::drive_train::Drive;
use super::footing::Footing;
use super::sane::{vector, within};
use super::tyre::passed_on;
use super::vehicle_body::direction;
use super::{GRAVITY_MPS2, Ground, VehicleBody};
use endless_world::math::f64::{atan, exp};
use glam::{DVec2, DVec3};

/// How fast the front wheels turn, rad/s.
const STEERING_RATE: f64 = 3.0;
/// Within this height over the ground a body that was put somewhere is let down at once, metres.
const LET_DOWN_M: f64 = 1.0;
/// A vehicle that was put on the ground keeps a tilt that differs less from the ground's for a step, radians.
const NEARLY_TILTED_RAD: f64 = 0.035;
/// How far wheels hang down before they leave the ground, metres.
const DROOP_M: f64 = 0.08;
/// How soon the body follows bumps, seconds.
const BUMP_S: f64 = 0.04;
/// How soon the load follows the acceleration, seconds.
const LOAD_S: f64 = 0.08;
/// Slower than this without throttle, and in gear, it is held as on a slope, m/s.
const HELD_BELOW_MPS: f64 = 0.3;
/// How steep a slope may be for that, as a share of the weight.
const HELD: f64 = 0.25;

impl VehicleBody {
    /// Goes on by a hundredth of a second or less.
    pub(super) fn substep(&mut self, dt_s: f64, ground: &Ground<'_>) {
        if !self.simulated {
            return;
        }
        let forward = direction(self.yaw_rad);
        let footing = self.footing(ground, forward);
        if let (true, true, Some(footing)) = (self.fresh, self.gravity, footing)
            && (self.position.z - footing.height_m).abs() <= LET_DOWN_M
        {
            self.position.z = footing.height_m;
            // What clients read of a pose that they have set on a road is that pose.
            self.keeps_tilt = (tilt(footing) - self.tilt).length() < NEARLY_TILTED_RAD;
            if !self.keeps_tilt {
                self.tilt = tilt(footing);
            }
            self.climb_mps = 0.0;
            self.grounded = true;
        }
        self.fresh = false;

        let before = self.planar.velocity;
        let slope = footing.filter(|_| self.grounded && self.gravity).map(|footing| footing.slope);
        self.steer(dt_s);
        let drive = self.drive_train.step(&self.p, &self.input, before.dot(forward), dt_s);
        self.drift(slope, forward, dt_s);
        self.keep_constant(forward);
        if let Some(slope) = slope {
            let forces = self.axle_forces(&drive, slope);
            self.axles = bicycle::step(&mut self.planar, &self.p, forward, self.steer_rad, forces, dt_s);
            self.keep_constant(forward);
        } else {
            self.axles = Default::default();
        }
        let felt = (self.planar.velocity - before) / dt_s;
        let felt = DVec2::new(felt.dot(forward), felt.dot(forward.perp()));
        self.felt += (felt - self.felt) * (1.0 - exp(-dt_s / LOAD_S));

        self.advance(forward, dt_s);
        self.follow(footing, forward, dt_s);
        self.suspension.step(&self.p, self.felt, dt_s);
    }

    /// The ground under it; asked for anew only after it moved.
    fn footing(&mut self, ground: &Ground<'_>, forward: DVec2) -> Option<Footing> {
        let at = self.position.truncate();
        let key = at.extend(self.yaw_rad);
        match self.footing {
            Some((known, footing)) if known == key => footing,
            _ => {
                let footing = Footing::under(ground, &self.p, self.position, forward);
                self.footing = Some((key, footing));
                footing
            }
        }
    }

    fn steer(&mut self, dt_s: f64) {
        let wanted = self.p.steering_angle(self.input.steer, self.planar.velocity.length());
        let most = STEERING_RATE * dt_s;
        self.steer_rad += (wanted - self.steer_rad).clamp(-most, most);
    }

    /// What acts without tyres: weight on a slope, air, and what clients push with.
    fn drift(&mut self, slope: Option<DVec2>, forward: DVec2, dt_s: f64) {
        if let Some(slope) = slope {
            let fall = forward * slope.x + forward.perp() * slope.y;
            self.planar.velocity -= fall * (GRAVITY_MPS2 * dt_s / (1.0 + fall.length_squared()));
        }
        self.planar.velocity += self.force_n.truncate() * (dt_s / self.p.mass_kg);
        self.planar.yaw_rate += self.torque_nm.z * dt_s / self.p.yaw_inertia;
        // Implicit: never more than what stops it.
        let air = self.p.air_drag * self.planar.velocity.length() * dt_s / self.p.mass_kg;
        let (velocity, yaw_rate) = (self.planar.velocity / (1.0 + air), self.planar.yaw_rate);
        self.set_planar(velocity, yaw_rate);
    }

    fn keep_constant(&mut self, forward: DVec2) {
        if let Some(constant) = self.constant_velocity {
            self.planar.velocity = forward * constant.x + forward.perp() * constant.y;
        }
    }

    fn axle_forces(&self, drive: &Drive, slope: DVec2) -> [AxleForces; 2] {
        let (p, input) = (&self.p, &self.input);
        let weight_n = p.weight_n() / (1.0 + slope.length_squared()).sqrt();
        let shifted_n = p.mass_kg * self.felt.x * p.centre_height_m / p.wheelbase_m;
        let speed_mps = self.planar.velocity.length();
        let held = input.throttle == 0.0 && speed_mps < HELD_BELOW_MPS && self.drive_train.gear != 0;
        let loads = [-shifted_n, shifted_n];
        // Brakes are shared out as the loads are, as valves and computers do.
        let braking_n = input.brake * (p.axles[0].brake_n + p.axles[1].brake_n);
        [0, 1].map(|index| {
            let axle = &p.axles[index];
            let load_n = (axle.weight * weight_n + loads[index]).clamp(0.0, weight_n);
            let share = load_n / weight_n.max(1e-9);
            let hand_n = if input.hand_brake { axle.hand_brake_n } else { 0.0 };
            let pulling_n = drive.force_n * axle.driven;
            let rolling_n = p.rolling * load_n + if held { HELD * load_n } else { 0.0 };
            AxleForces {
                load_n,
                drive_n: pulling_n * passed_on(pulling_n / axle.wheels, axle.long_stiffness),
                resist_n: braking_n * share + hand_n + rolling_n + drive.drag_n * axle.driven,
                braked: braking_n > 0.0,
                locked: hand_n > axle.friction * load_n,
            }
        })
    }

    /// Moves the centre of mass, and the origin with it.
    fn advance(&mut self, forward: DVec2, dt_s: f64) {
        let along = self.planar.velocity.dot(forward);
        // Locked wheels do not roll; those of an axle that is not are enough.
        self.rolled_m = within(self.rolled_m + along * dt_s, -1e9, 1e9, 0.0);
        let centre = self.centre() + self.planar.velocity * dt_s;
        self.turn_to(self.yaw_rad + self.planar.yaw_rate * dt_s);
        let origin = centre - direction(self.yaw_rad) * self.p.centre_m;
        self.position = vector(origin.extend(self.position.z), 1e6);
    }

    /// Up and down: over the ground as springs let it, and through the air as it falls.
    fn follow(&mut self, footing: Option<Footing>, forward: DVec2, dt_s: f64) {
        let pushed = self.force_n.z / self.p.mass_kg - if self.gravity { GRAVITY_MPS2 } else { 0.0 };
        let climb = self.climb_mps + pushed * dt_s;
        let free_m = self.position.z + climb * dt_s;
        let tilted = self.tilt;
        let rise = footing.map(|footing| {
            (footing, (forward * footing.slope.x + forward.perp() * footing.slope.y).dot(self.planar.velocity))
        });
        match rise {
            Some((footing, rise)) => {
                // Where the origin is now, on the plane that was under it at the beginning of the step.
                let height_m = footing.height_m + rise * dt_s;
                let lifted = climb > rise + 1.0;
                let near = free_m - height_m < if self.grounded { DROOP_M } else { 0.0 };
                self.grounded = near && self.gravity && !lifted;
                if self.grounded {
                    let soon = 1.0 - exp(-dt_s / BUMP_S);
                    let expected_m = self.position.z + rise * dt_s;
                    self.position.z = expected_m + (height_m - expected_m) * soon;
                    self.climb_mps = rise;
                    if !self.keeps_tilt {
                        self.tilt += (tilt(footing) - self.tilt) * soon;
                    }
                } else if free_m < height_m {
                    (self.position.z, self.climb_mps) = (height_m, climb.max(rise));
                } else {
                    (self.position.z, self.climb_mps) = (free_m, climb);
                }
            }
            None => {
                self.grounded = false;
                (self.position.z, self.climb_mps) = (free_m, climb);
            }
        }
        self.climb_mps = within(self.climb_mps, -super::FASTEST_MPS, super::FASTEST_MPS, 0.0);
        self.position = vector(self.position, 1e6);
        self.tilt_rates = (self.tilt - tilted) / dt_s;
        debug_assert!(self.position.is_finite() && DVec3::from((self.tilt, self.climb_mps)).is_finite());
    }
}

/// Pitch (nose up) and roll (left side up) of a plane.
fn tilt(footing: Footing) -> DVec2 {
    DVec2::new(atan(footing.slope.x), atan(footing.slope.y))
}
