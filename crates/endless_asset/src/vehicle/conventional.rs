//! American lorries: a long bonnet before the cab, a bunk behind it, chrome, two driven axles, and a box on two more.

use super::assemble::{Assembly, HitchMeasures, VehicleBlueprint, VehicleMeasures};
use super::car::{open_arch, plate};
use super::draw::DesignDraw;
use super::paint;
use super::shell::{Arch, BodyOutline, Greenhouse, Shell};
use super::truck::closed_box;
use super::two_wheeler::{rod, v};
use super::wheel::{Rim, wheel};
use crate::shape::{MonotoneCubic, Region, Sculpt, rounded};
use endless_scene::Material;
use glam::{Vec2, Vec3};

const HALF: f32 = 1.14;
const WHEEL: f32 = 0.50;
const FRONT_D: f32 = 1.20;
const FRAME: f32 = 1.0;
const BELT: f32 = 1.78;
const SILL: f32 = 0.56;
/// Distances from the front: foot and top of the screen, back of the doors.
const SCREEN_D: [f32; 2] = [1.98, 2.34];
const DOORS_D: f32 = 3.36;
const WHEEL_Y: f32 = 1.02;

fn block(low: Vec3, high: Vec3, material: Material) -> Sculpt {
    Sculpt::cuboid(low, high, 0.0, material)
}

/// What differs from one tractor to the next; distances from the front, metres.
#[derive(Debug, Clone, Copy)]
struct Tractor {
    cab_d: f32,
    length: f32,
    roof: f32,
    stacks: bool,
    visor: bool,
}

impl Tractor {
    fn axles_d(&self) -> [f32; 2] {
        [self.length - 1.95, self.length - 0.62]
    }

    fn kingpin(&self) -> f32 {
        -0.5 * (self.axles_d()[0] + self.axles_d()[1])
    }

    fn height(&self) -> f32 {
        if self.stacks { (self.roof + 0.32).max(3.45) } else { self.roof }
    }
}

/// Tractor and box.
pub(crate) fn conventional(draw: &DesignDraw) -> VehicleBlueprint {
    let bunk = draw.chance("bunk", 0.65);
    let cab_d = DOORS_D + if bunk { draw.range("sleeper", 0.95, 1.5) } else { 0.18 };
    let tractor = Tractor {
        cab_d,
        length: cab_d + draw.range("frame", 2.75, 2.95),
        roof: if bunk { draw.range("roof", 3.0, 3.45) } else { draw.range("day roof", 2.72, 2.85) },
        stacks: draw.chance("stacks", 0.75),
        visor: draw.chance("visor", 0.5),
    };
    let kingpin = tractor.kingpin();
    let top = draw.range("trailer height", 3.95, 4.08);
    let (ahead, long) = (0.92, draw.range("trailer", 11.9, 12.7));
    let rear = kingpin + ahead - long;
    let axles = [rear + 3.05, rear + 1.80];
    let size = VehicleMeasures {
        front: 0.10,
        rear: -tractor.length,
        width: 2.44,
        height: tractor.height().max(top),
        axles: [-FRONT_D, -tractor.axles_d()[1]],
        wheel_radius: WHEEL,
    };
    let joint = HitchMeasures {
        hitch: kingpin,
        axle: 0.5 * (axles[0] + axles[1]),
        front: kingpin + ahead,
        towing_rear: -tractor.length,
    };
    VehicleBlueprint::new(size, move || tractor.build()).towing(joint, rear - 0.03, top, move || {
        let mut body = closed_box(-rear, kingpin + ahead, FRAME + 0.20, top, false);
        body.add(bogie(kingpin, rear, axles));
        (body, axles.iter().flat_map(|&x| [(x, WHEEL_Y), (x, WHEEL_Y - 0.32)]).collect())
    })
}

impl Tractor {
    fn build(&self) -> Assembly {
        let mut s = self.cab();
        self.frame(&mut s);
        let mut a = Assembly::new(s, wheel(WHEEL, 0.28, 0.58, Rim::Steel, paint::BRIGHT_STEEL), WHEEL);
        a.axle(-FRONT_D, WHEEL_Y, true);
        for d in self.axles_d() {
            a.axle(-d, WHEEL_Y, false);
            a.axle(-d, WHEEL_Y - 0.32, false);
        }
        let lamp = v(-0.20, 0.83, 1.12);
        a.headlights = vec![lamp, v(lamp.x, -lamp.y, lamp.z)];
        a
    }

