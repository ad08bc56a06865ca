//! Circles of queues that wait for one another.
//!
//! Where the queue beyond a junction reaches back to it, nobody drives into the junction. When that queue waits for another one in the
//! same way, and so on back to the first, nobody would move for ever. All of them are let on by one vehicle then: each makes the
//! room that the one behind it needs.
//!
//! ```text
//!   a a a a →┐      the first a waits for room behind the b,
//!   ↑        b      the first b for room behind the c,
//!   d        b      the first c for room behind the d,
//!   d        ↓      the first d for room behind the a
//!   └← c c c c
//! ```

use crate::entry_request::EntryRequest;
use crate::occupancy::Occupancy;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::LaneId;
use std::collections::BTreeMap;

/// A queue whose first has waited for so long stands, seconds.
const STANDS_S: f64 = 45.0;
/// Queues in the longest circle that is looked for.
const MOST_QUEUES: usize = 24;

/// The requests, by index in ascending order, of those who are first in queues that wait for one another in a circle.
/// `goes_nowhere` tells of each whether it stands at the line without room beyond the junction.
pub(crate) fn circles(
    roads: &Roads,
    occupancy: &Occupancy,
    vehicles: &[Vehicle],
    requests: &[EntryRequest],
    goes_nowhere: &[bool],
) -> Vec<usize> {
    let stands = |r: &EntryRequest| r.waited_s > STANDS_S;
    let heads: BTreeMap<LaneId, usize> = requests
        .iter()
        .enumerate()
        .filter(|&(k, r)| stands(r) && goes_nowhere[k])
        .map(|(k, r)| (r.before, k))
        .collect();
    let next = |k: usize| {
        let exit = requests[k].exit;
        let last = occupancy.on(exit).iter().min_by(|a, b| a.rear.total_cmp(&b.rear))?;
        let them = vehicles.get(last.vehicle)?;
        heads.get(&queue_of(roads, them, exit)?).copied()
    };
    let closes = |&k: &usize| std::iter::successors(next(k), |&k| next(k)).take(MOST_QUEUES).any(|other| other == k);
    let mut found: Vec<usize> = heads.values().copied().filter(closes).collect();
    found.sort_unstable();
    found
}

/// The lane at whose end the queue on a lane waits, as the way of somebody in it tells.
pub(crate) fn queue_of(roads: &Roads, vehicle: &Vehicle, exit: LaneId) -> Option<LaneId> {
    let onwards = vehicle.route.iter().copied().skip_while(|&lane| lane != exit);
    onwards.take_while(|&lane| roads.table(lane).junction.is_none()).last()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::driver::Driver;
    use crate::entry_request::request;
    use crate::focus::Focus;
    use crate::roads::TrafficMap;
    use crate::settings::DrivingCondition;
    use endless_road::{Junction, JunctionId, Lane, Polyline, RoadNetwork};
    use endless_world::math::f64::sin_cos;
    use endless_world::{Stream, VehicleModelId, VehicleRef, VehicleSpec};
    use glam::DVec3;

    /// Four lanes around a block, each with a way over a junction to the next.
    fn block(spec: &VehicleSpec) -> Roads {
        let corners = [[0.0, 0.0], [60.0, 0.0], [60.0, 60.0], [0.0, 60.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let line = |a: DVec3, b: DVec3| Polyline::new((0..=20).map(|k| a.lerp(b, f64::from(k) / 20.0)));
        let mut network = RoadNetwork::default();
        for k in 0..4 {
            let (a, b, c) = (corners[k], corners[(k + 1) % 4], corners[(k + 2) % 4]);
            let ahead = (b - a).normalize();
            let street = Lane::new(LaneId(2 * k as u32), line(a + ahead * 10.0, b - ahead * 10.0), 3.5, 13.9);
            // A quarter of a circle.
            let centre = b - ahead * 10.0 + (c - b).normalize() * 10.0;
            let arc = (0..=16).map(|i| {
                let turn = f64::from(i) / 16.0 * std::f64::consts::FRAC_PI_2;
                let (sin, cos) = sin_cos(turn);
                centre - (c - b).normalize() * (10.0 * cos) + ahead * (10.0 * sin)
            });
            let mut way = Lane::new(LaneId(2 * k as u32 + 1), Polyline::new(arc), 3.5, 13.9);
            way.junction = Some(JunctionId(k as u16));
            way.successors = vec![LaneId(2 * ((k as u32 + 1) % 4))];
            let street = Lane { successors: vec![way.id], ..street };
            network.junctions.push(Junction { lanes: vec![way.id], ..Junction::default() });
            network.lanes.extend([street, way]);
        }
        let network = network.finish().expect("a block");
        Roads::new(&TrafficMap::new(network, std::slice::from_ref(spec)), &Focus::default(), &[])
    }

    #[test]
    fn four_who_wait_for_one_another_are_let_on_and_fewer_are_not() {
        let spec = VehicleSpec::default();
        let roads = block(&spec);
        let mut stream = Stream::named(1, "test.gridlock", &[]);
        let asset = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
        let vehicles: Vec<Vehicle> = (0..4)
            .map(|k| {
                let driver = Driver::new(&spec, &DrivingCondition::default(), 0.5, &mut stream);
                let lane = LaneId(2 * k);
                let s = roads.table(lane).length - 0.5 * f64::from(spec.length_m) - 0.5;
                let mut vehicle = Vehicle::new(&spec, asset, driver, lane, s, stream.fork(u64::from(k)));
                vehicle.plan(&roads);
                vehicle
            })
            .collect();
        let mut occupancy = Occupancy::default();
        occupancy.rebuild(&roads, &vehicles);
        let mut requests: Vec<EntryRequest> =
            (0..4).map(|i| request(&roads, &[], &vehicles[i], i).expect("at a junction")).collect();
        requests.iter_mut().for_each(|r| r.waited_s = 2.0 * STANDS_S);
        let found =
            |requests: &[EntryRequest], room: bool| circles(&roads, &occupancy, &vehicles, requests, &[!room; 4]);
        assert_eq!(found(&requests, false), [0, 1, 2, 3]);
        assert!(found(&requests, true).is_empty());
        requests[2].waited_s = 1.0;
        assert!(found(&requests, false).is_empty());
    }
}
