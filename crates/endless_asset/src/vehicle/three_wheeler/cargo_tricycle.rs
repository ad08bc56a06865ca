//! Cargo tricycles: the front half of a motorcycle before a bed on an axle.

use super::block;
use crate::shape::{Region, Sculpt};
use crate::vehicle::assemble::{Assembly, VehicleBlueprint, VehicleMeasures};
use crate::vehicle::draw::DesignDraw;
use crate::vehicle::freight::Freight;
use crate::vehicle::paint;
use crate::vehicle::rider_fit::{HelmetKind, RiderFit};
use crate::vehicle::two_wheeler::{hull, indicators, mirrors_and_bars, mudguard, rod, v};
use crate::vehicle::wheel::{Rim, wheel};
use endless_scene::{Material, Surface};
use endless_world::{ClassTag, Outfit};
use glam::{Vec2, Vec3};

const RADIUS: f32 = 0.265;
const FRONT: f32 = 1.26;
const REAR: f32 = -0.92;
const HALF: f32 = 0.62;
const FLOOR: f32 = 0.60;
/// Front and rear of the bed.
const BED: [f32; 2] = [-0.02, -1.62];
const TARPAULIN: Material = Material::new(Surface::Cloth, [0.03, 0.10, 0.26], ClassTag::Car);

/// What is left open of a cargo tricycle.
#[derive(Debug, Clone, Copy)]
struct Fittings {
    walls: f32,
    freight: Freight,
    seed: u64,
    roof: bool,
}

impl Fittings {
    fn height(&self) -> f32 {
        let load = FLOOR + self.freight.height(self.walls);
        let roof = if self.roof { 1.92 } else { 0.0 };
        load.max(roof).max(MIRRORS)
    }
}

/// Top of the mirrors.
const MIRRORS: f32 = 1.325;

/// A rider before a bed with low walls; some have a roof over their head.
pub(crate) fn cargo_tricycle(draw: &DesignDraw) -> VehicleBlueprint {
    let fittings = Fittings {
        walls: draw.range("walls", 0.26, 0.42),
        freight: draw.pick("freight", &Freight::ALL),
        seed: draw.range("pieces", 0.0, 1e6) as u64,
        roof: draw.chance("roof", 0.35),
    };
    let size = VehicleMeasures {
        front: FRONT + RADIUS + 0.02,
        rear: BED[1] - 0.03,
        width: 2.0 * HALF,
        height: fittings.height(),
        axles: [FRONT, REAR],
        wheel_radius: RADIUS,
    };
    VehicleBlueprint::new(size, move || fittings.build()).scaled(draw.range("scale", 0.97, 1.04))
}

impl Fittings {
    fn build(&self) -> Assembly {
        let mut s = motorcycle();
        self.bed(&mut s);
        if self.roof {
            roof(&mut s);
        }
        let mut a = Assembly::new(s, wheel(RADIUS, 0.12, 0.66, Rim::Steel, paint::STEEL), RADIUS);
        a.single(FRONT, true);
        a.axle(REAR, HALF - 0.10, false);
        a.headlights = vec![v(1.14, 0.0, 0.86)];
        a.fit = Some(RiderFit {
            seat: v(0.30, 0.0, 0.80),
            grip: v(0.84, 0.34, 1.045),
            foot: v(0.66, 0.17, 0.36),
            right_foot: Vec3::ZERO,
            lean_rad: 0.06,
            helmet: 0.25,
            helmets: HelmetKind::Open,
            outfit: Outfit::Hot,
            standing: false,
            pillion: None,
        });
        a
    }

    /// Floor, walls, load, lamps.
    fn bed(&self, s: &mut Sculpt) {
        let [x1, x0] = BED;
        let top = FLOOR + self.walls;
        let t = 0.035;
        s.add(block(v(x0, -HALF, FLOOR - 0.05), v(x1, HALF, FLOOR), paint::BODY));
        s.add(block(v(x0, HALF - t, FLOOR), v(x1, HALF, top), paint::BODY).both_sides());
        s.add(block(v(x0, -HALF + t, FLOOR), v(x0 + t, HALF - t, top), paint::BODY));
        s.add(block(v(x1 - t, -HALF + t, FLOOR), v(x1, HALF - t, top + 0.10), paint::BODY));
        for i in 0..5 {
            let x = x0 + 0.06 + (x1 - x0 - 0.16) * i as f32 / 4.0;
            s.add(block(v(x, HALF - 0.01, FLOOR - 0.03), v(x + 0.04, HALF + 0.02, top), paint::BODY).both_sides());
        }
        let low = v(x0 + t + 0.01, -HALF + t + 0.01, FLOOR);
        let high = Vec2::new(x1 - t - 0.01, HALF - t - 0.01);
        s.add(self.freight.on(low, high, self.freight.height(self.walls), self.seed));
        // Frame and axle.
        s.add(block(v(x0 + 0.1, 0.24, FLOOR - 0.14), v(0.45, 0.30, FLOOR - 0.05), paint::CHASSIS).both_sides());
        s.add(block(v(REAR - 0.045, -0.5, RADIUS - 0.045), v(REAR + 0.045, 0.5, RADIUS + 0.045), paint::CHASSIS));
        s.add(
            block(v(REAR - 0.30, 0.27, RADIUS + 0.04), v(REAR + 0.30, 0.33, RADIUS + 0.09), paint::CHASSIS)
                .both_sides(),
        );
        s.add(rod(v(0.30, 0.0, 0.32), v(REAR, 0.0, RADIUS), 0.03, paint::STEEL));
        for x in [REAR - RADIUS - 0.07, REAR + RADIUS + 0.05] {
            s.add(block(v(x, 0.42, 0.34), v(x + 0.02, HALF - 0.01, FLOOR - 0.05), paint::RUBBER).both_sides());
        }
        let lamp = |y0: f32, y1: f32, m: Material| {
            Sculpt::cuboid(v(x0 - 0.03, y0, FLOOR - 0.13), v(x0 + 0.02, y1, FLOOR - 0.055), 0.01, m)
        };
        s.add(block(v(x0, -HALF + 0.05, FLOOR - 0.16), v(x0 + 0.04, HALF - 0.05, FLOOR - 0.05), paint::CHASSIS));
        s.add(lamp(0.40, 0.54, paint::TAIL).both_sides());
        s.add(lamp(0.28, 0.38, paint::LEFT));
        s.add(lamp(0.28, 0.38, paint::RIGHT).mirrored());
        s.add(block(v(x0 - 0.012, -0.13, FLOOR - 0.15), v(x0, 0.13, FLOOR - 0.06), paint::PLATE));
    }
}