    fn cab(&self) -> Sculpt {
        let outline = BodyOutline {
            front: 0.0,
            rear: -self.cab_d,
            half_width: HALF,
            bow: [0.22, 0.0],
            corner: [0.34, 0.08],
            taper: [0.10, 0.0],
        };
        let curve = |points: &[(f32, f32)]| MonotoneCubic::new(points);
        let arch = Arch { x: -FRONT_D, z: WHEEL, radius: WHEEL + 0.11, flare: 0.03 };
        let shell = Shell {
            outline,
            section: vec![
                (0.0, 0.08, 0.12, 0.0),
                (0.05, 0.02, 0.03, 0.0),
                (0.3, 0.0, 0.0, 0.0),
                (0.6, 0.0, 0.01, 0.0),
                (0.85, 0.03, 0.03, 0.0),
                (1.0, 0.10, 0.08, 0.0),
            ],
            sill: curve(&[(-9.0, SILL), (9.0, SILL)]),
            // Wings lie lower than the bonnet between them.
            belt: curve(&[(-9.0, BELT), (-2.5, BELT), (-1.9, BELT - 0.10), (-0.9, 1.42), (0.0, 1.28)]),
            deck: curve(&[(-9.0, BELT), (-2.0, BELT), (-1.0, 1.70), (-0.1, 1.60)]),
            cabin: Greenhouse {
                foot: BodyOutline {
                    front: -SCREEN_D[0],
                    bow: [0.14, 0.0],
                    corner: [0.14, 0.08],
                    taper: [0.02, 0.0],
                    ..outline.inset(0.09, 0.0, 0.0)
                },
                top: BodyOutline {
                    front: -SCREEN_D[1],
                    bow: [0.12, 0.0],
                    corner: [0.16, 0.08],
                    taper: [0.02, 0.0],
                    ..outline.inset(0.15, 0.0, 0.03)
                },
                roof: curve(&[
                    (-9.0, self.roof),
                    (-DOORS_D - 0.25, self.roof),
                    (-DOORS_D + 0.5, (2.72 + 0.35 * (self.roof - 2.72)).min(self.roof)),
                    (-SCREEN_D[1], 2.66),
                ]),
                edge_drop: 0.10,
                bulge: 0.01,
            },
            arches: vec![arch],
        };
        let mut s = shell.sculpt(paint::BODY);
        s.paint(&Region::all().facing(-Vec3::Z, 0.5).within(Vec3::Z, 0.9), paint::DARK);
        glass(&mut s);
        nose(&mut s);
        open_arch(&mut s, &arch, HALF, true);
        s
    }

