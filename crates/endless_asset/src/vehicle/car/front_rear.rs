//! Front and rear of a car: grille, lamps, number plates.

use super::shape::{CarShape, Grille};
use crate::shape::{Region, Sculpt, rounded};
use crate::vehicle::paint;
use glam::{Vec2, Vec3};

impl CarShape {
    /// Grille, bumper intake, headlamps, fog lamps, number plate.
    pub(super) fn front_face(&self, body: &mut Sculpt) {
        if self.grille == Grille::Classic {
            return self.classic_face(body);
        }
        let w = self.half_width;
        let [z0, z1] = self.head_lamp_z;
        let front = |polygon: &[(f32, f32)], r: f32| {
            Region::end(&rounded(polygon, r)).facing(Vec3::X, 0.3).beyond(Vec3::X, self.x(0.75))
        };
        let c = self.clearance;
        // Lower intake with its fog lamps, then the upper grille between the lamps.
        body.paint(
            &front(&[(-0.70 * w, c + 0.03), (0.70 * w, c + 0.03), (0.58 * w, c + 0.16), (-0.58 * w, c + 0.16)], 0.03),
            paint::DARK,
        );
        body.paint_both(
            &front(&[(0.72 * w, c + 0.07), (0.90 * w, c + 0.08), (0.88 * w, c + 0.18), (0.74 * w, c + 0.15)], 0.03),
            paint::DARK,
        );
        self.grille(body);
        // Headlamps sweep around the corner and rise outwards.
        let lamp = |m: f32| {
            let polygon = [
                (0.53 * w + m, z0 + 0.015 + m),
                (w + 0.05, z0 + 0.06 + m),
                (w + 0.05, z1 + 0.07 - m),
                (0.53 * w + m, z1 - 0.03 - m),
            ];
            Region::end(&polygon.map(Vec2::from))
                .beyond(Vec3::X, self.x(0.52) + m)
                .within(Vec3::Z, z1 + 0.03)
                .facing(Vec3::new(0.8, 0.6, 0.0), 0.22)
        };
        body.paint_both(&lamp(0.0), paint::DARK);
        body.paint_both(&lamp(0.012), paint::HEAD);
        let corner = |side: f32| lamp(0.014).within(Vec3::X, self.x(0.44)).within(Vec3::Y * side, 2.0);
        body.paint(&corner(1.0), paint::LEFT);
        body.paint(&corner(1.0).mirrored(), paint::RIGHT);
        plate(body, Vec3::new(self.x(0.0), 0.0, c + 0.20), 1.0);
    }

    /// A flat black grille between square lamps, indicators at the corners, the plate below the bumper.
    fn classic_face(&self, body: &mut Sculpt) {
        let w = self.half_width;
        let [z0, z1] = self.head_lamp_z;
        let front = |y0: f32, y1: f32, z0: f32, z1: f32, r: f32| {
            let polygon = [(y0, z0), (y1, z0), (y1, z1), (y0, z1)];
            Region::end(&rounded(&polygon, r)).facing(Vec3::X, 0.3).beyond(Vec3::X, self.x(0.5))
        };
        body.paint(&front(-0.90 * w, 0.90 * w, z0 - 0.015, z1 + 0.015, 0.01), paint::TRIM);
        for i in 0..3 {
            let z = z0 + 0.015 + 0.33 * (z1 - z0 - 0.02) * i as f32;
            body.paint(&front(-0.50 * w, 0.50 * w, z, z + 0.012, 0.0), paint::STEEL);
        }
        body.paint_both(&front(0.55 * w, 0.83 * w, z0, z1, 0.012), paint::HEAD);
        let corner = Region::end(&[(0.86 * w, z0), (w + 0.05, z0), (w + 0.05, z1), (0.86 * w, z1)].map(Vec2::from))
            .beyond(Vec3::X, self.x(0.16))
            .facing(Vec3::new(0.8, 0.6, 0.0), 0.22);
        body.paint(&corner, paint::LEFT);
        body.paint(&corner.mirrored(), paint::RIGHT);
        let c = self.clearance;
        body.paint(&front(-0.85 * w, 0.85 * w, c, c + 0.16, 0.0), paint::DARK);
        plate(body, Vec3::new(self.x(-0.01), 0.0, c + 0.11), 1.0);
    }

