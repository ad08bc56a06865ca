//! The naked measures: sections of trunk, arms and legs, and which bones they follow.

use super::appearance::Appearance;
use super::skeleton::{ARM, BONES, Bone, Side, Skeleton};
use super::skin::{Weights, one, two};
use crate::shape::MonotoneCubic;
use endless_world::math::{self, lerp, smoothstep};
use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};

/// Points of a section of the trunk, and of a limb.
pub(crate) const TRUNK: usize = 16;
pub(crate) const LIMB: usize = 12;

/// Subdivision draws rings in; these make up for it.
const TRUNK_GROWTH: f32 = 1.03;
const LIMB_GROWTH: f32 = 1.05;

/// Heights over the body's: the crotch, the armpit, the middle and top of the shoulder's opening, the neck's base.
pub(crate) const CROTCH: f32 = 0.478;
pub(crate) const ARMPIT: f32 = 0.740;
const SHOULDER: f32 = 0.776;

/// Measures shared by the parts.
pub(crate) struct Body<'a> {
    pub(crate) appearance: &'a Appearance,
    pub(crate) skeleton: &'a Skeleton,
    /// Stature.
    pub(crate) h: f32,
    /// Height of the body without the head, so scaled that 0.83 is the base of the neck.
    pub(crate) b: f32,
    /// Half breadth, depth in front and behind, over the stature, by height over the body's.
    breadth: MonotoneCubic,
    front: MonotoneCubic,
    back: MonotoneCubic,
    arm: MonotoneCubic,
    leg: MonotoneCubic,
    calf: MonotoneCubic,
}

/// Height, half breadth, depth in front, depth behind.
type Section = (f32, f32, f32, f32);

const MALE: &[Section] = &[
    (0.460, 0.092, 0.062, 0.064),
    (0.500, 0.0965, 0.062, 0.074),
    (0.540, 0.0950, 0.061, 0.071),
    (0.580, 0.0890, 0.060, 0.058),
    (0.620, 0.0845, 0.060, 0.051),
    (0.660, 0.0865, 0.062, 0.055),
    (0.700, 0.0910, 0.064, 0.062),
    (0.740, 0.0930, 0.064, 0.067),
    (0.776, 0.0900, 0.055, 0.066),
];
const FEMALE: &[Section] = &[
    (0.460, 0.096, 0.060, 0.066),
    (0.500, 0.1020, 0.060, 0.078),
    (0.540, 0.0980, 0.059, 0.073),
    (0.580, 0.0860, 0.056, 0.055),
    (0.620, 0.0750, 0.053, 0.045),
    (0.660, 0.0765, 0.054, 0.048),
    (0.700, 0.0815, 0.057, 0.055),
    (0.740, 0.0825, 0.057, 0.060),
    (0.776, 0.0795, 0.048, 0.060),
];
const CHILD: &[Section] = &[
    (0.460, 0.083, 0.060, 0.062),
    (0.500, 0.0880, 0.062, 0.068),
    (0.540, 0.0870, 0.064, 0.064),
    (0.580, 0.0840, 0.066, 0.055),
    (0.620, 0.0830, 0.067, 0.050),
    (0.660, 0.0840, 0.065, 0.053),
    (0.700, 0.0860, 0.063, 0.058),
    (0.740, 0.0870, 0.060, 0.061),
    (0.776, 0.0820, 0.052, 0.060),
];

