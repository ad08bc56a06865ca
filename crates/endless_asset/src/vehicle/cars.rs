//! The passenger cars of the catalogue.

use super::assemble::{Assembly, Built};
use super::car::CarShape;
use super::wheel::Rim;
use super::{VehicleSpec, paint};
use crate::shape::{Region, Sculpt};
use crate::{Material, Surface};
use endless_world::{ClassTag, ObjectClass};
use glam::{Vec2, Vec3};

fn spec(name: &'static str, frequency: f64) -> VehicleSpec {
    VehicleSpec {
        cruise_mps: 13.5,
        acceleration_mps2: 2.0,
        frequency,
        parks: true,
        ..VehicleSpec::blank(name, ObjectClass::Car)
    }
}

fn finish(shape: &CarShape, assembly: Assembly) -> Built {
    assembly.finish(2.0 * shape.half_width)
}

/// All cars, from small to large.
pub(crate) fn all() -> Vec<Built> {
    let plain = [
        (city(), "car.city", 11.0),
        (hatchback(), "car.hatchback", 19.0),
        (sedan(), "car.sedan", 17.0),
        (estate(), "car.estate", 5.0),
        (suv(), "car.suv", 12.0),
        (mpv(), "car.mpv", 4.0),
    ];
    let mut models: Vec<Built> =
        plain.iter().map(|(shape, name, f)| finish(shape, shape.build(spec(name, *f)))).collect();
    models.push(taxi());
    models.push(pickup());
    models
}

fn city() -> CarShape {
    CarShape {
        length: 3.62,
        half_width: 0.82,
        clearance: 0.17,
        wheelbase: 2.42,
        front_axle_d: 0.68,
        wheel_radius: 0.285,
        tyre_width: 0.175,
        rim: Rim::Alloy(6),
        deck: vec![(0.10, 0.74), (0.30, 0.83), (0.60, 0.93), (0.86, 1.00), (3.35, 1.02), (3.6, 1.0)],
        belt: vec![(0.05, 0.72), (0.35, 0.82), (0.86, 0.92), (2.2, 0.96), (3.6, 1.01)],
        roof: vec![(1.4, 1.45), (1.75, 1.50), (2.3, 1.50), (3.0, 1.45), (3.4, 1.40)],
        cabin_d: [0.86, 1.62, 3.20, 3.52],
        tumblehome: 0.20,
        bow: [0.17, 0.10],
        corner: [0.22, 0.20],
        rake: [0.08, 0.03],
        pillars_d: vec![2.02],
        glass_end_d: [3.05, 2.86],
        doors_d: vec![0.98, 2.03, 2.85],
        cladding: false,
        rails: false,
        upright_lamps: true,
        rear_window: true,
        tail_lamp_z: [0.66, 0.94],
        head_lamp_z: [0.60, 0.74],
    }
}

fn hatchback() -> CarShape {
    CarShape {
        length: 4.08,
        half_width: 0.875,
        clearance: 0.16,
        wheelbase: 2.56,
        front_axle_d: 0.82,
        wheel_radius: 0.31,
        tyre_width: 0.205,
        rim: Rim::Alloy(5),
        deck: vec![(0.12, 0.70), (0.35, 0.80), (0.75, 0.90), (1.12, 0.97), (3.8, 1.03), (4.08, 0.98)],
        belt: vec![(0.05, 0.69), (0.40, 0.80), (1.12, 0.91), (2.4, 0.95), (4.0, 1.02)],
        roof: vec![(1.75, 1.42), (2.1, 1.465), (2.6, 1.465), (3.3, 1.42), (3.85, 1.34)],
        cabin_d: [1.12, 1.92, 3.55, 3.98],
        tumblehome: 0.215,
        bow: [0.18, 0.11],
        corner: [0.24, 0.20],
        rake: [0.10, 0.035],
        pillars_d: vec![2.35],
        glass_end_d: [3.55, 3.28],
        doors_d: vec![1.20, 2.36, 3.30],
        cladding: false,
        rails: false,
        upright_lamps: true,
        rear_window: true,
        tail_lamp_z: [0.70, 0.95],
        head_lamp_z: [0.57, 0.70],
    }
}

