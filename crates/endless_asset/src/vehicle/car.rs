//! Passenger cars: from a few measures of the side view to a finished body.

use super::paint;
use super::shell::{Arch, Cabin, Ring, SectionRow, Shell};
use super::wheel::{Rim, wheel};
use super::{VehicleSpec, assemble::Assembly};
use crate::shape::{Curve, Region, Sculpt, rounded};
use glam::{Vec2, Vec3};

/// Measures of a car. `d` is the distance from the front bumper backwards, metres.
#[derive(Debug, Clone)]
pub(crate) struct CarShape {
    pub(crate) length: f32,
    pub(crate) half_width: f32,
    pub(crate) clearance: f32,
    pub(crate) wheelbase: f32,
    pub(crate) front_axle_d: f32,
    pub(crate) wheel_radius: f32,
    pub(crate) tyre_width: f32,
    pub(crate) rim: Rim,
    /// Centre line of bonnet and boot: (d, z), from the nose's upper edge to the tail's.
    pub(crate) deck: Vec<(f32, f32)>,
    /// Belt line: (d, z).
    pub(crate) belt: Vec<(f32, f32)>,
    /// Roof's centre line: (d, z).
    pub(crate) roof: Vec<(f32, f32)>,
    /// d of the windscreen's foot, its top, the roof's rear edge, the rear window's foot.
    pub(crate) cabin_d: [f32; 4],
    /// How much narrower the roof's edge is than the body, each side.
    pub(crate) tumblehome: f32,
    /// Plan view: bow and corner radius at front and rear.
    pub(crate) bow: [f32; 2],
    pub(crate) corner: [f32; 2],
    /// How far nose and tail recede from the bumper up to the deck.
    pub(crate) rake: [f32; 2],
    /// d where side glass is divided by pillars, and where it ends.
    pub(crate) pillars_d: Vec<f32>,
    /// Foot and top of the rear end of the side glass.
    pub(crate) glass_end_d: [f32; 2],
    /// d of door gaps.
    pub(crate) doors_d: Vec<f32>,
    /// Black cladding around arches and sills.
    pub(crate) cladding: bool,
    /// Rails along the roof.
    pub(crate) rails: bool,
    /// Tail lamps: upright beside the rear window (true) or flat below the boot lid's edge.
    pub(crate) upright_lamps: bool,
    /// Rear window in the tailgate or behind the cabin; false for blind panels.
    pub(crate) rear_window: bool,
    /// Height range of the tail lamps.
    pub(crate) tail_lamp_z: [f32; 2],
    /// Height range of the headlamps at their inner end.
    pub(crate) head_lamp_z: [f32; 2],
}

impl CarShape {
    /// x of a distance from the front.
    pub(crate) fn x(&self, d: f32) -> f32 {
        0.5 * self.length - d
    }

    fn curve(&self, points: &[(f32, f32)]) -> Curve {
        Curve::new(&points.iter().map(|&(d, z)| (self.x(d), z)).collect::<Vec<_>>())
    }

    fn section(&self) -> Vec<SectionRow> {
        let [n, t] = self.rake;
        vec![
            (0.0, 0.12, 0.17, 0.15),
            (0.03, 0.055, 0.085, 0.08),
            (0.09, 0.03, 0.03, 0.03),
            (0.2, 0.018, 0.005, 0.006),
            (0.34, 0.006, 0.0, 0.0),
            (0.48, 0.0, 0.012, 0.004),
            (0.56, 0.0, 0.03 + 0.1 * n, 0.03 + 0.1 * t),
            (0.7, 0.002, 0.045 + 0.3 * n, 0.035 + 0.35 * t),
            (0.8, 0.010, 0.055 + 0.5 * n, 0.04 + 0.55 * t),
            (0.88, 0.014, 0.065 + 0.65 * n, 0.045 + 0.75 * t),
            (0.94, 0.024, 0.08 + 0.78 * n, 0.055 + 0.87 * t),
            (0.98, 0.040, 0.105 + 0.9 * n, 0.075 + 0.95 * t),
            (1.0, 0.060, 0.14 + n, 0.10 + t),
        ]
    }