impl<'a> Body<'a> {
    pub(crate) fn new(appearance: &'a Appearance, skeleton: &'a Skeleton) -> Self {
        let sections = if appearance.age < 12.0 {
            CHILD
        } else if appearance.female {
            FEMALE
        } else {
            MALE
        };
        let g = appearance.girth;
        let curve = |value: &dyn Fn(&Section) -> f32| {
            MonotoneCubic::new(&sections.iter().map(|s| (s.0, value(s))).collect::<Vec<_>>())
        };
        // Weight shows at the belly and the hips, less at the chest.
        let belly = |t: f32| (g - 1.0).max(0.0) * smoothstep(0.48, 0.60, t) * (1.0 - smoothstep(0.64, 0.76, t));
        let broad = |t: f32| lerp(g, 0.45 * g + 0.55 * appearance.shoulder, smoothstep(0.66, 0.78, t));
        let limbs = 0.45 + 0.55 * g;
        let slim = if appearance.female { 0.88 } else { 1.0 } * limbs;
        let arm = [
            (0.0, 0.0360),
            (0.10, 0.0365),
            (0.22, 0.0330),
            (0.36, 0.0285),
            (0.52, 0.0255),
            (0.62, 0.0270),
            (0.78, 0.0225),
            (0.92, 0.0170),
            (1.0, 0.0160),
        ];
        let leg = [
            (-0.1, 0.0205),
            (0.10, 0.0205),
            (0.35, 0.0270),
            (0.62, 0.0335),
            (0.86, 0.0300),
            (1.0, 0.0315),
            (1.15, 0.0350),
            (1.45, 0.0440),
            (1.75, 0.0510),
            (2.0, 0.0530),
        ];
        let scaled = |points: &[(f32, f32)], k: f32| {
            MonotoneCubic::new(&points.iter().map(|p| (p.0, p.1 * k)).collect::<Vec<_>>())
        };
        Self {
            appearance,
            skeleton,
            h: appearance.height,
            b: skeleton.body,
            breadth: curve(&|s| s.1 * broad(s.0) + 0.012 * belly(s.0)),
            front: curve(&|s| s.2 * lerp(g, 1.0, 0.6 * smoothstep(0.66, 0.78, s.0)) + 0.085 * belly(s.0)),
            back: curve(&|s| s.3 * lerp(g, 1.0, 0.6 * smoothstep(0.66, 0.78, s.0))),
            arm: scaled(&arm, slim),
            leg: scaled(&leg, limbs * if appearance.female { 1.03 } else { 1.0 }),
            calf: MonotoneCubic::new(&[
                (0.0, 0.0),
                (0.35, -0.005),
                (0.65, -0.010),
                (0.9, -0.002),
                (1.0, 0.0),
                (2.0, 0.0),
            ]),
        }
    }

    /// A section of the trunk at a height up to the shoulder, this much (over the stature) outside the skin. Points
    /// go from the front over the left.
    pub(crate) fn trunk_ring(&self, t: f32, ease: f32) -> [Vec3; TRUNK] {
        let s = t.clamp(0.50, SHOULDER);
        let low = smoothstep(0.50, 0.46, t);
        let (ry, front, back) = (self.breadth.at(s), self.front.at(s), self.back.at(s));
        let (front, back) = (lerp(front, front - 0.004, low), lerp(back, back - 0.012, low));
        std::array::from_fn(|k| {
            let (sin, cos) = math::sin_cos(TAU * k as f32 / TRUNK as f32);
            let depth = if cos >= 0.0 { front } else { back } + ease;
            let bend = |c: f32| c.signum() * math::pow(c.abs(), 0.86);
            let x = bend(cos) * depth * TRUNK_GROWTH - 0.004;
            let y = bend(sin) * (ry + ease) * TRUNK_GROWTH;
            Vec3::new(x * self.h, y * self.h, t * self.b)
        })
    }

    /// The line over the top of the shoulders; chest, trapezius and back lie beneath it.
    fn yoke(&self, ease: f32) -> [Vec3; TRUNK] {
        let ry = self.breadth.at(SHOULDER) * 0.92;
        std::array::from_fn(|k| {
            let (sin, cos) = math::sin_cos(TAU * k as f32 / TRUNK as f32);
            let depth = if cos >= 0.0 { 0.040 } else { 0.056 } + ease;
            let z = 0.803 + 0.016 * sin * sin + if cos < 0.0 { 0.006 } else { 0.0 };
            Vec3::new((cos * depth - 0.008) * self.h, sin * (ry + 0.6 * ease) * self.h, z * self.b + ease * self.h)
        })
    }

    /// The base of the neck, or a section further up it (1 = below the jaw).
    pub(crate) fn neck_ring(&self, up: f32, ease: f32) -> [Vec3; TRUNK] {
        let stout = (0.5 + 0.5 * self.appearance.girth) * if self.appearance.female { 0.86 } else { 1.0 };
        let (ry, rx) =
            (lerp(0.047, 0.0335, up.min(1.0)) * stout + ease, lerp(0.043, 0.034, up.min(1.0)) * stout + ease);
        let scale = 0.5 + 0.5 * self.skeleton.head_height / (0.131 * self.h);
        std::array::from_fn(|k| {
            let (sin, cos) = math::sin_cos(TAU * k as f32 / TRUNK as f32);
            let z = lerp(0.836 - 0.013 * cos, 0.872, up) * self.b;
            Vec3::new((cos * rx * scale - lerp(0.012, 0.007, up)) * self.h, sin * ry * scale * self.h, z)
        })
    }

