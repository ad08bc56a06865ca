//! The side views of passenger cars, in the middle of what cars of their segment measure.

mod passenger;
mod utility;

pub(crate) use passenger::{city, coupe, estate, executive, hatchback, liftback, micro, sedan};
pub(crate) use utility::{crossover, large_pickup, large_suv, mpv, offroad, pickup, suv};
