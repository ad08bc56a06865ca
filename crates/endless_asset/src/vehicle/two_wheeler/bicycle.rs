//! Bicycles of one frame: two triangles between crank, saddle, head and the rear wheel.

use super::*;
use glam::{Affine3A, Quat};
use std::f32::consts::FRAC_PI_2;

/// How the handlebar is bent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum HandlebarShape {
    Swept,
    Flat,
    Drop,
}

/// Measures of a bicycle, metres.
#[derive(Debug, Clone)]
struct BicycleFrame {
    r: f32,
    tyre: f32,
    front: f32,
    rear: f32,
    crank: Vec3,
    /// Top of the saddle.
    seat: Vec3,
    /// Foot of the stem.
    head: Vec3,
    /// Where the top tube meets the seat tube.
    knot: Vec3,
    /// Left grip.
    grip: Vec3,
    bar: HandlebarShape,
    guards: bool,
    rack: bool,
    lean_rad: f32,
    helmet: f64,
}

fn blueprint(draw: &DesignDraw, frame: BicycleFrame, rear: f32, height: f32, width: f32) -> VehicleBlueprint {
    let size = size([frame.front + frame.r, rear], width, height, [frame.front, frame.rear], frame.r);
    framed(draw, VehicleBlueprint::new(size, move || frame.assemble(Sculpt::new())))
}

fn city_frame() -> BicycleFrame {
    BicycleFrame {
        r: 0.345,
        tyre: 0.04,
        front: 0.54,
        rear: -0.52,
        crank: v(-0.08, 0.0, 0.29),
        seat: v(-0.27, 0.0, 0.90),
        head: v(0.37, 0.0, 0.86),
        knot: v(-0.235, 0.0, 0.78),
        grip: v(0.22, 0.27, 1.04),
        bar: HandlebarShape::Swept,
        guards: true,
        rack: true,
        lean_rad: 0.30,
        helmet: 0.55,
    }
}

/// With mudguards and a rack; some frames to step through.
pub(crate) fn city(draw: &DesignDraw) -> VehicleBlueprint {
    let frame = city_frame();
    let knot = if draw.chance("step through", 0.45) { v(-0.135, 0.0, 0.46) } else { frame.knot };
    blueprint(draw, BicycleFrame { knot, ..frame }, -0.893, 1.062, 0.576)
}

/// Drop bars, thin tyres, nothing else.
pub(crate) fn road(draw: &DesignDraw) -> VehicleBlueprint {
    let frame = BicycleFrame {
        r: 0.335,
        tyre: 0.026,
        front: 0.50,
        rear: -0.49,
        crank: v(-0.08, 0.0, 0.27),
        seat: v(-0.29, 0.0, 0.95),
        head: v(0.36, 0.0, 0.83),
        knot: v(-0.245, 0.0, 0.78),
        grip: v(0.44, 0.20, 0.89),
        bar: HandlebarShape::Drop,
        guards: false,
        rack: false,
        lean_rad: 0.72,
        helmet: 0.9,
    };
    blueprint(draw, frame, -0.825, 0.985, 0.456)
}

/// Flat bar, fat tyres.
pub(crate) fn mountain(draw: &DesignDraw) -> VehicleBlueprint {
    let frame = BicycleFrame {
        r: 0.355,
        tyre: 0.058,
        front: 0.57,
        rear: -0.53,
        crank: v(-0.09, 0.0, 0.32),
        seat: v(-0.28, 0.0, 0.93),
        head: v(0.36, 0.0, 0.86),
        knot: v(-0.20, 0.0, 0.72),
        grip: v(0.34, 0.33, 0.985),
        bar: HandlebarShape::Flat,
        guards: false,
        rack: false,
        lean_rad: 0.45,
        helmet: 0.7,
    };
    blueprint(draw, frame, -0.885, 1.0, 0.76)
}