    pub(crate) fn axles(&self) -> [f32; 2] {
        [self.x(self.front_axle_d), self.x(self.front_axle_d + self.wheelbase)]
    }

    fn shell(&self) -> Shell {
        let outline = Ring {
            front: 0.5 * self.length,
            rear: -0.5 * self.length,
            half_width: self.half_width,
            bow: self.bow,
            corner: self.corner,
            taper: [0.05, 0.04],
        };
        let [foot_d, top_d, roof_rear_d, tail_d] = self.cabin_d;
        let cabin_ring = |front: f32, rear: f32, half_width: f32, corner: [f32; 2]| Ring {
            front: self.x(front),
            rear: self.x(rear),
            half_width,
            bow: [0.13, 0.08],
            corner,
            taper: [0.03, 0.05],
        };
        Shell {
            outline,
            section: self.section(),
            sill: self.curve(&[
                (0.1, self.clearance + 0.02),
                (1.0, self.clearance),
                (self.length - 1.0, self.clearance),
                (self.length - 0.1, self.clearance + 0.05),
            ]),
            belt: self.curve(&self.belt),
            deck: self.curve(&self.deck),
            cabin: Cabin {
                foot: cabin_ring(foot_d, tail_d, self.half_width - 0.075, [0.10, 0.12]),
                top: cabin_ring(top_d, roof_rear_d, self.half_width - self.tumblehome, [0.10, 0.12]),
                roof: self.curve(&self.roof),
                edge_drop: 0.055,
                bulge: 0.018,
            },
            arches: self
                .axles()
                .map(|x| Arch { x, z: self.wheel_radius, radius: self.wheel_radius + 0.055, flare: 0.018 })
                .to_vec(),
        }
    }

    /// Body, wheels and lamps of a car without extras.
    pub(crate) fn build(&self, spec: VehicleSpec) -> Assembly {
        let shell = self.shell();
        let mut body = shell.sculpt(paint::BODY);
        self.underside(&mut body, &shell);
        self.glazing(&mut body, &shell);
        self.front_face(&mut body);
        self.rear_face(&mut body);
        self.seams(&mut body, &shell);
        if self.cladding {
            self.clad(&mut body, &shell);
        }
        for arch in &shell.arches {
            open_arch(&mut body, arch, self.half_width, self.cladding);
        }
        self.mirrors(&mut body, &shell);
        if self.rails {
            self.roof_rails(&mut body, &shell);
        }
        let y = self.half_width - 0.5 * self.tyre_width - 0.012;
        let wheel_mesh = wheel(
            self.wheel_radius,
            self.tyre_width,
            0.69,
            self.rim,
            if self.rim == Rim::Steel { paint::STEEL } else { paint::ALLOY },
        );
        let mut assembly = Assembly::new(spec, body, wheel_mesh, self.wheel_radius);
        let [front, rear] = self.axles();
        assembly.axle(front, y, true);
        assembly.axle(rear, y, false);
        let [z0, z1] = self.head_lamp_z;
        let lamp =
            Vec3::new(self.x(self.bow[0] * 0.6 + self.rake[0] * 0.4 + 0.08), self.half_width - 0.26, 0.5 * (z0 + z1));
        assembly.headlights = vec![lamp, Vec3::new(lamp.x, -lamp.y, lamp.z)];
        assembly
    }

    fn underside(&self, body: &mut Sculpt, shell: &Shell) {
        body.paint(&Region::all().facing(-Vec3::Z, 0.35).within(Vec3::Z, self.clearance + 0.12), paint::DARK);
        let [front, rear] = self.axles();
        let r = shell.arches[0].radius;
        // Black sills between the wheels.
        let sill = [
            (rear + r, 0.0),
            (front - r, 0.0),
            (front - r, self.clearance + 0.045),
            (rear + r, self.clearance + 0.045),
        ];
        body.paint_both(&Region::side(&sill.map(Vec2::from)), paint::TRIM);
    }

