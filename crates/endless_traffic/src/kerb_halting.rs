//! How a vehicle gets on with a halt at the kerb.

use crate::bay_way::BayWay;
use crate::incident::Drift;
use crate::kerb_halt::{INDICATES_S, KerbHalt, LEAST_DRIFT_M, LEAVES_M, Phase, STRAIGHT_M};
use crate::occupancy::Occupancy;
use crate::pulling_out;
use crate::roads::Roads;
use crate::vehicle::Vehicle;

/// Pulling in begins so far before the place, metres.
const PULLS_IN_M: f64 = 32.0;
/// Who stands so near before the place has come to it, metres.
const THERE_M: f64 = 1.6;
/// Slower than this a vehicle stands, m/s.
const STANDS_MPS: f64 = 0.05;

/// Goes on with all halts by one step.
pub(crate) fn step(roads: &Roads, occupancy: &Occupancy, vehicles: &mut [Vehicle], step_s: f64) {
    for i in 0..vehicles.len() {
        let Some(halt) = vehicles[i].kerb_halt else { continue };
        // Who is parked waits for a gap.
        let may_leave = match (halt.bay, halt.phase) {
            (Some(way), Phase::Standing { left_s }) => {
                left_s <= 0.0 && pulling_out::is_free(roads, occupancy, vehicles, i, way.out_m)
            }
            _ => true,
        };
        vehicles[i].kerb_halt = go_on(roads, &vehicles[i], halt, may_leave, step_s);
    }
}

fn go_on(roads: &Roads, vehicle: &Vehicle, mut halt: KerbHalt, may_leave: bool, step_s: f64) -> Option<KerbHalt> {
    let stands = vehicle.speed < STANDS_MPS;
    match halt.phase {
        Phase::Coming => {
            let mut ahead = vehicle.ahead(roads).filter(|(lane, _)| *lane == halt.lane);
            let ahead_m = ahead.next().map(|(_, base)| base + halt.front_s - vehicle.half_length);
            let Some(ahead_m) = ahead_m.filter(|ahead_m| *ahead_m > -1.0) else { return leave(vehicle, halt) };
            halt.ahead_m = ahead_m;
            let (begin_m, left_m) = (vehicle.rolled, halt.left_m);
            halt.drift = halt.drift.or_else(|| match halt.bay {
                Some(way) => {
                    // The line lies beyond the place.
                    let pulls_in = ahead_m - LEAVES_M < way.begins_m();
                    pulls_in.then(|| BayWay::inwards(begin_m, way.in_m, left_m))
                }
                None => {
                    let length_m = (ahead_m - STRAIGHT_M).max(LEAST_DRIFT_M);
                    (ahead_m < PULLS_IN_M).then_some(Drift { begin_m, length_m, left_m, back_m: None })
                }
            });
            if stands && ahead_m < THERE_M {
                halt.phase = Phase::Standing { left_s: halt.stands_s + INDICATES_S };
            }
        }
        Phase::Standing { left_s } if left_s <= 0.0 && may_leave => return leave(vehicle, halt),
        Phase::Standing { left_s } => {
            halt.phase = Phase::Standing { left_s: left_s - step_s };
            halt.stood_s += step_s;
        }
        Phase::Leaving => return halt.drift.filter(|drift| !drift.is_over(vehicle.rolled)).map(|_| halt),
    }
    Some(halt)
}

/// Back to the usual place in the lane.
fn leave(vehicle: &Vehicle, halt: KerbHalt) -> Option<KerbHalt> {
    let drift = halt.drift?;
    let back = Drift { back_m: Some(vehicle.rolled), ..drift };
    let drift = Some(halt.bay.map_or(back, |way| way.outwards(vehicle.rolled, halt.left_m)));
    Some(KerbHalt { phase: Phase::Leaving, drift, ..halt })
}
