//! Auto-rickshaws: tuk-tuk, bajaj, mototaxi.

use super::{block, plank};
use crate::shape::{Region, Sculpt};
use crate::vehicle::assemble::{Assembly, VehicleBlueprint, VehicleMeasures};
use crate::vehicle::car::plate;
use crate::vehicle::draw::DesignDraw;
use crate::vehicle::paint;
use crate::vehicle::rider_fit::{HelmetKind, RiderFit};
use crate::vehicle::two_wheeler::{mudguard, rod, v};
use crate::vehicle::wheel::{Rim, wheel};
use endless_scene::{Material, Surface};
use endless_world::{ClassTag, Outfit, math};
use glam::{Vec2, Vec3};
use std::f32::consts::PI;

const RADIUS: f32 = 0.215;
const FRONT: f32 = 1.02;
const REAR: f32 = -0.92;
/// Half width of body and canopy.
const HALF: f32 = 0.635;
const FLOOR: f32 = 0.34;
/// Top of the cowl and of the panels behind.
const WAIST: f32 = 0.98;

const fn cloth(base_color: [f32; 3]) -> Material {
    Material::new(Surface::Cloth, base_color, ClassTag::Car)
}

/// Canopies: black, cream, yellow, blue, red, green.
const CANOPIES: [Material; 6] = [
    cloth([0.020; 3]),
    cloth([0.58, 0.50, 0.32]),
    cloth([0.68, 0.42, 0.02]),
    cloth([0.02, 0.08, 0.30]),
    cloth([0.34, 0.02, 0.02]),
    cloth([0.02, 0.16, 0.07]),
];

/// What is left open of a rickshaw.
#[derive(Debug, Clone, Copy)]
struct Fittings {
    canopy: Material,
    top: f32,
    rack: bool,
    band: bool,
    two_lamps: bool,
    curtains: bool,
}

/// A cabin without doors under a canopy: the driver before, a bench behind.
pub(crate) fn auto_rickshaw(draw: &DesignDraw) -> VehicleBlueprint {
    let fittings = Fittings {
        canopy: draw.pick("canopy", &CANOPIES),
        top: draw.range("height", 1.69, 1.77),
        rack: draw.chance("rack", 0.25),
        band: draw.chance("band", 0.5),
        two_lamps: draw.chance("two lamps", 0.4),
        curtains: draw.chance("side curtains", 0.35),
    };
    let size = VehicleMeasures {
        front: 1.345,
        rear: -1.335,
        width: 2.0 * HALF,
        height: fittings.top + if fittings.rack { 0.11 } else { 0.0 },
        axles: [FRONT, REAR],
        wheel_radius: RADIUS,
    };
    VehicleBlueprint::new(size, move || fittings.build()).scaled(draw.range("scale", 0.97, 1.04))
}

impl Fittings {
    fn build(&self) -> Assembly {
        let mut s = cowl();
        self.face(&mut s);
        under(&mut s);
        tub(&mut s, self.band);
        seats(&mut s);
        self.hood(&mut s);
        tail(&mut s);
        let mut a = Assembly::new(s, wheel(RADIUS, 0.115, 0.58, Rim::Steel, paint::STEEL), RADIUS);
        a.single(FRONT, true);
        // Half behind the panels.
        a.axle(REAR, HALF - 0.125, false);
        a.headlights = self.lamps().map(|y| v(1.30, y, 0.74)).collect();
        a.fit = Some(RiderFit {
            seat: v(0.10, 0.0, 0.60),
            grip: v(0.50, 0.27, 0.98),
            foot: v(0.60, 0.17, FLOOR + 0.04),
            right_foot: Vec3::ZERO,
            lean_rad: 0.04,
            helmet: 0.0,
            helmets: HelmetKind::Open,
            outfit: Outfit::Hot,
            standing: false,
            pillion: None,
        });
        a
    }

    fn lamps(&self) -> impl Iterator<Item = f32> + use<> {
        let ys: &'static [f32] = if self.two_lamps { &[0.27, -0.27] } else { &[0.0] };
        ys.iter().copied()
    }

