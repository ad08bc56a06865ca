//! The blueprints that clients may spawn actors from, and what each means here.
//!
//! Ids, attributes and defaults are those of CARLA 0.9.16, as its public reference of sensors and its catalogues tell
//! them. Left out are `sensor.other.rss` and `sensor.other.v2x*` (see [`SensorKind`]). What CARLA keeps in its assets
//! (paints, drivers, who is of which sex) is ours.

mod attribute;
mod camera;
mod entry;
mod kind;
mod library;
mod lidar;
mod other_sensor;
mod prop;
mod prop_table;
mod reading;
mod scenery;
mod sensor;
#[cfg(test)]
mod tests;
mod vehicle;
mod vehicle_table;
mod walker;

pub use entry::Blueprint;
pub use kind::{BlueprintKind, PropBlueprint, PropBody, VehicleBlueprint, WalkerBlueprint};
pub use library::BlueprintLibrary;
pub use reading::{AttributeError, Attributes};
pub use sensor::SensorKind;
