//! A near miss: who follows takes notice late that the one ahead stands, or brakes hard for nothing.

use super::conflict::{EVASIVE_MPS2, NEAR_MISS_S};
use super::following::{FollowingPair, FollowingPairs};
use super::moment::{Candidate, Moment};
use super::order::{Braking, Order};
use crate::vehicle::Vehicle;

/// Who follows is faster than this, m/s.
const LEAST_MPS: f64 = 4.5;
/// Who is slower does not brake hard but is come upon, m/s.
const SLOW_MPS: f64 = 3.0;
/// Gaps before it begins, metres.
const GAP_M: [f64; 2] = [3.0, 32.0];
/// Braking of the one ahead, m/s², and how long it stands then, seconds.
const BRAKING_MPS2: f64 = 6.5;
const STANDS_S: f64 = 1.0;
/// What is left of the gap when both have braked as hard as they can, about, metres.
const LEFT_M: [f64; 4] = [0.4, 0.9, 1.5, 2.2];
/// Delays after which who follows takes notice, seconds.
const SEES_AFTER_S: [f64; 2] = [0.3, 4.0];
/// What the brakes do on average from when they are pressed, m/s², after a moment, seconds.
const FULL_MPS2: f64 = 6.5;
const PRESSES_S: f64 = 0.25;
/// Where their headings differ by more is a bend, no place for it: bodies do not go on straight there. Radians.
const STRAIGHT: f64 = 0.05;

/// Pairs on a straight lane, of whom one follows at some speed.
pub(super) fn candidates(moment: &Moment<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    let free = |vehicle: &Vehicle| vehicle.order.is_none() && vehicle.shift.is_none() && !vehicle.class.two_wheeled();
    let pairs = FollowingPairs { gap_m: GAP_M, least_mps: LEAST_MPS, straight: STRAIGHT };
    for FollowingPair { follower: (i, follower), leader, ahead } in pairs.of(moment, free) {
        let brakes_s = ahead.speed / BRAKING_MPS2;
        let hard = Braking { mps2: BRAKING_MPS2, until_s: brakes_s + STANDS_S };
        let brakes = (ahead.speed > SLOW_MPS).then_some(hard);
        let stop_m = follower.speed * follower.speed / (2.0 * FULL_MPS2) + PRESSES_S * follower.speed;
        let ahead_m = 0.5 * brakes_s * ahead.speed;
        let delays = LEFT_M.map(|left_m| (leader.gap + ahead_m - stop_m - left_m) / follower.speed);
        for sees_after_s in delays.into_iter().filter(|delay| (SEES_AFTER_S[0]..SEES_AFTER_S[1]).contains(delay)) {
            let late = Order { sees_after_s, ..Order::default() };
            let first = Order { braking: brakes, ..Order::default() };
            found.push(Candidate {
                roles: vec![(leader.vehicle, first), (i, late)],
                walk: None,
                junction: None,
                ahead_m,
            });
        }
    }
    found
}

/// While who follows would soon touch the one ahead, and could not brake gently any more.
pub(super) fn happens(moment: &Moment<'_>, actors: &[usize]) -> bool {
    let [ahead, follower] = [actors[0], actors[1]].map(|i| &moment.vehicles[i]);
    let leader = moment.occupancy.leader(moment.roads, moment.vehicles, actors[1], GAP_M[1]);
    let Some(gap) = leader.filter(|leader| leader.vehicle == actors[0]).map(|leader| leader.gap) else { return false };
    let closing = follower.speed - ahead.speed;
    gap > 0.0 && closing > 0.0 && gap / closing < NEAR_MISS_S && closing * closing / (2.0 * gap) > EVASIVE_MPS2
}
