//! The body and its clothes as lofted parts, each with the bones it follows.

use super::clothes;
use super::head;
use super::look::{Bottom, Look, Top};
use super::skeleton::{Bone, Side, Skeleton};
use super::skin::{Blend, Skin};
use crate::Material;
use crate::shape::{Region, Sculpt};
use endless_world::math::{lerp, smoothstep};
use glam::{Vec2, Vec3};

/// Everything in the rest pose.
pub(crate) fn build(look: &Look, skeleton: &Skeleton) -> Skin {
    let mut skin = Skin::default();
    let body = Body::new(look, skeleton);
    body.trunk(&mut skin);
    for side in Side::BOTH {
        body.leg(&mut skin, side);
        body.shoe(&mut skin, side);
        body.arm(&mut skin, side);
        body.hand(&mut skin, side);
    }
    head::add(&mut skin, look, skeleton);
    clothes::carried(&mut skin, &body);
    skin
}

/// Measures shared by the parts.
pub(crate) struct Body<'a> {
    pub(crate) look: &'a Look,
    pub(crate) skeleton: &'a Skeleton,
    /// Stature, and height of the neck's base over the average's share of it.
    pub(crate) h: f32,
    /// Height of the body without the head, scaled so that 0.83 is the base of the neck.
    pub(crate) b: f32,
}

/// A section of the trunk: height over `b`, half breadth and half depth over the stature, how far it lies ahead.
pub(crate) type Section = (f32, f32, f32, f32);

const MALE: &[Section] = &[
    (0.460, 0.060, 0.050, 0.000),
    (0.490, 0.092, 0.066, -0.004),
    (0.530, 0.100, 0.070, -0.006),
    (0.570, 0.095, 0.066, -0.002),
    (0.620, 0.088, 0.063, 0.003),
    (0.670, 0.093, 0.066, 0.004),
    (0.720, 0.102, 0.071, 0.002),
    (0.760, 0.102, 0.069, -0.004),
    (0.787, 0.094, 0.060, -0.008),
    (0.810, 0.074, 0.050, -0.010),
    (0.828, 0.050, 0.041, -0.011),
    (0.842, 0.038, 0.036, -0.010),
];
const FEMALE: &[Section] = &[
    (0.460, 0.062, 0.052, 0.000),
    (0.490, 0.098, 0.070, -0.006),
    (0.530, 0.105, 0.074, -0.008),
    (0.570, 0.094, 0.064, -0.003),
    (0.620, 0.077, 0.055, 0.003),
    (0.670, 0.083, 0.061, 0.007),
    (0.720, 0.091, 0.075, 0.012),
    (0.760, 0.090, 0.066, 0.002),
    (0.787, 0.083, 0.053, -0.007),
    (0.810, 0.066, 0.045, -0.010),
    (0.828, 0.045, 0.037, -0.011),
    (0.842, 0.034, 0.032, -0.010),
];

impl<'a> Body<'a> {
    fn new(look: &'a Look, skeleton: &'a Skeleton) -> Self {
        let b = skeleton.joint(Bone::Neck).z / 0.83;
        Self { look, skeleton, h: look.height, b }
    }

