//! The measures of a bus, and its body built from them.

use super::super::assemble::{Assembly, VehicleBlueprint, VehicleMeasures};
use super::super::car::{open_arch, plate};
use super::super::paint;
use super::super::shell::{Arch, BodyOutline, Greenhouse, Shell};
use super::super::wheel::{Rim, wheel};
use crate::shape::{MonotoneCubic, Region, Sculpt, rounded};
use endless_scene::{Material, Surface};
use endless_world::ClassTag;
use glam::Vec3;

/// The measures of a bus, metres.
pub(super) struct BusShape {
    pub(super) length: f32,
    pub(super) height: f32,
    pub(super) half_width: f32,
    pub(super) floor: f32,
    /// Distance of the axles from the front.
    pub(super) axles_d: Vec<f32>,
    pub(super) wheel_radius: f32,
    /// Lower and upper edge of the side windows.
    pub(super) glass_z: [f32; 2],
    /// The same of the upper deck.
    pub(super) upper_glass_z: Option<[f32; 2]>,
    pub(super) pane: f32,
    /// Doors on the right side: distance from the front and width.
    pub(super) doors: Vec<(f32, f32)>,
    /// How far the roof's front lies behind the bumper.
    pub(super) rake: f32,
    pub(super) coach: bool,
    pub(super) white_roof: bool,
    /// Whether front and rear are ends, and not joined to another piece.
    pub(super) ends: [bool; 2],
}

pub(super) fn rect(a0: f32, a1: f32, b0: f32, b1: f32) -> [(f32, f32); 4] {
    [(a0, b0), (a1, b0), (a1, b1), (a0, b1)]
}
impl BusShape {
    pub(super) fn x(&self, d: f32) -> f32 {
        0.5 * self.length - d
    }

    pub(super) fn shell(&self) -> Shell {
        let outline = BodyOutline {
            front: self.x(0.0),
            rear: self.x(self.length),
            half_width: self.half_width,
            bow: [0.16, 0.06],
            corner: [0.20, 0.14],
            taper: [0.01, 0.01],
        };
        let flat = |z: f32| MonotoneCubic::new(&[(-9.0, z), (9.0, z)]);
        let belt = self.glass_z[0] - 0.08;
        Shell {
            section: vec![
                (0.0, 0.06, 0.10, 0.08),
                (0.06, 0.01, 0.02, 0.02),
                (0.2, 0.0, 0.0, 0.0),
                (0.5, 0.0, 0.0, 0.0),
                (0.75, 0.0, 0.01, 0.0),
                (1.0, 0.0, 0.02, 0.002),
            ],
            sill: flat(self.floor),
            belt: flat(belt),
            deck: flat(belt),
            cabin: Greenhouse {
                foot: outline.inset(0.0, 0.02, 0.002),
                top: BodyOutline { corner: [0.24, 0.16], ..outline.inset(0.045, self.rake, 0.05) },
                roof: MonotoneCubic::new(&[(-9.0, self.height), (9.0, self.height)]),
                edge_drop: 0.16,
                bulge: 0.01,
            },
            arches: self
                .axles_d
                .iter()
                .map(|&d| Arch { x: self.x(d), z: self.wheel_radius, radius: self.wheel_radius + 0.08, flare: 0.0 })
                .collect(),
            outline,
        }
    }

    pub(super) fn blueprint(self) -> VehicleBlueprint {
        let size = VehicleMeasures {
            // Mirrors reach ahead of the front.
            front: self.x(0.02 + 0.5 * self.rake) + 0.26,
            rear: self.x(self.length) - 0.006,
            width: 2.0 * self.half_width,
            height: self.height + 0.19,
            axles: [self.x(self.axles_d[0]), self.x(self.axles_d[self.axles_d.len() - 1])],
            wheel_radius: self.wheel_radius,
        };
        VehicleBlueprint::new(size, move || self.build())
    }

