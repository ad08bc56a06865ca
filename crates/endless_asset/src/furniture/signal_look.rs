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
    /// Two heads side by side where others have one: for those who go on and for those who turn.
    pub(crate) paired: bool,
    pub(crate) head: &'static HeadSize,
}

/// Sizes of a vehicle's head, metres.
#[derive(Debug, PartialEq)]
pub(crate) struct HeadSize {
    pub(crate) lens_radius: f32,
    /// From the middle of one lens to that of the next.
    pub(crate) pitch: f32,
    /// Half width and half height of the housing, and of a back-plate.
    pub(crate) housing: [f32; 2],
    pub(crate) plate: [f32; 2],
}

/// Lenses of 200 and of 300 mm (EN 12368; the MUTCD's 8 and 12 inches).
const SMALL: HeadSize = HeadSize { lens_radius: 0.10, pitch: 0.27, housing: [0.145, 0.42], plate: [0.25, 0.54] };
const LARGE: HeadSize = HeadSize { lens_radius: 0.15, pitch: 0.355, housing: [0.18, 0.54], plate: [0.30, 0.67] };

impl SignalLook {
    /// Half width and half height of a head with its plate.
    pub(crate) const fn outline(&self) -> [f32; 2] {
        if self.plate.is_some() { self.head.plate } else { self.head.housing }
    }
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

const fn look(housing: Material, plate: Option<BackPlate>, pole: Material) -> SignalLook {
    SignalLook { housing, plate, pole, paired: false, head: &SMALL }
}
const fn paired(look: SignalLook) -> SignalLook {
    SignalLook { paired: true, ..look }
}
const fn large(look: SignalLook) -> SignalLook {
    SignalLook { head: &LARGE, ..look }
}

/// Of the towns that come with the program, then of those that are dressed anew.
const LOOKS: &[SignalLook] = &[
    look(paint::HOUSING, BLACK_PLATE, paint::POLE),
    paired(look(paint::HOUSING, None, paint::POLE)),
    look(YELLOW, None, paint::POLE),
    large(look(YELLOW, BLACK_PLATE, painted_pole([0.05, 0.05, 0.045]))),
    large(paired(look(paint::HOUSING, edged([0.80, 0.80, 0.78]), painted_pole([0.045, 0.05, 0.05])))),
    look(housing([0.02, 0.07, 0.04]), None, painted_pole([0.03, 0.09, 0.06])),
    large(look(paint::HOUSING, edged([0.75, 0.45, 0.01]), painted_pole([0.60, 0.36, 0.02]))),
    paired(look(housing([0.27, 0.29, 0.29]), None, painted_pole([0.35, 0.37, 0.37]))),
];

/// How many there are.
pub(crate) const COUNT: u32 = LOOKS.len() as u32;

/// The look of a variant.
pub(crate) const fn of(variant: u32) -> &'static SignalLook {
    &LOOKS[variant as usize % LOOKS.len()]
}
