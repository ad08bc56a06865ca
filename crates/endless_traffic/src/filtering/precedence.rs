//! Whom riders pass, and who is beside whom.

use super::way::Filtering;
use crate::across::Across;
use crate::vehicle::Vehicle;

/// Room between the side of a rider and that of a vehicle that is passed, metres: where lanes are 3.25 m wide there is hardly
/// more between those who stand side by side.
pub(super) const ROOM_M: f64 = 0.2;
/// Bodies with so much between their sides do not touch, whatever they do along the road, metres.
pub(super) const CLEAR_M: f64 = 0.15;
/// Faster ones are not passed, m/s.
pub(super) const QUEUES_MPS: f64 = 2.0;
/// Who is less than this ahead, bumper to bumper, is beside somebody, metres.
const BESIDE_M: f64 = 2.0;
/// Who is slower has not set off, m/s.
pub(super) const STAYS_MPS: f64 = 0.1;
/// Room kept to who stands at the end of the queue, metres.
pub(super) const BEHIND_M: f64 = 1.0;

/// Whether somebody stands or crawls in a queue and stays in its place there: who may go is passed no more.
pub(crate) fn queues(vehicle: &Vehicle) -> bool {
    vehicle.speed < QUEUES_MPS && waits(vehicle)
}

/// Whether somebody keeps their place and may not go on yet.
pub(super) fn waits(vehicle: &Vehicle) -> bool {
    vehicle.shift.is_none()
        && vehicle.kerb_halt.is_none()
        && vehicle.order.is_none()
        && vehicle.rights_of_way.is_empty()
}

/// Whether a rider who takes this of a lane's width passes somebody in a queue who takes that of it, so far ahead: once beside,
/// or if that will be in time.
pub(crate) fn passes(me: &Vehicle, across: &Across, theirs: &Across, gap_m: f64) -> bool {
    let Some(Filtering { drift, .. }) = me.filtering.filter(|way| way.drift.back_m.is_none()) else { return false };
    let to_go_m = drift.left_to_go_m(me.rolled);
    let in_time = to_go_m <= 0.0 || gap_m > to_go_m + BEHIND_M;
    in_time && goal(me, across).is_clear_of(theirs, ROOM_M)
}

/// Whether somebody in a lane goes past a rider who reaches over its line, at this speed, and waits for the way of the lane beside:
/// they are in two queues, and there is room between them.
pub(crate) fn goes_past(me: &Vehicle, across: &Across, rider: &Across, speed_mps: f64) -> bool {
    me.filtering.is_none() && speed_mps < STAYS_MPS && across.is_clear_of(rider, ROOM_M)
}

/// What a rider will take of a lane's width, of which this is taken on the way there.
fn goal(me: &Vehicle, across: &Across) -> Across {
    let width_m = 2.0 * me.half_width;
    let leads_left = me.filtering.is_some_and(|way| way.goal_m() > way.aside(me.rolled).0);
    if leads_left {
        Across { right_m: across.left_m - width_m, ..*across }
    } else {
        Across { left_m: across.right_m + width_m, ..*across }
    }
}

/// Whether two of whom one passes queues are beside one another, with room between, so far apart, bumper to bumper.
pub(crate) fn is_beside(across: &Across, theirs: &Across, gap_m: f64) -> bool {
    gap_m < BESIDE_M && across.is_clear_of(theirs, CLEAR_M)
}

/// Whether somebody lets another go first who is beside them, with room between: not who may go while the other stands and may
/// not. That one may wait for who waits for this one.
pub(crate) fn lets_go_first(me: &Vehicle, other: &Vehicle) -> bool {
    me.rights_of_way.is_empty() || !waits(other) || other.speed >= STAYS_MPS
}
