//! SUVs, people carriers, off-road cars and pickups.

use crate::vehicle::car::{CarShape, Grille};
use crate::vehicle::wheel::Rim;

pub(crate) fn suv() -> CarShape {
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
        grille: Grille::Framed,
    }
}

pub(crate) fn mpv() -> CarShape {
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
        grille: Grille::Framed,
    }
}

/// Double cab, open bed.
pub(crate) fn pickup() -> CarShape {
    CarShape {
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
        grille: Grille::Bars,
    }
}

/// A hatchback on stilts.
pub(crate) fn crossover() -> CarShape {
    CarShape {
        length: 4.26,
        half_width: 0.895,
        clearance: 0.19,
        wheelbase: 2.60,
        front_axle_d: 0.84,
        wheel_radius: 0.335,
        tyre_width: 0.215,
        deck: vec![(0.12, 0.80), (0.35, 0.89), (0.78, 0.98), (1.12, 1.04), (4.0, 1.10), (4.26, 1.05)],
        belt: vec![(0.05, 0.78), (0.40, 0.88), (1.12, 0.98), (2.5, 1.02), (4.2, 1.10)],
        roof: vec![(1.70, 1.52), (2.08, 1.575), (2.65, 1.58), (3.4, 1.53), (4.0, 1.45)],
        cabin_d: [1.12, 1.90, 3.74, 4.16],
        pillars_d: vec![2.34],
        glass_end_d: [3.80, 3.50],
        doors_d: vec![1.22, 2.35, 3.32],
        tail_lamp_z: [0.80, 1.00],
        head_lamp_z: [0.66, 0.79],
        ..suv()
    }
}

/// Three rows of seats, off the road if need be.
pub(crate) fn large_suv() -> CarShape {
    CarShape {
        length: 4.98,
        half_width: 0.98,
        clearance: 0.23,
        wheelbase: 2.90,
        front_axle_d: 0.90,
        wheel_radius: 0.385,
        tyre_width: 0.265,
        deck: vec![(0.12, 0.98), (0.35, 1.07), (0.85, 1.15), (1.34, 1.20), (4.8, 1.24), (4.98, 1.20)],
        belt: vec![(0.05, 0.96), (0.40, 1.05), (1.34, 1.13), (2.9, 1.16), (4.9, 1.22)],
        roof: vec![(1.95, 1.74), (2.35, 1.805), (3.1, 1.815), (4.1, 1.79), (4.75, 1.73)],
        cabin_d: [1.34, 2.12, 4.50, 4.88],
        pillars_d: vec![2.64, 3.70],
        glass_end_d: [4.62, 4.42],
        doors_d: vec![1.42, 2.65, 3.72],
        tail_lamp_z: [0.92, 1.22],
        head_lamp_z: [0.80, 0.94],
        grille: Grille::Bars,
        ..suv()
    }
}

/// A box on large wheels with a spare one at the back.
pub(crate) fn offroad() -> CarShape {
    CarShape {
        length: 3.92,
        half_width: 0.92,
        clearance: 0.29,
        wheelbase: 2.40,
        front_axle_d: 0.68,
        wheel_radius: 0.39,
        tyre_width: 0.25,
        deck: vec![(0.06, 1.04), (0.25, 1.10), (0.80, 1.14), (1.30, 1.16), (3.75, 1.20), (3.92, 1.18)],
        belt: vec![(0.05, 1.02), (0.30, 1.08), (1.30, 1.12), (2.6, 1.14), (3.85, 1.16)],
        roof: vec![(1.62, 1.80), (1.85, 1.845), (2.6, 1.85), (3.4, 1.84), (3.78, 1.82)],
        cabin_d: [1.30, 1.62, 3.72, 3.82],
        tumblehome: 0.13,
        bow: [0.07, 0.04],
        corner: [0.12, 0.10],
        rake: [0.03, 0.01],
        pillars_d: vec![2.40],
        glass_end_d: [3.58, 3.54],
        doors_d: vec![1.34, 2.41, 3.20],
        rails: false,
        tail_lamp_z: [0.86, 1.06],
        head_lamp_z: [0.86, 1.02],
        grille: Grille::Slots,
        ..suv()
    }
}

/// As long as a van, with a bed as wide as a sheet of plywood.
pub(crate) fn large_pickup() -> CarShape {
    CarShape {
        length: 5.84,
        half_width: 1.01,
        wheelbase: 3.62,
        front_axle_d: 0.98,
        wheel_radius: 0.41,
        tyre_width: 0.275,
        deck: vec![(0.10, 1.12), (0.35, 1.19), (0.8, 1.24), (1.44, 1.28), (3.98, 1.27), (4.06, 1.24), (5.84, 1.24)],
        belt: vec![(0.05, 1.10), (0.40, 1.17), (1.4, 1.23), (2.8, 1.24), (4.0, 1.25), (5.8, 1.25)],
        roof: vec![(1.98, 1.90), (2.35, 1.955), (3.0, 1.96), (3.78, 1.92)],
        cabin_d: [1.46, 2.18, 3.78, 3.96],
        pillars_d: vec![2.74],
        glass_end_d: [3.78, 3.64],
        doors_d: vec![1.52, 2.75, 3.74],
        tail_lamp_z: [0.86, 1.18],
        head_lamp_z: [0.90, 1.08],
        grille: Grille::Tall,
        ..pickup()
    }
}