fn sedan() -> CarShape {
    CarShape {
        length: 4.64,
        half_width: 0.905,
        clearance: 0.16,
        wheelbase: 2.70,
        front_axle_d: 0.90,
        wheel_radius: 0.325,
        tyre_width: 0.215,
        rim: Rim::Alloy(5),
        deck: vec![(0.14, 0.70), (0.40, 0.81), (0.85, 0.90), (1.32, 0.965), (4.02, 1.085), (4.3, 1.08), (4.62, 1.03)],
        belt: vec![(0.05, 0.68), (0.45, 0.80), (1.32, 0.91), (2.6, 0.945), (4.0, 1.0), (4.6, 0.96)],
        roof: vec![(1.95, 1.39), (2.35, 1.445), (2.85, 1.45), (3.3, 1.415), (3.75, 1.34)],
        cabin_d: [1.32, 2.18, 3.42, 4.04],
        tumblehome: 0.225,
        bow: [0.19, 0.13],
        corner: [0.26, 0.22],
        rake: [0.11, 0.05],
        pillars_d: vec![2.58],
        glass_end_d: [3.82, 3.35],
        doors_d: vec![1.38, 2.59, 3.55],
        cladding: false,
        rails: false,
        upright_lamps: false,
        rear_window: true,
        tail_lamp_z: [0.74, 0.90],
        head_lamp_z: [0.57, 0.69],
    }
}

fn estate() -> CarShape {
    CarShape {
        length: 4.72,
        roof: vec![(1.95, 1.40), (2.35, 1.455), (3.0, 1.465), (3.8, 1.44), (4.45, 1.385)],
        deck: vec![(0.14, 0.70), (0.40, 0.81), (0.85, 0.90), (1.32, 0.965), (4.5, 1.03), (4.72, 0.99)],
        belt: vec![(0.05, 0.68), (0.45, 0.80), (1.32, 0.91), (2.6, 0.945), (4.6, 1.01)],
        cabin_d: [1.32, 2.18, 4.22, 4.62],
        pillars_d: vec![2.58, 3.52],
        glass_end_d: [4.36, 4.10],
        upright_lamps: true,
        rails: true,
        rake: [0.11, 0.035],
        corner: [0.26, 0.20],
        tail_lamp_z: [0.72, 0.98],
        ..sedan()
    }
}

fn suv() -> CarShape {
    CarShape {
        length: 4.52,
        half_width: 0.925,
        clearance: 0.22,
        wheelbase: 2.68,
        front_axle_d: 0.88,
        wheel_radius: 0.36,
        tyre_width: 0.235,
        rim: Rim::Alloy(5),
        deck: vec![(0.12, 0.90), (0.35, 0.98), (0.8, 1.06), (1.20, 1.12), (4.3, 1.16), (4.52, 1.12)],
        belt: vec![(0.05, 0.88), (0.40, 0.97), (1.20, 1.05), (2.6, 1.08), (4.45, 1.15)],
        roof: vec![(1.75, 1.61), (2.15, 1.665), (2.8, 1.675), (3.6, 1.64), (4.2, 1.58)],
        cabin_d: [1.22, 1.98, 3.98, 4.42],
        tumblehome: 0.205,
        bow: [0.15, 0.10],
        corner: [0.24, 0.20],
        rake: [0.07, 0.035],
        pillars_d: vec![2.42, 3.36],
        glass_end_d: [4.10, 3.90],
        doors_d: vec![1.28, 2.43, 3.38],
        cladding: true,
        rails: true,
        upright_lamps: true,
        rear_window: true,
        tail_lamp_z: [0.84, 1.10],
        head_lamp_z: [0.73, 0.87],
    }
}

fn mpv() -> CarShape {
    CarShape {
        length: 4.62,
        half_width: 0.92,
        clearance: 0.17,
        wheelbase: 2.78,
        front_axle_d: 0.92,
        wheel_radius: 0.33,
        tyre_width: 0.215,
        rim: Rim::Alloy(7),
        deck: vec![(0.12, 0.76), (0.35, 0.87), (0.7, 0.98), (1.02, 1.05), (4.4, 1.08), (4.62, 1.04)],
        belt: vec![(0.05, 0.74), (0.40, 0.86), (1.02, 0.98), (2.6, 1.01), (4.55, 1.06)],
        roof: vec![(1.75, 1.58), (2.2, 1.645), (2.9, 1.655), (3.8, 1.62), (4.4, 1.56)],
        cabin_d: [1.02, 1.98, 4.22, 4.54],
        tumblehome: 0.19,
        bow: [0.18, 0.10],
        corner: [0.24, 0.18],
        rake: [0.10, 0.03],
        pillars_d: vec![1.72, 2.62, 3.62],
        glass_end_d: [4.36, 4.22],
        doors_d: vec![1.42, 2.63, 3.65],
        cladding: false,
        rails: true,
        upright_lamps: true,
        rear_window: true,
        tail_lamp_z: [0.80, 1.14],
        head_lamp_z: [0.62, 0.76],
    }
}