    pub(crate) fn sections(&self) -> &'static [Section] {
        if self.look.female && !self.look.child { FEMALE } else { MALE }
    }

    /// A tube around the trunk between two heights (over `b`), this much (metres) outside the skin.
    pub(crate) fn around(&self, from: f32, to: f32, ease: impl Fn(f32) -> f32, material: Material) -> Sculpt {
        let n = ((to - from) / 0.028).ceil().max(2.0) as usize;
        let path: Vec<(Vec3, Vec2)> = (0..=n)
            .map(|i| {
                let t = lerp(from, to, i as f32 / n as f32);
                let (ry, rx, x) = self.section_at(t);
                (Vec3::new(x, 0.0, t * self.b), Vec2::new(ry, rx) + ease(t))
            })
            .collect();
        Sculpt::sweep(&path, Vec3::Y, 20, 2.35, true, material)
    }

    /// Half breadth, half depth and offset of the trunk at a height.
    fn section_at(&self, t: f32) -> (f32, f32, f32) {
        let s = self.sections();
        let i = s.partition_point(|q| q.0 <= t).clamp(1, s.len() - 1);
        let (a, b) = (s[i - 1], s[i]);
        let k = ((t - a.0) / (b.0 - a.0)).clamp(0.0, 1.0);
        let girth = self.look.girth;
        let shoulder = smoothstep(0.70, 0.78, t);
        let breadth = lerp(girth, 0.35 * girth + 0.65 * self.look.shoulder, shoulder);
        // Weight shows in front, at the belly.
        let belly = (girth - 1.0).max(0.0) * 0.05 * smoothstep(0.48, 0.58, t) * (1.0 - smoothstep(0.62, 0.75, t));
        (
            lerp(a.1, b.1, k) * self.h * breadth,
            (lerp(a.2, b.2, k) * lerp(girth, 1.0, 0.5 * shoulder) + belly) * self.h,
            (lerp(a.3, b.3, k) + 0.7 * belly) * self.h,
        )
    }

    /// Weights of the trunk by height; below the hips cloth follows the thighs a little.
    pub(crate) fn trunk_blend(&self, p: Vec3) -> Blend {
        let t = p.z / self.b;
        if t < 0.535 {
            let down = smoothstep(0.535, 0.40, t);
            let left = smoothstep(-0.035, 0.035, p.y / self.h);
            let follow = 0.88 * down;
            return Blend([
                (Bone::Pelvis, 1.0 - follow),
                (Bone::ThighL, follow * left),
                (Bone::ThighR, follow * (1.0 - left)),
            ]);
        }
        if t < 0.635 {
            return Blend::two(Bone::Pelvis, Bone::Spine, smoothstep(0.545, 0.635, t));
        }
        if t < 0.81 {
            return Blend::two(Bone::Spine, Bone::Chest, smoothstep(0.635, 0.715, t));
        }
        Blend::two(Bone::Chest, Bone::Neck, smoothstep(0.82, 0.85, t))
    }

    fn trunk(&self, skin: &mut Skin) {
        let look = self.look;
        let blend = |p: Vec3| self.trunk_blend(p);
        if !matches!(look.bottom, Bottom::Dress) {
            skin.add(self.around(0.462, 0.615, |_| 0.004 * self.h, look.bottom_color), blend);
        }
        let (hem, ease) = match look.top {
            Top::Sleeveless => (0.545, 0.004),
            Top::TShirt => (0.505, 0.007),
            Top::Shirt => (0.495, 0.007),
            Top::Hoodie => (0.500, 0.012),
            Top::Jacket => (0.490, 0.013),
            Top::Coat => (0.310, 0.015),
        };
        let flare = |t: f32| (ease + 0.05 * smoothstep(0.52, 0.28, t) + 0.004 * smoothstep(0.60, 0.52, t)) * self.h;
        let mut top = self.around(hem, 0.842, flare, look.top_color);
        if look.stripes {
            for i in 0..4 {
                let z = (0.56 + 0.06 * i as f32) * self.b;
                top.paint(&Region::all().beyond(Vec3::Z, z).within(Vec3::Z, z + 0.025 * self.b), look.inner_color);
            }
        }
        let opening = 0.021 * self.h;
        match look.top {
            Top::Jacket | Top::Coat => {
                // Worn open: what is beneath shows in front.
                let front = Region::all().within(Vec3::Y, opening).within(-Vec3::Y, opening).facing(Vec3::X, 0.2);
                top.paint(&front.clone().beyond(Vec3::Z, 0.53 * self.b), look.inner_color);
                top.paint(&front.within(Vec3::Z, 0.53 * self.b), look.bottom_color);
            }
            Top::Sleeveless | Top::TShirt => {
                top.paint(&Region::all().beyond(Vec3::Z, 0.829 * self.b), look.skin);
                let v = Region::all()
                    .within(Vec3::new(0.0, 1.0, -1.2), -0.97 * self.b)
                    .within(Vec3::new(0.0, -1.0, -1.2), -0.97 * self.b);
                top.paint(&v.facing(Vec3::X, 0.1), look.skin);
            }
            Top::Shirt => {
                top.paint(
                    &Region::all().within(Vec3::Y, 0.004).within(-Vec3::Y, 0.004).facing(Vec3::X, 0.2),
                    look.inner_color,
                );
            }
            Top::Hoodie => {}
        }
        skin.add(top, blend);
        if matches!(look.top, Top::Hoodie | Top::Jacket | Top::Coat) {
            let neck = self.skeleton.joint(Bone::Neck);
            let collar =
                if look.top == Top::Hoodie { Vec3::new(0.052, 0.062, 0.034) } else { Vec3::new(0.046, 0.050, 0.020) }
                    * self.h;
            let back = Vec3::new(-0.016 * self.h, 0.0, 0.004 * self.h);
            skin.add(Sculpt::ellipsoid(neck + back, collar, 14, look.top_color), |_| {
                Blend::two(Bone::Chest, Bone::Neck, 0.3)
            });
        }
        match look.bottom {
            Bottom::Skirt => skin.add(
                self.around(0.30, 0.615, |t| (0.007 + 0.06 * smoothstep(0.56, 0.25, t)) * self.h, look.bottom_color),
                blend,
            ),
            Bottom::Dress => skin.add(
                self.around(0.27, 0.60, |t| (0.009 + 0.075 * smoothstep(0.60, 0.25, t)) * self.h, look.bottom_color),
                blend,
            ),
            _ => {}
        }
        if matches!(look.bottom, Bottom::Trousers | Bottom::Shorts) && matches!(look.top, Top::Sleeveless) {
            let belt = Material { base_color: [0.03, 0.025, 0.02], ..look.shoe_color };
            skin.add(self.around(0.588, 0.606, |_| 0.006 * self.h, belt), blend);
        }
    }

    fn leg(&self, skin: &mut Skin, side: Side) {
        let h = self.h;
        let g = 0.45 + 0.55 * self.look.girth;
        let [thigh, shin, foot] = side.leg();
        let (hip, knee, ankle) = (self.skeleton.joint(thigh), self.skeleton.joint(shin), self.skeleton.joint(foot));
        let blend = |p: Vec3| {
            if p.z > 0.5 * (hip.z + knee.z) {
                Blend::two(thigh, Bone::Pelvis, 0.55 * smoothstep(hip.z - 0.045 * h, hip.z + 0.01 * h, p.z))
            } else if p.z > 0.5 * (knee.z + ankle.z) {
                Blend::two(shin, thigh, smoothstep(knee.z - 0.03 * h, knee.z + 0.03 * h, p.z))
            } else {
                Blend::two(shin, foot, smoothstep(ankle.z + 0.012 * h, ankle.z - 0.015 * h, p.z))
            }
        };
        // Height from ankle (0) over knee (1) to hip (2), radius, offset ahead; all over the stature.
        let bare: &[(f32, f32, f32)] = &[
            (-0.06, 0.021, 0.0),
            (0.12, 0.021, 0.0),
            (0.40, 0.029, -0.006),
            (0.66, 0.034, -0.009),
            (0.88, 0.030, -0.002),
            (1.0, 0.032, 0.002),
            (1.12, 0.034, 0.002),
            (1.45, 0.044, 0.002),
            (1.75, 0.051, 0.0),
            (2.0, 0.051, -0.002),
        ];
        let at = |t: f32| if t < 1.0 { ankle.lerp(knee, t) } else { knee.lerp(hip, t - 1.0) };
        let tube = |from: f32, to: f32, ease: &dyn Fn(f32) -> f32, material: Material| {
            let radius = |t: f32| {
                let i = bare.partition_point(|q| q.0 <= t).clamp(1, bare.len() - 1);
                let (a, b) = (bare[i - 1], bare[i]);
                let k = ((t - a.0) / (b.0 - a.0)).clamp(0.0, 1.0);
                (lerp(a.1, b.1, k), lerp(a.2, b.2, k))
            };
            let n = ((to - from) / 0.14).ceil().max(3.0) as usize;
            let path: Vec<(Vec3, Vec2)> = (0..=n)
                .map(|i| {
                    let t = lerp(from, to, i as f32 / n as f32);
                    let (r, x) = radius(t);
                    (at(t) + Vec3::X * x * h, Vec2::new(1.0, 1.06) * (r * g + ease(t)) * h)
                })
                .collect();
            Sculpt::sweep(&path, Vec3::Y, 14, 2.1, true, material)
        };
        let look = self.look;
        match look.bottom {
            Bottom::Trousers => {
                let ease = |t: f32| 0.0045 + 0.011 * smoothstep(0.75, 0.1, t);
                skin.add(tube(-0.02, 2.0, &ease, look.bottom_color), blend);
            }
            Bottom::Shorts => {
                skin.add(tube(-0.06, 1.3, &|_| 0.0, look.skin), blend);
                skin.add(tube(1.06, 2.0, &|t| 0.005 + 0.012 * smoothstep(1.5, 1.05, t), look.bottom_color), blend);
            }
            Bottom::Skirt | Bottom::Dress => skin.add(tube(-0.06, 2.0, &|_| 0.0, look.skin), blend),
        }
    }

    fn shoe(&self, skin: &mut Skin, side: Side) {
        let h = self.h;
        let foot = side.leg()[2];
        let a = self.skeleton.joint(foot);
        let (toe, heel) = (self.skeleton.toe, self.skeleton.heel);
        let row = |x: f32, half: f32, top: f32, low: f32| {
            let (top, low) = (top * h, low * h);
            (
                Vec3::new(a.x + x, a.y + 0.004 * h * side.sign(), 0.5 * (top + low)),
                Vec2::new(half * h, 0.5 * (top - low)),
            )
        };
        let path = [
            row(-heel, 0.012, 0.028, 0.006),
            row(-heel * 0.85, 0.019, 0.040, 0.0),
            row(-heel * 0.2, 0.023, 0.056, 0.0),
            row(toe * 0.25, 0.024, 0.050, 0.0),
            row(toe * 0.55, 0.028, 0.037, 0.0),
            row(toe * 0.82, 0.027, 0.028, 0.0),
            row(toe * 0.96, 0.018, 0.021, 0.004),
            row(toe, 0.008, 0.016, 0.008),
        ];
        let mut shoe = Sculpt::sweep(&path, Vec3::Y, 14, 3.0, true, self.look.shoe_color);
        let sole = if self.look.shoe_color.base_color[0] > 0.3 { [0.5; 3] } else { [0.05, 0.045, 0.04] };
        shoe.paint(&Region::all().within(Vec3::Z, 0.009 * h), Material { base_color: sole, ..self.look.shoe_color });
        skin.add(shoe, |_| Blend::one(foot));
    }

    fn arm(&self, skin: &mut Skin, side: Side) {
        let h = self.h;
        let look = self.look;
        let g = 0.5 + 0.5 * look.girth;
        let [upper, fore, hand] = side.arm();
        let (s, e, w) = (self.skeleton.joint(upper), self.skeleton.joint(fore), self.skeleton.joint(hand));
        let (along, length) = ((w - s).normalize_or(-Vec3::Z), (w - s).length());
        let elbow = (e - s).length();
        let blend = |p: Vec3| {
            let d = (p - s).dot(along);
            if d < 0.5 * elbow {
                Blend::two(upper, Bone::Chest, 0.7 * smoothstep(0.030 * h, -0.035 * h, d))
            } else {
                Blend::two(upper, fore, smoothstep(elbow - 0.025 * h, elbow + 0.025 * h, d))
            }
        };
        let tube = |from: f32, to: f32, ease: f32, cuff: f32, material: Material| {
            let radius = |d: f32| {
                let t = d / length;
                let shoulder = 0.0335 * smoothstep(-0.17, 0.06, t).sqrt();
                let arm = lerp(0.030, 0.0255, smoothstep(0.2, 0.5, t));
                let forearm = lerp(arm, 0.0165, smoothstep(0.58, 1.0, t));
                lerp(shoulder, forearm, smoothstep(0.0, 0.22, t)) * if look.female { 0.9 } else { 1.0 }
            };
            let n = ((to - from) / (0.035 * h)).ceil().max(3.0) as usize;
            let path: Vec<(Vec3, Vec2)> = (0..=n)
                .map(|i| {
                    let d = lerp(from, to, i as f32 / n as f32);
                    let extra = ease + cuff * smoothstep(to - 0.08 * h, to, d);
                    (s + along * d, Vec2::splat((radius(d) * g + extra * smoothstep(-0.16, 0.0, d / length)) * h))
                })
                .collect();
            Sculpt::sweep(&path, Vec3::X, 12, 2.0, true, material)
        };
        let start = -0.022 * h;
        let (sleeve, ease, cuff) = match look.top {
            Top::Sleeveless => (0.0, 0.0, 0.0),
            Top::TShirt => (0.56 * elbow, 0.004, 0.007),
            Top::Shirt if look.stripes => (0.60 * elbow, 0.004, 0.007),
            Top::Shirt => (0.985 * length, 0.004, 0.002),
            Top::Hoodie => (0.99 * length, 0.009, 0.0),
            Top::Jacket => (0.99 * length, 0.009, 0.003),
            Top::Coat => (0.99 * length, 0.010, 0.005),
        };
        if sleeve < 0.9 * length {
            skin.add(tube(start.max(sleeve - 0.05 * h), length, 0.0, 0.0, look.skin), blend);
        }
        if sleeve > 0.0 {
            skin.add(tube(start, sleeve, ease, cuff, look.top_color), blend);
        }
    }

    fn hand(&self, skin: &mut Skin, side: Side) {
        let h = self.h;
        let [_, fore, hand] = side.arm();
        let w = self.skeleton.joint(hand);
        let along = (w - self.skeleton.joint(fore)).normalize_or(-Vec3::Z);
        // Relaxed: palm towards the thigh, fingers a little curled forward.
        let curl = (along + Vec3::X * 0.35).normalize_or(along);
        let p = |d: f32| w + along * (d.min(0.045) * h) + curl * ((d - 0.045).max(0.0) * h);
        let row = |d: f32, broad: f32, thick: f32| (p(d), Vec2::new(broad, thick) * h);
        let palm = [
            row(-0.008, 0.0145, 0.0125),
            row(0.012, 0.019, 0.0115),
            row(0.040, 0.024, 0.011),
            row(0.060, 0.022, 0.010),
            row(0.085, 0.017, 0.008),
            row(0.098, 0.008, 0.005),
        ];
        skin.add(Sculpt::sweep(&palm, Vec3::X, 10, 2.3, true, self.look.skin), |_| Blend::one(hand));
        let root = p(0.015) + Vec3::X * 0.014 * h;
        let thumb = [
            (root, 0.009 * h),
            (root + Vec3::new(0.016, 0.0, -0.018) * h, 0.009 * h),
            (root + Vec3::new(0.020, 0.0, -0.040) * h, 0.006 * h),
        ];
        skin.add(Sculpt::tube(&thumb, 7, self.look.skin), |_| Blend::one(hand));
    }
}
