//! What can be worn: garments as patterns over the body, what covers legs, shoes.

use super::palette;
use endless_scene::{Material, Surface};

/// How far up a garment goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum GarmentTop {
    /// To this height over the body's.
    Waist(f32),
    /// Over the shoulders; how far the neckline dips in front (0 to 0.9), how much wider than the neck it is.
    Neck { dip: f32, wide: f32 },
}

/// What is at the neck.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Collar {
    None,
    /// Turned down, as on shirts.
    Shirt,
    /// Standing, as on jackets.
    Stand,
    /// A hood lying on the back.
    Hood,
    /// Lapels over a shirt, with a tie or without.
    Lapels {
        tie: bool,
    },
    /// A scarf.
    Scarf,
}

/// How colours are laid out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr)]
pub(crate) enum FabricPattern {
    Plain,
    /// Horizontal stripes.
    Stripes,
    /// Chest and sleeves of another colour.
    Block,
    /// Checks.
    Checks,
    /// Reflecting bands around the body and over the shoulders.
    HighVisibility,
    /// A border along the hem.
    Border,
}

/// A garment of the trunk.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Garment {
    pub(crate) name: &'static str,
    /// Height of the hem over the body's.
    pub(crate) hem: f32,
    pub(crate) upper: GarmentTop,
    /// Over the arm's length; 0: none.
    pub(crate) sleeve: f32,
    /// Half opening in front over the stature, at the hem and at the neck.
    pub(crate) gap: Option<(f32, f32)>,
    /// Room over the stature, how much it grows towards the hem.
    pub(crate) ease: f32,
    pub(crate) flare: f32,
    pub(crate) material: Material,
    pub(crate) accent: Material,
    pub(crate) pattern: FabricPattern,
    pub(crate) collar: Collar,
    pub(crate) folds: f32,
}

impl Garment {
    pub(crate) fn new(name: &'static str, hem: f32, sleeve: f32, ease: f32, material: Material) -> Self {
        Self {
            name,
            hem,
            upper: GarmentTop::Neck { dip: 0.15, wide: 0.006 },
            sleeve,
            gap: None,
            ease,
            flare: 0.0,
            material,
            accent: material,
            pattern: FabricPattern::Plain,
            collar: Collar::None,
            folds: 1.0,
        }
    }

    pub(crate) fn skirt(name: &'static str, hem: f32, flare: f32, material: Material) -> Self {
        Self { upper: GarmentTop::Waist(0.612), flare, ..Self::new(name, hem, 0.0, 0.006, material) }
    }

    pub(crate) fn neck(self, dip: f32, wide: f32) -> Self {
        Self { upper: GarmentTop::Neck { dip, wide }, ..self }
    }

    pub(crate) fn open(self, hem: f32, neck: f32) -> Self {
        Self { gap: Some((hem, neck)), ..self }
    }

    pub(crate) fn collar(self, collar: Collar) -> Self {
        Self { collar, ..self }
    }

    pub(crate) fn pattern(self, pattern: FabricPattern, accent: Material) -> Self {
        Self { pattern, accent, ..self }
    }

    pub(crate) fn flare(self, flare: f32) -> Self {
        Self { flare, ..self }
    }
}

/// What covers the legs one by one.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Legs {
    pub(crate) name: &'static str,
    /// Where they end, from ankle (0) to hip (2); 2: bare.
    pub(crate) end: f32,
    pub(crate) ease: f32,
    /// Extra room at the end.
    pub(crate) cuff: f32,
    pub(crate) material: Material,
    pub(crate) accent: Material,
    /// A stripe of the accent's colour down the side.
    pub(crate) stripe: bool,
    /// Legs below, bare or in stockings.
    pub(crate) below: Material,
}

impl Legs {
    pub(crate) fn bare(skin: Material) -> Self {
        Self { name: "", end: 2.0, ease: 0.0, cuff: 0.0, material: skin, accent: skin, stripe: false, below: skin }
    }

    pub(crate) fn new(name: &'static str, end: f32, ease: f32, cuff: f32, material: Material, skin: Material) -> Self {
        Self { name, end, ease, cuff, material, accent: material, stripe: false, below: skin }
    }

    /// Whether one can sit astride in it.
    pub(crate) fn can_ride(&self) -> bool {
        self.end < 1.9
    }
}

/// The kind of shoe.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr)]
pub(crate) enum ShoeKind {
    Trainers,
    Leather,
    Boots,
    Heels,
    Sandals,
}

/// A pair of shoes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Shoes {
    pub(crate) kind: ShoeKind,
    pub(crate) material: Material,
    pub(crate) sole: Material,
}

impl Shoes {
    pub(crate) fn plain() -> Self {
        Self::new(ShoeKind::Leather, palette::material(Surface::Leather, [30, 28, 27], 1.0))
    }

    pub(crate) fn new(kind: ShoeKind, material: Material) -> Self {
        let white = palette::linear(Surface::Plastic, [0.75, 0.75, 0.73]);
        let black = palette::linear(Surface::Plastic, [0.02, 0.02, 0.02]);
        Self { kind, material, sole: if kind == ShoeKind::Trainers { white } else { black } }
    }
}
