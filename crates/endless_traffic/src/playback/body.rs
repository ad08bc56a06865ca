//! What the track of somebody does not tell: wheels, steering, lean, lamps, steps.

use super::ground::GroundIndex;
use super::path::{PathPlace, TrackPath, heading};
use crate::lights;
use crate::trailer::TrailerState;
use endless_road::RoadNetwork;
use endless_world::math::f64::{atan, wrap_angle};
use endless_world::walking::{Footsteps, PedestrianSpec};
use endless_world::{Gait, Motion, ObjectClass, Pose, Side, VehicleLights, VehicleMotion, VehicleSpec, WalkerMotion};

const GRAVITY: f64 = 9.81;
/// Slower than this nothing is known of the steering, m/s.
const CREEPS_MPS: f64 = 0.7;
/// Steering and lean follow the track within this time, seconds.
const FOLLOWS_S: f64 = 0.2;
/// Who turns by more than this soon indicates it, radians.
const TURNS: f64 = 0.6;
/// How far ahead drivers indicate: seconds and metres.
const INDICATES: (f64, f64) = (3.0, 20.0);
/// Backwards faster than this, reversing lights are on, m/s.
const REVERSES_MPS: f64 = -0.3;
/// Kerbs are stepped on with this speed, m/s, and slopes climbed in this part of the speed.
const STEPS_UP: (f64, f64) = (0.6, 0.4);

/// A moment of playing.
#[derive(Clone, Copy)]
pub(super) struct Moment<'a> {
    pub(super) network: &'a RoadNetwork,
    pub(super) ground: &'a GroundIndex,
    /// On the file's clock, seconds.
    pub(super) file_s: f64,
    /// Since frame 0, seconds.
    pub(super) time_s: f64,
    pub(super) step_s: f64,
    /// Share of vehicles that drive with dipped headlights.
    pub(super) headlights_on: f32,
}

/// A vehicle that plays a track.
#[derive(Debug, Clone)]
pub(super) struct VehicleBody {
    pub(super) class: ObjectClass,
    pub(super) half_length: f64,
    front_axle: f64,
    rear_axle: f64,
    variant: u64,
    trailer: Option<TrailerState>,
    steer: f64,
    roll: f64,
    brake_hold_s: f64,
    lit: VehicleLights,
    pub(super) indicating: Option<Side>,
}

/// A person who plays a track.
#[derive(Debug, Clone)]
pub(super) struct PersonBody {
    spec: PedestrianSpec,
    steps: Footsteps,
    gait: Gait,
    walked: f64,
    last: Option<(glam::DVec2, f64)>,
}

impl VehicleBody {
    pub(super) fn new(spec: &VehicleSpec, variant: u64) -> Self {
        Self {
            class: spec.class,
            half_length: 0.5 * f64::from(spec.length_m),
            front_axle: f64::from(spec.front_axle_m),
            rear_axle: f64::from(spec.rear_axle_m.min(spec.front_axle_m - 0.6)),
            variant,
            trailer: TrailerState::of(spec),
            steer: 0.0,
            roll: 0.0,
            brake_hold_s: 0.0,
            lit: VehicleLights::empty(),
            indicating: None,
        }
    }

