//! Who sits down on a bench, when, and for how long.

use super::errand::{AGAIN_S, Rest};
use super::places::BenchPlace;
use crate::roads::Roads;
use crate::settings::DrivingCondition;
use crate::walk_strip::DirectedEdge;
use crate::walker::Walker;
use endless_road::WalkKind;
use endless_world::Stream;
use endless_world::math::f64::exp;
use glam::DVec2;

/// The share of people who, walking past a bench with a free seat, sit down. A round figure, like those below.
const SITS: f64 = 0.2;
/// They make up their mind while a seat is so far ahead, metres, and give that much room to get there.
const AHEAD_M: [f64; 2] = [0.5, 4.5];
/// For how long they sit, seconds.
const SITS_S: [f64; 2] = [60.0, 420.0];
/// Who still sits when it gets dark or begins to rain gets up within this time, seconds.
const LEAVES_S: f64 = 15.0;
/// Wetter seats are not sat on.
const DRY: f32 = 0.2;
/// Seats of a bench that count once: people choose among benches, not seats.
const SEATS_A_BENCH: f64 = 3.0;
/// Most of the reachable seats that are taken at the beginning, and the room that those who stand leave to one, metres.
const MOST_TAKEN: f64 = 0.5;
const APART_M: f64 = 1.0;

/// Whether people sit down: by day, while it is dry.
fn invites(condition: &DrivingCondition) -> bool {
    condition.is_day_without_rain() && condition.wetness < DRY
}

impl Walker {
    /// Whether they may sit down at all.
    fn sits_down(&self) -> bool {
        self.spec.sits_down && !self.jogs && self.company.is_none()
    }

    /// Whether they could make up their mind to sit down now.
    fn may_choose_seat(&self) -> bool {
        let busy = self.bus.ride.is_some() || self.bus.waits() || self.road_walk.is_some() || self.on_roadway();
        self.sits_down() && self.rest.is_none() && self.rests_again_s <= 0.0 && !busy
    }
}

/// Lets some of those who come along a bench choose a seat of it that nobody has; sends all away when the weather is bad.
pub(crate) fn choose(roads: &Roads, walkers: &mut [Walker], condition: &DrivingCondition, step_s: f64) {
    if roads.benches.is_empty() {
        return;
    }
    if !invites(condition) {
        for walker in walkers.iter_mut() {
            let Some(rest) = walker.rest.as_deref_mut() else { continue };
            if rest.is_at_bench() {
                rest.left_s = rest.left_s.min(LEAVES_S * walker.stream.fork(walker.passed.into()).f64());
            } else {
                walker.rest = None;
            }
        }
        return;
    }
    let mut taken: Vec<usize> = walkers.iter().filter_map(|walker| Some(walker.rest.as_deref()?.place.seat)).collect();
    for walker in walkers.iter_mut() {
        walker.rests_again_s = (walker.rests_again_s - step_s).max(0.0);
        let (edge, to) = walker.way[0];
        let places = roads.benches.on(edge);
        if places.is_empty() || !walker.may_choose_seat() {
            continue;
        }
        let strip = DirectedEdge::new(roads, walker.from, edge, to);
        let here = strip.local(walker.position).0;
        let ahead = |place: &&BenchPlace| {
            let ahead_m = strip.local(place.from).0 - here;
            (AHEAD_M[0]..AHEAD_M[1]).contains(&ahead_m) && !taken.contains(&place.seat)
        };
        let free: Vec<&BenchPlace> = places.iter().filter(ahead).collect();
        // As likely, in all the time in which a bench lies ahead, as said.
        let passes_s = (AHEAD_M[1] - AHEAD_M[0]) / walker.pace.max(0.3);
        if free.is_empty() || !walker.stream.chance(1.0 - exp(-SITS * step_s / passes_s)) {
            continue;
        }
        let place = **walker.stream.pick(&free);
        taken.push(place.seat);
        let left_s = walker.stream.range_f64(SITS_S[0], SITS_S[1]);
        walker.rest = Some(Box::new(Rest::chosen(place, left_s)));
    }
}

/// Whether who stands somewhere would be in the way of who sits.
fn is_near(place: &BenchPlace, at: DVec2) -> bool {
    at.distance(place.at.truncate() + place.facing * (0.5 * APART_M)) < APART_M
}

/// Seats as many as sit at any time, as a renewal process has it: of the time from one rest to the next the share for which they
/// rest. Where `drawn` people are wanted, seats in sight are as much more likely to be theirs as places to walk are.
pub(crate) fn seat_some(roads: &Roads, walkers: &mut [Walker], condition: &DrivingCondition, seed: u64) {
    let places = roads.benches.all();
    if places.is_empty() || !invites(condition) {
        return;
    }
    let walk = &roads.network.walk;
    let sidewalks = walk.edges.iter().filter(|edge| edge.kind == WalkKind::Sidewalk);
    let metres: f64 = sidewalks.map(|e| walk.nodes[e.nodes[0].index()].distance(walk.nodes[e.nodes[1].index()])).sum();
    let benches_a_metre = places.len() as f64 / SEATS_A_BENCH / metres.max(1.0);
    let at: Vec<DVec2> = walkers.iter().map(|walker| walker.position).collect();
    let mut taken: Vec<bool> = places.iter().map(|place| at.iter().any(|at| is_near(place, *at))).collect();
    let mut left = (MOST_TAKEN * places.len() as f64) as usize;
    for (k, walker) in walkers.iter_mut().enumerate().filter(|(_, walker)| walker.sits_down()) {
        let mut own = Stream::named(seed, "traffic.seated", &[k as u64]);
        let walks_s = AGAIN_S + 1.0 / (SITS * benches_a_metre * walker.pace);
        let rests_s = 0.5 * (SITS_S[0] + SITS_S[1]);
        if left == 0 || !own.chance(rests_s / (rests_s + walks_s)) {
            continue;
        }
        let wanted = |(number, place): (usize, &BenchPlace)| {
            let first = walk.nodes[walk.edges[place.edge.index()].nodes[0].index()].truncate();
            let along = place.from.distance(first);
            let seen = walker.drawn && roads.attraction.focus.on_walk(place.edge.index(), along) != 0;
            if taken[number] { 0.0 } else { roads.attraction.density(place.from, seen) }
        };
        let weights: Vec<f64> = places.iter().enumerate().map(wanted).collect();
        let number = own.weighted(&weights);
        if taken[number] {
            continue;
        }
        taken[number] = true;
        left -= 1;
        let place = places[number];
        // Long rests are more likely to be under way; any part of them may be over.
        let [least, most] = SITS_S.map(|seconds| seconds * seconds);
        let whole_s = (least + (most - least) * own.f64()).sqrt();
        let left_s = whole_s * own.f64();
        let mut nodes = walk.edges[place.edge.index()].nodes;
        if own.chance(0.5) {
            nodes.reverse();
        }
        (walker.from, walker.way) = (nodes[0], [(place.edge, nodes[1])].into());
        walker.around_corner = false;
        walker.sit(place, left_s);
    }
}
