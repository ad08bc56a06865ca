//! Cars of the eighties, which many streets still have: upright, flat-sided, narrow, on small wheels.

use crate::vehicle::car::{CarShape, Grille};
use crate::vehicle::wheel::Rim;

/// Three boxes.
pub(crate) fn old_saloon() -> CarShape {
    CarShape {
        length: 4.32,
        half_width: 0.83,
        clearance: 0.17,
        wheelbase: 2.50,
        front_axle_d: 0.80,
        wheel_radius: 0.295,
        tyre_width: 0.165,
        rim: Rim::Steel,
        deck: vec![(0.05, 0.80), (0.15, 0.885), (0.5, 0.92), (1.28, 0.955), (3.56, 0.975), (4.2, 0.955), (4.32, 0.91)],
        belt: vec![(0.04, 0.79), (0.2, 0.865), (1.28, 0.915), (2.6, 0.925), (3.56, 0.945), (4.3, 0.90)],
        roof: vec![(1.84, 1.355), (2.1, 1.395), (2.7, 1.405), (3.05, 1.39), (3.24, 1.36)],
        cabin_d: [1.28, 1.80, 3.18, 3.56],
        tumblehome: 0.165,
        bow: [0.05, 0.04],
        corner: [0.09, 0.08],
        rake: [0.015, 0.02],
        pillars_d: vec![2.36, 3.06],
        glass_end_d: [3.44, 3.16],
        doors_d: vec![1.34, 2.37, 3.22],
        cladding: false,
        rails: false,
        upright_lamps: false,
        rear_window: true,
        tail_lamp_z: [0.66, 0.83],
        head_lamp_z: [0.64, 0.78],
        grille: Grille::Classic,
    }
}

/// Two boxes, the second one steep behind.
pub(crate) fn old_hatchback() -> CarShape {
    CarShape {
        length: 3.70,
        half_width: 0.79,
        wheelbase: 2.38,
        front_axle_d: 0.72,
        wheel_radius: 0.28,
        tyre_width: 0.155,
        deck: vec![(0.05, 0.78), (0.15, 0.865), (0.5, 0.90), (1.08, 0.94), (3.5, 0.97), (3.70, 0.93)],
        belt: vec![(0.04, 0.77), (0.2, 0.845), (1.08, 0.90), (2.2, 0.915), (3.66, 0.935)],
        roof: vec![(1.62, 1.36), (1.88, 1.395), (2.5, 1.40), (3.0, 1.385), (3.28, 1.355)],
        cabin_d: [1.08, 1.58, 3.20, 3.54],
        tumblehome: 0.15,
        pillars_d: vec![2.16, 2.94],
        glass_end_d: [3.40, 3.13],
        doors_d: vec![1.14, 2.17, 2.98],
        upright_lamps: true,
        tail_lamp_z: [0.64, 0.86],
        head_lamp_z: [0.62, 0.76],
        ..old_saloon()
    }
}

/// Two seats and a long bed.
pub(crate) fn old_pickup() -> CarShape {
    CarShape {
        length: 4.70,
        half_width: 0.82,
        clearance: 0.26,
        wheelbase: 2.78,
        front_axle_d: 0.76,
        wheel_radius: 0.335,
        tyre_width: 0.185,
        deck: vec![(0.05, 0.90), (0.15, 0.98), (0.7, 1.02), (1.22, 1.05), (2.66, 1.04), (2.74, 1.0), (4.70, 1.0)],
        belt: vec![(0.04, 0.89), (0.2, 0.96), (1.2, 1.0), (2.0, 1.01), (2.74, 1.02), (4.66, 1.02)],
        roof: vec![(1.72, 1.555), (1.95, 1.605), (2.3, 1.615), (2.54, 1.585)],
        cabin_d: [1.22, 1.68, 2.52, 2.64],
        tumblehome: 0.15,
        corner: [0.09, 0.06],
        pillars_d: vec![],
        glass_end_d: [2.52, 2.42],
        doors_d: vec![1.30, 2.44],
        upright_lamps: true,
        tail_lamp_z: [0.66, 0.88],
        head_lamp_z: [0.72, 0.88],
        ..old_saloon()
    }
}