/// A long wheelbase with a box before the rider.
pub(crate) fn cargo(draw: &DesignDraw) -> VehicleBlueprint {
    let frame =
        BicycleFrame { r: 0.275, front: 1.22, rear: -0.62, head: v(0.37, 0.0, 0.84), rack: false, ..city_frame() };
    let (wooden, high) = (draw.chance("wooden", 0.5), draw.range("box", 0.70, 0.82));
    let rear = frame.rear - frame.r - 0.028;
    let size = size([frame.front + frame.r, rear], 0.58, 1.062, [frame.front, frame.rear], frame.r);
    let blueprint = VehicleBlueprint::new(size, move || {
        let mut s = Sculpt::new();
        let skin = if wooden { paint::WOOD } else { paint::TRIM };
        let (x0, x1, y, z) = (0.34, 0.93, 0.29, 0.26);
        let slab = |low: Vec3, high: Vec3| Sculpt::cuboid(low, high, 0.0, skin);
        s.add(slab(v(x0, -y, z), v(x1, y, z + 0.02)));
        s.add(slab(v(x0, y - 0.015, z + 0.02), v(x1, y, high)).both_sides());
        s.add(slab(v(x0, -y + 0.015, z + 0.02), v(x0 + 0.015, y - 0.015, high + 0.04)));
        s.add(slab(v(x1 - 0.015, -y + 0.015, z + 0.02), v(x1, y - 0.015, high)));
        s.add(rod(v(-0.08, 0.0, 0.25), v(1.0, 0.0, 0.22), 0.025, paint::BODY));
        s.add(rod(v(1.0, 0.0, 0.22), v(1.12, 0.0, 0.66), 0.022, paint::BODY));
        frame.assemble(s)
    });
    framed(draw, blueprint)
}

impl BicycleFrame {
    fn assemble(&self, mut s: Sculpt) -> Assembly {
        let Self { r, front, rear, crank, seat, head, knot, grip, .. } = *self;
        let tubes = [
            (crank, seat - v(0.0, 0.0, 0.07), 0.017),
            (head - v(0.0, 0.0, 0.10) * 0.6, crank, 0.020),
            (if knot.z < 0.6 { head - v(0.0, 0.0, 0.03) } else { head }, knot, 0.017),
        ];
        for (a, b, radius) in tubes {
            s.add(rod(a, b, radius, paint::BODY));
        }
        let stay = v(-0.235, 0.0, seat.z - 0.12);
        s.add(rod(crank, v(rear, 0.045, r), 0.011, paint::BODY).both_sides());
        s.add(rod(stay, v(rear, 0.045, r), 0.009, paint::BODY).both_sides());
        let crown = v(head.x.max(front - 0.15) + 0.04, 0.0, (head.z - 0.14).min(2.0 * r + 0.03));
        let fork = [
            (v(front, 0.045, r), 0.010),
            (crown.with_y(0.045) - v(0.0, 0.0, 0.08), 0.013),
            (crown.with_y(0.02), 0.016),
        ];
        s.add(Sculpt::tube(&fork, 8, paint::BODY).both_sides());
        s.add(rod(crown, crown + v(-0.02, 0.0, 0.14), 0.018, paint::BODY));
        let stem = v(head.x - 0.025, 0.0, grip.z.max(head.z + 0.05) - 0.05);
        s.add(rod(v(head.x + 0.05, 0.0, head.z - 0.16), stem, 0.017, paint::BODY));
        self.handlebar(&mut s, stem);
        s.add(Sculpt::ellipsoid(v(head.x + 0.07, 0.0, head.z - 0.02), v(0.035, 0.032, 0.03), 10, paint::WHITE));
        self.saddle(&mut s);
        self.drive(&mut s);
        if self.guards {
            self.guard(&mut s);
        }
        if self.rack {
            self.carrier(&mut s);
        }
        let lamp = if self.rack { v(-0.775, 0.0, 0.70) } else { v(seat.x - 0.07, 0.0, seat.z - 0.16) };
        s.add(Sculpt::cuboid(lamp - v(0.0, 0.035, 0.0), lamp + v(0.02, 0.035, 0.04), 0.006, paint::TAIL));
        let mut a = Assembly::new(s, wheel(r, self.tyre, 0.91, Rim::Wire, paint::STEEL), r);
        a.single(front, true);
        a.single(rear, false);
        a.fit = Some(RiderFit {
            seat: seat + v(-0.03, 0.0, 0.03),
            grip,
            foot: crank + v(0.035, 0.145, -0.15),
            right_foot: v(-0.07, 0.0, 0.33),
            lean_rad: self.lean_rad,
            helmet: self.helmet,
            helmets: HelmetKind::Cycle,
            outfit: Outfit::Fair,
            standing: false,
            pillion: None,
        });
        a
    }

