//! For how long those have waited whom somebody at a line keeps from getting on.
//!
//! Where the pieces between junctions are short, queues stand one behind another: who has just come to the line of a piece has not
//! waited yet, but those have who wait for the room on the piece that it would leave. It goes on for all of them, so the longest
//! wait counts, as in the signal control by waiting times of max pressure (Varaiya 2013, "Max pressure control of a network of
//! signalized intersections").

use crate::entry_request::{EntryRequest, STANDS_MPS};
use crate::gridlock::queue_of;
use crate::occupancy::Occupancy;
use crate::queue_stand::longest_stands_s;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::LaneId;
use std::collections::BTreeMap;

/// Queues one behind another that are looked at.
const MOST_QUEUES: usize = 6;

/// Of each request: the longest time that who asks, or somebody in the queue behind it or in one that waits for that, has stood,
/// seconds.
pub(crate) fn pressures_s(
    roads: &Roads,
    occupancy: &Occupancy,
    vehicles: &[Vehicle],
    requests: &[EntryRequest],
) -> Vec<f64> {
    let stands_s = longest_stands_s(roads, vehicles);
    let behind_s = |r: &EntryRequest| stands_s.get(&r.before).copied().filter(|_| r.at_the_line()).unwrap_or(0.0);
    let own_s: Vec<f64> = requests.iter().map(|r| behind_s(r).max(r.waited_s)).collect();
    let at_line = requests.iter().enumerate().filter(|(_, r)| r.at_the_line());
    let heads: BTreeMap<LaneId, usize> = at_line.map(|(k, r)| (r.before, k)).collect();
    // The first of the queue that one waits for to move.
    let next = |k: &usize| {
        let exit = requests[*k].exit;
        let last = occupancy.on(exit).iter().min_by(|a, b| a.rear.total_cmp(&b.rear))?;
        let them = vehicles.get(last.vehicle).filter(|them| them.speed < STANDS_MPS)?;
        heads.get(&queue_of(roads, them, exit)?).copied()
    };
    let mut pressures_s = own_s.clone();
    for &k in heads.values().filter(|&&k| own_s[k] > 0.0) {
        for ahead in std::iter::successors(next(&k), next).take(MOST_QUEUES) {
            pressures_s[ahead] = own_s[k].max(pressures_s[ahead]);
        }
    }
    pressures_s
}