    fn grille(&self, body: &mut Sculpt) {
        let w = self.half_width;
        let [z0, z1] = self.head_lamp_z;
        let front = |polygon: &[(f32, f32)], r: f32| {
            Region::end(&rounded(polygon, r)).facing(Vec3::X, 0.3).beyond(Vec3::X, self.x(0.75))
        };
        let opening = |inner: f32, outer: f32, low: f32, high: f32| {
            [(-inner * w, low), (inner * w, low), (outer * w, high), (-outer * w, high)]
        };
        let bar = 0.5 * (z0 + z1) - 0.045;
        let mut emblem = bar + 0.012;
        match self.grille {
            Grille::Framed => {
                body.paint(&front(&opening(0.43, 0.53, z0 - 0.10, z1 - 0.045), 0.05), paint::CHROME);
                body.paint(&front(&opening(0.42, 0.52, z0 - 0.086, z1 - 0.059), 0.05), paint::DARK);
                body.paint(&front(&opening(0.46, 0.46, bar, bar + 0.022), 0.0), paint::CHROME);
            }
            Grille::Bars => {
                body.paint(&front(&opening(0.40, 0.46, z0 - 0.07, z1 - 0.03), 0.04), paint::DARK);
                for i in 0..3 {
                    let z = z0 - 0.045 + 0.3 * (z1 - z0 + 0.01) * i as f32;
                    body.paint(&front(&opening(0.41, 0.41, z, z + 0.014), 0.0), paint::STEEL);
                }
            }
            Grille::Slit => {
                body.paint(&front(&opening(0.50, 0.52, z1 - 0.085, z1 - 0.03), 0.02), paint::DARK);
                emblem = z1 - 0.057;
            }
            Grille::Closed | Grille::Classic => emblem = z1 - 0.04,
            Grille::Tall => {
                body.paint(&front(&opening(0.24, 0.38, self.clearance + 0.18, z1 - 0.02), 0.07), paint::CHROME);
                body.paint(&front(&opening(0.23, 0.365, self.clearance + 0.195, z1 - 0.035), 0.065), paint::DARK);
                emblem = z1 - 0.07;
            }
            Grille::Slots => {
                for i in 0..7 {
                    let y = (-0.39 + 0.13 * i as f32) * w;
                    let slot = [(y - 0.02, z0 - 0.10), (y + 0.02, z0 - 0.10), (y + 0.02, z1), (y - 0.02, z1)];
                    body.paint(&front(&slot, 0.015), paint::DARK);
                }
                emblem = z1 + 0.03;
            }
        }
        body.add(Sculpt::ellipsoid(
            Vec3::new(self.x(0.035 + 0.1 * self.rake[0]), 0.0, emblem),
            Vec3::new(0.02, 0.055, 0.045),
            12,
            paint::CHROME,
        ));
    }

