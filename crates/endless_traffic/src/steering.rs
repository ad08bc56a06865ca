//! A vehicle's acceleration: the smallest of those that leaders, signals, bends and crossings ahead demand.

use crate::crossing::{CrossingState, blocks_lane, comfortable_stop_m, signal_of};
use crate::driver::HARDEST_BRAKING;
use crate::filtering;
use crate::junction_controller::JunctionController;
use crate::occupancy::{Leader, Leaders, Occupancy};
use crate::overlap::SweptExit;
use crate::queue_exit;
use crate::roads::{Roads, fastest_before};
use crate::vehicle::Vehicle;
use endless_road::LaneId;
use endless_world::{SignalAspect, SignalState};

/// How far drivers look, metres.
pub(crate) const SIGHT_M: f64 = 180.0;
/// How far they look for a place to wait that is no crossing, metres.
const CLOSE_M: f64 = 50.0;
/// Who waits for somebody nearer than this beyond the line waits at the line, metres.
const AT_LINE_M: f64 = 0.5;
/// Who keeps room to pull out of a queue brakes no harder for it, m/s².
const KEEPS_MPS2: f64 = 0.8;
/// Who lets somebody go first who is beside them, with room between, brakes no harder, m/s².
const LETS_GO_MPS2: f64 = 1.5;
/// How fast acceleration may rise and fall, m/s³.
const JERK_UP: f64 = 5.0;
const JERK_DOWN: f64 = 25.0;
/// The last of a stop is gentle: hardest braking of who is about to stand, m/s², and how much harder it may be for each m/s.
const LAST_BRAKING: f64 = 0.8;
const BRAKING_PER_MPS: f64 = 4.0;

/// Who is slower than this beyond a junction may come to stand in the way of one who turns beside them, m/s.
const CRAWLS_MPS: f64 = 3.0;
/// Room that is kept before them, metres.
const BEFORE_SWEPT_M: f64 = 0.5;

/// What all drivers see.
pub(crate) struct DriverView<'a> {
    pub(crate) roads: &'a Roads,
    pub(crate) occupancy: &'a Occupancy,
    pub(crate) controller: &'a JunctionController,
    pub(crate) crossings: &'a [CrossingState],
    pub(crate) signals: &'a [SignalState],
    pub(crate) vehicles: &'a [Vehicle],
}

