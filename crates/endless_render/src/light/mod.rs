//! Light sources (sun, sky, lamps, headlights) and the air.

mod beams;
mod clouds;
mod dusk_switch;
mod environment;
mod fog;
mod fog8;
mod halo_grid;
mod lamp_maps;
mod lamps;
mod sky;
mod twilight;

pub use beams::{BeamKind, VehicleBeam};
pub(crate) use dusk_switch::lamp_power;
pub(crate) use environment::{Environment, SUN_SAMPLES, Sun};
pub(crate) use fog::Fog;
pub(crate) use halo_grid::HaloGrid;
pub(crate) use lamp_maps::LampMaps;
pub(crate) use lamps::{Lamps, PointLamp};
pub(crate) use sky::Sky;
