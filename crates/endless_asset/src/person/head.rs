//! Neck, head, hair and headgear.

use super::look::{Hair, Look};
use super::skeleton::{Bone, Skeleton};
use super::skin::{Blend, Skin};
use crate::shape::{Region, Sculpt};
use crate::{Material, Surface};
use endless_world::math::smoothstep;
use glam::{Vec2, Vec3};

/// Everything above the collar.
pub(crate) fn add(skin: &mut Skin, look: &Look, skeleton: &Skeleton) {
    let chin = Vec3::new(0.008 * look.height, 0.0, skeleton.height - skeleton.head_height);
    let head = Head { look, chin, size: skeleton.head_height };
    head.neck(skin, skeleton);
    head.face(skin);
    match look.hair {
        Hair::Bald => {}
        Hair::Short => head.short(skin, 1.0),
        Hair::Long => head.long(skin, skeleton),
        Hair::Bun => {
            head.short(skin, 1.0);
            head.ball(skin, Vec3::new(-0.46, 0.0, 0.86), Vec3::new(0.14, 0.15, 0.14), look.hair_color);
        }
        Hair::Cap => head.cap(skin),
        Hair::FullHelmet => head.full_helmet(skin),
        Hair::CycleHelmet => head.cycle_helmet(skin),
    }
}

struct Head<'a> {
    look: &'a Look,
    chin: Vec3,
    /// Chin to crown, metres.
    size: f32,
}

