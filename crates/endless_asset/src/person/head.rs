//! The head: skull and face as one surface, and shells over it (hair, hats) that rise where they show.

use super::appearance::{Appearance, Beard, Glasses};
use super::palette;
use super::skeleton::{Bone, Skeleton};
use super::skin::Skin;
use crate::shape::{MonotoneCubic, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::math::{self, smoothstep};
use glam::Vec3;
use std::f32::consts::TAU;

/// Columns around the head, denser in the face.
const COLUMNS: usize = 24;

/// Heights of rows above the chin, over the head's height.
const ROWS: [f32; 17] =
    [0.0, 0.04, 0.10, 0.16, 0.215, 0.27, 0.32, 0.37, 0.44, 0.50, 0.56, 0.64, 0.73, 0.82, 0.90, 0.965, 1.0];

/// The surface of a head, in units of its height above the chin.
pub(crate) struct Head<'a> {
    pub(crate) appearance: &'a Appearance,
    chin: Vec3,
    /// Chin to crown, metres.
    pub(crate) size: f32,
    breadth: MonotoneCubic,
    front: MonotoneCubic,
    back: MonotoneCubic,
}

impl<'a> Head<'a> {
    pub(crate) fn new(appearance: &'a Appearance, skeleton: &Skeleton) -> Self {
        let chin = Vec3::new(0.004 * appearance.height, 0.0, skeleton.height - skeleton.head_height);
        // Jaws of women and children are narrower; flesh rounds them.
        let jaw =
            if appearance.female || appearance.age < 14.0 { 0.92 } else { 1.0 } * (0.75 + 0.25 * appearance.girth);
        let breadth = [
            (0.0, 0.090 * jaw),
            (0.04, 0.165 * jaw),
            (0.12, 0.235 * jaw),
            (0.20, 0.265 * jaw),
            (0.35, 0.300),
            (0.50, 0.325),
            (0.65, 0.345),
            (0.80, 0.315),
            (0.90, 0.235),
            (0.965, 0.14),
            (1.0, 0.012),
        ];
        let front = [
            (0.0, 0.320),
            (0.05, 0.385),
            (0.13, 0.375),
            (0.22, 0.390),
            (0.30, 0.375),
            (0.38, 0.375),
            (0.50, 0.380),
            (0.57, 0.405),
            (0.70, 0.400),
            (0.82, 0.345),
            (0.90, 0.255),
            (0.965, 0.15),
            (1.0, 0.012),
        ];
        let back = [
            (0.0, 0.02),
            (0.06, 0.10),
            (0.14, 0.27),
            (0.22, 0.36),
            (0.35, 0.415),
            (0.50, 0.455),
            (0.65, 0.460),
            (0.80, 0.410),
            (0.90, 0.310),
            (0.965, 0.18),
            (1.0, 0.012),
        ];
        Self {
            appearance,
            chin,
            size: skeleton.head_height,
            breadth: MonotoneCubic::new(&breadth),
            front: MonotoneCubic::new(&front),
            back: MonotoneCubic::new(&back),
        }
    }

    /// A place in units of the head's height above the chin.
    pub(crate) fn at(&self, p: Vec3) -> Vec3 {
        self.chin + p * self.size
    }

    /// The angle of a column: 0 is ahead, positive to the left.
    fn angle(column: f32) -> f32 {
        let half = 0.5 * COLUMNS as f32;
        let u = TAU * if column > half { column - COLUMNS as f32 } else { column } / COLUMNS as f32;
        u - 0.38 * math::sin(u)
    }

    /// A point of the surface, raised by `grow`; all in units of the head's height.
    pub(crate) fn surface(&self, z: f32, angle: f32, grow: f32) -> Vec3 {
        let (sin, cos) = math::sin_cos(angle);
        let depth = if cos >= 0.0 { self.front.at(z) } else { self.back.at(z) };
        let p = Vec3::new(cos * depth, sin * self.breadth.at(z), z);
        let p = p + Vec3::X * if cos > 0.0 { self.relief(p.y, z) } else { 0.0 };
        let out = Vec3::new(p.x, p.y, (z - 0.5) * 1.1).normalize_or(Vec3::Z);
        p + out * grow
    }