    /// The trunk from armpits to neck as four rows: armpit, shoulder, yoke, neck. `dip` lowers the front of the
    /// neckline, 0 to 0.9; `neck` widens it (over the stature).
    pub(crate) fn bust_rows(&self, dip: f32, neck: f32, ease: &dyn Fn(f32) -> f32) -> [[Vec3; TRUNK]; 4] {
        let rows = [
            self.trunk_ring(ARMPIT, ease(ARMPIT)),
            self.trunk_ring(SHOULDER, ease(SHOULDER)),
            self.yoke(ease(0.81)),
            self.neck_ring(0.0, neck + 0.7 * ease(0.84)),
        ];
        let mut out = rows;
        for k in 0..TRUNK {
            let cos = math::cos(TAU * k as f32 / TRUNK as f32).max(0.0);
            let keep = 1.0 - dip * cos * cos * cos;
            for (row, s) in [(2usize, keep), (3, 2.0 * keep)] {
                let path = [rows[1][k], rows[2][k], rows[3][k]];
                out[row][k] = if s <= 1.0 { path[0].lerp(path[1], s) } else { path[1].lerp(path[2], s - 1.0) };
            }
        }
        out
    }

    /// A section of an arm, by distance from the shoulder over the arm's length. Points go from above over the front.
    pub(crate) fn arm_ring(&self, side: Side, along: f32, ease: f32) -> [Vec3; LIMB] {
        let [upper, _, hand] = side.arm();
        let (s, w) = (self.skeleton.joint(upper), self.skeleton.joint(hand));
        let centre = s + (w - s) * along;
        let r = (self.arm.at(along) + ease) * LIMB_GROWTH * self.h;
        let up = Vec3::new(0.0, -ARM.z, ARM.y);
        // Wrists are flatter than broad.
        let flat = 1.0 - 0.2 * smoothstep(0.8, 1.0, along);
        std::array::from_fn(|j| {
            let (sin, cos) = math::sin_cos(TAU * j as f32 / LIMB as f32);
            centre + side.flip(up * (r * cos * flat) + Vec3::X * (r * sin))
        })
    }

    /// The arm's length, metres.
    pub(crate) fn arm_length(&self) -> f32 {
        let [upper, _, hand] = Side::Left.arm();
        (self.skeleton.joint(hand) - self.skeleton.joint(upper)).length()
    }

    /// Where on the arm (0 to 1) the elbow is.
    pub(crate) fn elbow(&self) -> f32 {
        let [upper, fore, _] = Side::Left.arm();
        (self.skeleton.joint(fore) - self.skeleton.joint(upper)).length() / self.arm_length()
    }

    /// A section of a leg at ankle (0), knee (1) or hip (2). Points go from the inner front over the outer side.
    pub(crate) fn leg_ring(&self, side: Side, t: f32, ease: Vec2) -> [Vec3; LIMB] {
        let [thigh, shin, foot, _] = side.leg();
        let (hip, knee, ankle) = (self.skeleton.joint(thigh), self.skeleton.joint(shin), self.skeleton.joint(foot));
        let mut centre = if t < 1.0 { ankle.lerp(knee, t) } else { knee.lerp(hip, t - 1.0) };
        centre.x += self.calf.at(t) * self.h;
        let r = self.leg.at(t);
        std::array::from_fn(|j| {
            let (sin, cos) = math::sin_cos(TAU * j as f32 / LIMB as f32 - PI / 6.0);
            let p = Vec3::new((r + ease.x) * 1.04 * cos, (r + ease.y) * sin, 0.0) * (LIMB_GROWTH * self.h);
            let y = (centre.y * side.sign() + p.y).max(0.002 * self.h);
            Vec3::new(centre.x + p.x, y * side.sign(), centre.z)
        })
    }

