//! Street furniture, plants, parked vehicles and lights.

mod parking;
mod stage;
mod wire;

pub(crate) use parking::keep_the_seen;
pub(crate) use stage::{Spot, Stage};
pub(crate) use wire::hang;
