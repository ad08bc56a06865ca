//! The way into a bay and out of it, forwards, rehearsed with the vehicle's own motion among what stands there.

use crate::bay_way::{BayWay, out};
use crate::kerb_halt::KerbHalt;
use crate::kinematics;
use crate::parking_place::ParkingPlace;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::swept::OrientedRectangle;
use endless_world::math::f64::wrap_angle;
use glam::DVec2;
use std::collections::VecDeque;

/// Lengths of the way across, in and out, the most comfortable first, metres.
const LENGTHS_M: [f64; 6] = [13.0, 11.5, 10.3, 9.3, 8.5, 7.8];
/// Pulling in ends so far before the place, metres: a vehicle straightens up on the rest of the way.
const STRAIGHT_M: [f64; 2] = [3.2, 1.8];
/// Who stands in a bay stands along it to this angle, radians.
const ALIGNED_RAD: f64 = 0.05;
/// Front wheels turn no further, radians.
const LOCK_RAD: f64 = 0.65;
/// Room kept to all that stands, metres.
const CLEAR_M: f64 = 0.05;
/// A body leaves bays by no more than this, metres: along the kerb, where they have gaps, and across it.
const BETWEEN_BAYS_M: f64 = 0.12;
const OVER_KERB_M: f64 = 0.02;
/// Between lane and bays is no more than this, metres.
const GUTTER_M: f64 = 0.55;
/// A rehearsal begins so far before the first length, goes on so far beyond the last, and moves on in such pieces, metres.
const BEFORE_M: f64 = 1.0;
const BEYOND_M: f64 = 5.0;
const PIECE_M: f64 = 0.3;
const MOST_PIECES: u32 = 200;
/// Who stops does so this near to the place, metres beyond.
const BEYOND_PLACE_M: f64 = 0.35;
/// Between a body in a bay and its sides, both together, metres.
const SIDES_M: f64 = 0.1;

/// The way of a vehicle into and out of the place with this number; `None` if it does not fit, or could not without touching anything.
pub(crate) fn bay_way(roads: &Roads, vehicle: &Vehicle, place: &ParkingPlace, number: usize) -> Option<BayWay> {
    let spec = &roads.specs[vehicle.asset.model.index()];
    let [length_m, width_m] = [spec.length_m, spec.width_m].map(f64::from);
    if length_m > place.room.x || width_m > place.room.y - SIDES_M {
        return None;
    }
    let ways = STRAIGHT_M.into_iter().flat_map(|straight_m| LENGTHS_M.map(|in_m| (in_m, straight_m)));
    ways.into_iter().find_map(|(in_m, straight_m)| {
        let stands = pull_in(roads, vehicle, place, BayWay { place: number, in_m, out_m: in_m, straight_m })?;
        let out_m = LENGTHS_M.into_iter().find(|out_m| pulls_out(roads, stands.clone(), place, *out_m))?;
        Some(BayWay { place: number, in_m, out_m, straight_m })
    })
}

/// The vehicle as it stands in the bay.
fn pull_in(roads: &Roads, vehicle: &Vehicle, place: &ParkingPlace, way: BayWay) -> Option<Vehicle> {
    let lane = roads.network.lane(place.lane);
    let way_m = way.begins_m();
    let mut probe =
        Vehicle { shift: None, tail: None, order: None, filtering: None, acceleration: 0.0, ..vehicle.clone() };
    probe.route = VecDeque::from([place.lane]);
    (probe.here, probe.s) = (0, place.s - way_m - BEFORE_M);
    if let [next] = lane.successors[..] {
        probe.route.push_back(next);
    }
    if let ([before], true) = (&lane.predecessors[..], probe.s < 0.0) {
        probe.route.push_front(*before);
        probe.s += roads.table(*before).length;
    }
    if probe.s < 0.0 {
        return None;
    }
    probe.rolled = 0.0;
    let left_m = place.stands_left_m(2.0 * probe.half_width) - probe.driver.lateral_m;
    let halt = place.halt(way, &probe, BEFORE_M + way_m, 0.0);
    probe.kerb_halt = Some(KerbHalt { drift: Some(BayWay::inwards(BEFORE_M, way.in_m, left_m)), ..halt });
    kinematics::settle(&mut probe, roads);
    let is_there = |probe: &Vehicle| probe.lane() == place.lane && probe.s > place.s + BEYOND_PLACE_M;
    let stands = goes_on(roads, &mut probe, place, is_there);
    let along_rad = lane.centerline.at(place.s).heading_rad;
    (stands && wrap_angle(probe.yaw - along_rad).abs() < ALIGNED_RAD).then_some(probe)
}

/// Whether a vehicle that stands in the bay gets out.
fn pulls_out(roads: &Roads, mut probe: Vehicle, place: &ParkingPlace, out_m: f64) -> bool {
    let left_m = place.stands_left_m(2.0 * probe.half_width) - probe.driver.lateral_m;
    let drift = Some(out(probe.rolled, out_m, left_m));
    probe.kerb_halt = probe.kerb_halt.map(|halt| KerbHalt { drift, ..halt });
    let is_out_m = probe.rolled + out_m + BEYOND_M;
    goes_on(roads, &mut probe, place, |probe| probe.rolled > is_out_m)
}

/// Whether it goes on without touching anything until it is there.
fn goes_on(roads: &Roads, probe: &mut Vehicle, place: &ParkingPlace, is_there: impl Fn(&Vehicle) -> bool) -> bool {
    let (lane, kerb) = (roads.network.lane(place.lane), place.left_m.signum());
    for _ in 0..MOST_PIECES {
        if is_there(probe) {
            return true;
        }
        probe.speed = 1.0;
        kinematics::advance(probe, roads, PIECE_M);
        if probe.steer.abs() > LOCK_RAD {
            return false;
        }
        let body = probe.footprint(&roads.specs, CLEAR_M);
        if place.standing.iter().any(|other| other.overlaps(&body)) {
            return false;
        }
        let body = probe.footprint(&roads.specs, 0.0);
        let outer = [1.0, -1.0].map(|x| body.place(x * body.half.x, kerb * body.half.y));
        let is_off = |corner: &DVec2| {
            let beyond_m = lane.centerline.project(*corner).1 * kerb - 0.5 * lane.width_m;
            beyond_m > 0.0 && !place.bays.iter().any(|bay| holds(bay, kerb, *corner))
        };
        if outer.iter().any(is_off) {
            return false;
        }
    }
    false
}

pub(crate) fn corners(body: &OrientedRectangle) -> [DVec2; 4] {
    [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|[x, y]| body.place(x * body.half.x, y * body.half.y))
}

/// How far a place is outside of all of these, metres.
pub(crate) fn outside_m(bays: &[OrientedRectangle], at: DVec2) -> f64 {
    bays.iter().map(|bay| bay.distance(at)).fold(f64::INFINITY, f64::min)
}

/// Whether a place beside a lane is in a bay whose kerb is on its left (1) or right (−1), or between it and the lane.
fn holds(bay: &OrientedRectangle, kerb: f64, at: DVec2) -> bool {
    let local = bay.local(at);
    let to_kerb_m = kerb * local.y;
    let across = -bay.half.y - GUTTER_M..bay.half.y + OVER_KERB_M;
    local.x.abs() < bay.half.x + BETWEEN_BAYS_M && across.contains(&to_kerb_m)
}
