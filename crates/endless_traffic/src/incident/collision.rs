//! A rear-end collision: who follows does not look, and drives into the one ahead, who stands or brakes hard. Both then move
//! as bodies on tyres ([`super::impact`]) until they stand, hazard lights on.

use super::following::{FollowingPair, FollowingPairs};
use super::moment::{Candidate, Moment};
use super::order::{Braking, Order};
use crate::vehicle::Vehicle;

/// Who follows is faster than this, m/s.
const LEAST_MPS: f64 = 4.0;
/// Who is slower does not brake hard but is come upon, m/s.
const SLOW_MPS: f64 = 3.0;
/// Gaps before it begins, metres.
const GAP_M: [f64; 2] = [3.0, 35.0];
/// Braking of the one ahead, m/s².
const BRAKING_MPS2: [f64; 2] = [5.0, 7.0];
/// Seconds for which they brake: until they stand, and then some.
const BRAKES_S: f64 = 8.0;
/// Where their headings differ by more is a bend, radians.
const STRAIGHT: f64 = 0.2;

/// Pairs of whom one follows at some speed.
pub(super) fn candidates(moment: &Moment<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    let free = |vehicle: &Vehicle| {
        let rigid = vehicle.trailer.is_none() && !vehicle.class.two_wheeled();
        vehicle.order.is_none() && vehicle.shift.is_none() && rigid
    };
    let pairs = FollowingPairs { gap_m: GAP_M, least_mps: LEAST_MPS, straight: STRAIGHT };
    for FollowingPair { follower: (i, _), leader, ahead } in pairs.of(moment, free) {
        for mps2 in BRAKING_MPS2 {
            let braking = (ahead.speed > SLOW_MPS).then_some(Braking { mps2, until_s: BRAKES_S });
            let first = Order { braking, collides: true, ..Order::default() };
            let blind = Order { sees_after_s: f64::INFINITY, collides: true, ..Order::default() };
            let ahead_m = ahead.speed * ahead.speed / (2.0 * mps2);
            found.push(Candidate {
                roles: vec![(i, blind), (leader.vehicle, first)],
                walk: None,
                junction: None,
                ahead_m,
            });
        }
    }
    found
}

/// From when they touch to when both stand.
pub(super) fn happens(moment: &Moment<'_>, actors: &[usize]) -> bool {
    let crashed = |i: &usize| {
        let crash = moment.vehicles[*i].order.and_then(|order| order.crash);
        crash.is_some_and(|body| !body.rests())
    };
    actors.iter().any(crashed)
}