    pub(super) fn build(&self) -> Assembly {
        let shell = self.shell();
        let mut body = shell.sculpt(paint::BODY);
        body.paint(&Region::all().facing(-Vec3::Z, 0.5).within(Vec3::Z, self.floor + 0.3), paint::DARK);
        if self.white_roof {
            let edge = self.upper_glass_z.unwrap_or(self.glass_z)[1] + 0.28;
            body.paint(&Region::all().beyond(Vec3::Z, edge), paint::WHITE);
        }
        self.sides(&mut body);
        if self.ends[0] {
            self.front(&mut body);
        }
        if self.ends[1] {
            self.rear(&mut body);
        }
        self.roof(&mut body);
        for arch in &shell.arches {
            open_arch(&mut body, arch, self.half_width, true);
        }
        let wheel_mesh = wheel(self.wheel_radius, 0.29, 0.62, Rim::Steel, paint::STEEL);
        let mut assembly = Assembly::new(body, wheel_mesh, self.wheel_radius);
        for (i, d) in self.axles_d.iter().enumerate() {
            assembly.axle(self.x(*d), self.half_width - 0.16, i == 0);
        }
        let lamp = Vec3::new(self.x(0.12), self.half_width - 0.32, 0.78);
        assembly.headlights = vec![lamp, Vec3::new(lamp.x, -lamp.y, lamp.z)];
        assembly
    }

    /// A row of side windows in a dark band.
    fn panes(&self, body: &mut Sculpt, [z0, z1]: [f32; 2]) {
        let side = |polygon: &[(f32, f32)], r: f32| {
            Region::side(&rounded(polygon, r)).facing(Vec3::Y, 0.6).beyond(Vec3::Y, 0.7 * self.half_width)
        };
        let (front, rear) = (self.x(0.55 + self.rake), self.x(self.length - 0.30));
        body.paint_both(&side(&rect(rear, front, z0 - 0.03, z1 + 0.03), 0.05), paint::TRIM);
        let n = ((front - rear) / self.pane).round().max(1.0);
        let pane = (front - rear) / n;
        for i in 0..n as usize {
            let x = front - pane * i as f32;
            body.paint_both(&side(&rect(x - pane + 0.04, x - 0.04, z0, z1), 0.07), paint::GLASS);
            if !self.coach && i % 2 == 1 {
                let slit = z1 - 0.32;
                body.paint_both(&side(&rect(x - pane + 0.04, x - 0.04, slit, slit + 0.025), 0.0), paint::TRIM);
            }
        }
    }

    fn sides(&self, body: &mut Sculpt) {
        for glass_z in std::iter::once(self.glass_z).chain(self.upper_glass_z) {
            self.panes(body, glass_z);
        }
        let [z0, z1] = self.glass_z;
        let side = |polygon: &[(f32, f32)], r: f32| {
            Region::side(&rounded(polygon, r)).facing(Vec3::Y, 0.6).beyond(Vec3::Y, 0.7 * self.half_width)
        };
        let (front, rear) = (self.x(0.55 + self.rake), self.x(self.length - 0.30));
        // A stripe in the livery, panel seams, skirt line.
        let stripe = if self.coach { 1.18 } else { 0.86 };
        body.paint_both(&side(&rect(rear - 0.1, front, stripe, stripe + 0.11), 0.0), paint::WHITE);
        let mut d = 1.6;
        while d < self.length - 0.5 {
            let x = self.x(d);
            body.paint_both(&side(&rect(x, x + 0.014, self.floor + 0.1, z0 - 0.10), 0.0), paint::DARK);
            d += 1.35;
        }
        body.paint_both(&side(&rect(rear, front, self.floor + 0.36, self.floor + 0.375), 0.0), paint::DARK);
        for &(d, width) in &self.doors {
            let (x1, x0) = (self.x(d), self.x(d + width));
            let top = (self.floor + 2.05).max(z1 - 0.05).min(z1 + 0.03);
            body.paint(&side(&rect(x0, x1, self.floor + 0.04, top), 0.03).mirrored(), paint::TRIM);
            let half = 0.5 * (x0 + x1);
            for (a, b) in [(x0, half), (half, x1)] {
                body.paint(
                    &side(&rect(a + 0.07, b - 0.07, self.floor + 0.22, top - 0.08), 0.04).mirrored(),
                    paint::GLASS,
                );
            }
        }
        for i in 0..5 {
            let x = self.x(1.2 + (self.length - 2.4) * i as f32 / 4.0);
            body.add(
                Sculpt::cuboid(
                    Vec3::new(x - 0.04, self.half_width - 0.01, 0.62),
                    Vec3::new(x + 0.04, self.half_width + 0.006, 0.65),
                    0.0,
                    paint::ORANGE,
                )
                .both_sides(),
            );
        }
    }