    /// Lamps, plate and wiper.
    fn face(&self, s: &mut Sculpt) {
        for y in self.lamps() {
            let x = if y == 0.0 { 1.24 } else { 1.195 };
            let mut lamp = Sculpt::ellipsoid(v(x, y, 0.74), v(0.095, 0.10, 0.10), 16, paint::TRIM);
            lamp.paint(&Region::all().facing(Vec3::X, 0.35), paint::HEAD);
            s.add(lamp);
        }
        let lens = |m: Material| Sculpt::ellipsoid(v(1.02, 0.50, 0.74), v(0.05, 0.05, 0.045), 10, m);
        s.add(lens(paint::LEFT));
        s.add(lens(paint::RIGHT).mirrored());
        plate(s, v(1.335, 0.0, 0.54), 1.0);
        s.add(rod(v(1.18, 0.0, 0.54), v(1.33, 0.0, 0.54), 0.02, paint::CHASSIS));
    }

    /// Posts, canopy, its hind curtain with a small window.
    fn hood(&self, s: &mut Sculpt) {
        let (top, cloth) = (self.top, self.canopy);
        let roof = [
            (v(0.70, 0.0, top - 0.10), Vec2::new(0.54, 0.025)),
            (v(0.62, 0.0, top - 0.065), Vec2::new(HALF - 0.035, 0.045)),
            (v(0.20, 0.0, top - 0.055), Vec2::new(HALF - 0.01, 0.055)),
            (v(-0.70, 0.0, top - 0.055), Vec2::new(HALF - 0.01, 0.055)),
            (v(-1.12, 0.0, top - 0.085), Vec2::new(HALF - 0.02, 0.055)),
            (v(-1.20, 0.0, top - 0.13), Vec2::new(HALF - 0.06, 0.03)),
        ];
        s.add(Sculpt::sweep(&roof, Vec3::Y, 18, 5.0, true, cloth));
        // The frame of the screen, posts beside the driver's seat and behind.
        s.add(rod(v(0.87, 0.53, WAIST), v(0.63, 0.53, top - 0.07), 0.022, paint::CHASSIS).both_sides());
        s.add(rod(v(0.635, -0.53, top - 0.10), v(0.635, 0.53, top - 0.10), 0.025, paint::CHASSIS));
        s.add(rod(v(0.87, -0.53, WAIST + 0.01), v(0.87, 0.53, WAIST + 0.01), 0.02, paint::CHASSIS));
        s.add(rod(v(0.86, 0.1, WAIST + 0.03), v(0.78, -0.15, 1.22), 0.008, paint::TRIM));
        s.add(rod(v(-0.16, HALF - 0.04, FLOOR), v(-0.16, HALF - 0.04, top - 0.06), 0.02, paint::CHASSIS).both_sides());
        let (foot, head) = (Vec2::new(-1.255, WAIST - 0.04), Vec2::new(-1.13, top - 0.06));
        let mut back = plank(foot, head, 0.03, [-HALF + 0.02, HALF - 0.02], cloth);
        let window = [(-0.30, 1.22), (0.30, 1.22), (0.27, 1.42), (-0.27, 1.42)].map(Vec2::from);
        back.paint(&Region::end(&window).facing(-Vec3::X, 0.5), paint::DARK);
        s.add(back);
        // Cloth behind the bench's ends, and before them where it is let down.
        let from = if self.curtains { -0.42 } else { -0.78 };
        let side = [(-1.23, WAIST - 0.04), (from, WAIST - 0.04), (from - 0.04, top - 0.05), (-1.10, top - 0.05)];
        s.add(Sculpt::slab(&side.map(Vec2::from), HALF - 0.045, HALF - 0.02, 20.0, cloth).both_sides());
        if self.rack {
            for y in [-0.4, 0.0, 0.4] {
                s.add(rod(v(0.3, y, top + 0.06), v(-1.0, y, top + 0.06), 0.014, paint::STEEL));
            }
            for x in [0.3, -0.35, -1.0] {
                s.add(rod(v(x, -0.5, top + 0.095), v(x, 0.5, top + 0.095), 0.015, paint::STEEL));
                s.add(rod(v(x, 0.48, top - 0.03), v(x, 0.48, top + 0.095), 0.014, paint::STEEL).both_sides());
            }
        }
    }
}

