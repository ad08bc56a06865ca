//! Paint colours as on real roads.

use crate::color_key::color_key;
use endless_world::{ObjectClass, Stream};

/// Share and linear colour.
pub(crate) type PaintShare = (f64, [f32; 3]);

/// The paints of a class.
pub(crate) fn of_class(class: ObjectClass) -> &'static [PaintShare] {
    match class {
        ObjectClass::Van => VANS,
        ObjectClass::Truck => TRUCKS,
        ObjectClass::Bus => BUSES,
        ObjectClass::Motorcycle => MOTORCYCLES,
        ObjectClass::Bicycle => BICYCLES,
        _ => CARS,
    }
}

/// Passenger cars: white, black, grey and silver are four in five.
pub(crate) const CARS: &[PaintShare] = &[
    (33.0, [0.74, 0.74, 0.73]),
    (20.0, [0.010, 0.010, 0.011]),
    (10.0, [0.085, 0.088, 0.092]),
    (8.0, [0.17, 0.175, 0.18]),
    (10.0, [0.42, 0.43, 0.44]),
    (4.0, [0.012, 0.035, 0.13]),
    (3.0, [0.03, 0.12, 0.30]),
    (4.5, [0.34, 0.012, 0.012]),
    (1.5, [0.13, 0.008, 0.012]),
    (2.0, [0.10, 0.065, 0.04]),
    (1.5, [0.33, 0.28, 0.20]),
    (1.0, [0.02, 0.09, 0.045]),
    (0.8, [0.65, 0.22, 0.02]),
    (0.7, [0.70, 0.52, 0.04]),
];
pub(crate) const TAXIS: &[PaintShare] = &[(60.0, [0.78, 0.48, 0.02]), (40.0, [0.74, 0.74, 0.73])];
pub(crate) const VANS: &[PaintShare] = &[
    (68.0, [0.74, 0.74, 0.73]),
    (12.0, [0.40, 0.41, 0.42]),
    (8.0, [0.09, 0.09, 0.095]),
    (4.0, [0.02, 0.08, 0.28]),
    (4.0, [0.38, 0.02, 0.015]),
    (4.0, [0.66, 0.45, 0.03]),
];
pub(crate) const TRUCKS: &[PaintShare] = &[
    (50.0, [0.72, 0.72, 0.71]),
    (14.0, [0.03, 0.10, 0.32]),
    (14.0, [0.40, 0.025, 0.02]),
    (10.0, [0.68, 0.40, 0.02]),
    (6.0, [0.03, 0.18, 0.08]),
    (6.0, [0.12, 0.12, 0.125]),
];
pub(crate) const BUSES: &[PaintShare] = &[
    (30.0, [0.46, 0.07, 0.02]),
    (20.0, [0.03, 0.13, 0.38]),
    (18.0, [0.05, 0.26, 0.12]),
    (17.0, [0.70, 0.70, 0.69]),
    (15.0, [0.66, 0.44, 0.03]),
];
pub(crate) const MOTORCYCLES: &[PaintShare] = &[
    (34.0, [0.012, 0.012, 0.013]),
    (30.0, [0.42, 0.012, 0.012]),
    (14.0, [0.02, 0.06, 0.30]),
    (12.0, [0.70, 0.70, 0.69]),
    (10.0, [0.16, 0.165, 0.17]),
];
pub(crate) const BICYCLES: &[PaintShare] = &[
    (30.0, [0.015, 0.015, 0.016]),
    (20.0, [0.36, 0.37, 0.38]),
    (16.0, [0.36, 0.015, 0.015]),
    (14.0, [0.02, 0.09, 0.34]),
    (10.0, [0.04, 0.26, 0.14]),
    (10.0, [0.70, 0.66, 0.55]),
];

/// Cars of the eighties: fewer greys, more colours, faded.
pub(crate) const OLD: &[PaintShare] = &[
    (24.0, [0.62, 0.61, 0.57]),
    (14.0, [0.30, 0.045, 0.035]),
    (12.0, [0.06, 0.12, 0.24]),
    (10.0, [0.40, 0.34, 0.23]),
    (9.0, [0.17, 0.22, 0.28]),
    (9.0, [0.30, 0.31, 0.31]),
    (7.0, [0.06, 0.14, 0.09]),
    (6.0, [0.16, 0.09, 0.05]),
    (5.0, [0.03, 0.03, 0.032]),
    (4.0, [0.50, 0.34, 0.06]),
];

/// Small buses that their drivers own.
pub(crate) const COLECTIVOS: &[PaintShare] = &[
    (26.0, [0.70, 0.70, 0.68]),
    (20.0, [0.40, 0.03, 0.02]),
    (18.0, [0.02, 0.12, 0.36]),
    (14.0, [0.66, 0.44, 0.02]),
    (12.0, [0.03, 0.22, 0.09]),
    (10.0, [0.55, 0.20, 0.02]),
];

/// Auto-rickshaws and cargo tricycles, painted to be seen.
pub(crate) const THREE_WHEELERS: &[PaintShare] = &[
    (24.0, [0.34, 0.012, 0.012]),
    (20.0, [0.02, 0.10, 0.34]),
    (18.0, [0.66, 0.44, 0.02]),
    (16.0, [0.03, 0.20, 0.07]),
    (12.0, [0.70, 0.70, 0.69]),
    (10.0, [0.012, 0.012, 0.013]),
];

pub(crate) const WHITES: &[PaintShare] = &[(80.0, [0.74, 0.74, 0.73]), (20.0, [0.62, 0.62, 0.60])];
pub(crate) const POLICE: &[PaintShare] =
    &[(55.0, [0.74, 0.74, 0.73]), (25.0, [0.010, 0.010, 0.011]), (20.0, [0.40, 0.41, 0.42])];
pub(crate) const FIRE: &[PaintShare] = &[(85.0, [0.42, 0.010, 0.008]), (15.0, [0.50, 0.05, 0.01])];
pub(crate) const AMBULANCES: &[PaintShare] = &[(65.0, [0.74, 0.74, 0.73]), (35.0, [0.72, 0.55, 0.02])];
pub(crate) const SCHOOL: &[PaintShare] = &[(100.0, [0.70, 0.36, 0.01])];
pub(crate) const REFUSE: &[PaintShare] =
    &[(35.0, [0.70, 0.28, 0.01]), (30.0, [0.72, 0.72, 0.71]), (25.0, [0.03, 0.24, 0.08]), (10.0, [0.03, 0.13, 0.35])];
/// Leisure vehicles of two colours, the upper half white.
pub(crate) const CAMPERS: &[PaintShare] = &[
    (30.0, [0.05, 0.24, 0.28]),
    (25.0, [0.42, 0.07, 0.03]),
    (20.0, [0.55, 0.42, 0.20]),
    (15.0, [0.10, 0.25, 0.10]),
    (10.0, [0.70, 0.70, 0.68]),
];

/// Linear paint colour of a variant.
pub(crate) fn tint(paints: &[PaintShare], variant: u64) -> [f32; 3] {
    let mut stream = Stream::named(variant, "vehicle paint", &[]);
    // By the colours themselves: a paint more in the list leaves other vehicles as they are.
    let chosen = stream.weighted_by_key(paints.iter().map(|(share, color)| (color_key(color), *share)));
    let color = chosen.map_or([1.0; 3], |index| paints[index].1);
    // Batches and years differ a little.
    let shade = stream.range_f32(0.88, 1.1);
    color.map(|c| (c * shade).clamp(0.004, 0.85))
}
