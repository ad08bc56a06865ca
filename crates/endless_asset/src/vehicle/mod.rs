//! Vehicle models.

mod articulated;
mod assemble;
mod attributes;
mod bus;
mod car;
mod cars;
mod design;
mod draw;
mod emergency;
mod fire;
mod freight;
mod heavy;
mod list;
mod lorry;
mod model;
mod paint;
mod rider_fit;
mod roof_load;
mod shell;
mod three_wheeler;
mod tint;
mod truck;
mod two_wheeler;
mod van;
mod wear;
mod wheel;

pub use assemble::Trailer;
pub(crate) use assemble::VehicleParts;
pub use list::VehicleDesignSummary;
pub(crate) use list::{all, design_summaries, drawn};
pub use model::VehicleModel;
pub(crate) use rider_fit::{HelmetKind, RiderFit};
pub use wheel::Wheel;