impl DriverView<'_> {
    /// Acceleration of a vehicle for the coming step, m/s².
    pub(crate) fn acceleration(&self, i: usize, step_s: f64) -> f64 {
        let me = &self.vehicles[i];
        let driver = &me.driver;
        let looks = me.order.is_none_or(|order| order.sees_leader());
        let leaders = if looks { self.occupancy.leaders(self.roads, me, i, SIGHT_M) } else { Leaders::default() };
        let mut wanted = driver.free(me.speed, speed_ahead(self.roads, me));
        let lets_go_first =
            |beside: &Leader| self.vehicles.get(beside.vehicle).is_none_or(|other| filtering::lets_go_first(me, other));
        for ahead in leaders.ahead.into_iter().chain(leaders.stands_first) {
            wanted = wanted.min(driver.follow(me.speed, ahead.gap, ahead.speed));
            if me.pulls_out && me.shift.is_none() {
                let keeps = driver.follow(me.speed, ahead.gap - queue_exit::KEEPS_M, ahead.speed);
                wanted = wanted.min(keeps.max(-KEEPS_MPS2));
            }
        }
        if let Some(beside) = leaders.beside.filter(lets_go_first) {
            wanted = wanted.min(driver.follow(me.speed, beside.gap, beside.speed).max(-LETS_GO_MPS2));
        }
        if let Some(pace_mps) = leaders.pace_mps {
            wanted = wanted.min(driver.free(me.speed, pace_mps));
        }
        if let Some(gap) = self.line_ahead(i, leaders.could_stand_m()) {
            wanted = wanted.min(driver.stop_at(me.speed, gap));
        }
        let wanted = me.kerb_halt.map_or(wanted, |halt| halt.wanted(wanted, driver, me.speed));
        let wanted = me.order.map_or(wanted, |order| order.wanted(wanted));
        let eased = wanted.clamp(me.acceleration - JERK_DOWN * step_s, me.acceleration + JERK_UP * step_s);
        let hardest = HARDEST_BRAKING.min(LAST_BRAKING + BRAKING_PER_MPS * me.speed);
        eased.clamp(-hardest, driver.accelerate)
    }

    /// Distance from the front bumper to the nearest line at which to stop, where those ahead could stand so far on, metres.
    fn line_ahead(&self, i: usize, leaders_m: f64) -> Option<f64> {
        let me = &self.vehicles[i];
        let heedless = me.order.is_some_and(|order| order.heedless);
        let sure = self.surely_free(i, leaders_m);
        let mut nearest = f64::INFINITY;
        let mut setback = 0.0;
        for (k, (lane, base)) in me.ahead(self.roads).enumerate() {
            if base > SIGHT_M {
                break;
            }
            let table = self.roads.table(lane);
            let kept = std::mem::replace(&mut setback, table.setback);
            for person in self.occupancy.people_on(lane) {
                let gap = base + person.s - person.half_width_m - me.half_length - 0.8;
                if gap > -0.5 && blocks_lane(person.to_lane_m, me) {
                    nearest = nearest.min(gap.max(0.06));
                }
            }
            if me.long() {
                nearest = nearest.min(self.swept_exit_ahead(lane, base));
            }
            if let Some(junction) = table.junction {
                match me.right_of_way_at(junction) {
                    Some(right_of_way) => {
                        let setback = if k > 0 && base > 0.0 { kept } else { 0.0 };
                        let earlier = self.earlier_ahead(i, lane, base, right_of_way.order, Some(setback));
                        nearest = nearest.min(earlier);
                    }
                    None if k > 0 && base > 0.0 => {
                        let line = nearest.min(stop_before(me, base - me.half_length - 0.3, kept));
                        return Some(self.off_crossings(me, line));
                    }
                    None => {}
                }
            }
            for cut in &table.cuts {
                let gap = base + cut.range.0 - me.half_length - 0.8;
                if gap < -0.5 {
                    continue;
                }
                let state = &self.crossings[cut.crossing.index()];
                let invited =
                    signal_of(self.roads, cut.crossing).is_none_or(|s| self.signals[s].aspect == SignalAspect::Green);
                let lets_go =
                    !heedless && state.wanted && invited && !state.occupied && gap > comfortable_stop_m(me.speed);
                // Who may have to stop on it keeps off while people come, or if it is no junction's, always: nobody on
                // foot shall find the way barred in the middle of the road.
                let stops_on_it = sure < base + cut.range.1 + me.half_length + me.driver.standing_gap_m;
                let keeps_off = !heedless && stops_on_it && (table.junction.is_none() || state.awaits(cut, me));
                if state.blocks(cut, me) || lets_go || keeps_off {
                    nearest = nearest.min(gap.max(0.06));
                }
            }
        }
        nearest.is_finite().then(|| self.off_crossings(me, nearest))
    }

    /// Distance to where one who is long would begin to sweep over those who are slow to leave the junction beside it, metres.
    fn swept_exit_ahead(&self, lane: LaneId, base: f64) -> f64 {
        let is_in_the_way = |swept: &&SweptExit| {
            let mut there = self.occupancy.on(swept.lane).iter();
            base + swept.from_m > 0.0 && there.any(|o| o.rear < swept.to_m && o.front > 0.0 && o.speed < CRAWLS_MPS)
        };
        let swept = self.roads.table(lane).sweeps.exits.iter().filter(is_in_the_way);
        swept.map(|swept| (base + swept.from_m - BEFORE_SWEPT_M).max(0.06)).fold(f64::INFINITY, f64::min)
    }

    /// How far the front bumper gets without waiting for anybody, even if those ahead brake, metres.
    fn surely_free(&self, i: usize, leaders_m: f64) -> f64 {
        let me = &self.vehicles[i];
        let mut free = leaders_m;
        for (lane, base) in me.ahead(self.roads).take_while(|a| a.1 < CLOSE_M) {
            let right_of_way = self.roads.table(lane).junction.and_then(|junction| me.right_of_way_at(junction));
            if let Some(right_of_way) = right_of_way {
                free = free.min(self.earlier_ahead(i, lane, base, right_of_way.order, None));
            }
        }
        free
    }

    /// A stop so that the body does not stand on a crossing that it has not reached yet.
    fn off_crossings(&self, me: &Vehicle, line: f64) -> f64 {
        let mut stop = line;
        for (lane, base) in me.ahead(self.roads) {
            if base > stop + me.half_length {
                break;
            }
            for cut in &self.roads.table(lane).cuts {
                let begin = base + cut.range.0 - me.half_length - 0.8;
                let end = base + cut.range.1 - me.half_length;
                if begin >= 0.0 && begin < stop && stop - 2.0 * me.half_length < end {
                    stop = begin.max(0.06);
                }
            }
        }
        stop
    }

    /// Distance to the nearest place on a lane where somebody who entered the junction before has not passed yet;
    /// with foresight, unless they will be gone in time, and who has to wait at the line keeps this setback.
    fn earlier_ahead(&self, i: usize, lane: LaneId, base: f64, order: u64, foresight: Option<f64>) -> f64 {
        let me = &self.vehicles[i];
        let mut nearest = f64::INFINITY;
        let heedless = me.order.is_some_and(|order| order.heedless);
        let Some(junction) = self.roads.table(lane).junction.filter(|_| !heedless) else { return nearest };
        for &other in self.controller.holders(junction) {
            let them = &self.vehicles[other];
            let Some(right_of_way) = them.right_of_way_at(junction).filter(|g| other != i && g.order < order) else {
                continue;
            };
            for conflict in self.roads.table(lane).conflicts(me.long() || them.long()) {
                let mut gap = base + conflict.range.0 - me.half_length - 0.4;
                if gap < -1.0 || !right_of_way.lanes.contains(&conflict.other) {
                    continue;
                }
                let Some(distance) = them.distance_to(self.roads, conflict.other) else { continue };
                let to_clear = distance + conflict.other_range.1 + them.half_length + 0.3;
                if to_clear <= 0.0 {
                    continue;
                }
                let is_at_line = conflict.range.0 < AT_LINE_M;
                gap = foresight.filter(|_| is_at_line).map_or(gap, |setback| stop_before(me, gap, setback));
                // No need to brake for who will be gone, as long as stopping is still possible.
                let gone_in = to_clear / them.speed.max(0.1);
                let in_time = gone_in + 0.5 < gap / me.speed.max(1.0);
                if !(foresight.is_some() && in_time && gap > comfortable_stop_m(me.speed) + 1.0) {
                    nearest = nearest.min(gap.max(0.06));
                }
            }
        }
        nearest
    }
}

