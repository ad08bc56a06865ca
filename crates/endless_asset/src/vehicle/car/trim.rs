//! Seams, cladding, mirrors and rails of a car.

use super::arch::disc;
use super::shape::CarShape;
use crate::shape::{Region, Sculpt};
use crate::vehicle::paint;
use crate::vehicle::shell::Shell;
use glam::{Vec2, Vec3};

impl CarShape {
    /// Gaps of doors, bonnet and fuel flap; handles.
    pub(super) fn seams(&self, body: &mut Sculpt, shell: &Shell) {
        let low = self.clearance + 0.06;
        const GAP: f32 = 0.011;
        let sideways = |r: Region| r.facing(Vec3::Y, 0.4).beyond(Vec3::Y, 0.5 * self.half_width);
        for &d in &self.doors_d {
            let x = self.x(d);
            let strip = [(x, low), (x + GAP, low), (x + GAP, shell.belt_z(x) + 0.02), (x, shell.belt_z(x) + 0.02)];
            body.paint_both(&sideways(Region::side(&strip.map(Vec2::from))), paint::DARK);
        }
        if let (Some(&first), Some(&last)) = (self.doors_d.first(), self.doors_d.last()) {
            let (front, rear) = (self.x(first), self.x(last));
            let strip = [(rear, low), (front, low), (front, low + GAP), (rear, low + GAP)];
            body.paint_both(&sideways(Region::side(&strip.map(Vec2::from))), paint::DARK);
        }
        for &d in self.doors_d.iter().skip(1) {
            let x = self.x(d) + 0.13;
            let z = shell.belt_z(x) - 0.115;
            let handle = Sculpt::ellipsoid(
                Vec3::new(x, self.half_width + 0.004, z),
                Vec3::new(0.085, 0.022, 0.016),
                10,
                paint::BODY,
            );
            body.add(handle.both_sides());
        }
        // Bonnet: gaps along both wings and across the nose.
        let [foot, ..] = self.cabin_d;
        let up = |r: Region| r.facing(Vec3::Z, 0.5).within(Vec3::Z, shell.deck.at(self.x(foot)) + 0.01);
        let (x0, x1) = (self.x(foot), self.x(0.30));
        let (y0, y1) = (self.half_width - 0.17, self.half_width - 0.26);
        let strip = [(x0, y0), (x0, y0 + GAP), (x1, y1 + GAP), (x1, y1)];
        body.paint_both(&up(Region::top(&strip.map(Vec2::from))), paint::DARK);
        // Wipers.
        let screen = Vec3::new(self.x(foot - 0.03), 0.0, shell.deck.at(self.x(foot)) + 0.012);
        for y in [0.42, -0.18] {
            let path = [(screen + Vec3::new(0.0, y, 0.0), 0.010), (screen + Vec3::new(-0.06, y - 0.5, 0.035), 0.007)];
            body.add(Sculpt::tube(&path, 5, paint::TRIM));
        }
    }

    pub(super) fn clad(&self, body: &mut Sculpt, shell: &Shell) {
        let sideways = |r: Region| r.facing(Vec3::Y, 0.1).beyond(Vec3::Y, 0.6 * self.half_width);
        for arch in &shell.arches {
            body.paint_both(&sideways(disc(arch, arch.radius + 0.06)), paint::TRIM);
        }
        let [front, rear] = self.axles();
        let z = self.clearance + 0.13;
        let sill = [(rear, 0.0), (front, 0.0), (front, z), (rear, z)];
        body.paint_both(&sideways(Region::side(&sill.map(Vec2::from))), paint::TRIM);
        for (direction, x) in [(Vec3::X, self.x(0.0)), (-Vec3::X, self.x(self.length))] {
            let band = Region::end(&[(-2.0, 0.0), (2.0, 0.0), (2.0, z), (-2.0, z)].map(Vec2::from))
                .beyond(direction, x.abs() - 0.6);
            body.paint(&band, paint::TRIM);
        }
    }

    pub(super) fn mirrors(&self, body: &mut Sculpt, shell: &Shell) {
        let x = self.x(self.cabin_d[0] + 0.42);
        let z = shell.belt_z(x) + 0.075;
        let root = Vec3::new(x, self.half_width - 0.06, z - 0.05);
        let centre = Vec3::new(x + 0.01, self.half_width + 0.085, z);
        let mut mirror = Sculpt::tube(&[(root, 0.035), (centre - Vec3::Z * 0.04, 0.025)], 6, paint::TRIM);
        let mut housing = Sculpt::ellipsoid(centre, Vec3::new(0.075, 0.115, 0.072), 14, paint::BODY);
        housing.paint(&Region::all().within(Vec3::X, centre.x - 0.015), paint::TRIM);
        housing.paint(&Region::all().within(Vec3::X, centre.x - 0.035), paint::CHROME);
        mirror.add(housing);
        body.add(mirror.both_sides());
    }

    pub(super) fn roof_rails(&self, body: &mut Sculpt, shell: &Shell) {
        let [_, top, rear, _] = self.cabin_d;
        let y = self.half_width - self.tumblehome - 0.045;
        let n = 6;
        let path: Vec<(Vec3, f32)> = (0..=n)
            .map(|i| {
                let x = self.x(top + 0.28) + (self.x(rear - 0.12) - self.x(top + 0.28)) * i as f32 / n as f32;
                let lift = if i == 0 || i == n { -0.02 } else { 0.035 };
                (Vec3::new(x, y, shell.roof_edge_z(x) + 0.035 + lift), 0.014)
            })
            .collect();
        body.add(Sculpt::tube(&path, 6, paint::STEEL).both_sides());
    }
}