    /// Rails, tanks, steps, stacks, fifth wheel, guards, lamps.
    fn frame(&self, s: &mut Sculpt) {
        let [first, last] = self.axles_d().map(|d| -d);
        let rear = -self.length;
        s.add(block(v(rear + 0.05, 0.34, 0.72), v(-0.5, 0.44, FRAME), paint::CHASSIS).both_sides());
        for x in [-FRONT_D, first, last] {
            s.add(block(v(x - 0.08, -0.9, WHEEL - 0.08), v(x + 0.08, 0.9, WHEEL + 0.08), paint::CHASSIS));
        }
        let tank = |x: f32, r: f32| (v(x, 0.84, 0.66), Vec2::splat(r));
        let round = [tank(-DOORS_D - 0.15, 0.24), tank(-DOORS_D - 0.11, 0.29), tank(-2.14, 0.29), tank(-2.10, 0.24)];
        s.add(Sculpt::sweep(&round, Vec3::Y, 20, 2.0, true, paint::CHROME).both_sides());
        for x in [-2.35, -3.1] {
            s.add(block(v(x - 0.2, 1.0, 0.90), v(x + 0.2, 1.15, 0.94), paint::STEEL).both_sides());
        }
        if self.stacks {
            let x = -self.cab_d - 0.12;
            let pipe = [
                (v(x, 1.0, 1.0), 0.06),
                (v(x, 1.0, 1.45), 0.06),
                (v(x, 1.0, 1.5), 0.11),
                (v(x, 1.0, 2.55), 0.11),
                (v(x, 1.0, 2.62), 0.065),
                (v(x, 1.0, self.height()), 0.065),
            ];
            s.add(Sculpt::tube(&pipe, 12, paint::CHROME).both_sides());
        }
        let pin = self.kingpin();
        s.add(Sculpt::post(v(pin, 0.0, FRAME + 0.02), 0.14, 0.46, 0.44, 20, paint::CHASSIS));
        s.add(block(v(pin - 0.5, -0.34, FRAME - 0.02), v(pin + 0.5, 0.34, FRAME + 0.04), paint::CHASSIS));
        for x in [last - WHEEL - 0.10, first + WHEEL + 0.06] {
            s.add(block(v(x, 0.62, 0.45), v(x + 0.025, 1.17, 1.06), paint::RUBBER).both_sides());
        }
        s.add(block(v(rear, -0.55, 0.70), v(rear + 0.08, 0.55, FRAME - 0.05), paint::CHASSIS));
        let lamp = |y0: f32, y1: f32, m: Material| block(v(rear - 0.01, y0, 0.80), v(rear + 0.03, y1, 0.90), m);
        s.add(lamp(0.30, 0.50, paint::TAIL).both_sides());
        if self.visor {
            let at = |x: f32, z: f32| Vec2::new(x, z);
            let shade = [at(-SCREEN_D[1] - 0.05, 2.60), at(-SCREEN_D[1] + 0.28, 2.44), at(-SCREEN_D[1] + 0.27, 2.48)];
            let shade = [shade[0], shade[1], shade[2], at(-SCREEN_D[1] - 0.05, 2.66)];
            s.add(Sculpt::slab(&shade, -0.88, 0.88, 30.0, paint::CHROME));
        }
        // Mirrors, and lamps over the screen.
        for z in [1.95, 2.45] {
            s.add(
                rod(v(-SCREEN_D[1], 0.95, z), v(-SCREEN_D[0] - 0.05, HALF + 0.16, z), 0.016, paint::CHROME)
                    .both_sides(),
            );
        }
        let mirror = v(-SCREEN_D[0] - 0.06, HALF + 0.16, 2.2);
        s.add(
            Sculpt::cuboid(mirror - v(0.04, 0.09, 0.30), mirror + v(0.04, 0.09, 0.28), 0.03, paint::CHROME)
                .both_sides(),
        );
    }
}

/// Screen in two panes, side windows.
fn glass(s: &mut Sculpt) {
    let front = |y0: f32, y1: f32, m: f32| {
        let polygon = [
            (y0 + m, BELT + 0.06 + m),
            (y1 - m, BELT + 0.06 + m),
            (y1 - m - 0.05, 2.54 - m),
            (y0 + m + 0.05, 2.54 - m),
        ];
        Region::end(&rounded(&polygon, 0.05))
            .facing(Vec3::X, 0.22)
            .beyond(Vec3::X, -SCREEN_D[1] - 0.3)
            .within(Vec3::X, -SCREEN_D[0] + 0.05)
    };
    s.paint(&front(-0.98, 0.98, 0.0), paint::TRIM);
    s.paint(&front(-0.96, 0.0, 0.02), paint::GLASS);
    s.paint(&front(0.0, 0.96, 0.02), paint::GLASS);
    let side = |m: f32| {
        let polygon = [
            (-DOORS_D + 0.14 + m, BELT + 0.04 + m),
            (-2.42 - m, BELT + 0.04 + m),
            (-2.58 - m, 2.50 - m),
            (-DOORS_D + 0.14 + m, 2.50 - m),
        ];
        Region::side(&rounded(&polygon, 0.06)).facing(Vec3::Y, 0.5).beyond(Vec3::Y, 0.6)
    };
    s.paint_both(&side(0.0), paint::TRIM);
    s.paint_both(&side(0.03), paint::GLASS);
    for x in [-DOORS_D, -2.26] {
        let gap = [(x, SILL + 0.2), (x + 0.014, SILL + 0.2), (x + 0.014, 2.52), (x, 2.52)].map(Vec2::from);
        s.paint_both(&Region::side(&gap).facing(Vec3::Y, 0.5).beyond(Vec3::Y, 0.6), paint::DARK);
    }
}

