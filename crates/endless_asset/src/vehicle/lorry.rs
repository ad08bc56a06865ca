//! Lorries: a cab over the front axle and a chassis, drawn as those of twelve tons; heavier and lighter ones are larger
//! and smaller.

use super::assemble::{Assembly, VehicleBlueprint, VehicleMeasures};
use super::car::{open_arch, plate};
use super::paint;
use super::shell::{Arch, BodyOutline, Greenhouse, Shell};
use super::wheel::{Rim, wheel};
use crate::shape::{MonotoneCubic, Region, Sculpt, rounded};
use endless_scene::Material;
use glam::Vec3;

const HALF_WIDTH: f32 = 1.15;
const WHEEL: f32 = 0.44;
const AXLE_D: f32 = 1.15;
/// Top of the ordinary cab.
pub(super) const CAB_TOP: f32 = 2.58;
const FLOOR: f32 = 0.48;
const BELT: f32 = 1.55;
/// Top of the chassis.
pub(super) const FRAME_Z: f32 = 0.98;
/// Half width of bodies on the chassis.
pub(super) const BODY_HALF_WIDTH: f32 = 1.2;

/// Kinds of cabs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Cab {
    /// Two or three seats.
    Day,
    /// With a bunk and a high roof.
    Sleeper,
    /// With a second row of seats.
    Crew,
}

impl Cab {
    /// Depth, metres.
    pub(super) fn length(self) -> f32 {
        match self {
            Self::Day => 1.95,
            Self::Sleeper => 2.12,
            Self::Crew => 2.85,
        }
    }

    fn top(self) -> f32 {
        if self == Self::Sleeper { CAB_TOP + 0.62 } else { CAB_TOP }
    }
}

/// Measures of a lorry; distances from the front, metres.
#[derive(Debug, Clone)]
pub(super) struct Lorry {
    pub(super) length: f32,
    pub(super) cab: Cab,
    pub(super) rear_axles_d: Vec<f32>,
    /// Height of what it carries or of its cab, whichever is higher.
    pub(super) height: f32,
}

impl Lorry {
    /// x of the front of what it carries.
    pub(super) fn body_front(&self) -> f32 {
        -self.cab.length() - 0.13
    }

    /// With what it carries: built in the cab's frame, front at x = 0.
    pub(super) fn blueprint(self, cargo: impl FnOnce(&Self) -> Sculpt + 'static) -> VehicleBlueprint {
        let last = self.rear_axles_d[self.rear_axles_d.len() - 1];
        let size = VehicleMeasures {
            front: 0.012,
            rear: -self.length - 0.03,
            width: 2.0 * BODY_HALF_WIDTH,
            height: self.height,
            axles: [-AXLE_D, -last],
            wheel_radius: WHEEL,
        };
        VehicleBlueprint::new(size, move || self.build(cargo))
    }

    fn build(&self, cargo: impl FnOnce(&Self) -> Sculpt) -> Assembly {
        let mut body = cab(self.cab);
        body.add(chassis(self.length, &self.rear_axles_d, (AXLE_D + 1.5).max(self.cab.length() + 0.1)));
        body.add(cargo(self));
        let mut assembly = Assembly::new(body, wheel(WHEEL, 0.27, 0.60, Rim::Steel, paint::STEEL), WHEEL);
        assembly.axle(-AXLE_D, 0.98, true);
        // Twin tyres behind.
        for d in &self.rear_axles_d {
            assembly.axle(-d, 0.98, false);
            assembly.axle(-d, 0.68, false);
        }
        let lamp = Vec3::new(-0.08, HALF_WIDTH - 0.33, 0.85);
        assembly.headlights = vec![lamp, Vec3::new(lamp.x, -lamp.y, lamp.z)];
        assembly
    }
}

pub(super) fn rect(a0: f32, a1: f32, b0: f32, b1: f32) -> [(f32, f32); 4] {
    [(a0, b0), (a1, b0), (a1, b1), (a0, b1)]
}

