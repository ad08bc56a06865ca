//! The gap for which somebody waits who is parked and wants to pull out.

use crate::occupancy::Occupancy;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::LaneId;

/// The least time until the next vehicle comes, seconds: the base critical headway of a right turn from a minor street (Highway
/// Capacity Manual 2010, exhibit 19-10).
const CRITICAL_S: f64 = 6.2;
/// Who crawls behind may be as near as this, metres.
const BEHIND_M: f64 = 5.0;
/// It looks back this far, metres.
const LOOKS_BACK_M: f64 = 140.0;
/// Free lane beyond the way out, metres.
const BEYOND_M: f64 = 4.0;
/// Who is about to change to the lane within this along it is let go first, metres.
const CHANGES_M: f64 = 45.0;

/// Whether the lane is free for a vehicle beside it that needs so much of it to pull out, metres.
pub(crate) fn is_free(roads: &Roads, occupancy: &Occupancy, vehicles: &[Vehicle], i: usize, out_m: f64) -> bool {
    let me = &vehicles[i];
    is_free_ahead(roads, occupancy, me, out_m) && is_free_behind(roads, occupancy, me) && {
        let comes = |other: &Vehicle| {
            other.intent.is_some_and(|(target, _)| target == me.lane())
                && other.pose.position.distance(me.pose.position) < CHANGES_M as f32
        };
        !vehicles.iter().any(comes)
    }
}

fn is_free_ahead(roads: &Roads, occupancy: &Occupancy, me: &Vehicle, out_m: f64) -> bool {
    let reach_m = me.half_length + out_m + BEYOND_M;
    me.ahead(roads).take_while(|(_, base)| *base < reach_m).all(|(lane, base)| {
        let [from, to] = [-me.half_length - base, reach_m - base];
        occupancy.on(lane).iter().all(|other| other.front < from || other.rear > to)
            && occupancy.people_on(lane).iter().all(|person| person.s < from || person.s > to)
    })
}

fn is_free_behind(roads: &Roads, occupancy: &Occupancy, me: &Vehicle) -> bool {
    // Lanes with where they are looked at from, and how far that is behind.
    let mut lanes: Vec<(LaneId, f64, f64)> = vec![(me.lane(), me.s - me.half_length, 0.0)];
    while let Some((lane, to, behind_m)) = lanes.pop() {
        let comes = |front: f64, speed: f64| {
            front < to + 2.0 * me.half_length
                && behind_m + to - front < (CRITICAL_S * me.driver.gap_factor * speed).max(BEHIND_M)
        };
        if occupancy.on(lane).iter().any(|other| comes(other.front, other.speed)) {
            return false;
        }
        let behind_m = behind_m + to.max(0.0);
        if behind_m < LOOKS_BACK_M {
            let before = roads.network.lane(lane).predecessors.iter();
            lanes.extend(before.map(|&before| (before, roads.table(before).length, behind_m)));
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bay_way::BayWay;
    use crate::driver::Driver;
    use crate::focus::Focus;
    use crate::kerb_halt::{KerbHalt, Phase};
    use crate::roads::TrafficMap;
    use crate::settings::DrivingCondition;
    use endless_road::{Lane, Polyline, RoadNetwork};
    use endless_world::{Side, Stream, VehicleModelId, VehicleRef, VehicleSpec};
    use glam::DVec3;

    /// Whether somebody beside a lane at 150 m may pull out before others who are there with these speeds.
    fn may(others: &[(f64, f64)]) -> bool {
        let spec = VehicleSpec::default();
        let line = |from: f64| Polyline::new([DVec3::X * from, DVec3::X * (from + 100.0)]);
        let lane = |id: u32, next: &[u32]| Lane {
            successors: next.iter().map(|&next| LaneId(next)).collect(),
            ..Lane::new(LaneId(id), line(100.0 * f64::from(id)), 3.5, 14.0)
        };
        let lanes = vec![lane(0, &[1]), lane(1, &[2]), lane(2, &[])];
        let network = RoadNetwork { lanes, ..RoadNetwork::default() }.finish().expect("three lanes");
        let map = TrafficMap::new(network, std::slice::from_ref(&spec));
        let roads = Roads::new(&map, &Focus::default(), &[]);
        let asset = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
        let mut stream = Stream::named(1, "test.pulling_out", &[]);
        let mut vehicle = |x: f64, speed: f64| {
            let driver = Driver::new(&spec, &DrivingCondition::default(), 0.5, &mut stream);
            let lane = LaneId((x / 100.0) as u32);
            let mut vehicle = Vehicle::new(&spec, asset, driver, lane, x % 100.0, stream.fork(0));
            vehicle.driver.gap_factor = 1.0;
            vehicle.plan(&roads);
            Vehicle { speed, ..vehicle }
        };
        let way = BayWay { place: 0, in_m: 9.0, out_m: 9.0, straight_m: 3.0 };
        let halt = KerbHalt::new(0.0, (LaneId(1), 52.0, 0.0), (Side::Right, -2.8), 1.0);
        let halt = KerbHalt { bay: Some(way), phase: Phase::Standing { left_s: 0.0 }, ..halt };
        let mut vehicles = vec![Vehicle { kerb_halt: Some(halt), ..vehicle(150.0, 0.0) }];
        vehicles.extend(others.iter().map(|&(x, speed)| vehicle(x, speed)));
        let mut occupancy = Occupancy::default();
        occupancy.rebuild(&roads, &vehicles);
        is_free(&roads, &occupancy, &vehicles, 0, 9.0)
    }

    #[test]
    fn a_gap_of_the_critical_headway_is_taken_and_no_shorter_one() {
        assert!(may(&[]));
        let behind = |gap_m: f64, speed: f64| [(150.0 - f64::from(VehicleSpec::default().length_m) - gap_m, speed)];
        assert!(may(&behind(CRITICAL_S * 10.0 + 1.0, 10.0)) && !may(&behind(CRITICAL_S * 10.0 - 1.0, 10.0)));
        // On the lane before, too, and who stands is passed when there is room.
        assert!(!may(&[(80.0, 13.0)]) && may(&[(80.0, 5.0)]));
        assert!(may(&behind(BEHIND_M + 0.5, 0.0)) && !may(&behind(BEHIND_M - 0.5, 0.0)));
    }

    #[test]
    fn nobody_pulls_out_into_who_is_beside_or_right_ahead() {
        assert!(!may(&[(151.0, 0.0)]) && !may(&[(163.0, 0.0)]));
        assert!(may(&[(185.0, 0.0)]));
    }
}
