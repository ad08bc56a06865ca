//! What stands and lies in streets: signals, signs, lamps, furniture, iron, wires, parked vehicles.

pub(crate) mod furniture;
pub(crate) mod iron;
pub(crate) mod kerb_guard;
pub(crate) mod parking;
mod parking_bay;
pub(crate) mod post;
pub(crate) mod sign_standard;
pub(crate) mod street_life;
pub(crate) mod street_sign;
mod swept_ground;
pub(crate) mod walk_signal;
pub(crate) mod wire;
