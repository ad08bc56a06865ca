//! Buses serve stops on their way.

use crate::bus_stop::BusHalts;
use crate::kerb_halt::KerbHalt;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_world::math::f64::exp;
use endless_world::{ObjectClass, Stream};

/// Buses know of stops so far ahead, metres: from there on they stay on the lane.
const KNOWN_M: f64 = 120.0;
/// The share of stops on its way that a bus serves; at the others nobody waits for its line.
const SERVED: f64 = 0.7;
/// Dwell times: their mean, of stops between a downtown's and an outskirt's, and their spread, log-normal with a coefficient of
/// variation of 0.6; shortest and longest (Transit Capacity and Quality of Service Manual, third edition, TCRP Report 165,
/// chapter 6).
const DWELL_S: f64 = 22.0;
const DWELL_SIGMA: f64 = 0.5545;
const DWELLS_S: [f64; 2] = [10.0, 60.0];

/// A bus without anything else to do takes notice of the next stop that it serves. To be called once a second.
pub(crate) fn look_out(roads: &Roads, halts: &BusHalts, vehicle: &mut Vehicle) {
    let busy = vehicle.kerb_halt.is_some() || vehicle.order.is_some() || vehicle.shift.is_some();
    if vehicle.class == ObjectClass::Bus && !busy {
        vehicle.kerb_halt = next_halt(roads, halts, vehicle);
    }
}

fn next_halt(roads: &Roads, halts: &BusHalts, vehicle: &Vehicle) -> Option<KerbHalt> {
    let least_m = KerbHalt::least_ahead_m(vehicle.speed);
    let length_m = 2.0 * vehicle.half_length;
    let width_m = f64::from(roads.specs[vehicle.asset.model.index()].width_m);
    for (lane, base) in vehicle.ahead(roads).take_while(|(_, base)| *base < KNOWN_M) {
        for halt in halts.on(lane) {
            let ahead_m = base + halt.front() - vehicle.half_length;
            if ahead_m < least_m || ahead_m > KNOWN_M || !halt.takes(length_m) || !serves(vehicle, halt.stop) {
                continue;
            }
            let mut own = Stream::named(
                vehicle.asset.variant,
                "traffic.bus_stop.dwell",
                &[halt.stop as u64, vehicle.rolled.to_bits()],
            );
            let place = (lane, halt.front(), ahead_m);
            let kerb = (halt.side, halt.left_m(width_m));
            let kerb_halt = KerbHalt::new(vehicle.driver.lateral_m, place, kerb, dwell_s(&mut own));
            return Some(kerb_halt.for_stop(halt.is_open.then_some(halt.stop)));
        }
    }
    None
}

/// Whether a bus is of a line that stops there.
pub(crate) fn serves(vehicle: &Vehicle, stop: usize) -> bool {
    Stream::named(vehicle.asset.variant, "traffic.bus_stop", &[stop as u64]).chance(SERVED)
}

fn dwell_s(own: &mut Stream) -> f64 {
    let deviation = DWELL_SIGMA * own.normal() - 0.5 * DWELL_SIGMA * DWELL_SIGMA;
    (DWELL_S * exp(deviation)).clamp(DWELLS_S[0], DWELLS_S[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dwell_times_are_those_of_the_manual() {
        let mut own = Stream::named(1, "test.dwell", &[]);
        let times: Vec<f64> = (0..4000).map(|_| dwell_s(&mut own)).collect();
        let mean = times.iter().sum::<f64>() / times.len() as f64;
        assert!((mean - DWELL_S).abs() < 2.0, "{mean}");
        assert!(times.iter().all(|s| (10.0..=60.0).contains(s)));
        assert!(times.iter().any(|s| *s > 45.0) && times.iter().any(|s| *s < 12.0));
    }
}
