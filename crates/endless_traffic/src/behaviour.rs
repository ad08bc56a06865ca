//! What vehicles and people are doing, for labels.

use crate::lights::side_of;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use crate::walker::Walker;
use endless_world::{Behaviour, LanePlace};

/// Slower than this people stand, m/s.
const STANDS_MPS: f64 = 0.1;

/// Of somebody who drives or rides.
pub(crate) fn of_vehicle(vehicle: &Vehicle, roads: &Roads) -> Behaviour {
    let lane = vehicle.lane();
    Behaviour {
        lane: (!vehicle.is_parked()).then_some(LanePlace { lane: lane.0, s_m: vehicle.s as f32 }),
        parking: vehicle.kerb_halt.and_then(|halt| halt.parking()),
        lane_left: vehicle.shift.map(|shift| shift.from.0),
        acceleration_mps2: vehicle.acceleration as f32,
        indicating: vehicle.indicating,
        turning: side_of(roads.network.lane(lane).turn),
        ..Behaviour::default()
    }
}

/// Of somebody on foot.
pub(crate) fn of_walker(walker: &Walker, roads: &Roads) -> Behaviour {
    let crossing = walker.crossing(roads).map(|(id, _)| id.0);
    let stands = walker.velocity.length() < STANDS_MPS;
    let at_kerb = !walker.is_at_bench() && (walker.next_crossing(roads).is_some() || walker.waits_for_gap());
    Behaviour { crossing, waiting: stands && at_kerb, jaywalking: walker.on_roadway(), ..Behaviour::default() }
}