/// A tall grille in chrome, lamps on the wings, a deep bumper.
fn nose(s: &mut Sculpt) {
    let front =
        |polygon: &[(f32, f32)], r: f32| Region::end(&rounded(polygon, r)).facing(Vec3::X, 0.25).beyond(Vec3::X, -0.8);
    let field = |w: f32, z0: f32, z1: f32| [(-w, z0), (w, z0), (0.94 * w, z1), (-0.94 * w, z1)];
    s.paint(&front(&field(0.56, 0.80, 1.60), 0.06), paint::CHROME);
    s.paint(&front(&field(0.51, 0.85, 1.55), 0.05), paint::DARK);
    for i in 0..7 {
        let z = 0.90 + 0.09 * i as f32;
        s.paint(&front(&field(0.51, z, z + 0.03), 0.0), paint::CHROME);
    }
    let rect = |y0: f32, y1: f32, z0: f32, z1: f32| [(y0, z0), (y1, z0), (y1, z1), (y0, z1)];
    s.paint_both(&front(&rect(0.68, 0.98, 1.0, 1.24), 0.03), paint::DARK);
    s.paint_both(&front(&rect(0.70, 0.96, 1.02, 1.22), 0.03), paint::HEAD);
    let at = v(-0.62, HALF - 0.05, 1.20);
    let lens = |m: Material| Sculpt::ellipsoid(at, v(0.09, 0.05, 0.05), 10, m);
    s.add(lens(paint::LEFT));
    s.add(lens(paint::RIGHT).mirrored());
    let bumper = |y: f32, x: f32| (v(x, y, 0.62), Vec2::new(0.045, 0.17));
    let bar = [
        bumper(-1.16, -0.42),
        bumper(-1.10, -0.15),
        bumper(-0.7, 0.035),
        bumper(0.0, 0.05),
        bumper(0.7, 0.035),
        bumper(1.10, -0.15),
        bumper(1.16, -0.42),
    ];
    s.add(Sculpt::sweep(&bar, Vec3::X, 10, 5.0, true, paint::CHROME));
    plate(s, v(0.10, 0.0, 0.62), 1.0);
}

/// Rails, legs, axles, guard and lamps of the box.
fn bogie(kingpin: f32, rear: f32, axles: [f32; 2]) -> Sculpt {
    let floor = FRAME + 0.20;
    let mut s = block(v(rear + 0.1, 0.34, floor - 0.20), v(rear + 4.4, 0.46, floor), paint::CHASSIS).both_sides();
    s.add(block(v(kingpin - 0.9, -0.9, floor - 0.04), v(kingpin + 0.8, 0.9, floor), paint::CHASSIS));
    s.add(block(v(kingpin - 2.5, 0.70, 0.42), v(kingpin - 2.36, 0.84, floor), paint::STEEL).both_sides());
    for x in axles {
        s.add(block(v(x - 0.07, -0.9, WHEEL - 0.07), v(x + 0.07, 0.9, WHEEL + 0.07), paint::CHASSIS));
        s.add(block(v(x - 0.05, 0.36, WHEEL), v(x + 0.05, 0.44, floor - 0.1), paint::CHASSIS).both_sides());
    }
    s.add(block(v(axles[1] - 0.72, 0.64, 0.40), v(axles[1] - 0.70, 1.18, floor - 0.02), paint::RUBBER).both_sides());
    // The bar that keeps cars from going under, and the lamps above it.
    s.add(block(v(rear + 0.02, -1.05, 0.46), v(rear + 0.12, 1.05, 0.57), paint::STEEL));
    s.add(block(v(rear + 0.04, 0.45, 0.52), v(rear + 0.12, 0.53, floor), paint::STEEL).both_sides());
    s.add(block(v(rear, -1.18, floor - 0.16), v(rear + 0.12, 1.18, floor + 0.02), paint::CHASSIS));
    let lamp = |y0: f32, y1: f32, m: Material| {
        Sculpt::cuboid(v(rear - 0.015, y0, floor - 0.13), v(rear + 0.05, y1, floor - 0.02), 0.012, m)
    };
    s.add(lamp(0.92, 1.12, paint::TAIL).both_sides());
    s.add(lamp(0.76, 0.90, paint::LEFT));
    s.add(lamp(0.76, 0.90, paint::RIGHT).mirrored());
    s.add(lamp(0.62, 0.74, paint::REVERSE).both_sides());
    plate(&mut s, v(rear - 0.005, 0.0, floor - 0.08), -1.0);
    s
}