    /// Moves on to a place, or appears there; `None` off the map. `height_m`: where it was.
    pub(super) fn place(
        &mut self,
        path: &TrackPath,
        place: &PathPlace,
        height_m: Option<f64>,
        appears: bool,
        moment: &Moment<'_>,
    ) -> Option<Pose> {
        let level = place.height_m.or(height_m);
        let ground = |ahead: f64| {
            let at = place.centre + heading(place.yaw) * ahead;
            moment.ground.height_m(moment.network, at, false, level)
        };
        let wheelbase = self.front_axle - self.rear_axle;
        let rise = |front: f64, rear: f64| (front - rear) / wheelbase;
        let (front, rear) = (ground(self.front_axle)?, ground(self.rear_axle)?);
        let height = rear - self.rear_axle * rise(front, rear);
        let follows = if appears { 1.0 } else { (moment.step_s / FOLLOWS_S).min(1.0) };
        if place.speed.abs() > CREEPS_MPS {
            let steer = atan(wheelbase * place.turning / place.speed).clamp(-0.6, 0.6);
            self.steer += (steer - self.steer) * follows;
        }
        if self.class.two_wheeled() {
            let lean = -atan(place.speed * place.turning / GRAVITY).clamp(-0.6, 0.6);
            self.roll += (lean - self.roll) * follows;
        }
        if let Some(trailer) = &mut self.trailer {
            if appears {
                trailer.settle(place.centre, place.yaw);
            } else {
                trailer.follow(place.centre, place.yaw);
            }
        }
        self.light_up(path, place, moment);
        Some(Pose {
            position: place.centre.extend(height).as_vec3(),
            yaw_rad: wrap_angle(place.yaw) as f32,
            pitch_rad: atan(rise(front, rear)) as f32,
            roll_rad: self.roll as f32,
        })
    }

    fn light_up(&mut self, path: &TrackPath, place: &PathPlace, moment: &Moment<'_>) {
        let turn = path.turn_ahead(moment.file_s, INDICATES.0, INDICATES.1);
        self.indicating = (turn.abs() > TURNS).then_some(if turn > 0.0 { Side::Left } else { Side::Right });
        let braking = lights::brakes(place.acceleration * place.speed.signum(), place.speed.abs());
        self.brake_hold_s = lights::brake_hold_s(self.brake_hold_s, braking, moment.step_s);
        let lamps = lights::Lamps {
            class: self.class,
            own: lights::own_share(self.variant),
            braking: self.brake_hold_s > 0.0,
            indicating: self.indicating,
        };
        self.lit = lamps.lit(moment.headlights_on, moment.time_s);
        if place.speed < REVERSES_MPS && self.class != ObjectClass::Bicycle {
            self.lit |= VehicleLights::REVERSE;
        }
    }

    pub(super) fn motion(&self, place: &PathPlace) -> Motion {
        Motion::Vehicle(VehicleMotion {
            speed_mps: place.speed as f32,
            rolled_m: place.rolled as f32,
            steer_rad: self.steer as f32,
            hitch_rad: self.trailer.map_or(0.0, |trailer| wrap_angle(trailer.yaw - place.yaw) as f32),
            lights: self.lit,
        })
    }
}

impl PersonBody {
    pub(super) fn new(spec: PedestrianSpec) -> Self {
        let steps = Footsteps::new(&spec, glam::DVec2::ZERO, 0.0);
        Self { spec, steps, gait: Gait::Stand, walked: 0.0, last: None }
    }

    /// Moves on to a place, or appears there; `None` off the map.
    pub(super) fn place(&mut self, place: &PathPlace, appears: bool, moment: &Moment<'_>) -> Option<Pose> {
        let last = self.last.filter(|_| !appears);
        let level = place.height_m.or(last.map(|(_, height)| height));
        let ground = moment.ground.height_m(moment.network, place.centre, true, level)?;
        let speed = place.velocity.length();
        let height = match last {
            None => {
                self.steps = Footsteps::new(&self.spec, place.centre, place.yaw);
                ground
            }
            Some((at, height)) => {
                self.walked += at.distance(place.centre);
                self.steps.advance(place.centre, place.yaw, place.velocity, moment.step_s);
                // Nobody is on a kerb at once.
                let most = (STEPS_UP.0 + STEPS_UP.1 * speed) * moment.step_s;
                height + (ground - height).clamp(-most, most)
            }
        };
        self.last = Some((place.centre, height));
        self.gait = self.steps.gait(speed, false);
        Some(Pose::level(place.centre.extend(height).as_vec3(), wrap_angle(place.yaw) as f32))
    }

    pub(super) fn motion(&self, place: &PathPlace, time_s: f64) -> Motion {
        Motion::Walker(WalkerMotion {
            speed_mps: place.velocity.length() as f32,
            gait: self.gait,
            walked_m: self.walked as f32,
            time_s: time_s as f32,
            footing: Some(self.steps.footing()),
            ..WalkerMotion::default()
        })
    }
}
