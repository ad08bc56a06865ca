//! What stands and lies in streets: signals, signs, lamps, furniture, iron, wires, parked vehicles.

pub(crate) mod furniture;
pub(crate) mod iron;
pub(crate) mod parking;
pub(crate) mod post;
pub(crate) mod wire;
