//! Passenger cars: from a few measures of the side view to a finished body.

mod arch;
mod build;
mod front_rear;
mod shape;
mod trim;
mod variation;

pub(crate) use arch::open_arch;
pub(crate) use front_rear::plate;
pub(crate) use shape::{CarShape, Grille};