    fn handlebar(&self, s: &mut Sculpt, stem: Vec3) {
        let grip = self.grip;
        let path = match self.bar {
            HandlebarShape::Swept => vec![
                (stem, 0.012),
                (stem + v(0.03, 0.12, 0.045), 0.012),
                (grip + v(0.08, 0.0, 0.005), 0.012),
                (grip - v(0.06, 0.0, 0.0), 0.012),
            ],
            HandlebarShape::Flat => {
                vec![(stem, 0.013), (stem + v(0.03, 0.10, 0.03), 0.013), (grip + v(0.0, 0.02, 0.0), 0.013)]
            }
            HandlebarShape::Drop => vec![
                (stem, 0.013),
                (stem + v(0.05, 0.19, 0.0), 0.013),
                (grip + v(0.04, 0.01, -0.03), 0.014),
                (grip + v(0.02, 0.01, -0.12), 0.014),
                (grip + v(-0.08, 0.01, -0.14), 0.014),
            ],
        };
        s.add(Sculpt::tube(&path, 8, paint::STEEL).both_sides());
        let (from, to) = match self.bar {
            HandlebarShape::Swept => (grip + v(0.05, 0.0, 0.0), grip - v(0.07, 0.0, 0.0)),
            HandlebarShape::Flat => (grip - v(0.0, 0.07, 0.0), grip + v(0.0, 0.05, 0.0)),
            HandlebarShape::Drop => (grip + v(0.03, 0.01, 0.0), grip + v(0.045, 0.01, -0.05)),
        };
        s.add(rod(from, to, 0.018, paint::RUBBER).both_sides());
    }

    fn saddle(&self, s: &mut Sculpt) {
        let seat = self.seat;
        s.add(Sculpt::sweep(
            &[
                (seat + v(0.16, 0.0, 0.005), Vec2::new(0.015, 0.012)),
                (seat + v(0.08, 0.0, 0.01), Vec2::new(0.032, 0.025)),
                (seat + v(-0.05, 0.0, 0.015), Vec2::new(0.085, 0.032)),
                (seat + v(-0.12, 0.0, 0.02), Vec2::new(0.075, 0.022)),
            ],
            Vec3::Y,
            12,
            2.2,
            true,
            paint::SEAT,
        ));
        s.add(rod(seat - v(0.0, 0.0, 0.10), seat, 0.013, paint::STEEL));
    }

    /// Chain wheel, cranks, pedals, chain.
    fn drive(&self, s: &mut Sculpt) {
        let Self { crank, rear, r, .. } = *self;
        let ring = Sculpt::post(v(0.0, 0.0, -0.004), 0.008, 0.095, 0.095, 20, paint::STEEL);
        let upright = Affine3A::from_rotation_translation(Quat::from_rotation_x(FRAC_PI_2), crank - v(0.0, 0.05, 0.0));
        s.add(ring.placed(upright));
        for (y, z) in [(0.09f32, -0.165f32), (-0.09, 0.165)] {
            let pedal = crank + v(0.035 * y.signum(), y, z);
            s.add(rod(crank + v(0.0, y * 0.75, 0.0), pedal, 0.011, paint::STEEL));
            let side = 0.055 * y.signum();
            s.add(Sculpt::cuboid(
                pedal + v(-0.045, side - 0.045, -0.012),
                pedal + v(0.045, side + 0.045, 0.012),
                0.0,
                paint::TRIM,
            ));
        }
        for z in [0.088, -0.04] {
            s.add(rod(crank + v(0.0, -0.05, z), v(rear, -0.05, r + z * 0.4), 0.005, paint::CHASSIS));
        }
    }

    fn guard(&self, s: &mut Sculpt) {
        for (x, from, to) in [(self.front, 30.0f32, 190.0f32), (self.rear, 20.0, 180.0)] {
            let reach = self.r + 0.022;
            let path: Vec<(Vec3, Vec2)> = (0..=10)
                .map(|i| {
                    let angle = (from + (to - from) * i as f32 / 10.0).to_radians();
                    let (sin, cos) = endless_world::math::sin_cos(angle);
                    (v(x + cos * reach, 0.0, self.r + sin * reach), Vec2::new(0.026, 0.006))
                })
                .collect();
            s.add(Sculpt::sweep(&path, Vec3::Y, 6, 2.0, true, paint::TRIM));
        }
    }

    fn carrier(&self, s: &mut Sculpt) {
        s.add(rod(v(-0.30, 0.06, 0.745), v(-0.74, 0.06, 0.745), 0.007, paint::STEEL).both_sides());
        s.add(rod(v(self.rear, 0.06, self.r), v(-0.62, 0.06, 0.745), 0.006, paint::STEEL).both_sides());
        for i in 0..4 {
            let x = -0.36 - 0.12 * i as f32;
            s.add(rod(v(x, -0.06, 0.745), v(x, 0.06, 0.745), 0.006, paint::STEEL));
        }
    }
}