    /// Nose, brows, eye sockets, lips, chin: how far they stand out.
    fn relief(&self, y: f32, z: f32) -> f32 {
        let bell = |d: f32| math::exp(-d * d);
        let side = (y.abs() - 0.135) / 0.075;
        let nose = if z < 0.37 { smoothstep(0.295, 0.355, z) } else { (1.0 - (z - 0.36) / 0.19).clamp(0.0, 1.0) };
        let young = 1.0 - 0.35 * smoothstep(14.0, 4.0, self.appearance.age);
        0.105 * nose * bell(y / 0.058) * young + 0.012 * bell((z - 0.575) / 0.03) * bell(y / 0.22)
            - 0.034 * bell(side) * bell((z - 0.505) / 0.042)
            + 0.014 * bell((z - 0.215) / 0.035) * bell(y / 0.10)
            + 0.018 * bell((z - 0.05) / 0.045) * bell(y / 0.10)
            - 0.010 * bell((z - 0.135) / 0.03) * bell(y / 0.12)
    }

    /// A sheet over the head; `grow` gives its height over the skin by height and angle. Where it lies beneath the
    /// skin it is left out.
    pub(crate) fn shell(&self, grow: impl Fn(f32, f32) -> f32, material: Material) -> Sculpt {
        let n = COLUMNS;
        let heights: Vec<Vec<f32>> =
            ROWS.iter().map(|&z| (0..n).map(|j| grow(z, Self::angle(j as f32))).collect()).collect();
        let mut s = Sculpt::new();
        let point = |i: usize, j: usize| self.at(self.surface(ROWS[i], Self::angle(j as f32), heights[i][j]));
        for i in 0..ROWS.len() - 1 {
            for j in 0..n {
                let k = (j + 1) % n;
                let corners = [(i, j), (i, k), (i + 1, k), (i + 1, j)];
                if corners.iter().any(|&(r, c)| heights[r][c] > -0.008) {
                    s.quad(corners.map(|(r, c)| point(r, c)), material);
                }
            }
        }
        s.smooth(75.0)
    }

    /// Everything that is seen of the head itself.
    pub(crate) fn add(&self, skin: &mut Skin) {
        let appearance = self.appearance;
        let mut face = self.shell(|_, _| 0.0, appearance.skin);
        let under: Vec<Vec3> =
            (0..COLUMNS).rev().map(|j| self.at(self.surface(0.0, Self::angle(j as f32), 0.0))).collect();
        face.polygon(&under, appearance.skin);
        skin.add_rigid(face, Bone::Head);
        let [r, g, b] = appearance.skin.base_color;
        let darker = |k: [f32; 3]| Material { base_color: [r * k[0], g * k[1], b * k[2]], ..appearance.skin };
        let red = if appearance.female { 0.40 } else { 0.55 };
        let mut features = Sculpt::new();
        features.add(self.patch([0.0, 0.212], [0.085, 0.020], 0.006, darker([0.80, red, red])));
        let white = palette::linear(Surface::Skin, [0.42, 0.40, 0.38]);
        let iris = palette::linear(Surface::Leather, [0.018, 0.014, 0.012]);
        let brow = Material { surface: Surface::Hair, ..appearance.hair_color };
        let thick = if appearance.female { 0.011 } else { 0.016 };
        for y in [-0.138, 0.138] {
            features.add(self.patch([y, 0.502], [0.052, 0.021], 0.006, white));
            features.add(self.patch([y, 0.502], [0.024, 0.022], 0.009, iris));
            features.add(self.patch([1.02 * y, 0.527], [0.062, 0.008], 0.010, darker([0.35, 0.30, 0.30])));
            features.add(self.patch([1.02 * y, 0.575], [0.072, thick], 0.008, brow));
            let ear = Vec3::new(-0.03, y.signum() * 0.335, 0.45);
            features.add(Sculpt::ellipsoid(
                self.at(ear),
                Vec3::new(0.062, 0.028, 0.098) * self.size,
                8,
                appearance.skin,
            ));
        }
        skin.add_rigid(features, Bone::Head);
        self.beard(skin);
        self.glasses(skin);
    }

