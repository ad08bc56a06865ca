//! The side views of passenger cars, in the middle of what cars of their segment measure.

mod old;
mod passenger;
mod utility;

pub(crate) use old::{old_hatchback, old_pickup, old_saloon};
pub(crate) use passenger::{city, coupe, estate, executive, hatchback, liftback, micro, sedan};
pub(crate) use utility::{crossover, large_pickup, large_suv, mpv, offroad, pickup, suv};
