//! The vehicles of the catalogue, and the designs that they are drawn from.

use super::design::{DESIGNS, VehicleDesign};
use super::draw::DesignDraw;
use super::model::VehicleModel;
use crate::carla;
use endless_world::ObjectClass;

/// A vehicle design with the smallest and largest size of its draws, metres.
#[derive(Debug, Clone, PartialEq)]
pub struct VehicleDesignSummary {
    /// Unique, e.g. `car.hatchback`.
    pub name: &'static str,
    /// Class of the vehicle itself.
    pub class: ObjectClass,
    /// Length over all.
    pub length_m: [f32; 2],
    /// Width without mirrors.
    pub width_m: [f32; 2],
    /// Height.
    pub height_m: [f32; 2],
}

/// The designs, from small to large within each class.
pub(crate) fn design_summaries() -> Vec<VehicleDesignSummary> {
    /// Draws looked at.
    const DRAWS: u64 = 256;
    let span = |values: &[f32]| {
        let wider = |[low, high]: [f32; 2], &v: &f32| [low.min(v), high.max(v)];
        values.iter().fold([f32::INFINITY, f32::NEG_INFINITY], wider)
    };
    DESIGNS
        .iter()
        .map(|design| {
            let sizes = || (0..DRAWS).map(|i| (design.blueprint)(&DesignDraw::new(design.name, i)).size);
            VehicleDesignSummary {
                name: design.name,
                class: design.class,
                length_m: span(&sizes().map(|s| s.front - s.rear).collect::<Vec<_>>()),
                width_m: span(&sizes().map(|s| s.width).collect::<Vec<_>>()),
                height_m: span(&sizes().map(|s| s.height).collect::<Vec<_>>()),
            }
        })
        .collect()
}

/// Draw number `index` of the design of a name.
pub(crate) fn drawn(name: &str, index: u64) -> Option<VehicleModel> {
    let design = DESIGNS.iter().find(|d| d.name == name)?;
    Some(VehicleModel::new(design, index, design.frequency))
}

/// The vehicles of the catalogue: the first draws of each design, which share its frequency, and those that stand for
/// CARLA's, which the traffic of our own towns leaves out.
pub(crate) fn all() -> Vec<VehicleModel> {
    let draws = |d: &'static VehicleDesign| {
        let each = d.frequency / f64::from(d.draws);
        (0..u64::from(d.draws)).map(move |i| VehicleModel::new(d, i, each))
    };
    let design = |name: &str| DESIGNS.iter().find(|d| d.name == name);
    let of_carla = carla::VEHICLES.iter().filter_map(|b| Some(VehicleModel::new(design(b.3)?, b.4, 0.0)));
    DESIGNS.iter().flat_map(draws).chain(of_carla).collect()
}