    /// Tail lamps, number plate, lower bumper.
    pub(super) fn rear_face(&self, body: &mut Sculpt) {
        let w = self.half_width;
        let [z0, z1] = self.tail_lamp_z;
        let rear_x = self.x(self.length);
        let c = self.clearance;
        let rear = |polygon: &[(f32, f32)], r: f32| {
            Region::end(&rounded(polygon, r)).facing(-Vec3::X, 0.3).within(Vec3::X, rear_x + 0.7)
        };
        body.paint(
            &rear(&[(-0.80 * w, c), (0.80 * w, c), (0.72 * w, c + 0.19), (-0.72 * w, c + 0.19)], 0.04),
            paint::TRIM,
        );
        let inner = if self.upright_lamps { 0.72 * w } else { 0.46 * w };
        let lamp = |inner: f32, z0: f32, z1: f32| {
            Region::end(&[(inner, z0), (w + 0.05, z0 - 0.01), (w + 0.05, z1 + 0.02), (inner, z1)].map(Vec2::from))
                .within(Vec3::X, rear_x + if self.upright_lamps { 0.24 } else { 0.32 })
                .facing(Vec3::new(-0.8, 0.6, 0.0), 0.25)
        };
        body.paint_both(&lamp(inner - 0.012, z0 - 0.012, z1 + 0.012), paint::DARK);
        body.paint_both(&lamp(inner, z0, z1), paint::TAIL);
        let h = z1 - z0;
        let (low, high) =
            if self.upright_lamps { (z0 + 0.42 * h, z0 + 0.62 * h) } else { (z0 + 0.08 * h, z0 + 0.38 * h) };
        body.paint(&lamp(inner + 0.01, low, high), paint::LEFT);
        body.paint(&lamp(inner + 0.01, low, high).mirrored(), paint::RIGHT);
        let (low, high) =
            if self.upright_lamps { (z0 + 0.06 * h, z0 + 0.22 * h) } else { (z0 + 0.45 * h, z0 + 0.6 * h) };
        body.paint_both(&lamp(inner + 0.01, low, high).within(Vec3::Y, inner + 0.10), paint::REVERSE);
        // Lid gap, and the plate in its recess.
        let bumper = c + 0.42 * (z0 - c) + 0.06;
        body.paint(
            &rear(
                &[(-0.70 * w, bumper), (0.70 * w, bumper), (0.70 * w, bumper + 0.012), (-0.70 * w, bumper + 0.012)],
                0.0,
            ),
            paint::DARK,
        );
        let plate_z = if self.upright_lamps { bumper + 0.16 } else { 0.5 * (z0 + z1) - 0.04 };
        body.paint(
            &rear(
                &[(-0.32, plate_z - 0.09), (0.32, plate_z - 0.09), (0.30, plate_z + 0.10), (-0.30, plate_z + 0.10)],
                0.04,
            ),
            paint::TRIM,
        );
        let recess = if self.upright_lamps { self.rake[1] * 0.45 + 0.02 } else { self.rake[1] * 0.6 + 0.03 };
        plate(body, Vec3::new(rear_x + recess, 0.0, plate_z), -1.0);
        body.paint(
            &rear(
                &[(-0.14, plate_z + 0.115), (0.14, plate_z + 0.115), (0.14, plate_z + 0.135), (-0.14, plate_z + 0.135)],
                0.0,
            ),
            paint::CHROME,
        );
        // Exhaust.
        let pipe = Vec3::new(rear_x + 0.10, -0.55 * w, c + 0.03);
        body.add(Sculpt::tube(&[(pipe + Vec3::X * 0.3, 0.03), (pipe - Vec3::X * 0.03, 0.03)], 10, paint::STEEL));
    }
}

/// A number plate on the front (`facing` 1) or rear (−1) face.
pub(crate) fn plate(body: &mut Sculpt, centre: Vec3, facing: f32) {
    let (w, h, t) = (0.26, 0.057, 0.008);
    let (low, high) = if facing > 0.0 { (-t, 0.006) } else { (-0.006, t) };
    body.add(Sculpt::cuboid(centre + Vec3::new(low, -w, -h), centre + Vec3::new(high, w, h), 0.0, paint::PLATE));
    let x = centre.x + facing * 0.008;
    // Seven dark characters, as bars broken in the middle.
    for i in 0..7 {
        let y = centre.y - 0.20 + 0.064 * i as f32 + if i > 2 { 0.02 } else { 0.0 };
        for (a, b) in [(0.0, 0.014), (0.024, 0.038)] {
            let c = |dy: f32, dz: f32| Vec3::new(x, y + dy, centre.z + dz);
            let corners = [c(a, -0.036), c(b, -0.036), c(b, 0.036), c(a, 0.036)];
            let corners = if facing > 0.0 { corners } else { [corners[1], corners[0], corners[3], corners[2]] };
            body.quad(corners, paint::PLATE_INK);
        }
    }
}