impl Head<'_> {
    /// A place in units of the head's height above the chin.
    fn at(&self, p: Vec3) -> Vec3 {
        self.chin + p * self.size
    }

    fn ball(&self, skin: &mut Skin, centre: Vec3, radii: Vec3, material: Material) {
        skin.add(Sculpt::ellipsoid(self.at(centre), radii * self.size, 12, material), |_| Blend::one(Bone::Head));
    }

    fn neck(&self, skin: &mut Skin, skeleton: &Skeleton) {
        let base = skeleton.joint(Bone::Neck) - Vec3::Z * 0.10 * self.size;
        let top = self.at(Vec3::new(-0.12, 0.0, 0.22));
        let r = if self.look.female { 0.215 } else { 0.25 } * self.size;
        let path = [(base, 1.2 * r), (base.lerp(top, 0.45), r), (top, 0.95 * r)];
        let z = (base.z, top.z);
        skin.add(Sculpt::tube(&path, 12, self.look.skin), |p| {
            Blend::two(Bone::Neck, Bone::Head, smoothstep(z.0 + 0.3 * (z.1 - z.0), z.1, p.z))
        });
    }

    /// The skull and jaw as a loft: height, offset ahead, half breadth, half depth.
    fn skull(&self, grow: f32, material: Material) -> Sculpt {
        let rows: &[(f32, f32, f32, f32)] = &[
            (0.000, 0.16, 0.08, 0.07),
            (0.025, 0.135, 0.145, 0.15),
            (0.10, 0.085, 0.225, 0.255),
            (0.20, 0.035, 0.270, 0.335),
            (0.32, 0.005, 0.300, 0.395),
            (0.46, -0.02, 0.325, 0.425),
            (0.60, -0.04, 0.340, 0.435),
            (0.74, -0.05, 0.335, 0.420),
            (0.86, -0.05, 0.285, 0.355),
            (0.94, -0.045, 0.205, 0.255),
            (0.985, -0.04, 0.105, 0.135),
            (1.0, -0.04, 0.020, 0.025),
        ];
        let path: Vec<(Vec3, Vec2)> = rows
            .iter()
            .map(|&(z, x, ry, rx)| {
                let z = 0.5 + (z - 0.5) * (1.0 + grow);
                (self.at(Vec3::new(x, 0.0, z)), Vec2::new(ry + 0.5 * grow, rx + 0.5 * grow) * self.size)
            })
            .collect();
        Sculpt::sweep(&path, Vec3::Y, 18, 2.0, true, material).smooth(80.0)
    }

    fn face(&self, skin: &mut Skin) {
        skin.add(self.skull(0.0, self.look.skin), |_| Blend::one(Bone::Head));
        let nose = [
            (self.at(Vec3::new(0.365, 0.0, 0.52)), 0.025 * self.size),
            (self.at(Vec3::new(0.425, 0.0, 0.37)), 0.05 * self.size),
            (self.at(Vec3::new(0.36, 0.0, 0.33)), 0.035 * self.size),
        ];
        skin.add(Sculpt::tube(&nose, 7, self.look.skin), |_| Blend::one(Bone::Head));
        let dark = Material { base_color: [0.02, 0.015, 0.012], ..self.look.hair_color };
        let [r, g, b] = self.look.skin.base_color;
        let lips = Material { base_color: [r * 0.72, g * 0.45, b * 0.45], ..self.look.skin };
        self.ball(skin, Vec3::new(0.355, 0.0, 0.225), Vec3::new(0.025, 0.085, 0.022), lips);
        for y in [-0.14, 0.14] {
            self.ball(skin, Vec3::new(0.335, y, 0.505), Vec3::new(0.03, 0.05, 0.022), dark);
            self.ball(skin, Vec3::new(0.350, y, 0.575), Vec3::new(0.025, 0.075, 0.014), self.look.hair_color);
            self.ball(skin, Vec3::new(-0.03, 2.35 * y, 0.44), Vec3::new(0.065, 0.035, 0.10), self.look.skin);
        }
    }

    /// Hair follows the skull above a line from the forehead over the ears to the nape.
    fn scalp(&self, grow: f32, material: Material) -> Sculpt {
        let mut hair = self.skull(grow, material);
        let plane = |x: f32, z: f32, p: Vec3| Vec3::new(x, 0.0, z).dot(self.at(p));
        let face = Region::all()
            .within(Vec3::new(-0.5, 0.0, 1.0), plane(-0.5, 1.0, Vec3::new(0.42, 0.0, 0.80)))
            .beyond(Vec3::X, plane(1.0, 0.0, Vec3::new(0.02, 0.0, 0.0)));
        hair.remove(&face);
        let low = Region::all().within(Vec3::Z, plane(0.0, 1.0, Vec3::new(0.0, 0.0, 0.22)));
        hair.remove(&low);
        hair
    }

    fn short(&self, skin: &mut Skin, volume: f32) {
        skin.add(self.scalp(0.075 * volume, self.look.hair_color), |_| Blend::one(Bone::Head));
    }

    fn long(&self, skin: &mut Skin, skeleton: &Skeleton) {
        self.short(skin, 1.15);
        let row = |x: f32, z: f32, ry: f32, rx: f32| (self.at(Vec3::new(x, 0.0, z)), Vec2::new(ry, rx) * self.size);
        let fall = [
            row(-0.20, 0.80, 0.30, 0.24),
            row(-0.24, 0.50, 0.385, 0.27),
            row(-0.27, 0.20, 0.385, 0.23),
            row(-0.30, -0.10, 0.37, 0.18),
            row(-0.31, -0.35, 0.33, 0.13),
            row(-0.31, -0.55, 0.22, 0.06),
        ];
        let neck = skeleton.joint(Bone::Neck).z;
        skin.add(Sculpt::sweep(&fall, Vec3::Y, 16, 2.2, true, self.look.hair_color), |p| {
            Blend::two(
                Bone::Head,
                Bone::Chest,
                0.85 * smoothstep(neck + 0.30 * self.size, neck - 0.25 * self.size, p.z),
            )
        });
    }

    fn cap(&self, skin: &mut Skin) {
        self.short(skin, 0.9);
        let mut cap = self.skull(0.12, self.look.inner_color);
        cap.remove(&Region::all().within(Vec3::Z, self.at(Vec3::new(0.0, 0.0, 0.68)).z));
        skin.add(cap, |_| Blend::one(Bone::Head));
        let row = |x: f32, z: f32, ry: f32| (self.at(Vec3::new(x, 0.0, z)), Vec2::new(ry, 0.018) * self.size);
        let visor = [row(0.25, 0.72, 0.31), row(0.50, 0.705, 0.29), row(0.66, 0.67, 0.20), row(0.70, 0.66, 0.08)];
        skin.add(Sculpt::sweep(&visor, Vec3::Y, 12, 2.4, true, self.look.inner_color), |_| Blend::one(Bone::Head));
    }

    fn full_helmet(&self, skin: &mut Skin) {
        let shell =
            Material { surface: Surface::CarPaint, base_color: self.look.bag_color.base_color, ..self.look.skin };
        let plain = Material { surface: Surface::Plastic, ..shell };
        let visor = Material { surface: Surface::CarGlass, base_color: [0.015; 3], ..shell };
        let mut helmet =
            Sculpt::ellipsoid(self.at(Vec3::new(0.0, 0.0, 0.52)), Vec3::new(0.60, 0.50, 0.62) * self.size, 22, plain);
        let z = |t: f32| self.at(Vec3::new(0.0, 0.0, t)).z;
        helmet.remove(&Region::all().within(Vec3::Z, z(0.02)));
        helmet.paint(
            &Region::all().beyond(Vec3::Z, z(0.34)).within(Vec3::Z, z(0.74)).beyond(Vec3::X, self.at(Vec3::X * 0.16).x),
            visor,
        );
        skin.add(helmet, |_| Blend::one(Bone::Head));
    }

    fn cycle_helmet(&self, skin: &mut Skin) {
        self.short(skin, 0.8);
        let shell =
            Material { surface: Surface::Plastic, base_color: self.look.bag_color.base_color, ..self.look.skin };
        let dark = Material { base_color: [0.02; 3], ..shell };
        let mut helmet =
            Sculpt::ellipsoid(self.at(Vec3::new(0.0, 0.0, 0.70)), Vec3::new(0.58, 0.44, 0.44) * self.size, 20, shell);
        helmet.remove(&Region::all().within(Vec3::Z, self.at(Vec3::new(0.0, 0.0, 0.66)).z));
        for y in [-0.24, -0.08, 0.08, 0.24] {
            let y = y * self.size;
            let w = 0.035 * self.size;
            helmet.paint(
                &Region::all().beyond(Vec3::Y, y - w).within(Vec3::Y, y + w).beyond(Vec3::Z, self.at(Vec3::Z * 0.80).z),
                dark,
            );
        }
        skin.add(helmet, |_| Blend::one(Bone::Head));
    }
}
