//! What the cameras of a town are chosen among: buildings, open spaces, what stands in the streets.

use super::height_field::HeightField;
use endless_road::RoadNetwork;
use glam::{DVec2, Vec3};

/// A building as sight sees it: a prism.
#[derive(Debug, Clone)]
pub(crate) struct BuildingPrism {
    /// Counter-clockwise.
    pub(crate) outline: Vec<DVec2>,
    pub(crate) base: f64,
    pub(crate) top: f64,
}

/// A square or a park.
#[derive(Debug, Clone)]
pub(crate) struct OpenSpace {
    pub(crate) outline: Vec<DVec2>,
    pub(crate) park: bool,
}

/// Something that stands in the street.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TallProp {
    pub(crate) foot: Vec3,
    /// Its height, metres.
    pub(crate) height: f32,
}

/// What the cameras of a town are chosen for.
pub(crate) struct CameraSurroundings<'a> {
    pub(crate) network: &'a RoadNetwork,
    pub(crate) relief: &'a HeightField,
    pub(crate) solids: &'a [BuildingPrism],
    pub(crate) open: &'a [OpenSpace],
    /// Lamp posts, masts, signs.
    pub(crate) posts: Vec<TallProp>,
    /// Parked vehicles.
    pub(crate) parked: Vec<Vec3>,
}
