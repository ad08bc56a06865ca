//! Steps over the ground: feet stay where they stand until they are lifted, however the body starts, stops and turns.

use super::look::{Carried, Look};
use super::skeleton::Side;
use super::step::{self, Step};
use endless_world::math::f64::{sin_cos, wrap_angle};
use endless_world::{FootPlace, Footing, Gait};
use glam::DVec2;

/// Both feet of one person, in the world; advanced along with the body.
#[derive(Debug, Clone, PartialEq)]
pub struct Footsteps {
    height: f64,
    walk_mps: f64,
    carried: Carried,
    phase: f64,
    speed: f64,
    feet: [Foot; 2],
    position: DVec2,
    yaw: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Foot {
    at: DVec2,
    yaw: f64,
    /// Where it left the ground, while it swings.
    from: Option<(DVec2, f64)>,
}

/// Slower than this (m/s) people come to a stand.
const STANDING: f64 = 0.15;
/// Steps that only put the feet right: cycles a second.
const SHUFFLE: f64 = 0.85;

fn turned(v: DVec2, angle: f64) -> DVec2 {
    let (sin, cos) = sin_cos(angle);
    DVec2::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos)
}

impl Footsteps {
    /// Of the person of a variant, standing at a place (world frame, metres) and heading there (radians).
    pub fn new(variant: u64, position: DVec2, yaw: f64) -> Self {
        let look = Look::of(variant, false);
        let habit = super::gait::Habit::new(variant, &look);
        let mut steps = Self {
            height: f64::from(look.height),
            walk_mps: f64::from(habit.walk_mps),
            carried: look.carried,
            phase: f64::from(habit.offset),
            speed: 0.0,
            feet: [Foot { at: position, yaw, from: None }; 2],
            position,
            yaw,
        };
        for side in Side::BOTH {
            let (at, heading) = steps.home(side, 0.0);
            steps.feet[side.index()] = Foot { at, yaw: heading, from: None };
        }
        steps
    }

    /// Comfortable walking speed, m/s.
    pub fn walk_mps(&self) -> f64 {
        self.walk_mps
    }

    /// Whether they can run: not with a pram, and not in a wheelchair.
    pub fn can_run(&self) -> bool {
        !matches!(self.carried, Carried::Pram | Carried::Wheelchair | Carried::Cane | Carried::Suitcase)
    }

    /// What they do at a speed (m/s); `waits`: for leave to go on.
    pub fn gait(&self, speed_mps: f64, waits: bool) -> Gait {
        match self.carried {
            Carried::Wheelchair => Gait::Sit,
            _ if speed_mps < 0.08 => {
                if waits {
                    Gait::Wait
                } else {
                    Gait::Idle
                }
            }
            _ if speed_mps >= 2.1 => Gait::Run,
            Carried::Pram => Gait::Push,
            _ if speed_mps > 1.28 * self.walk_mps => Gait::Hurry,
            _ => Gait::Walk,
        }
    }

    /// Where a foot belongs under the body, and its heading.
    fn home(&self, side: Side, speed: f64) -> (DVec2, f64) {
        let (at, yaw) = step::home(self.height as f32, side, step::alike(self.height as f32, speed as f32));
        (self.position + turned(at.as_dvec2(), self.yaw), self.yaw + f64::from(yaw))
    }

    /// Moves on by a step of time to where the body is now.
    pub fn advance(&mut self, position: DVec2, yaw: f64, velocity: DVec2, step_s: f64) {
        let turning = wrap_angle(yaw - self.yaw) / step_s.max(1e-6);
        (self.position, self.yaw) = (position, yaw);
        let wanted = velocity.length();
        // Bodies do not change their gait in an instant.
        self.speed += (wanted - self.speed).clamp(-3.0 * step_s, 3.0 * step_s);
        let speed = self.speed;
        let alike = step::alike(self.height as f32, speed as f32);
        let duty = f64::from(step::duty(alike));
        let stride = f64::from(step::stride(self.height as f32, speed as f32));
        let in_air = self.feet.iter().any(|f| f.from.is_some());
        let rate = if speed > STANDING {
            (speed / stride).max(0.45)
        } else if in_air || self.misplaced() {
            SHUFFLE
        } else {
            0.0
        };
        // Who slows down from a run has a foot far behind: it is lifted soon.
        let stretched = Side::BOTH.into_iter().any(|side| {
            let foot = &self.feet[side.index()];
            foot.from.is_none() && foot.at.distance(self.home(side, speed).0) > 0.36 * self.height
        });
        let rate = if stretched { 1.6 * rate } else { rate };
        self.phase += rate * step_s;
        self.phase -= self.phase.floor();
        for side in Side::BOTH {
            let phase = self.phase + 0.5 * f64::from(side.index() as u32);
            let step = Step::of((phase - phase.floor()) as f32, duty as f32);
            let (home, heading) = self.home(side, speed);
            let foot = &mut self.feet[side.index()];
            match step {
                Step::Stance(_) => foot.from = None,
                Step::Swing(u) => {
                    let (from, from_yaw) = *foot.from.get_or_insert((foot.at, foot.yaw));
                    let left = (1.0 - f64::from(u)) * (1.0 - duty) / rate.max(0.3);
                    let ahead = if speed > STANDING {
                        velocity * left + velocity.normalize_or_zero() * (0.5 * duty * stride).min(wanted * 0.5)
                    } else {
                        DVec2::ZERO
                    };
                    let done = f64::from(Step::forward(u));
                    let target_yaw = heading + (turning * left).clamp(-0.8, 0.8);
                    foot.at = from.lerp(home + ahead, done);
                    foot.yaw = from_yaw + wrap_angle(target_yaw - from_yaw) * done;
                }
            }
        }
    }

    /// Whether somebody who stands had better put a foot elsewhere.
    fn misplaced(&self) -> bool {
        Side::BOTH.into_iter().any(|side| {
            let (home, heading) = self.home(side, 0.0);
            let foot = &self.feet[side.index()];
            foot.at.distance(home) > 0.055 * self.height || wrap_angle(foot.yaw - heading).abs() > 0.5
        })
    }

    /// The feet in the person's object frame.
    pub fn footing(&self) -> Footing {
        let speed = step::alike(self.height as f32, self.speed as f32);
        let vigour = (self.speed / self.walk_mps).clamp(0.0, 1.1) as f32;
        let duty = step::duty(speed);
        let feet = Side::BOTH.map(|side| {
            let phase = self.phase as f32 + 0.5 * side.index() as f32;
            let (lift, pitch, toes) = Step::of(phase - phase.floor(), duty).roll(speed, vigour);
            let foot = &self.feet[side.index()];
            let at = turned(foot.at - self.position, -self.yaw).as_vec2();
            FootPlace {
                at: at.to_array(),
                yaw_rad: wrap_angle(foot.yaw - self.yaw) as f32,
                lift_m: lift * self.height as f32,
                pitch_rad: pitch,
                toes_rad: toes,
            }
        });
        Footing { phase: self.phase as f32, feet }
    }
}
