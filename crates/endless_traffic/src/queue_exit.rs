//! Drivers in a queue who leave it for the lane beside, where that moves.
//!
//! Who has stood for long beside a lane with room stops further behind those ahead, and pulls out at walking pace as soon as there is
//! a gap: forced lane changes (Hidas 2005, "Modelling vehicle interactions in microscopic simulation of merging and weaving"). Without
//! them the queue on a lane that is blocked would grow for ever, while the lane beside is empty.

use crate::occupancy::{Occupancy, Occupant};
use crate::roads::Roads;
use crate::vehicle::{LaneChange, Vehicle};
use endless_road::LaneId;
use endless_world::ObjectClass;

/// Slower than this vehicles queue, m/s; and who has done so for so long would rather be on the lane beside, seconds.
const QUEUES_MPS: f64 = 2.0;
const QUEUED_S: f64 = 45.0;
/// They try for so long, seconds.
const TRIES_S: f64 = 25.0;
/// Time in a queue is forgotten so many times as fast once it moves.
const FORGETS: f64 = 4.0;
/// The lane beside is looked along so far, metres; it is open where less of that is in a queue, each of which takes so much, metres.
const SEEN_M: f64 = 60.0;
const OPEN: f64 = 0.5;
const TAKES_M: f64 = 7.5;
/// Room to those behind there, metres.
const BEHIND_M: f64 = 3.0;
/// How far somebody who pulls out drives meanwhile, metres, and how fast, m/s.
pub(crate) const PULLS_OUT_M: f64 = 12.0;
pub(crate) const PULLS_OUT_MPS: f64 = 3.0;
/// Room ahead that this takes, with the widest vehicle there, metres.
const WIDEST_HALF_M: f64 = 1.3;
const APART_M: f64 = 0.2;
/// Room that is kept to those ahead before, metres more than usual.
pub(crate) const KEEPS_M: f64 = 6.0;
/// Room ahead on the lane beside, metres.
pub(crate) const ROOM_THERE_M: f64 = PULLS_OUT_M + 4.0;

/// Takes notice of how long somebody has queued, and of lanes beside that are open: once a second.
pub(crate) fn notice(roads: &Roads, occupancy: &Occupancy, vehicles: &mut [Vehicle], i: usize) {
    let me = &vehicles[i];
    let queued_s = me.queued_s + if me.speed < QUEUES_MPS { 1.0 } else { -FORGETS };
    // Who found no gap closes up, and tries again later.
    let queued_s = if queued_s > QUEUED_S + TRIES_S { 0.0 } else { queued_s.max(0.0) };
    let pulls_out = queued_s > QUEUED_S && could_pull_out(roads, occupancy, vehicles, i);
    (vehicles[i].queued_s, vehicles[i].pulls_out) = (queued_s, pulls_out);
}

/// Whether a vehicle is short and free to go where it likes, and a lane beside open. Where the one ahead keeps room already there is
/// no more to be kept, or the queue would grow longer than the road.
fn could_pull_out(roads: &Roads, occupancy: &Occupancy, vehicles: &[Vehicle], i: usize) -> bool {
    let me = &vehicles[i];
    let bound = me.order.is_some() || me.kerb_halt.is_some() || me.filtering.is_some();
    let lane = roads.network.lane(me.lane());
    if bound || me.long() || me.trailer.is_some() || me.class == ObjectClass::Bicycle || lane.junction.is_some() {
        return false;
    }
    let leader = occupancy.leader(roads, vehicles, i, SEEN_M).and_then(|l| vehicles.get(l.vehicle));
    let opens = |target: &LaneId| is_open(roads, occupancy, me, *target);
    leader.is_none_or(|l| !l.pulls_out) && [lane.left, lane.right].iter().flatten().any(opens)
}

/// Whether one does not come into a ring on a lane beside.
pub(crate) fn leads_on(roads: &Roads, me: &Vehicle, target: LaneId) -> bool {
    !roads.table(target).leads_back || roads.table(me.lane()).leads_back
}