/// The sheet before the driver's knees, round in plan.
fn cowl() -> Sculpt {
    // Height; x of the nose and of the ends; half width.
    const ROWS: [(f32, f32, f32, f32); 6] = [
        (0.30, 1.00, 0.74, 0.38),
        (0.42, 1.16, 0.68, 0.52),
        (0.60, 1.235, 0.64, 0.585),
        (0.80, 1.20, 0.64, 0.60),
        (0.94, 1.08, 0.66, 0.585),
        (WAIST, 0.92, 0.72, 0.56),
    ];
    let row = |inset: f32, &(z, nose, end, half): &(f32, f32, f32, f32)| -> Vec<Vec3> {
        (0..=16)
            .map(|i| {
                let (sin, cos) = math::sin_cos(PI * i as f32 / 16.0);
                let bend = |c: f32| c.signum() * math::pow(c.abs(), 0.72);
                v(end + (nose - inset - end) * bend(sin), -(half - inset) * bend(cos), z)
            })
            .collect()
    };
    let outer: Vec<_> = ROWS.iter().map(|r| row(0.0, r)).collect();
    let inner: Vec<_> = ROWS.iter().rev().map(|r| row(0.03, r)).collect();
    let mut s = Sculpt::new();
    s.grid(&outer, false, paint::BODY);
    let mut within = Sculpt::new();
    within.grid(&inner, false, paint::TRIM);
    let mut rim = Sculpt::new();
    rim.grid(&[outer[ROWS.len() - 1].clone(), inner[0].clone()], false, paint::TRIM);
    // The edges of both ends.
    for (k, flip) in [(0, false), (16, true)] {
        for (i, pair) in outer.windows(2).enumerate() {
            let (below, above) = (inner[ROWS.len() - 1 - i][k], inner[ROWS.len() - 2 - i][k]);
            let corners = [below, pair[0][k], pair[1][k], above];
            let [a, b, c, d] = corners;
            rim.quad(if flip { [d, c, b, a] } else { corners }, paint::TRIM);
        }
    }
    let mut s = s.smooth(60.0);
    s.add(within.smooth(60.0));
    s.add(rim);
    // A board over the instruments, and the handlebar below it.
    s.add(block(v(0.70, -0.52, WAIST - 0.05), v(0.90, 0.52, WAIST - 0.005), paint::TRIM));
    s.add(rod(v(0.62, 0.0, 0.42), v(0.56, 0.0, 0.98), 0.028, paint::CHASSIS));
    s.add(rod(v(0.56, 0.0, 0.98), v(0.50, 0.34, 0.98), 0.015, paint::STEEL).both_sides());
    s.add(rod(v(0.51, 0.20, 0.98), v(0.50, 0.34, 0.98), 0.021, paint::RUBBER).both_sides());
    let mirror = v(0.80, HALF + 0.04, 1.12);
    s.add(rod(v(0.76, 0.54, WAIST), mirror, 0.009, paint::TRIM).both_sides());
    s.add(Sculpt::ellipsoid(mirror, v(0.02, 0.055, 0.075), 10, paint::TRIM).both_sides());
    s
}