    /// Windscreen, rear window and the side glass with its black surround and pillars.
    fn glazing(&self, body: &mut Sculpt, shell: &Shell) {
        let Cabin { foot, top, .. } = &shell.cabin;
        let (foot_front, _) = foot.flank();
        let (top_front, _) = top.flank();
        let [end_foot, end_top] = self.glass_end_d.map(|d| self.x(d));
        let a0 = foot_front - 0.03;
        let a1 = top_front - 0.05;
        let outline = |m: f32| {
            let low = |x: f32| shell.belt_z(x) + 0.012 + m;
            let high = |x: f32| shell.roof_edge_z(x) - 0.05 - m;
            let mut points = vec![(a0 - 2.2 * m, low(a0))];
            points.push((end_foot + m, low(end_foot)));
            for i in 0..=4 {
                let x = end_top + m + (a1 - 2.2 * m - end_top - m) * i as f32 / 4.0;
                points.push((x, high(x)));
            }
            rounded(&points, 0.05)
        };
        let sideways = |r: Region| r.facing(Vec3::Y, 0.45).beyond(Vec3::Y, 0.35 * self.half_width);
        body.paint_both(&sideways(Region::side(&outline(0.0))), paint::TRIM);
        let mut from = self.x(0.0);
        let ends: Vec<f32> = self.pillars_d.iter().map(|&d| self.x(d)).chain([-self.length]).collect();
        for to in ends {
            let pane = Region::side(&outline(0.014)).within(Vec3::X, from).beyond(Vec3::X, to + 0.035);
            body.paint_both(&sideways(pane), paint::GLASS);
            from = to - 0.035;
        }
        let window = |z0: f32, z1: f32, w0: f32, w1: f32, m: f32| {
            Region::end(&rounded(&[(-w0 + m, z0 + m), (w0 - m, z0 + m), (w1 - m, z1 - m), (-w1 + m, z1 - m)], 0.06))
        };
        let screen_foot = shell.deck.at(foot.front);
        let screen_top = shell.roof_edge_z(top.front) + 0.01;
        let (w0, w1) = (foot.half_width - 0.065, top.half_width - 0.055);
        let front =
            |r: Region| r.facing(Vec3::X, 0.22).beyond(Vec3::X, top.front - 0.35).within(Vec3::X, foot.front + 0.01);
        body.paint(&front(window(screen_foot - 0.05, screen_top, w0, w1, 0.0)), paint::TRIM);
        body.paint(&front(window(screen_foot + 0.01, screen_top, w0, w1, 0.022)), paint::GLASS);
        if self.rear_window {
            let low = shell.deck.at(foot.rear) + 0.03;
            let high = shell.roof_edge_z(top.rear) - 0.01;
            let (w0, w1) = (foot.half_width - 0.13, top.half_width - 0.11);
            let back =
                |r: Region| r.facing(-Vec3::X, 0.22).within(Vec3::X, top.rear + 0.35).beyond(Vec3::X, foot.rear - 0.01);
            body.paint(&back(window(low, high, w0, w1, 0.0)), paint::TRIM);
            body.paint(&back(window(low, high, w0, w1, 0.02)), paint::GLASS);
            body.paint(
                &back(Region::end(
                    &[(-0.16, high + 0.004), (0.16, high + 0.004), (0.16, high + 0.024), (-0.16, high + 0.024)]
                        .map(Vec2::from),
                )),
                paint::BRAKE_LIGHT,
            );
        }
    }

