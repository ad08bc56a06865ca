//! Lane changes by MOBIL (Kesting, Treiber, Helbing 2007, "General lane-changing model MOBIL for car-following
//! models"): change if it helps me more than it harms the others, and if nobody must brake hard.

use crate::crossing::comfortable_stop_m;
use crate::emergency;
use crate::kinematics;
use crate::lane_choice;
use crate::occupancy::Occupancy;
use crate::roads::Roads;
use crate::vehicle::{LaneChange, LaneCover, Vehicle};
use endless_road::LaneId;
use endless_world::ObjectClass;

/// Gap to somebody behind who plays a recorded track, metres.
const PLAYED_GAP_M: f64 = 15.0;
/// Hardest braking that who moves over, or comes beside, may ask of those behind there, m/s².
pub(crate) const SAFE_BRAKING: f64 = 2.0;
/// Gain that makes a change worthwhile, m/s².
const THRESHOLD: f64 = 0.25;
/// Drivers indicate for this long before they move over, seconds.
const INDICATE_S: f64 = 1.3;
/// Lanes with tighter bends are not left, metres.
pub(crate) const STRAIGHT_RADIUS_M: f64 = 60.0;
/// Clear of the lane's beginning, metres.
const FROM_START_M: f64 = 22.0;

/// Goes on with a change that was indicated, or thinks about one. `thinks` is true once a second.
pub(crate) fn step(
    roads: &Roads,
    occupancy: &mut Occupancy,
    vehicles: &mut [Vehicle],
    i: usize,
    thinks: bool,
    step_s: f64,
) {
    // Who halts at the kerb or passes a queue keeps to its lane.
    if vehicles[i].kerb_halt.is_some() || vehicles[i].filtering.is_some() {
        vehicles[i].intent = None;
        return;
    }
    if let Some((target, left)) = vehicles[i].intent {
        let neighbours = roads.network.lane(vehicles[i].lane());
        let still = neighbours.left == Some(target) || neighbours.right == Some(target);
        let left = left - step_s;
        vehicles[i].intent = (still && left > -1.5).then_some((target, left));
        if still && left <= 0.0 && gain(roads, occupancy, vehicles, i, target).is_some() {
            begin(roads, occupancy, vehicles, i, target);
        }
        return;
    }
    if !thinks || vehicles[i].class == ObjectClass::Bicycle {
        return;
    }
    lane_choice::think(roads, &mut vehicles[i]);
    let lane = roads.network.lane(vehicles[i].lane());
    let best = [lane.left, lane.right]
        .into_iter()
        .flatten()
        .filter_map(|target| gain(roads, occupancy, vehicles, i, target).map(|g| (g, target)))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    if let Some((gain, target)) = best
        && gain > THRESHOLD
    {
        vehicles[i].intent = Some((target, INDICATE_S));
    }
}

fn change_length(vehicle: &Vehicle) -> f64 {
    (vehicle.speed * 4.0).max(24.0)
}

/// What a change would gain, m/s²; `None` if it is not possible or not safe.
fn gain(roads: &Roads, occupancy: &Occupancy, vehicles: &[Vehicle], i: usize, target: LaneId) -> Option<f64> {
    let me = &vehicles[i];
    let table = roads.table(me.lane());
    let room = change_length(me) + 12.0 + me.half_length;
    if me.shift.is_some()
        || me.tail.is_some()
        || me.speed < 3.0
        || table.junction.is_some()
        || !roads.allowed(me.asset.model)[target.index()]
    {
        return None;
    }
    // Nor is a bend.
    if table.radius.min(roads.table(target).radius) < STRAIGHT_RADIUS_M {
        return None;
    }
    let at = roads.network.lane(me.lane()).centerline.at(me.s).position.truncate();
    let (s, _) = roads.network.lane(target).centerline.project(at);
    if me.s.min(s) < FROM_START_M || (table.length - me.s).min(roads.table(target).length - s) < room {
        return None;
    }
    // A crossing is no place to change lanes.
    if roads.table(target).cuts.iter().any(|c| c.range.1 > s - me.half_length && c.range.0 < s + room) {
        return None;
    }
    // Nor is it where somebody crosses on foot.
    let braking_m = comfortable_stop_m(me.speed);
    if occupancy.people_on(target).iter().any(|p| p.s > s - me.half_length && p.s < s + room + braking_m) {
        return None;
    }
    let for_call = emergency::incentive(&occupancy.coming, me, target, s)?;
    let (mut ahead, mut behind) = ((f64::INFINITY, 0.0), (f64::INFINITY, None));
    for o in occupancy.on(target).iter().filter(|o| o.vehicle != i) {
        if o.middle() > s {
            let gap = o.rear - s - me.half_length;
            if gap < ahead.0 {
                ahead = (gap, o.speed);
            }
        } else {
            let gap = s - me.half_length - o.front;
            if gap < behind.0 {
                behind = (gap, Some(o.vehicle));
            }
        }
    }
    if ahead.0 < 3.0 || behind.0 < 3.0 {
        return None;
    }
    let wanted = me.driver.cruise_mps.min(roads.table(me.lane()).speed_at(me.s) * me.driver.limit_factor);
    let free = me.driver.free(me.speed, wanted);
    let react = |gap: f64, speed: f64| if gap.is_finite() { me.driver.follow(me.speed, gap, speed) } else { free };
    let now = occupancy.leader(roads, vehicles, i, 80.0).map_or(free, |l| react(l.gap, l.speed)).min(free);
    let then = react(ahead.0, ahead.1).min(free);
    // Who plays a track brakes for nobody.
    if behind.1.is_some_and(|follower| follower >= vehicles.len()) && behind.0 < PLAYED_GAP_M {
        return None;
    }
    let harm = match behind.1.and_then(|follower| vehicles.get(follower)) {
        Some(them) => {
            let after = them.driver.follow(them.speed, behind.0, me.speed);
            if after < -SAFE_BRAKING {
                return None;
            }
            (them.acceleration.max(after) - after).max(0.0)
        }
        None => 0.0,
    };
    Some(then - now - me.driver.politeness * harm + lane_choice::incentive(roads, me, target) + for_call)
}

fn begin(roads: &Roads, occupancy: &mut Occupancy, vehicles: &mut [Vehicle], i: usize, target: LaneId) {
    let me = &mut vehicles[i];
    let from = me.lane();
    // The point that follows the lane must not jump: in a bend the lanes are not equally long.
    let (at_pivot, t) = roads.network.lane(target).centerline.project(me.pivot.truncate());
    let s = at_pivot - kinematics::pivot_ahead_m(me);
    me.shift = Some(LaneChange {
        from,
        from_minus_here: me.s - s,
        offset_m: t - me.driver.lateral_m,
        begin_s: s,
        length_m: change_length(me),
    });
    me.intent = None;
    me.s = s;
    me.here = 0;
    me.route.clear();
    me.route.push_back(target);
    me.rights_of_way.retain(|g| g.entered);
    me.plan(roads);
    let cover = LaneCover { lane: target, rear: s - me.half_length, front: s + me.half_length };
    let speed = me.speed;
    occupancy.put(i, cover, speed);
}
