//! Panel van and minibus: cars with a short bonnet and a tall, straight body.

use super::VehicleSpec;
use super::assemble::Built;
use super::car::CarShape;
use super::paint;
use super::wheel::Rim;
use crate::shape::Region;
use endless_world::ObjectClass;
use glam::{Vec2, Vec3};

fn spec(name: &'static str, frequency: f64, parks: bool) -> VehicleSpec {
    VehicleSpec {
        cruise_mps: 12.5,
        acceleration_mps2: 1.5,
        frequency,
        parks,
        ..VehicleSpec::blank(name, ObjectClass::Van)
    }
}

/// Vans and minibuses.
pub(crate) fn all() -> Vec<Built> {
    let van = panel_van();
    let mut assembly = van.build(spec("van.panel", 5.5, true));
    let side = |r: Region| r.facing(Vec3::Y, 0.5).beyond(Vec3::Y, 0.6);
    // Rub strip, the sliding door's rail, and the split of the rear doors.
    let rect = |d0: f32, d1: f32, z0: f32, z1: f32| {
        [(van.x(d1), z0), (van.x(d0), z0), (van.x(d0), z1), (van.x(d1), z1)].map(Vec2::from)
    };
    assembly.body.paint_both(&side(Region::side(&rect(2.5, 5.2, 0.62, 0.72))).facing(Vec3::Y, 0.5), paint::TRIM);
    assembly.body.paint_both(&side(Region::side(&rect(3.7, 5.2, 1.30, 1.335))), paint::TRIM);
    for d in [2.48, 3.72] {
        assembly.body.paint_both(&side(Region::side(&rect(d, d + 0.014, 0.4, 2.15))), paint::DARK);
    }
    let split = Region::end(&[(-0.008, 0.4), (0.008, 0.4), (0.008, 2.2), (-0.008, 2.2)].map(Vec2::from))
        .within(Vec3::X, -2.0)
        .facing(-Vec3::X, 0.3);
    assembly.body.paint(&split, paint::DARK);
    let bus = minibus();
    vec![assembly.finish(2.0 * van.half_width), bus.build(spec("van.minibus", 2.5, true)).finish(2.0 * bus.half_width)]
}

fn panel_van() -> CarShape {
    CarShape {
        length: 5.55,
        half_width: 1.0,
        clearance: 0.22,
        wheelbase: 3.35,
        front_axle_d: 0.96,
        wheel_radius: 0.345,
        tyre_width: 0.225,
        rim: Rim::Steel,
        deck: vec![(0.10, 0.98), (0.30, 1.08), (0.60, 1.20), (0.86, 1.30), (5.4, 1.28), (5.55, 1.26)],
        belt: vec![(0.05, 0.95), (0.35, 1.06), (0.86, 1.19), (2.0, 1.22), (5.5, 1.22)],
        roof: vec![(1.45, 2.20), (1.9, 2.32), (2.5, 2.36), (4.0, 2.37), (5.4, 2.34)],
        cabin_d: [0.84, 1.62, 5.40, 5.50],
        tumblehome: 0.145,
        bow: [0.17, 0.05],
        corner: [0.26, 0.10],
        rake: [0.08, 0.0],
        pillars_d: vec![1.38],
        glass_end_d: [2.36, 2.34],
        doors_d: vec![1.20, 2.42],
        cladding: false,
        rails: false,
        upright_lamps: true,
        rear_window: true,
        tail_lamp_z: [0.80, 1.25],
        head_lamp_z: [0.78, 0.98],
    }
}

fn minibus() -> CarShape {
    CarShape {
        length: 5.95,
        wheelbase: 3.68,
        half_width: 1.01,
        roof: vec![(1.45, 2.36), (1.9, 2.52), (2.5, 2.58), (4.4, 2.59), (5.8, 2.55)],
        deck: vec![(0.10, 0.98), (0.30, 1.08), (0.60, 1.20), (0.86, 1.30), (5.8, 1.28), (5.95, 1.26)],
        belt: vec![(0.05, 0.95), (0.35, 1.06), (0.86, 1.19), (2.0, 1.22), (5.9, 1.22)],
        cabin_d: [0.84, 1.68, 5.80, 5.90],
        pillars_d: vec![1.38, 2.44, 3.55, 4.65],
        glass_end_d: [5.72, 5.68],
        doors_d: vec![1.20, 2.44, 3.60],
        ..panel_van()
    }
}