    /// Grille, bumper intake, headlamps, fog lamps, number plate.
    fn front_face(&self, body: &mut Sculpt) {
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
        let grille = [(-0.42 * w, z0 - 0.10), (0.42 * w, z0 - 0.10), (0.52 * w, z1 - 0.045), (-0.52 * w, z1 - 0.045)];
        body.paint(&front(&grille.map(|(y, z)| (y * 1.03, z)), 0.05), paint::CHROME);
        body.paint(&front(&grille.map(|(y, z)| (y, if z < z0 { z + 0.014 } else { z - 0.014 })), 0.05), paint::DARK);
        let bar = 0.5 * (z0 + z1) - 0.045;
        body.paint(
            &front(&[(-0.46 * w, bar), (0.46 * w, bar), (0.46 * w, bar + 0.022), (-0.46 * w, bar + 0.022)], 0.0),
            paint::CHROME,
        );
        body.add(Sculpt::ellipsoid(
            Vec3::new(self.x(0.035 + 0.1 * self.rake[0]), 0.0, bar + 0.012),
            Vec3::new(0.02, 0.06, 0.05),
            12,
            paint::CHROME,
        ));
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

    /// Tail lamps, number plate, lower bumper.
    fn rear_face(&self, body: &mut Sculpt) {
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

    /// Gaps of doors, bonnet and fuel flap; handles.
    fn seams(&self, body: &mut Sculpt, shell: &Shell) {
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

    fn clad(&self, body: &mut Sculpt, shell: &Shell) {
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

    fn mirrors(&self, body: &mut Sculpt, shell: &Shell) {
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

    fn roof_rails(&self, body: &mut Sculpt, shell: &Shell) {
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

fn disc(arch: &Arch, radius: f32) -> Region {
    let polygon: Vec<Vec2> = (0..24)
        .map(|i| {
            let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::TAU * i as f32 / 24.0);
            Vec2::new(arch.x + radius * cos, arch.z + radius * sin)
        })
        .collect();
    Region::side(&polygon)
}

/// Cuts a wheel arch on both sides and lines it with a dark wheel well.
pub(crate) fn open_arch(body: &mut Sculpt, arch: &Arch, half_width: f32, clad: bool) {
    let inner = half_width - 0.36;
    body.remove(&disc(arch, arch.radius).beyond(Vec3::Y, inner));
    body.remove(&disc(arch, arch.radius).beyond(Vec3::Y, inner).mirrored());
    let chord = arch.radius * endless_world::math::cos(std::f32::consts::PI / 24.0);
    let on_rim = |p: Vec3| {
        let r = Vec2::new(p.x - arch.x, p.z - arch.z).length();
        r > chord - 2e-3 && r < arch.radius + 2e-3 && p.y.abs() > inner + 0.02
    };
    // The wall of the well hangs on the very edge of the cut: first a narrow lip, then darkness.
    let mut well = Sculpt::new();
    for face in &body.faces {
        for k in 0..3 {
            let (a, b) = (face.corners[k], face.corners[(k + 1) % 3]);
            if on_rim(a) && on_rim(b) && (a - b).length() > 1e-4 && a.y * b.y > 0.0 {
                let depth = |p: Vec3, y: f32| Vec3::new(p.x, (p.y.abs() - y).max(inner).copysign(p.y), p.z);
                let lip = if clad { paint::TRIM } else { paint::BODY };
                well.quad([b, a, depth(a, 0.025), depth(b, 0.025)], lip);
                well.quad([depth(b, 0.025), depth(a, 0.025), depth(a, 9.0), depth(b, 9.0)], paint::DARK);
            }
        }
    }
    let wall: Vec<Vec3> = disc_points(arch).map(|p| Vec3::new(p.x, inner, p.y)).collect();
    let mut back = Sculpt::new();
    back.polygon(&wall.iter().rev().copied().collect::<Vec<_>>(), paint::DARK);
    back.remove(&Region::all().within(Vec3::Z, arch.z - 0.1));
    well.add(back.both_sides());
    body.add(well);
}

fn disc_points(arch: &Arch) -> impl Iterator<Item = Vec2> + '_ {
    (0..24).map(|i| {
        let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::TAU * i as f32 / 24.0);
        Vec2::new(arch.x + arch.radius * cos, arch.z + arch.radius * sin)
    })
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
