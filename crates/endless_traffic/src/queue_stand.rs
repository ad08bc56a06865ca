//! For how long those have stood who queue before a line.
//!
//! Where few get over a line in a cycle, who is first has just come there; those behind have stood since the queue last moved. What
//! counts is the longest of these times, as for the queues of a switch, of which the one with the oldest packet is served first so that
//! none starves (Mekkittikul and McKeown 1996, "A starvation-free algorithm for achieving 100% throughput in an input-queued switch").

use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::LaneId;
use std::collections::BTreeMap;

/// Who is further behind the one ahead, or the line, is not in the queue, metres.
const APART_M: f64 = 15.0;

/// Somebody before a line, metres from there to both ends.
struct Queued {
    front_m: f64,
    rear_m: f64,
    stands_s: f64,
}

/// By the lane at whose end they queue, if anybody does: the longest time for which one of them has stood, seconds.
pub(crate) fn longest_stands_s(roads: &Roads, vehicles: &[Vehicle]) -> BTreeMap<LaneId, f64> {
    let mut queues: BTreeMap<LaneId, Vec<Queued>> = BTreeMap::new();
    for vehicle in vehicles.iter().filter(|vehicle| !vehicle.is_parked()) {
        let Some((lane, line_m)) = line_ahead(roads, vehicle) else { continue };
        let [front_m, rear_m] = [-1.0, 1.0].map(|end| line_m + end * vehicle.half_length);
        queues.entry(lane).or_default().push(Queued { front_m, rear_m, stands_s: vehicle.stands_s });
    }
    queues.into_iter().map(|(lane, queue)| (lane, longest_s(queue))).collect()
}

/// The lane before the next junction, and how far ahead its end is, metres; none within a junction.
fn line_ahead(roads: &Roads, vehicle: &Vehicle) -> Option<(LaneId, f64)> {
    let road = vehicle.ahead(roads).take_while(|(lane, _)| roads.table(*lane).junction.is_none());
    road.last().map(|(lane, base)| (lane, base + roads.table(lane).length))
}

/// The longest time for which one of those has stood who are one behind another from the line on, seconds.
fn longest_s(mut queue: Vec<Queued>) -> f64 {
    queue.sort_by(|a, b| a.front_m.total_cmp(&b.front_m));
    let (mut end_m, mut longest_s) = (0.0, 0.0_f64);
    for one in queue {
        if one.front_m > end_m + APART_M {
            break;
        }
        (end_m, longest_s) = (one.rear_m.max(end_m), longest_s.max(one.stands_s));
    }
    longest_s
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_has_stood_longest_in_the_queue_counts_and_nobody_further_behind() {
        let one = |front_m: f64, stands_s: f64| Queued { front_m, rear_m: front_m + 4.5, stands_s };
        assert_eq!(longest_s(vec![]), 0.0);
        assert_eq!(longest_s(vec![one(8.0, 90.0), one(1.0, 2.0)]), 90.0);
        assert_eq!(longest_s(vec![one(8.0, 9.0), one(1.0, 2.0), one(12.5 + APART_M + 0.1, 90.0)]), 9.0);
        assert_eq!(longest_s(vec![one(APART_M + 0.1, 90.0)]), 0.0, "it does not stand at the line");
    }
}
