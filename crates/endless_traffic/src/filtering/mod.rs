//! Riders of two-wheelers who pass a queue that stands or crawls before a red light: beside it in their lane, or between two
//! lanes of the same direction.
//!
//! ```text
//!  ────────────────────────────────┐ line      start   how they get beside the queue, if there is room beside it
//!     [ car ]    [ car ]  [ car ]  │           here    whom they pass, and who lets whom go first
//!  ─ ─ ─ ─ ─ ─ rider → ─ ─ ─ ─ ─ ─ ┤           finish  how they get back, into a gap or ahead of the first
//!        [ car ]  [ car ]   [ car ]│
//!  ────────────────────────────────┘
//! ```
//!
//! Who is beside one of these and has its middle further on goes first, whatever it is: the other keeps its speed or eases
//! off. So the order of a queue may change, but is known at every instant. A queue that moves off is passed no more: riders keep
//! beside it until there is a gap.
//!
//! They are no more than 4 m/s faster than those they pass, nor pass faster ones: the California Highway Patrol's general
//! guidelines (2013) have 10 miles an hour, and Rice, Troszak and Erhardt (2015, "Motorcycle lane-splitting and safety in
//! California") found those no more often hurt who keep to 15.

mod finish;
mod habit;
mod lane_beside;
mod precedence;
mod start;
mod view;
mod way;

pub(crate) use habit::rides_past_queues;
pub(crate) use lane_beside::lane_beside;
pub(crate) use precedence::{goes_past, is_beside, lets_go_first, passes, queues};
pub(crate) use view::RiderView;
pub(crate) use way::{Filtering, pace_past};

use crate::vehicle::Vehicle;

/// Every rider thinks of it once in so many steps.
const THINKS_STEPS: u64 = 6;

/// Goes on with all who pass queues. At most one begins and one ends in a step, so that no two take the same room.
pub(crate) fn step(view: &RiderView<'_>, vehicles: &mut [Vehicle], steps: u64) {
    let (mut began, mut ended) = (false, false);
    for i in 0..vehicles.len() {
        let me = &vehicles[i];
        if !me.rides_past_queues {
            continue;
        }
        let thinks = (steps + i as u64).is_multiple_of(THINKS_STEPS);
        match me.filtering {
            None if thinks && !began => {
                vehicles[i].filtering = start::look(view, vehicles, i);
                began = vehicles[i].filtering.is_some();
            }
            Some(way) if way.is_over(me.rolled) => vehicles[i].filtering = None,
            Some(way) if thinks && !ended && way.drift.back_m.is_none() && finish::may(view, vehicles, i, way) => {
                vehicles[i].filtering = Some(way.back(me.rolled, me.speed, finish::room_m(view, me)));
                ended = true;
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests;