/// The cab, its front at x = 0.
fn cab(kind: Cab) -> Sculpt {
    let (length, top) = (kind.length(), kind.top());
    let outline = BodyOutline {
        front: 0.0,
        rear: -length,
        half_width: HALF_WIDTH,
        bow: [0.10, 0.0],
        corner: [0.22, 0.06],
        taper: [0.02, 0.0],
    };
    let flat = |z: f32| MonotoneCubic::new(&[(-9.0, z), (9.0, z)]);
    let arch = Arch { x: -AXLE_D, z: WHEEL, radius: WHEEL + 0.10, flare: 0.015 };
    let shell = Shell {
        outline,
        section: vec![
            (0.0, 0.08, 0.10, 0.0),
            (0.04, 0.02, 0.02, 0.0),
            (0.2, 0.0, 0.0, 0.0),
            (0.42, 0.0, 0.0, 0.0),
            (0.48, 0.0, 0.03, 0.0),
            (0.8, 0.0, 0.05, 0.0),
            (1.0, 0.01, 0.07, 0.0),
        ],
        sill: flat(FLOOR),
        belt: flat(BELT),
        deck: flat(BELT),
        cabin: Greenhouse {
            foot: outline.inset(0.015, 0.075, 0.0),
            top: outline.inset(0.10, 0.30, 0.06),
            roof: MonotoneCubic::new(&[(-length, top), (-0.9, top), (-0.2, top - 0.10)]),
            edge_drop: 0.10,
            bulge: 0.01,
        },
        arches: vec![arch],
    };
    let mut body = shell.sculpt(paint::BODY);
    let w = HALF_WIDTH;
    let front =
        |polygon: &[(f32, f32)], r: f32| Region::end(&rounded(polygon, r)).facing(Vec3::X, 0.25).beyond(Vec3::X, -0.6);
    let side =
        |polygon: &[(f32, f32)], r: f32| Region::side(&rounded(polygon, r)).facing(Vec3::Y, 0.5).beyond(Vec3::Y, 0.6);
    body.paint(&Region::all().facing(-Vec3::Z, 0.5).within(Vec3::Z, 0.8), paint::DARK);
    body.paint(
        &front(&[(-w + 0.05, BELT), (w - 0.05, BELT), (w - 0.14, CAB_TOP - 0.22), (-w + 0.14, CAB_TOP - 0.22)], 0.10),
        paint::TRIM,
    );
    body.paint(
        &front(
            &[
                (-w + 0.10, BELT + 0.05),
                (w - 0.10, BELT + 0.05),
                (w - 0.19, CAB_TOP - 0.26),
                (-w + 0.19, CAB_TOP - 0.26),
            ],
            0.10,
        ),
        paint::GLASS,
    );
    let window = [(-1.22, BELT + 0.05), (-0.42, BELT - 0.10), (-0.55, CAB_TOP - 0.30), (-1.22, CAB_TOP - 0.28)];
    body.paint_both(&side(&window, 0.08), paint::TRIM);
    let pane = [(-1.19, BELT + 0.08), (-0.46, BELT - 0.06), (-0.58, CAB_TOP - 0.33), (-1.19, CAB_TOP - 0.31)];
    body.paint_both(&side(&pane, 0.08), paint::GLASS);
    if kind == Cab::Crew {
        let window = [(-2.62, BELT + 0.05), (-1.50, BELT + 0.05), (-1.50, CAB_TOP - 0.28), (-2.62, CAB_TOP - 0.28)];
        body.paint_both(&side(&window, 0.08), paint::TRIM);
        let pane = [(-2.59, BELT + 0.08), (-1.53, BELT + 0.08), (-1.53, CAB_TOP - 0.31), (-2.59, CAB_TOP - 0.31)];
        body.paint_both(&side(&pane, 0.08), paint::GLASS);
        body.paint_both(&side(&rect(-2.72, -2.707, FLOOR + 0.3, CAB_TOP - 0.2), 0.0), paint::DARK);
    }
    for x in [-1.34, -0.33] {
        body.paint_both(&side(&rect(x, x + 0.013, FLOOR + 0.3, CAB_TOP - 0.2), 0.0), paint::DARK);
    }
    body.add(
        Sculpt::ellipsoid(Vec3::new(-1.2, w + 0.003, BELT - 0.22), Vec3::new(0.09, 0.022, 0.018), 10, paint::TRIM)
            .both_sides(),
    );
    // Grille in bars, bumper, lamps.
    for i in 0..4 {
        let z = 1.02 + 0.095 * i as f32;
        body.paint(&front(&rect(-0.72, 0.72, z, z + 0.06), 0.02), paint::DARK);
    }
    body.paint(&front(&rect(-w, w, FLOOR, 0.72), 0.0), paint::TRIM);
    body.paint(&side(&rect(-0.6, 0.1, FLOOR, 0.72), 0.0), paint::TRIM);
    body.paint_both(&front(&rect(w - 0.48, w - 0.06, 0.74, 0.96), 0.04), paint::DARK);
    body.paint_both(&front(&rect(w - 0.46, w - 0.20, 0.76, 0.94), 0.04), paint::HEAD);
    body.paint(&front(&rect(w - 0.18, w - 0.08, 0.77, 0.93), 0.02), paint::LEFT);
    body.paint(&front(&rect(w - 0.18, w - 0.08, 0.77, 0.93), 0.02).mirrored(), paint::RIGHT);
    open_arch(&mut body, &arch, HALF_WIDTH, true);
    plate(&mut body, Vec3::new(0.005, 0.0, 0.60), 1.0);
    let mirror = [
        (Vec3::new(-0.35, w - 0.04, 2.25), 0.016),
        (Vec3::new(-0.22, w + 0.14, 2.25), 0.016),
        (Vec3::new(-0.22, w + 0.14, 1.6), 0.016),
    ];
    body.add(Sculpt::tube(&mirror, 6, paint::TRIM).both_sides());
    body.add(
        Sculpt::cuboid(Vec3::new(-0.26, w + 0.05, 1.72), Vec3::new(-0.18, w + 0.24, 2.16), 0.025, paint::TRIM)
            .both_sides(),
    );
    for y in [-0.5, 0.3] {
        body.add(Sculpt::tube(
            &[(Vec3::new(-0.03, y, BELT + 0.03), 0.011), (Vec3::new(-0.10, y + 0.55, BELT + 0.2), 0.008)],
            5,
            paint::DARK,
        ));
    }
    body
}

