//! A car's body, built from its shape.

use super::arch::open_arch;
use super::shape::CarShape;
use crate::shape::{MonotoneCubic, Region, Sculpt, rounded};
use crate::vehicle::assemble::{Assembly, VehicleBlueprint, VehicleMeasures};
use crate::vehicle::paint;
use crate::vehicle::shell::{Arch, BodyOutline, Greenhouse, SectionRow, Shell};
use crate::vehicle::wheel::{Rim, wheel};
use glam::{Vec2, Vec3};

impl CarShape {
    fn curve(&self, points: &[(f32, f32)]) -> MonotoneCubic {
        MonotoneCubic::new(&points.iter().map(|&(d, z)| (self.x(d), z)).collect::<Vec<_>>())
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

    fn shell(&self) -> Shell {
        let outline = BodyOutline {
            front: 0.5 * self.length,
            rear: -0.5 * self.length,
            half_width: self.half_width,
            bow: self.bow,
            corner: self.corner,
            taper: [0.05, 0.04],
        };
        let [foot_d, top_d, roof_rear_d, tail_d] = self.cabin_d;
        let cabin_ring = |front: f32, rear: f32, half_width: f32, corner: [f32; 2]| BodyOutline {
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
            cabin: Greenhouse {
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

    /// A car of this shape without extras.
    pub(crate) fn blueprint(self) -> VehicleBlueprint {
        let size = VehicleMeasures {
            front: 0.5 * self.length,
            rear: -0.5 * self.length,
            width: 2.0 * self.half_width,
            height: self.height(),
            axles: self.axles(),
            wheel_radius: self.wheel_radius,
        };
        VehicleBlueprint::new(size, move || self.build())
    }

    /// Body, wheels and lamps.
    fn build(&self) -> Assembly {
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
        let mut assembly = Assembly::new(body, wheel_mesh, self.wheel_radius);
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
        let Greenhouse { foot, top, .. } = &shell.cabin;
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
}
