//! Traffic: vehicles, two-wheelers, pedestrians and signals on a road network.
//!
//! [`Simulation`] owns a copy of the network and advances frame by frame; [`Simulation::state`] is what the renderer
//! sees. Everything random comes from streams keyed by the scene's seed, and a frame is a fixed number of equal steps,
//! so the same scene gives the same states, bit for bit.

mod approach;
mod attraction;
mod crossing;
mod driver;
mod footprint;
mod kinematics;
mod lane_change;
mod lights;
mod occupancy;
mod overlap;
mod population;
mod roads;
mod settings;
mod signals;
mod simulation;
mod spawn;
mod steering;
mod sweep;
mod trailer;
mod vehicle;
mod walker;

pub use population::{Conditions, Population};
pub use settings::{Fleet, TrafficSettings};
pub use simulation::Simulation;