/// Fork, lamp, tank, engine, seat.
fn motorcycle() -> Sculpt {
    let mut s = Sculpt::new();
    let head = v(0.98, 0.0, 0.93);
    s.add(rod(v(FRONT, 0.08, RADIUS), v(1.0, 0.08, 0.92), 0.027, paint::STEEL).both_sides());
    s.add(rod(v(FRONT - 0.02, 0.13, RADIUS), v(1.06, 0.12, 0.72), 0.016, paint::STEEL).both_sides());
    s.add(block(head - v(0.05, 0.12, 0.03), head + v(0.05, 0.12, 0.02), paint::ENGINE));
    let mut lamp = Sculpt::ellipsoid(v(1.08, 0.0, 0.86), v(0.10, 0.10, 0.10), 16, paint::BODY);
    lamp.paint(&Region::all().beyond(Vec3::X, 1.11), paint::HEAD);
    s.add(lamp);
    s.add(mudguard(v(FRONT, 0.0, RADIUS), RADIUS + 0.04, 0.075, 15.0, 165.0, paint::BODY));
    mirrors_and_bars(&mut s, head + v(-0.02, 0.0, 0.06), v(0.86, 0.35, 1.05));
    indicators(&mut s, v(1.04, 0.18, 0.84));
    let spine = [(head, 0.03), (v(0.86, 0.0, 0.58), 0.024), (v(0.74, 0.0, 0.28), 0.024), (v(0.20, 0.0, 0.30), 0.024)];
    s.add(Sculpt::tube(&spine, 8, paint::CHASSIS));
    s.add(rod(head, v(0.05, 0.0, 0.70), 0.03, paint::CHASSIS));
    s.add(Sculpt::cuboid(v(0.36, -0.14, 0.26), v(0.72, 0.14, 0.46), 0.05, paint::ENGINE));
    s.add(Sculpt::cuboid(v(0.52, -0.09, 0.44), v(0.72, 0.09, 0.68), 0.02, paint::ENGINE));
    s.add(rod(v(0.62, -0.14, 0.34), v(-0.10, -0.26, 0.34), 0.035, paint::STEEL));
    let tank = [
        (v(0.92, 0.0, 0.83), 0.07, 0.05),
        (v(0.80, 0.0, 0.855), 0.13, 0.10),
        (v(0.62, 0.0, 0.86), 0.145, 0.105),
        (v(0.48, 0.0, 0.82), 0.09, 0.06),
    ];
    s.add(hull(&tank, paint::BODY));
    s.add(hull(&[(v(0.50, 0.0, 0.56), 0.12, 0.13), (v(0.20, 0.0, 0.58), 0.16, 0.12)], paint::BODY));
    let seat = [
        (v(0.50, 0.0, 0.79), 0.08, 0.03),
        (v(0.36, 0.0, 0.765), 0.17, 0.05),
        (v(0.08, 0.0, 0.765), 0.20, 0.055),
        (v(0.0, 0.0, 0.77), 0.16, 0.035),
    ];
    s.add(hull(&seat, paint::SEAT));
    s.add(rod(v(0.66, -0.24, 0.33), v(0.66, 0.24, 0.33), 0.017, paint::CHASSIS));
    s
}

/// A sheet on four posts over the rider.
fn roof(s: &mut Sculpt) {
    for (x, foot, y) in [(1.02, 0.62, 0.30), (-0.02, FLOOR, HALF - 0.05)] {
        s.add(rod(v(x, y, foot), v(x * 0.95, HALF - 0.08, 1.88), 0.016, paint::CHASSIS).both_sides());
    }
    s.add(rod(v(1.02, -0.30, 0.62), v(1.02, 0.30, 0.62), 0.016, paint::CHASSIS));
    let sheet = [
        (v(1.10, 0.0, 1.86), Vec2::new(0.52, 0.015)),
        (v(1.0, 0.0, 1.89), Vec2::new(0.60, 0.03)),
        (v(-0.02, 0.0, 1.89), Vec2::new(0.60, 0.03)),
        (v(-0.12, 0.0, 1.87), Vec2::new(0.56, 0.015)),
    ];
    s.add(Sculpt::sweep(&sheet, Vec3::Y, 12, 5.0, true, TARPAULIN));
}
