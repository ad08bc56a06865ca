//! City cars, hatchbacks, sedans, estates and coupes.

use crate::vehicle::car::{CarShape, Grille};
use crate::vehicle::wheel::Rim;

pub(crate) fn city() -> CarShape {
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
        grille: Grille::Framed,
    }
}

pub(crate) fn hatchback() -> CarShape {
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
        grille: Grille::Framed,
    }
}

pub(crate) fn sedan() -> CarShape {
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
        grille: Grille::Framed,
    }
}

pub(crate) fn estate() -> CarShape {
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

/// Two seats, no longer than others are wide.
pub(crate) fn micro() -> CarShape {
    CarShape {
        length: 2.42,
        half_width: 0.755,
        clearance: 0.16,
        wheelbase: 1.50,
        front_axle_d: 0.48,
        wheel_radius: 0.265,
        tyre_width: 0.165,
        deck: vec![(0.08, 0.74), (0.22, 0.83), (0.42, 0.93), (2.2, 1.01), (2.42, 0.98)],
        belt: vec![(0.05, 0.72), (0.30, 0.83), (0.42, 0.88), (1.2, 0.95), (2.4, 1.0)],
        roof: vec![(0.95, 1.45), (1.25, 1.52), (1.65, 1.53), (2.2, 1.46)],
        cabin_d: [0.42, 1.02, 2.08, 2.34],
        tumblehome: 0.185,
        bow: [0.11, 0.07],
        corner: [0.16, 0.16],
        rake: [0.07, 0.03],
        pillars_d: vec![],
        glass_end_d: [1.96, 1.82],
        doors_d: vec![0.60, 1.72],
        tail_lamp_z: [0.66, 0.90],
        head_lamp_z: [0.60, 0.74],
        grille: Grille::Closed,
        ..city()
    }
}

/// Between hatchback and sedan: the rear window opens with the tailgate.
pub(crate) fn liftback() -> CarShape {
    CarShape {
        length: 4.58,
        deck: vec![(0.14, 0.71), (0.40, 0.82), (0.85, 0.92), (1.24, 0.99), (4.3, 1.12), (4.58, 1.06)],
        belt: vec![(0.05, 0.69), (0.45, 0.81), (1.24, 0.92), (2.6, 0.97), (4.5, 1.05)],
        roof: vec![(1.90, 1.42), (2.30, 1.475), (2.75, 1.475), (3.4, 1.42), (4.1, 1.29)],
        cabin_d: [1.22, 2.15, 3.72, 4.40],
        pillars_d: vec![2.55],
        glass_end_d: [3.92, 3.50],
        rake: [0.11, 0.04],
        tail_lamp_z: [0.80, 0.98],
        ..sedan()
    }
}

/// A large sedan.
pub(crate) fn executive() -> CarShape {
    CarShape {
        length: 5.02,
        half_width: 0.94,
        wheelbase: 2.98,
        front_axle_d: 0.90,
        wheel_radius: 0.345,
        tyre_width: 0.235,
        deck: vec![(0.14, 0.72), (0.40, 0.83), (0.90, 0.93), (1.46, 0.99), (4.36, 1.10), (4.7, 1.09), (5.0, 1.04)],
        belt: vec![(0.05, 0.70), (0.45, 0.82), (1.46, 0.93), (2.9, 0.965), (4.4, 1.02), (4.98, 0.98)],
        roof: vec![(2.15, 1.42), (2.55, 1.475), (3.05, 1.48), (3.6, 1.44), (4.1, 1.36)],
        cabin_d: [1.46, 2.38, 3.72, 4.40],
        pillars_d: vec![2.80],
        glass_end_d: [4.16, 3.66],
        doors_d: vec![1.50, 2.81, 3.88],
        ..sedan()
    }
}

/// Two doors, low roof.
pub(crate) fn coupe() -> CarShape {
    CarShape {
        length: 4.48,
        half_width: 0.925,
        clearance: 0.13,
        wheelbase: 2.60,
        front_axle_d: 0.92,
        wheel_radius: 0.335,
        tyre_width: 0.245,
        deck: vec![(0.14, 0.64), (0.40, 0.74), (0.90, 0.83), (1.55, 0.89), (3.95, 1.02), (4.2, 1.01), (4.46, 0.96)],
        belt: vec![(0.05, 0.62), (0.45, 0.73), (1.55, 0.84), (2.7, 0.89), (3.7, 0.97), (4.44, 0.92)],
        roof: vec![(2.10, 1.27), (2.45, 1.325), (2.8, 1.33), (3.3, 1.27), (3.7, 1.17)],
        cabin_d: [1.55, 2.30, 3.10, 4.02],
        tumblehome: 0.26,
        corner: [0.28, 0.26],
        rake: [0.12, 0.06],
        pillars_d: vec![],
        glass_end_d: [3.52, 3.16],
        doors_d: vec![1.50, 2.98],
        tail_lamp_z: [0.72, 0.85],
        head_lamp_z: [0.52, 0.62],
        grille: Grille::Slit,
        ..sedan()
    }
}