    fn front(&self, body: &mut Sculpt) {
        let w = self.half_width;
        let front = |polygon: &[(f32, f32)], r: f32| {
            Region::end(&rounded(polygon, r)).facing(Vec3::X, 0.25).beyond(Vec3::X, self.x(1.0))
        };
        let top = self.upper_glass_z.map_or(self.height - 0.18, |z| z[0] - 0.06);
        if let Some([z0, z1]) = self.upper_glass_z {
            body.paint(&front(&rect(-w + 0.05, w - 0.05, z0 - 0.03, z1 + 0.12), 0.12), paint::TRIM);
            body.paint(&front(&rect(-w + 0.09, w - 0.09, z0, z1 + 0.09), 0.11), paint::GLASS);
            body.paint(&front(&rect(-0.02, 0.02, z0, z1 + 0.09), 0.0), paint::TRIM);
        }
        let low = if self.coach { 1.28 } else { 0.98 };
        body.paint(&front(&rect(-w + 0.03, w - 0.03, low, top), 0.10), paint::TRIM);
        body.paint(&front(&rect(-w + 0.09, w - 0.09, low + 0.05, top - 0.34), 0.10), paint::GLASS);
        body.paint(&front(&rect(-0.006, 0.006, low + 0.05, top - 0.34), 0.0), paint::TRIM);
        // Destination sign: amber letters on black.
        let amber = Material::new(Surface::LitSign, [0.85, 0.36, 0.02], ClassTag::Bus);
        let (z0, z1) = (top - 0.27, top - 0.07);
        for (i, width) in [0.09, 0.09, 0.05, 0.10, 0.08, 0.10, 0.06, 0.09, 0.10, 0.07].into_iter().enumerate() {
            let y = -0.72 + 0.145 * i as f32 + if i > 2 { 0.05 } else { 0.0 };
            body.paint(&front(&rect(y, y + width, z0 + 0.03, z1 - 0.02), 0.0), amber);
            body.paint(&front(&rect(y + 0.025, y + width - 0.02, z0 + 0.08, z1 - 0.06), 0.0), paint::TRIM);
        }
        // Bumper and lamps.
        let f = self.floor;
        body.paint(&front(&rect(-0.55, 0.55, f + 0.30, f + 0.42), 0.04), paint::DARK);
        body.paint(&front(&rect(-w, w, f + 0.02, f + 0.10), 0.0), paint::TRIM);
        body.paint_both(&front(&rect(w - 0.56, w - 0.07, f + 0.36, f + 0.60), 0.06), paint::DARK);
        body.paint_both(&front(&rect(w - 0.53, w - 0.22, f + 0.385, f + 0.575), 0.05), paint::HEAD);
        body.paint(&front(&rect(w - 0.19, w - 0.09, f + 0.40, f + 0.56), 0.03), paint::LEFT);
        body.paint(&front(&rect(w - 0.19, w - 0.09, f + 0.40, f + 0.56), 0.03).mirrored(), paint::RIGHT);
        plate(body, Vec3::new(self.x(0.0), 0.0, f + 0.20), 1.0);
        // Mirrors on arms ahead of the corners.
        let x = self.x(0.02 + 0.5 * self.rake);
        let arm = [
            (Vec3::new(x - 0.15, w - 0.12, top - 0.05), 0.018),
            (Vec3::new(x + 0.16, w + 0.06, top - 0.08), 0.018),
            (Vec3::new(x + 0.20, w + 0.13, top - 0.25), 0.018),
        ];
        body.add(Sculpt::tube(&arm, 6, paint::TRIM).both_sides());
        body.add(
            Sculpt::cuboid(
                Vec3::new(x + 0.15, w + 0.04, top - 0.66),
                Vec3::new(x + 0.26, w + 0.22, top - 0.24),
                0.03,
                paint::TRIM,
            )
            .both_sides(),
        );
        for y in [-0.55, 0.35] {
            let foot = Vec3::new(self.x(-0.005), y, low + 0.06);
            body.add(Sculpt::tube(
                &[(foot, 0.012), (foot + Vec3::new(-0.02 - 0.3 * self.rake, 0.62, 0.22), 0.009)],
                5,
                paint::DARK,
            ));
        }
    }