/// Frame rails, tank, guards and the lamp bar; front at x = 0.
fn chassis(length: f32, rear_axles_d: &[f32], tank_d: f32) -> Sculpt {
    let mut s = Sculpt::new();
    let rear = -length;
    s.add(
        Sculpt::cuboid(Vec3::new(rear + 0.1, 0.32, 0.72), Vec3::new(-0.6, 0.42, FRAME_Z), 0.0, paint::CHASSIS)
            .both_sides(),
    );
    s.add(Sculpt::cuboid(
        Vec3::new(-AXLE_D - 0.06, -0.9, WHEEL - 0.06),
        Vec3::new(-AXLE_D + 0.06, 0.9, WHEEL + 0.06),
        0.0,
        paint::CHASSIS,
    ));
    for d in rear_axles_d {
        s.add(Sculpt::cuboid(
            Vec3::new(-d - 0.08, -0.9, WHEEL - 0.08),
            Vec3::new(-d + 0.08, 0.9, WHEEL + 0.08),
            0.0,
            paint::CHASSIS,
        ));
    }
    let (first, last) = (rear_axles_d[0], rear_axles_d[rear_axles_d.len() - 1]);
    let tank = -tank_d;
    s.add(Sculpt::cuboid(Vec3::new(tank - 0.85, 0.55, 0.42), Vec3::new(tank, 1.05, 0.90), 0.10, paint::STEEL));
    s.add(Sculpt::cuboid(Vec3::new(tank - 0.6, -1.05, 0.45), Vec3::new(tank, -0.55, 0.90), 0.04, paint::CHASSIS));
    // Side guards and mudguards.
    if tank - 0.95 > -first + 0.72 {
        for z in [0.48, 0.72] {
            let (low, high) = (Vec3::new(-first + 0.62, 1.06, z), Vec3::new(tank - 0.95, 1.09, z + 0.10));
            s.add(Sculpt::cuboid(low, high, 0.0, paint::STEEL).both_sides());
        }
    }
    for x in [-last - 0.60, -first + 0.58] {
        s.add(
            Sculpt::cuboid(Vec3::new(x, 0.60, 0.45), Vec3::new(x + 0.02, 1.12, 0.95), 0.0, paint::RUBBER).both_sides(),
        );
    }
    // Rear bumper bar with lamps.
    s.add(Sculpt::cuboid(Vec3::new(rear, -1.12, 0.50), Vec3::new(rear + 0.10, 1.12, 0.66), 0.02, paint::CHASSIS));
    let lamp = |y0: f32, y1: f32, m: Material| {
        Sculpt::cuboid(Vec3::new(rear - 0.015, y0, 0.70), Vec3::new(rear + 0.05, y1, 0.86), 0.012, m)
    };
    s.add(lamp(0.86, 1.10, paint::TAIL).both_sides());
    s.add(lamp(0.72, 0.85, paint::LEFT));
    s.add(lamp(0.72, 0.85, paint::RIGHT).mirrored());
    s.add(lamp(0.60, 0.71, paint::REVERSE).both_sides());
    plate(&mut s, Vec3::new(rear, 0.0, 0.78), -1.0);
    s
}