/// Whether a lane beside moves, and leads on no worse.
fn is_open(roads: &Roads, occupancy: &Occupancy, me: &Vehicle, target: LaneId) -> bool {
    if !roads.allowed(me.asset.model)[target.index()] || !leads_on(roads, me, target) {
        return false;
    }
    let at = roads.network.lane(me.lane()).centerline.at(me.s).position.truncate();
    let (s, _) = roads.network.lane(target).centerline.project(at);
    let queue = || occupancy.on(target).iter().filter(|o| o.speed < QUEUES_MPS);
    let is_in = |o: &&Occupant, from: f64, to: f64| o.front > from && o.rear < to;
    let beside = queue().any(|o| is_in(&o, s - me.half_length - BEHIND_M, s + me.half_length + ROOM_THERE_M));
    let seen_m = SEEN_M.min(roads.table(target).length - s);
    let queue_m = TAKES_M * queue().filter(|o| is_in(o, s, s + SEEN_M)).count() as f64;
    !beside && seen_m > ROOM_THERE_M && queue_m < OPEN * seen_m
}

/// How far ahead of the front bumper those must be on the lane that is left who are no hindrance, metres; none, where the lanes are
/// too near to one another.
pub(crate) fn clear_m(vehicle: &Vehicle, offset_m: f64, length_m: f64) -> Option<f64> {
    let aside_m = vehicle.half_width + WIDEST_HALF_M + APART_M;
    let places = (1..=24).map(|k| f64::from(k) / 24.0);
    let over = places.into_iter().find(|&u| LaneChange::rise(u) * offset_m.abs() >= aside_m);
    over.map(|u| u * length_m)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::driver::Driver;
    use crate::focus::Focus;
    use crate::roads::TrafficMap;
    use crate::settings::DrivingCondition;
    use endless_road::{Lane, Polyline, RoadNetwork};
    use endless_world::{Stream, VehicleModelId, VehicleRef, VehicleSpec};
    use glam::DVec3;

    #[test]
    fn who_has_stood_long_beside_an_open_lane_pulls_out_unless_the_one_ahead_does() {
        let spec = VehicleSpec::default();
        let lane = |id: u32, y: f64| {
            Lane::new(LaneId(id), Polyline::new([0.0, 300.0].map(|x| DVec3::new(x, y, 0.0))), 3.5, 13.9)
        };
        let right = Lane { left: Some(LaneId(1)), ..lane(0, 0.0) };
        let left = Lane { right: Some(LaneId(0)), ..lane(1, 3.5) };
        let network = RoadNetwork { lanes: vec![right, left], ..RoadNetwork::default() }.finish().expect("a road");
        let roads = Roads::new(&TrafficMap::new(network, std::slice::from_ref(&spec)), &Focus::default(), &[]);
        let asset = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
        let after = |seconds: u32, beside_s: Option<f64>| {
            let mut stream = Stream::named(1, "test.queue_exit", &[]);
            let places = [(0, 100.0), (0, 93.0)].into_iter().chain(beside_s.map(|s| (1, s)));
            let mut vehicles: Vec<Vehicle> = places
                .map(|(lane, s)| {
                    let driver = Driver::new(&spec, &DrivingCondition::default(), 0.5, &mut stream);
                    Vehicle::new(&spec, asset, driver, LaneId(lane), s, stream.fork(s as u64))
                })
                .collect();
            let mut occupancy = Occupancy::default();
            occupancy.rebuild(&roads, &vehicles);
            for _ in 0..seconds {
                (0..2).for_each(|i| notice(&roads, &occupancy, &mut vehicles, i));
            }
            [0, 1].map(|i| vehicles[i].pulls_out)
        };
        assert_eq!(after(40, None), [false, false]);
        assert_eq!(after(50, None), [true, false]);
        assert_eq!(after(50, Some(108.0)), [false, false], "no room there");
        assert_eq!(after(75, None), [false, false], "it closes up");
    }
}
