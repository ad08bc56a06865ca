//! What sets the traffic lights of one country apart from those of another: the variants of all signals.

use super::paint;
use endless_scene::{Material, Surface};
use endless_world::ClassTag;

/// The board behind a head.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BackPlate {
    pub(crate) face: Material,
    /// A bright rim, where there is one.
    pub(crate) edge: Option<Material>,
}

/// Colours of a signal's parts.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SignalLook {
    pub(crate) housing: Material,
    pub(crate) plate: Option<BackPlate>,
    pub(crate) pole: Material,
}

const fn housing(base_color: [f32; 3]) -> Material {
    Material { base_color, ..paint::HOUSING }
}

const fn painted_pole(base_color: [f32; 3]) -> Material {
    Material { base_color, ..paint::DARK_POLE }
}

const BLACK_PLATE: Option<BackPlate> = Some(BackPlate { face: paint::HOUSING, edge: None });
const fn edged(color: [f32; 3]) -> Option<BackPlate> {
    let edge = Material::new(Surface::Plate, color, ClassTag::TrafficLight);
    Some(BackPlate { face: paint::HOUSING, edge: Some(edge) })
}

const YELLOW: Material = housing([0.62, 0.36, 0.01]);

/// Of the towns that come with the program, then of those that are dressed anew.
const LOOKS: &[SignalLook] = &[
    SignalLook { housing: paint::HOUSING, plate: BLACK_PLATE, pole: paint::POLE },
    SignalLook { housing: paint::HOUSING, plate: None, pole: paint::POLE },
    SignalLook { housing: YELLOW, plate: None, pole: paint::POLE },
    SignalLook { housing: YELLOW, plate: BLACK_PLATE, pole: painted_pole([0.05, 0.05, 0.045]) },
    SignalLook { housing: paint::HOUSING, plate: edged([0.80, 0.80, 0.78]), pole: painted_pole([0.045, 0.05, 0.05]) },
    SignalLook { housing: housing([0.02, 0.07, 0.04]), plate: None, pole: painted_pole([0.03, 0.09, 0.06]) },
    SignalLook { housing: paint::HOUSING, plate: edged([0.75, 0.45, 0.01]), pole: painted_pole([0.60, 0.36, 0.02]) },
    SignalLook { housing: housing([0.27, 0.29, 0.29]), plate: None, pole: painted_pole([0.35, 0.37, 0.37]) },
];

/// How many there are.
pub(crate) const COUNT: u32 = LOOKS.len() as u32;

/// The look of a variant.
pub(crate) const fn of(variant: u32) -> &'static SignalLook {
    &LOOKS[variant as usize % LOOKS.len()]
}