    /// Bones of the trunk at a place; below the hips cloth around both legs follows them.
    pub(crate) fn trunk_weights(&self, p: Vec3) -> Weights {
        let t = p.z / self.b;
        if t < 0.545 {
            let down = smoothstep(0.545, 0.40, t);
            let left = smoothstep(-0.045, 0.045, p.y / self.h);
            let shin = 0.75 * smoothstep(0.33, 0.18, t);
            let follow = 0.97 * down;
            let mut w = [0.0; BONES];
            w[Bone::Pelvis as usize] = 1.0 - follow;
            w[Bone::ThighL as usize] = follow * left * (1.0 - shin);
            w[Bone::ThighR as usize] = follow * (1.0 - left) * (1.0 - shin);
            w[Bone::ShinL as usize] = follow * left * shin;
            w[Bone::ShinR as usize] = follow * (1.0 - left) * shin;
            return w;
        }
        if t < 0.64 {
            return two(Bone::Pelvis, Bone::Spine, smoothstep(0.545, 0.64, t));
        }
        if t < 0.80 {
            return two(Bone::Spine, Bone::Chest, smoothstep(0.64, 0.72, t));
        }
        two(Bone::Chest, Bone::Neck, smoothstep(0.815, 0.85, t))
    }

    /// Bones of the trunk above the armpits: its sides follow the arms a little.
    pub(crate) fn bust_weights(&self, p: Vec3) -> Weights {
        let mut w = self.trunk_weights(p);
        let side = if p.y > 0.0 { Bone::UpperArmL } else { Bone::UpperArmR };
        let share = 0.42 * smoothstep(0.055, 0.092, p.y.abs() / self.h);
        w.iter_mut().for_each(|x| *x *= 1.0 - share);
        w[side as usize] += share;
        w
    }

    /// Bones of an arm at a place along it.
    pub(crate) fn arm_weights(&self, side: Side, along: f32) -> Weights {
        let [upper, fore, hand] = side.arm();
        let elbow = self.elbow();
        if along < 0.5 * elbow {
            two(upper, Bone::Chest, 0.38 * smoothstep(0.22, -0.02, along))
        } else if along < 0.93 {
            two(upper, fore, smoothstep(elbow - 0.09, elbow + 0.09, along))
        } else {
            two(fore, hand, 0.4 * smoothstep(0.95, 1.02, along))
        }
    }

    /// Bones of a leg at a height.
    pub(crate) fn leg_weights(&self, side: Side, p: Vec3) -> Weights {
        let [thigh, shin, foot, _] = side.leg();
        let (hip, knee, ankle) =
            (self.skeleton.joint(thigh).z, self.skeleton.joint(shin).z, self.skeleton.joint(foot).z);
        let h = self.h;
        if p.z > 0.5 * (hip + knee) {
            two(thigh, Bone::Pelvis, 0.55 * smoothstep(hip - 0.075 * h, hip + 0.01 * h, p.z))
        } else if p.z > 0.5 * (knee + ankle) {
            two(shin, thigh, smoothstep(knee - 0.035 * h, knee + 0.035 * h, p.z))
        } else if p.z > ankle + 0.03 * h {
            one(shin)
        } else {
            two(shin, foot, 0.6 * smoothstep(ankle + 0.03 * h, ankle - 0.02 * h, p.z))
        }
    }

    /// Breasts and buttocks, as heights over the plain sections.
    pub(crate) fn curves(&self, p: Vec3) -> f32 {
        if self.appearance.age < 13.0 {
            return 0.0;
        }
        let h = self.h;
        let p = Vec3::new(p.x, p.y.abs(), p.z);
        let at = |x: f32, y: f32, t: f32| Vec3::new(x * h, y * h, t * self.b);
        let bell = |c: Vec3, r: f32| {
            let d = (p - c) / (r * h);
            math::exp(-d.length_squared())
        };
        let mut out = 0.012 * h * self.appearance.girth * bell(at(-0.075, 0.045, 0.505), 0.035);
        if self.appearance.female {
            out += 0.023 * h * self.appearance.girth * bell(at(0.062, 0.040, 0.713), 0.030);
        } else {
            out += 0.005 * h * bell(at(0.062, 0.042, 0.735), 0.035);
        }
        out
    }
}