fn taxi() -> Built {
    let shape = sedan();
    let mut assembly = shape.build(spec("car.taxi", 5.0));
    let x = shape.x(2.55);
    let sign = Material::new(Surface::LitSign, [0.85, 0.68, 0.12], ClassTag::Car);
    let mut roof_sign = Sculpt::cuboid(Vec3::new(x - 0.09, -0.30, 1.445), Vec3::new(x + 0.09, 0.30, 1.60), 0.03, sign);
    // TAXI, in bars, on both faces.
    for direction in [1.0, -1.0] {
        let text = Region::end(&[(-0.22, 1.485), (0.22, 1.485), (0.22, 1.565), (-0.22, 1.565)].map(Vec2::from))
            .facing(Vec3::X * direction, 0.9);
        for i in 0..4 {
            let y = -0.22 + 0.12 * i as f32;
            roof_sign.paint(&text.clone().beyond(Vec3::Y, y).within(Vec3::Y, y + 0.06), paint::TRIM);
        }
    }
    assembly.body.add(roof_sign);
    // A chequered band along the doors.
    for i in 0..22 {
        let x = shape.x(1.45 + 0.1 * i as f32);
        let row = (i % 2) as f32 * 0.07;
        let square = [(x - 0.1, 0.66 + row), (x, 0.66 + row), (x, 0.73 + row), (x - 0.1, 0.73 + row)].map(Vec2::from);
        assembly.body.paint_both(&Region::side(&square).facing(Vec3::Y, 0.5).beyond(Vec3::Y, 0.6), paint::TRIM);
    }
    finish(&shape, assembly)
}

fn pickup() -> Built {
    let shape = CarShape {
        length: 5.30,
        half_width: 0.93,
        clearance: 0.27,
        wheelbase: 3.12,
        front_axle_d: 0.95,
        wheel_radius: 0.38,
        tyre_width: 0.25,
        rim: Rim::Alloy(6),
        deck: vec![(0.10, 1.00), (0.35, 1.07), (0.8, 1.12), (1.36, 1.17), (3.6, 1.16), (3.7, 1.12), (5.3, 1.12)],
        belt: vec![(0.05, 0.98), (0.40, 1.05), (1.3, 1.12), (2.6, 1.13), (3.7, 1.14), (5.25, 1.14)],
        roof: vec![(1.9, 1.74), (2.25, 1.795), (2.8, 1.80), (3.4, 1.76)],
        cabin_d: [1.38, 2.08, 3.42, 3.60],
        tumblehome: 0.20,
        bow: [0.12, 0.04],
        corner: [0.20, 0.10],
        rake: [0.05, 0.01],
        pillars_d: vec![2.52],
        glass_end_d: [3.42, 3.28],
        doors_d: vec![1.45, 2.53, 3.40],
        cladding: true,
        rails: false,
        upright_lamps: true,
        rear_window: true,
        tail_lamp_z: [0.76, 1.06],
        head_lamp_z: [0.80, 0.96],
    };
    let mut assembly = shape.build(spec("car.pickup", 5.0));
    // The bed: open the deck behind the cabin and set a box into it.
    let (x0, x1, y) = (shape.x(5.18), shape.x(3.74), shape.half_width - 0.13);
    let bed =
        Region::top(&[(x0, -y), (x1, -y), (x1, y), (x0, y)].map(Vec2::from)).beyond(Vec3::Z, 0.9).facing(Vec3::Z, 0.3);
    assembly.body.remove(&bed);
    let liner = Sculpt::cuboid(Vec3::new(x0, -y, 0.72), Vec3::new(x1, y, 1.125), 0.0, paint::TRIM);
    let mut inside = Sculpt::new();
    for face in liner.faces.iter().filter(|f| f.normals[0].z < 0.5) {
        let [a, b, c] = face.corners;
        inside.triangle([a, c, b], paint::TRIM);
    }
    assembly.body.add(inside);
    // Gap between cabin and bed; gap and handle of the tailgate.
    let x = shape.x(3.67);
    let strip = [(x, 0.4), (x + 0.02, 0.4), (x + 0.02, 1.2), (x, 1.2)].map(Vec2::from);
    assembly.body.paint_both(&Region::side(&strip).facing(Vec3::Y, 0.3).beyond(Vec3::Y, 0.6), paint::DARK);
    finish(&shape, assembly)
}