/// Where to stop for a line `at_line` metres ahead from which a setback is to be kept: room for those who turn is left by who can
/// still stop for it; who stands in it stays there.
fn stop_before(me: &Vehicle, at_line: f64, setback: f64) -> f64 {
    let short = at_line - setback;
    let late = me.speed > 0.5 && short < me.firm_stop_m();
    if late { at_line } else { short.max(at_line.min(0.06)) }
}

/// The speed that limits and bends allow, now and in time to brake, m/s.
pub(crate) fn speed_ahead(roads: &Roads, me: &Vehicle) -> f64 {
    let mut speed = me.driver.cruise_mps.min(me.driver.sight_mps);
    if me.shift.is_some_and(|shift| shift.length_m <= queue_exit::PULLS_OUT_M) {
        speed = speed.min(queue_exit::PULLS_OUT_MPS);
    }
    for (k, (lane, base)) in me.ahead(roads).enumerate() {
        if base > SIGHT_M {
            break;
        }
        let table = roads.table(lane);
        let limit = roads.network.lane(lane).speed_limit_mps;
        let (at, distance) = if k == 0 { (me.s, 0.0) } else { (0.0, base) };
        let profile = table.speed_at(at);
        // Bends by the driver's courage, limits by the driver's patience.
        let allowed = (profile * me.driver.bend_factor).min(limit * me.driver.limit_factor);
        speed = speed.min(fastest_before(allowed, distance));
    }
    speed
}
