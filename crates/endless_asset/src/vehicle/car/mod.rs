//! Passenger cars: from a few measures of the side view to a finished body.

mod arch;
mod build;
mod face;
mod shape;
mod trim;
mod vary;

pub(crate) use arch::open_arch;
pub(crate) use face::plate;
pub(crate) use shape::{CarShape, Grille};
