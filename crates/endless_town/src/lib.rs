//! Towns: a road network dressed with ground, buildings, trees, furniture, parked cars, lamps and camera sites.

mod town;

pub use town::{Lamp, ParkedVehicle, Placement, Town, TownError, What};
