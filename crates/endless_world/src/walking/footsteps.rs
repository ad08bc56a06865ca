//! Steps over the ground: feet stay where they stand until they are lifted, however the body starts, stops and turns.

use super::{Mobility, PedestrianSpec, SIDES, StepPhase, average_speed_mps, duty_factor, foot_home, stride_m};
use crate::math::f64::{sin_cos, wrap_angle};
use crate::{FootPlace, Footing, Gait};
use glam::DVec2;

/// Both feet of one person, in the world; advanced along with the body.
#[derive(Debug, Clone, PartialEq)]
pub struct Footsteps {
    height: f64,
    walk_mps: f64,
    mobility: Mobility,
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
    /// Footsteps of a person who stands at a position (world frame, metres) with a heading (radians).
    pub fn new(person: &PedestrianSpec, position: DVec2, yaw: f64) -> Self {
        let mut steps = Self {
            height: f64::from(person.height_m),
            walk_mps: f64::from(person.walk_mps),
            mobility: person.mobility,
            phase: f64::from(person.step_phase),
            speed: 0.0,
            feet: [Foot { at: position, yaw, from: None }; 2],
            position,
            yaw,
        };
        for side in 0..2 {
            let (at, heading) = steps.home(side, 0.0);
            steps.feet[side] = Foot { at, yaw: heading, from: None };
        }
        steps
    }

    /// Whether they can run.
    pub fn can_run(&self) -> bool {
        self.mobility == Mobility::Agile
    }

    /// Their gait at a speed (m/s); `waits`: to cross a road.
    pub fn gait(&self, speed_mps: f64, waits: bool) -> Gait {
        match self.mobility {
            Mobility::Wheelchair => Gait::Sit,
            _ if speed_mps < 0.08 => {
                if waits {
                    Gait::Wait
                } else {
                    Gait::Idle
                }
            }
            _ if speed_mps >= 2.1 => Gait::Run,
            Mobility::Pram => Gait::Push,
            _ if speed_mps > 1.28 * self.walk_mps => Gait::Hurry,
            _ => Gait::Walk,
        }
    }

    /// Where a foot (0 left, 1 right) belongs under the body, and its heading.
    fn home(&self, side: usize, speed: f64) -> (DVec2, f64) {
        let alike = average_speed_mps(self.height as f32, speed as f32);
        let (at, yaw) = foot_home(self.height as f32, SIDES[side], alike);
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
        let alike = average_speed_mps(self.height as f32, speed as f32);
        let duty = f64::from(duty_factor(alike));
        let stride = f64::from(stride_m(self.height as f32, speed as f32));
        let in_air = self.feet.iter().any(|f| f.from.is_some());
        let rate = if speed > STANDING {
            (speed / stride).max(0.45)
        } else if in_air || self.misplaced() {
            SHUFFLE
        } else {
            0.0
        };
        // Who slows down from a run has a foot far behind: it is lifted soon.
        let stretched = (0..2).any(|side| {
            let foot = &self.feet[side];
            foot.from.is_none() && foot.at.distance(self.home(side, speed).0) > 0.36 * self.height
        });
        let rate = if stretched { 1.6 * rate } else { rate };
        self.phase += rate * step_s;
        self.phase -= self.phase.floor();
        for side in 0..2 {
            let phase = self.phase + 0.5 * side as f64;
            let step = StepPhase::of((phase - phase.floor()) as f32, duty as f32);
            let (home, heading) = self.home(side, speed);
            let foot = &mut self.feet[side];
            match step {
                StepPhase::Stance(_) => foot.from = None,
                StepPhase::Swing(u) => {
                    let (from, from_yaw) = *foot.from.get_or_insert((foot.at, foot.yaw));
                    let left = (1.0 - f64::from(u)) * (1.0 - duty) / rate.max(0.3);
                    let ahead = if speed > STANDING {
                        velocity * left + velocity.normalize_or_zero() * (0.5 * duty * stride).min(wanted * 0.5)
                    } else {
                        DVec2::ZERO
                    };
                    let done = f64::from(StepPhase::forward(u));
                    let target_yaw = heading + (turning * left).clamp(-0.8, 0.8);
                    foot.at = from.lerp(home + ahead, done);
                    foot.yaw = from_yaw + wrap_angle(target_yaw - from_yaw) * done;
                }
            }
        }
    }

    /// Whether a standing person should reposition a foot.
    fn misplaced(&self) -> bool {
        (0..2).any(|side| {
            let (home, heading) = self.home(side, 0.0);
            let foot = &self.feet[side];
            foot.at.distance(home) > 0.055 * self.height || wrap_angle(foot.yaw - heading).abs() > 0.5
        })
    }

    /// The feet in the person's object frame.
    pub fn footing(&self) -> Footing {
        let speed = average_speed_mps(self.height as f32, self.speed as f32);
        let vigour = (self.speed / self.walk_mps).clamp(0.0, 1.1) as f32;
        let duty = duty_factor(speed);
        let feet = [0, 1].map(|side: usize| {
            let phase = self.phase as f32 + 0.5 * side as f32;
            let (lift, pitch, toes) = StepPhase::of(phase - phase.floor(), duty).roll(speed, vigour);
            let foot = &self.feet[side];
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