    fn rear(&self, body: &mut Sculpt) {
        let w = self.half_width;
        let f = self.floor;
        let rear = |polygon: &[(f32, f32)], r: f32| {
            Region::end(&rounded(polygon, r)).facing(-Vec3::X, 0.3).within(Vec3::X, self.x(self.length - 0.8))
        };
        let [z0, z1] = self.glass_z;
        body.paint(&rear(&rect(-w + 0.16, w - 0.16, z0 + 0.25, z1 + 0.05), 0.10), paint::TRIM);
        body.paint(&rear(&rect(-w + 0.20, w - 0.20, z0 + 0.29, z1 + 0.01), 0.10), paint::GLASS);
        if let Some([z0, z1]) = self.upper_glass_z {
            body.paint(&rear(&rect(-w + 0.2, w - 0.2, z0, z1), 0.10), paint::GLASS);
        }
        for i in 0..7 {
            let z = f + 0.42 + 0.07 * i as f32;
            body.paint(&rear(&rect(-0.75, 0.75, z, z + 0.035), 0.0), paint::DARK);
        }
        body.paint(&rear(&rect(-w, w, f + 0.02, f + 0.20), 0.0), paint::TRIM);
        for (i, (z, lens)) in
            [(f + 0.36, paint::TAIL), (f + 0.58, paint::TAIL), (f + 0.98, paint::REVERSE)].into_iter().enumerate()
        {
            let h = if i == 2 { 0.12 } else { 0.17 };
            body.paint_both(&rear(&rect(w - 0.30, w - 0.12, z, z + h), 0.07), lens);
        }
        body.paint(&rear(&rect(w - 0.30, w - 0.12, f + 0.78, f + 0.94), 0.07), paint::LEFT);
        body.paint(&rear(&rect(w - 0.30, w - 0.12, f + 0.78, f + 0.94), 0.07).mirrored(), paint::RIGHT);
        body.paint(&rear(&rect(-0.25, 0.25, z1 + 0.14, z1 + 0.18), 0.0), paint::BRAKE_LIGHT);
        plate(body, Vec3::new(self.x(self.length), 0.0, f + 0.30), -1.0);
    }

    fn roof(&self, body: &mut Sculpt) {
        let z = self.height - 0.03;
        let unit = |d0: f32, d1: f32, half: f32, h: f32| {
            Sculpt::cuboid(Vec3::new(self.x(d1), -half, z), Vec3::new(self.x(d0), half, z + h), 0.07, paint::WHITE)
        };
        body.add(unit(0.3 * self.length, 0.5 * self.length, 0.78, 0.22));
        body.add(unit(self.length - 2.6, self.length - 1.0, 0.70, 0.16));
        for d in [2.0, 0.62 * self.length] {
            body.add(Sculpt::cuboid(
                Vec3::new(self.x(d + 0.7), -0.35, z),
                Vec3::new(self.x(d), 0.35, z + 0.07),
                0.03,
                paint::GREY,
            ));
        }
    }
}