/// Fork, mudguard, floor and axle.
fn under(s: &mut Sculpt) {
    s.add(rod(v(FRONT, 0.085, RADIUS), v(0.86, 0.085, 0.52), 0.024, paint::CHASSIS).both_sides());
    s.add(mudguard(v(FRONT, 0.0, RADIUS), RADIUS + 0.035, 0.085, -12.0, 165.0, paint::BODY));
    s.add(block(v(-1.24, -0.55, FLOOR - 0.05), v(0.80, 0.55, FLOOR), paint::CHASSIS));
    s.add(block(v(-0.30, 0.55, FLOOR - 0.07), v(0.70, 0.60, FLOOR + 0.02), paint::BODY).both_sides());
    s.add(block(v(REAR - 0.05, -0.5, RADIUS - 0.05), v(REAR + 0.05, 0.5, RADIUS + 0.05), paint::CHASSIS));
    s.add(block(v(-1.18, -0.32, 0.17), v(-0.70, 0.32, FLOOR), paint::ENGINE));
}

/// The panels about the bench, over the rear wheels, and the engine's cover.
fn tub(s: &mut Sculpt, band: bool) {
    let side = [
        (-1.30, 0.44),
        (-1.20, 0.35),
        (-0.66, 0.35),
        (-0.60, FLOOR - 0.02),
        (-0.36, FLOOR - 0.02),
        (-0.40, 0.78),
        (-0.62, WAIST),
        (-1.26, WAIST),
    ];
    s.add(Sculpt::slab(&side.map(Vec2::from), HALF - 0.06, HALF, 20.0, paint::BODY).both_sides());
    let mut back = block(v(-1.31, -HALF + 0.02, 0.44), v(-1.22, HALF - 0.02, WAIST - 0.01), paint::BODY);
    for i in 0..5 {
        let z = 0.60 + 0.035 * i as f32;
        let slot = [(-0.26, z), (0.26, z), (0.26, z + 0.018), (-0.26, z + 0.018)].map(Vec2::from);
        back.paint(&Region::end(&slot).facing(-Vec3::X, 0.9), paint::DARK);
    }
    s.add(back);
    if band {
        let strip = [(-1.3, 0.84), (-0.42, 0.84), (-0.50, 0.91), (-1.3, 0.91)].map(Vec2::from);
        s.repaint_both(&Region::side(&strip).facing(Vec3::Y, 0.7).beyond(Vec3::Y, 0.5), paint::BODY, paint::YELLOW);
    }
    // Sheet over the rear wheels, inside of the panels.
    s.add(block(v(-1.22, 0.40, 0.455), v(-0.62, HALF - 0.05, 0.48), paint::DARK).both_sides());
    s.add(block(v(-1.22, 0.40, FLOOR - 0.02), v(-0.62, 0.42, 0.48), paint::DARK).both_sides());
}

fn seats(s: &mut Sculpt) {
    let cushion = |low: Vec3, high: Vec3| Sculpt::cuboid(low, high, 0.04, paint::SEAT);
    s.add(block(v(-0.20, -0.34, FLOOR), v(0.22, 0.34, 0.48), paint::CHASSIS));
    s.add(cushion(v(-0.20, -0.36, 0.47), v(0.26, 0.36, 0.59)));
    s.add(cushion(v(-0.28, -0.36, 0.57), v(-0.19, 0.36, 0.92)));
    s.add(block(v(-1.15, -0.55, 0.48), v(-0.62, 0.55, 0.60), paint::CHASSIS));
    s.add(cushion(v(-1.12, -0.56, 0.58), v(-0.56, 0.56, 0.70)));
    s.add(cushion(v(-1.21, -0.56, 0.66), v(-1.09, 0.56, 1.22)));
}

/// Lamps and plate behind.
fn tail(s: &mut Sculpt) {
    let lamp = |z: f32, m: Material| Sculpt::cuboid(v(-1.335, 0.42, z), v(-1.30, 0.58, z + 0.075), 0.012, m);
    s.add(lamp(0.60, paint::TAIL).both_sides());
    s.add(lamp(0.685, paint::LEFT));
    s.add(lamp(0.685, paint::RIGHT).mirrored());
    plate(s, v(-1.312, 0.0, 0.86), -1.0);
    s.add(block(v(-1.33, -0.56, 0.40), v(-1.26, 0.56, 0.45), paint::CHASSIS));
}
