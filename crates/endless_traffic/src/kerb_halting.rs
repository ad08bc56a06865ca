//! How a vehicle gets on with a halt at the kerb.

use crate::bay_way::BayWay;
use crate::incident::Drift;
use crate::kerb_halt::{INDICATES_S, KerbHalt, LEAST_DRIFT_M, LEAVES_M, Phase, STRAIGHT_M};
use crate::occupancy::Occupancy;
use crate::pulling_out;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_world::math::f64::wrap_angle;

/// Pulling in begins so far before the place, metres.
const PULLS_IN_M: f64 = 32.0;
/// Who stands so near before the place has come to it, metres.
const THERE_M: f64 = 1.6;
/// Slower than this a vehicle stands, m/s.
const STANDS_MPS: f64 = 0.05;
/// Who has come to stand further aslant of the lane than this has not got into the bay, and drives out again, radians.
const ASLANT_RAD: f64 = 0.08;

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
                if halt.bay.is_some() && stands_aslant(roads, vehicle) {
                    return leave(vehicle, halt);
                }
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

fn stands_aslant(roads: &Roads, vehicle: &Vehicle) -> bool {
    let lane = roads.network.lane(vehicle.lane()).centerline.at(vehicle.s);
    wrap_angle(vehicle.yaw - lane.heading_rad).abs() > ASLANT_RAD
}

/// Back to the usual place in the lane.
fn leave(vehicle: &Vehicle, halt: KerbHalt) -> Option<KerbHalt> {
    let drift = halt.drift?;
    let back = Drift { back_m: Some(vehicle.rolled), ..drift };
    let drift = Some(halt.bay.map_or(back, |way| way.outwards(vehicle.rolled, halt.left_m)));
    Some(KerbHalt { phase: Phase::Leaving, drift, ..halt })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::driver::Driver;
    use crate::focus::Focus;
    use crate::roads::TrafficMap;
    use crate::settings::DrivingCondition;
    use endless_road::{Lane, LaneId, Polyline, RoadNetwork};
    use endless_world::{Side, Stream, VehicleModelId, VehicleRef, VehicleSpec};
    use glam::DVec3;

    /// What somebody does next who has come to stand in a bay so much aslant, radians.
    fn after_standing(aslant_rad: f64) -> Phase {
        let spec = VehicleSpec::default();
        let line = Polyline::new([DVec3::ZERO, DVec3::X * 100.0]);
        let network = RoadNetwork { lanes: vec![Lane::new(LaneId(0), line, 3.5, 14.0)], ..RoadNetwork::default() };
        let map = TrafficMap::new(network.finish().expect("a lane"), std::slice::from_ref(&spec));
        let roads = Roads::new(&map, &Focus::default(), &[]);
        let asset = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
        let mut stream = Stream::named(1, "test.kerb_halting", &[]);
        let driver = Driver::new(&spec, &DrivingCondition::default(), 0.5, &mut stream);
        let mut vehicle = Vehicle::new(&spec, asset, driver, LaneId(0), 50.0, stream);
        vehicle.yaw = aslant_rad;
        let way = BayWay { place: 0, in_m: 9.0, out_m: 9.0, straight_m: 3.0 };
        let halt = KerbHalt::new(0.0, (LaneId(0), 50.0 + vehicle.half_length, 0.0), (Side::Right, -2.3), 30.0);
        let halt = KerbHalt { drift: Some(BayWay::inwards(0.0, way.in_m, halt.left_m)), ..halt.in_bay(way) };
        go_on(&roads, &vehicle, halt, false, 0.1).expect("still a halt").phase
    }

    #[test]
    fn who_has_not_got_into_the_bay_drives_out_again() {
        for aslant_rad in [-0.05, 0.0, 0.05] {
            assert!(matches!(after_standing(aslant_rad), Phase::Standing { .. }));
        }
        assert!([-0.12, 0.12].into_iter().all(|aslant_rad| after_standing(aslant_rad) == Phase::Leaving));
    }
}
