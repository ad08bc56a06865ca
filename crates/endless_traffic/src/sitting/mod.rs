//! People who sit down on benches.
//!
//! Whoever walks alone past a bench may choose a free seat of it ([`choice`]): they come along the sidewalk to where the seat is
//! nearest, leave it, turn round before the seat, sit down, and after a while get up again and walk on ([`rest`]). A seat belongs
//! to who has chosen it.

mod choice;
mod errand;
mod passing;
mod places;
mod rest;

pub(crate) use choice::{choose, seat_some};
pub(crate) use errand::Rest;
pub(crate) use places::BenchPlaces;
