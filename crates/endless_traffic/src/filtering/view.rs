//! What riders see of a queue.

use crate::occupancy::Occupancy;
use crate::roads::Roads;
use endless_road::swept::OrientedRectangle;
use endless_world::SignalState;

/// What riders see.
pub(crate) struct RiderView<'a> {
    pub(crate) roads: &'a Roads,
    pub(crate) occupancy: &'a Occupancy,
    pub(crate) signals: &'a [SignalState],
    /// Bodies of parked vehicles.
    pub(crate) parked: &'a [OrientedRectangle],
}
