//! Vans whose driver sits over the front axle: the tiny ones of Japanese rules, and those that carry a dozen people.

use super::assemble::VehicleBlueprint;
use super::car::{CarShape, Grille};
use super::draw::DesignDraw;
use super::lettering;
use super::roof_load::RoofLoad;
use super::wear;
use super::wheel::Rim;

/// No longer than a city car, higher than wide.
pub(crate) fn kei(draw: &DesignDraw) -> VehicleBlueprint {
    let shape = CarShape { rim: Rim::Steel, grille: Grille::Closed, ..kei_shape().drawn(draw) };
    let blind = draw.chance("blind sides", 0.35);
    let shape = if blind { CarShape { pillars_d: vec![1.02], glass_end_d: [1.9, 1.88], ..shape } } else { shape };
    loaded(shape, draw, 0.25, 0.5)
}

/// Windows all along, a dozen seats, and often a load on the roof.
pub(crate) fn cab_over(draw: &DesignDraw) -> VehicleBlueprint {
    let shape = CarShape { rim: Rim::Steel, ..cab_over_shape().drawn(draw) };
    loaded(shape, draw, 0.35, 0.5)
}

fn loaded(shape: CarShape, draw: &DesignDraw, racks: f64, much: f64) -> VehicleBlueprint {
    let worn = wear::worn(&shape, draw, much);
    let stripe = draw.chance("stripe", 0.4).then(|| draw.pick("stripe colour", lettering::INKS));
    let rack = draw.chance("roof rack", racks).then(|| RoofLoad::drawn(draw));
    let mut blueprint = shape.clone().blueprint();
    if let Some(rack) = rack {
        blueprint.size.height = shape.height() + rack.height();
    }
    blueprint.with(move |a| {
        if let Some(ink) = stripe {
            lettering::stripe(&mut a.body, &shape, ink);
        }
        worn(a);
        if let Some(rack) = rack {
            rack.on(&mut a.body, &shape);
        }
    })
}

fn kei_shape() -> CarShape {
    CarShape {
        length: 3.42,
        half_width: 0.74,
        clearance: 0.18,
        wheelbase: 2.15,
        front_axle_d: 0.62,
        wheel_radius: 0.27,
        tyre_width: 0.155,
        rim: Rim::Steel,
        deck: vec![(0.02, 0.90), (0.08, 0.945), (0.24, 0.985), (3.28, 1.02), (3.42, 1.0)],
        belt: vec![(0.02, 0.88), (0.08, 0.92), (0.24, 0.955), (2.0, 0.97), (3.38, 0.98)],
        roof: vec![(0.66, 1.76), (0.95, 1.85), (1.6, 1.88), (2.7, 1.875), (3.26, 1.84)],
        cabin_d: [0.20, 0.68, 3.24, 3.36],
        tumblehome: 0.095,
        bow: [0.09, 0.04],
        corner: [0.14, 0.08],
        rake: [0.03, 0.01],
        pillars_d: vec![1.02, 1.98],
        glass_end_d: [3.13, 3.10],
        doors_d: vec![0.40, 1.06, 2.02],
        cladding: false,
        rails: false,
        upright_lamps: true,
        rear_window: true,
        tail_lamp_z: [0.60, 0.84],
        head_lamp_z: [0.62, 0.80],
        grille: Grille::Closed,
    }
}

fn cab_over_shape() -> CarShape {
    CarShape {
        length: 4.78,
        half_width: 0.86,
        clearance: 0.20,
        wheelbase: 2.60,
        front_axle_d: 1.02,
        wheel_radius: 0.325,
        tyre_width: 0.195,
        deck: vec![(0.03, 1.02), (0.10, 1.08), (0.34, 1.14), (4.64, 1.16), (4.78, 1.14)],
        belt: vec![(0.03, 1.0), (0.10, 1.05), (0.34, 1.10), (2.0, 1.11), (4.74, 1.12)],
        roof: vec![(1.05, 1.86), (1.4, 1.97), (2.0, 2.02), (3.9, 2.02), (4.62, 1.98)],
        cabin_d: [0.32, 1.08, 4.60, 4.71],
        tumblehome: 0.11,
        bow: [0.12, 0.05],
        corner: [0.18, 0.10],
        rake: [0.04, 0.01],
        pillars_d: vec![1.22, 2.24, 3.42],
        glass_end_d: [4.50, 4.46],
        doors_d: vec![0.66, 1.30, 2.42],
        tail_lamp_z: [0.72, 1.04],
        head_lamp_z: [0.70, 0.88],
        grille: Grille::Bars,
        ..kei_shape()
    }
}