    /// An ellipse laid on the face: centre and half axes (to the left, up).
    fn patch(&self, [y, z]: [f32; 2], [ry, rz]: [f32; 2], lift: f32, material: Material) -> Sculpt {
        let n = 8;
        let points: Vec<Vec3> = (0..n)
            .map(|i| {
                let (sin, cos) = math::sin_cos(TAU * i as f32 / n as f32);
                self.at(self.on_face(y + ry * cos, z + rz * sin, lift))
            })
            .collect();
        let mut s = Sculpt::new();
        s.polygon(&points, material);
        s.smooth(180.0)
    }

    /// The surface straight ahead of a point of the face, raised.
    fn on_face(&self, y: f32, z: f32, lift: f32) -> Vec3 {
        let sin = (y / self.breadth.at(z)).clamp(-0.98, 0.98);
        self.surface(z, math::asin(sin), lift)
    }

    fn beard(&self, skin: &mut Skin) {
        let (volume, moustache_only) = match self.appearance.beard {
            Beard::None => return,
            Beard::Stubble => (0.008, false),
            Beard::Moustache => (0.02, true),
            Beard::Full => (0.040, false),
        };
        if moustache_only {
            return skin
                .add_rigid(self.patch([0.0, 0.262], [0.105, 0.020], 0.018, self.appearance.hair_color), Bone::Head);
        }
        // Over jaw and chin up to the ears, around the mouth.
        let grow = move |z: f32, angle: f32| {
            let a = angle.abs();
            let top = if a < 0.35 { 0.28 } else { 0.26 + 0.20 * smoothstep(0.5, 1.35, a) };
            let mouth = 1.0 - smoothstep(0.16, 0.30, a);
            let lips = mouth * smoothstep(0.17, 0.195, z) * (1.0 - smoothstep(0.235, 0.255, z));
            let back = smoothstep(1.75, 1.45, a);
            let inside = smoothstep(top + 0.02, top - 0.03, z) * back * (1.0 - lips);
            volume * inside - 0.012 * (1.0 - inside)
        };
        let mut material = self.appearance.hair_color;
        if self.appearance.beard == Beard::Stubble {
            for (c, s) in material.base_color.iter_mut().zip(self.appearance.skin.base_color) {
                *c = 0.35 * *c + 0.65 * 0.6 * s;
            }
        }
        skin.add_rigid(self.shell(grow, material), Bone::Head);
    }

    fn glasses(&self, skin: &mut Skin) {
        if self.appearance.glasses == Glasses::None {
            return;
        }
        let frame = palette::linear(Surface::Plastic, [0.015, 0.014, 0.013]);
        let mut s = Sculpt::new();
        for y in [-0.145, 0.145] {
            if self.appearance.glasses == Glasses::Sun {
                let lens = palette::linear(Surface::CarGlass, [0.012, 0.012, 0.014]);
                s.add(self.patch([y, 0.495], [0.095, 0.065], 0.050, lens));
            } else {
                let rim: Vec<(Vec3, f32)> = (0..=10)
                    .map(|i| {
                        let (sin, cos) = math::sin_cos(TAU * i as f32 / 10.0);
                        (self.at(self.on_face(y + 0.088 * cos, 0.495 + 0.058 * sin, 0.045)), 0.011 * self.size)
                    })
                    .collect();
                s.add(Sculpt::tube(&rim, 4, frame));
            }
            let hinge = self.at(self.on_face(1.62 * y, 0.51, 0.045));
            let ear = self.at(Vec3::new(-0.05, y.signum() * 0.352, 0.50));
            s.add(Sculpt::tube(&[(hinge, 0.011 * self.size), (ear, 0.010 * self.size)], 4, frame));
        }
        let bridge = [-0.06, 0.06].map(|y| (self.at(self.on_face(y, 0.505, 0.030)), 0.010 * self.size));
        s.add(Sculpt::tube(&bridge, 4, frame));
        skin.add_rigid(s, Bone::Head);
    }
}
