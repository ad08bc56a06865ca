//! Lane changes by MOBIL (Kesting, Treiber, Helbing 2007, "General lane-changing model MOBIL for car-following
//! models"): change if it helps me more than it harms the others, and if nobody must brake hard.

use crate::crossing::comfortable_stop_m;
use crate::emergency;
use crate::kinematics;
use crate::lane_choice;
use crate::occupancy::{Leader, Occupancy};
use crate::queue_exit;
use crate::roads::{Roads, fastest_before};
use crate::steering::speed_ahead;
use crate::vehicle::{LaneChange, LaneCover, Vehicle};
use endless_road::swept::curvature_per_m;
use endless_road::{LaneId, Polyline};
use endless_world::ObjectClass;
use endless_world::math::f64::sin_cos;
use glam::DVec2;

/// Gap to somebody behind who plays a recorded track, metres.
const PLAYED_GAP_M: f64 = 15.0;
/// Hardest braking that who moves over, or comes beside, may ask of those behind there, m/s².
pub(crate) const SAFE_BRAKING: f64 = 2.0;
/// Gain that makes a change worthwhile, m/s².
const THRESHOLD: f64 = 0.25;
/// What it is worth to get out of a queue, m/s².
const PULLS_OUT_GAIN: f64 = 1.0;
/// Drivers indicate for this long before they move over, seconds.
const INDICATE_S: f64 = 1.3;
/// In tighter bends nobody changes lanes, metres; and how far apart the places are at which a lane is looked at for them.
pub(crate) const STRAIGHT_RADIUS_M: f64 = 60.0;
const LOOKS_M: f64 = 2.0;
/// Nor does anybody where a body bows out further than this, metres: in bends long vehicles fill their lanes.
const BOWS_OUT_M: f64 = 0.15;
/// Slower nobody changes lanes but who pulls out of a queue, m/s.
const SLOWEST_MPS: f64 = 3.0;
/// Changes take so long, seconds, and at least this far: of short vehicles and of those that swing out, metres.
const CHANGE_S: f64 = 3.5;
const SHORTEST_M: [f64; 2] = [16.0, 24.0];
/// Those ahead are looked at so far, metres.
const SEEN_M: f64 = 120.0;
/// Those who come onto a lane are looked at so far, metres.
const SEEN_BEHIND_M: f64 = 150.0;
/// Those ahead stop no harder when they come to a queue, m/s².
const QUEUES_UP_MPS2: f64 = 2.0;
/// Who drives with this share of the speed that they like has nobody near ahead.
const AT_EASE: f64 = 0.9;
/// Riders who pass a queue are looked at so far, metres.
const RIDERS_M: f64 = 25.0;
/// Clear of the lane's beginning and of the line at its end, metres.
const FROM_START_M: f64 = 6.0;
const TO_LINE_M: f64 = 6.0;

/// Goes on with a change that was indicated, or thinks about one. `thinks` is true once a second.
pub(crate) fn step(
    roads: &Roads,
    occupancy: &mut Occupancy,
    vehicles: &mut [Vehicle],
    i: usize,
    thinks: bool,
    step_s: f64,
) {
    // Who halts at the kerb, passes a queue, or does what an incident asks of them keeps to its lane.
    if vehicles[i].kerb_halt.is_some() || vehicles[i].filtering.is_some() || vehicles[i].order.is_some() {
        (vehicles[i].intent, vehicles[i].pulls_out) = (None, false);
        return;
    }
    if let Some((target, left)) = vehicles[i].intent {
        let neighbours = roads.network.lane(vehicles[i].lane());
        let still = neighbours.left == Some(target) || neighbours.right == Some(target);
        let left = left - step_s;
        vehicles[i].intent = (still && left > -1.5).then_some((target, left));
        if still && left <= 0.0 && gain(roads, occupancy, vehicles, i, target, 0.0).is_some() {
            begin(roads, occupancy, vehicles, i, target);
        }
        return;
    }
    if thinks {
        queue_exit::notice(roads, occupancy, vehicles, i);
    }
    if !thinks || vehicles[i].class == ObjectClass::Bicycle {
        return;
    }
    lane_choice::think(roads, &mut vehicles[i]);
    let lane = roads.network.lane(vehicles[i].lane());
    let best = [lane.left, lane.right]
        .into_iter()
        .flatten()
        .filter_map(|target| gain(roads, occupancy, vehicles, i, target, INDICATE_S).map(|g| (g, target)))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    if let Some((gain, target)) = best
        && gain > THRESHOLD
    {
        vehicles[i].intent = Some((target, INDICATE_S));
    }
}

/// Whether a change is one out of a queue, at walking pace.
fn pulls_out(vehicle: &Vehicle) -> bool {
    vehicle.pulls_out && vehicle.speed < SLOWEST_MPS
}

fn change_length(vehicle: &Vehicle) -> f64 {
    if pulls_out(vehicle) {
        return queue_exit::PULLS_OUT_M;
    }
    (CHANGE_S * vehicle.speed).max(SHORTEST_M[usize::from(vehicle.long())])
}

/// The tightest bend in which somebody changes lanes, metres.
fn tightest_m(vehicle: &Vehicle) -> f64 {
    STRAIGHT_RADIUS_M.max(vehicle.half_length * vehicle.half_length / (2.0 * BOWS_OUT_M))
}

/// Whether a lane bends too much for a change somewhere between two places.
fn bends(roads: &Roads, lane: LaneId, [from_m, to_m]: [f64; 2], vehicle: &Vehicle) -> bool {
    let (table, tightest_m) = (roads.table(lane), tightest_m(vehicle));
    let line = &roads.network.lane(lane).centerline;
    let (from_m, to_m) = (from_m.max(0.0), to_m.min(table.length));
    let places = ((to_m - from_m) / LOOKS_M).ceil().max(0.0) as u32;
    let tight = |k: u32| curvature_per_m(line, (from_m + LOOKS_M * f64::from(k)).min(to_m)) * tightest_m > 1.0;
    table.radius < tightest_m && (0..=places).any(tight)
}

/// How fast somebody may be on a lane so far before its end, metres, whatever way they take from there, m/s.
fn fastest_mps(roads: &Roads, vehicle: &Vehicle, lane: LaneId, to_end_m: f64) -> f64 {
    let allowed = roads.allowed(vehicle.asset.model);
    let ways = roads.network.lane(lane).successors.iter().filter(|way| allowed[way.index()]);
    let slowest = ways.map(|way| roads.table(*way).speed_at(0.0)).fold(f64::INFINITY, f64::min);
    fastest_before(slowest, to_end_m)
}

/// What a change would gain that begins in so many seconds, m/s²; `None` if it is not possible or not safe.
fn gain(
    roads: &Roads,
    occupancy: &Occupancy,
    vehicles: &[Vehicle],
    i: usize,
    target: LaneId,
    begins_s: f64,
) -> Option<f64> {
    let me = &vehicles[i];
    let table = roads.table(me.lane());
    let room = change_length(me) + TO_LINE_M + me.half_length;
    if me.shift.is_some()
        || me.tail.is_some()
        || me.speed < SLOWEST_MPS && !me.pulls_out
        || table.junction.is_some()
        || !roads.allowed(me.asset.model)[target.index()]
    {
        return None;
    }
    let at = roads.network.lane(me.lane()).centerline.at(me.s).position.truncate();
    let (s, _) = roads.network.lane(target).centerline.project(at);
    let begins_m = begins_s * me.speed;
    let from_start = me.s.min(s) + begins_m - me.half_length;
    let to_end = (table.length - me.s).min(roads.table(target).length - s) - begins_m;
    if from_start < FROM_START_M || to_end < room {
        return None;
    }
    if me.speed > fastest_mps(roads, me, target, to_end) {
        return None;
    }
    // A bend is no place to change lanes.
    let over_m = begins_m + room;
    if [(me.lane(), me.s), (target, s)]
        .iter()
        .any(|&(lane, s)| bends(roads, lane, [s - me.half_length, s + over_m], me))
    {
        return None;
    }
    // Nor is a crossing.
    if roads.table(target).cuts.iter().any(|c| c.range.1 > s - me.half_length && c.range.0 < s + room) {
        return None;
    }
    // Nor is it where somebody crosses on foot.
    let braking_m = comfortable_stop_m(me.speed);
    if occupancy.people_on(target).iter().any(|p| p.s > s - me.half_length && p.s < s + room + braking_m) {
        return None;
    }
    let out_of_queue = pulls_out(me);
    if out_of_queue && !queue_exit::leads_on(roads, me, target) {
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
    behind = who_comes(roads, occupancy, i, (target, s - me.half_length), behind);
    if ahead.0 < 3.0 || behind.0 < 3.0 {
        return None;
    }
    let wanted = me.driver.cruise_mps.min(roads.table(me.lane()).speed_at(me.s) * me.driver.limit_factor);
    let free = me.driver.free(me.speed, wanted);
    let react = |gap: f64, speed: f64| if gap.is_finite() { me.driver.follow(me.speed, gap, speed) } else { free };
    let leader = occupancy.leader(roads, vehicles, i, SEEN_M);
    // Who comes into a queue before the change has ended would stand in the way of two lanes.
    let ends = |gap: f64, speed: f64| gap + speed * speed / (2.0 * QUEUES_UP_MPS2) > change_length(me);
    // Who is as fast as it likes comes to no queue.
    let at_ease = |l: &Leader| vehicles.get(l.vehicle).is_some_and(|v| v.speed > AT_EASE * speed_ahead(roads, v));
    let has_room = if out_of_queue {
        pulls_out_clear(roads, occupancy, vehicles, i, (target, s), ahead, leader)
    } else {
        ends(ahead.0, ahead.1) && leader.is_none_or(|l| ends(l.gap, l.speed) || at_ease(&l))
    };
    if !has_room {
        return None;
    }
    let now = leader.map_or(free, |l| react(l.gap, l.speed)).min(free);
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
    if out_of_queue {
        return Some(PULLS_OUT_GAIN);
    }
    Some(then - now - me.driver.politeness * harm + lane_choice::incentive(roads, me, target) + for_call)
}

/// Who is the nearest behind a place on a lane of those who come onto it, if nearer than the one known: the gap, metres, and who.
fn who_comes(
    roads: &Roads,
    occupancy: &Occupancy,
    i: usize,
    (lane, rear): (LaneId, f64),
    known: (f64, Option<usize>),
) -> (f64, Option<usize>) {
    let mut nearest = known;
    let mut ways: Vec<(LaneId, f64)> = vec![(lane, 0.0)];
    while let Some((lane, on_m)) = ways.pop() {
        for &before in &roads.network.lane(lane).predecessors {
            let on_m = on_m + roads.table(before).length;
            for o in occupancy.on(before).iter().filter(|o| o.vehicle != i) {
                let gap = rear + on_m - o.front;
                if gap < nearest.0 {
                    nearest = (gap, Some(o.vehicle));
                }
            }
            if rear + on_m < SEEN_BEHIND_M {
                ways.push((before, on_m));
            }
        }
    }
    nearest
}

/// Whether somebody who pulls out to a place on the lane beside gets past those ahead on its own, and has room there, where the next
/// one is so far ahead and so fast, metres and m/s. No rider shall come up beside it.
fn pulls_out_clear(
    roads: &Roads,
    occupancy: &Occupancy,
    vehicles: &[Vehicle],
    i: usize,
    (target, s): (LaneId, f64),
    (ahead_m, ahead_mps): (f64, f64),
    leader: Option<Leader>,
) -> bool {
    let me = &vehicles[i];
    let offset_m = roads.network.lane(target).centerline.project(me.pivot.truncate()).1 - me.driver.lateral_m;
    let Some(clear_m) = queue_exit::clear_m(me, offset_m, queue_exit::PULLS_OUT_M) else { return false };
    // Who changes lanes as well may come to stand on both.
    let shifts = |l: &Leader| vehicles.get(l.vehicle).is_none_or(|v| v.shift.is_some());
    let gets_past = |l: Leader| l.gap >= clear_m.max(if shifts(&l) { queue_exit::ROOM_THERE_M } else { 0.0 });
    let rides_up = |(lane, s): (LaneId, f64)| {
        occupancy.on(lane).iter().any(|o| o.filters && o.front > s - RIDERS_M && o.rear < s + RIDERS_M)
    };
    ahead_m + ahead_mps * ahead_mps / (2.0 * QUEUES_UP_MPS2) >= queue_exit::ROOM_THERE_M
        && leader.is_none_or(gets_past)
        && ![(me.lane(), me.s), (target, s)].into_iter().any(rides_up)
}

/// The place on a line from which a point lies straight across, and how far to the left: metres. In bends it is not quite the nearest.
fn place_across(line: &Polyline, point: DVec2) -> (f64, f64) {
    const ROUNDS: usize = 4;
    let (mut s, mut left_m) = line.project(point);
    for _ in 0..ROUNDS {
        let on = line.at(s);
        let (sin, cos) = sin_cos(on.heading_rad);
        let away = point - on.position.truncate();
        s += away.dot(DVec2::new(cos, sin));
        left_m = away.dot(DVec2::new(-sin, cos));
    }
    (s, left_m)
}

fn begin(roads: &Roads, occupancy: &mut Occupancy, vehicles: &mut [Vehicle], i: usize, target: LaneId) {
    let me = &mut vehicles[i];
    let from = me.lane();
    let out_of_queue = pulls_out(me);
    let begins_m = me.s;
    // The point that follows the lane must not jump: in a bend the lanes are not equally long.
    let (at_pivot, t) = place_across(&roads.network.lane(target).centerline, me.pivot.truncate());
    let s = at_pivot - kinematics::pivot_ahead_m(me);
    let length_m = change_length(me);
    let clear_m = queue_exit::clear_m(me, t - me.driver.lateral_m, length_m);
    me.shift = Some(LaneChange {
        from,
        from_minus_here: me.s - s,
        offset_m: t - me.driver.lateral_m,
        begin_s: s,
        length_m,
        clear_from_m: clear_m.map_or(f64::INFINITY, |clear_m| begins_m + me.half_length + clear_m),
    });
    if out_of_queue {
        (me.pulls_out, me.queued_s, me.aim) = (false, 0.0, None);
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::driver::Driver;
    use crate::focus::Focus;
    use crate::roads::TrafficMap;
    use crate::settings::DrivingCondition;
    use endless_road::{Lane, RoadNetwork};
    use endless_world::{Stream, VehicleModelId, VehicleRef, VehicleSpec};
    use glam::DVec3;

    /// Two lanes of one direction, 300 m straight on, then a bend of 30 m to the left.
    fn road(specs: &[VehicleSpec]) -> Roads {
        let line = |left_m: f64| {
            let bend = (0..=20).map(move |k| {
                let (sin, cos) = sin_cos(f64::from(k) * 0.05);
                let radius_m = 30.0 - left_m;
                DVec3::new(300.0 + radius_m * sin, 30.0 - radius_m * cos, 0.0)
            });
            Polyline::new([DVec3::new(0.0, left_m, 0.0)].into_iter().chain(bend))
        };
        let lane = |id: u32, left_m: f64| Lane::new(LaneId(id), line(left_m), 3.5, 22.0);
        let right = Lane { left: Some(LaneId(1)), ..lane(0, 0.0) };
        let left = Lane { right: Some(LaneId(0)), ..lane(1, 3.5) };
        let network = RoadNetwork { lanes: vec![right, left], ..RoadNetwork::default() }.finish().expect("a road");
        Roads::new(&TrafficMap::new(network, specs), &Focus::default(), &[])
    }

    #[test]
    fn who_follows_a_bicycle_passes_it_where_the_road_is_straight() {
        let bicycle = VehicleSpec {
            class: ObjectClass::Bicycle,
            length_m: 1.8,
            width_m: 0.6,
            front_axle_m: 0.5,
            rear_axle_m: -0.5,
            cruise_mps: 5.0,
            ..VehicleSpec::default()
        };
        let specs = [VehicleSpec::default(), bicycle];
        let roads = road(&specs);
        let mut stream = Stream::named(1, "test.lane_change", &[]);
        let mut on_the_right = |model: usize, s: f64, share: f64| {
            let spec = &specs[model];
            let asset = VehicleRef { model: VehicleModelId::from_index(model), variant: 0 };
            let driver = Driver::new(spec, &DrivingCondition::default(), 0.5, &mut stream);
            let speed = share * 5.0;
            let mut vehicle = Vehicle::new(spec, asset, driver, LaneId(0), s, stream.fork(s as u64));
            (vehicle.speed, vehicle.driver.cruise_mps) = (speed, if model == 1 { 5.0 } else { 16.0 });
            vehicle.plan(&roads);
            vehicle
        };
        let mut gain_at = |s: f64, share: f64| {
            // 8 m from bumper to bumper, as one follows at that speed.
            let car = on_the_right(0, s, share);
            let rear = s + car.half_length + 8.0;
            let vehicles = [car, on_the_right(1, rear + 0.9, share)];
            let mut occupancy = Occupancy::default();
            occupancy.rebuild(&roads, &vehicles);
            gain(&roads, &occupancy, &vehicles, 0, LaneId(1), INDICATE_S)
        };
        assert!(gain_at(60.0, 1.0).is_some_and(|gain| gain > THRESHOLD));
        assert!(gain_at(60.0, 0.7).is_none(), "who goes slower than it likes may come to a queue");
        assert!(gain_at(290.0, 1.0).is_none(), "the bend");
    }

    /// A car that has stood long on the right, so far behind another who stands, metres, and who comes on the left, if anybody: its
    /// place, metres, and speed, m/s.
    fn queue(roads: &Roads, spec: &VehicleSpec, gap_m: f64, comes: Option<(f64, f64)>) -> Vec<Vehicle> {
        let mut stream = Stream::named(1, "test.lane_change", &[]);
        let asset = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
        let length_m = f64::from(spec.length_m);
        let places = [(0, 100.0, 0.0), (0, 100.0 + length_m + gap_m, 0.0)];
        let comes = comes.map(|(s, speed)| (1, s, speed));
        let mut vehicles: Vec<Vehicle> = places
            .into_iter()
            .chain(comes)
            .map(|(lane, s, speed)| {
                let driver = Driver::new(spec, &DrivingCondition::default(), 0.5, &mut stream);
                let mut vehicle = Vehicle::new(spec, asset, driver, LaneId(lane), s, stream.fork(s as u64));
                (vehicle.speed, vehicle.driver.cruise_mps) = (speed, 22.0);
                vehicle.plan(roads);
                kinematics::settle(&mut vehicle, roads);
                vehicle
            })
            .collect();
        vehicles[0].pulls_out = true;
        vehicles
    }

    #[test]
    fn who_has_room_ahead_pulls_out_of_a_queue_if_nobody_comes() {
        let spec = VehicleSpec::default();
        let roads = road(std::slice::from_ref(&spec));
        let gain_with = |gap_m: f64, comes: Option<(f64, f64)>| {
            let vehicles = queue(&roads, &spec, gap_m, comes);
            let mut occupancy = Occupancy::default();
            occupancy.rebuild(&roads, &vehicles);
            gain(&roads, &occupancy, &vehicles, 0, LaneId(1), 0.0)
        };
        assert!(gain_with(9.0, None).is_some());
        assert!(gain_with(3.0, None).is_none(), "it would touch the one ahead");
        assert!(gain_with(9.0, Some((50.0, 22.0))).is_none(), "somebody would have to brake hard");
        assert!(gain_with(9.0, Some((112.0, 0.0))).is_none(), "there is no room on the lane beside");
    }

    #[test]
    fn who_pulls_out_gets_past_those_ahead_without_a_touch() {
        let spec = VehicleSpec::default();
        let roads = road(std::slice::from_ref(&spec));
        let mut vehicles = queue(&roads, &spec, 9.0, None);
        let mut occupancy = Occupancy::default();
        occupancy.rebuild(&roads, &vehicles);
        begin(&roads, &mut occupancy, &mut vehicles, 0, LaneId(1));
        let specs = std::slice::from_ref(&spec);
        let standing = vehicles[1].footprint(specs, 0.0);
        let mut least_m = f64::INFINITY;
        for _ in 0..600 {
            occupancy.rebuild(&roads, &vehicles);
            let ahead = occupancy.leader(&roads, &vehicles, 0, 60.0);
            let wanted = vehicles[0].driver.free(vehicles[0].speed, speed_ahead(&roads, &vehicles[0]));
            let follow = |l: Leader| vehicles[0].driver.follow(vehicles[0].speed, l.gap, l.speed);
            vehicles[0].acceleration = ahead.map_or(wanted, |l| wanted.min(follow(l)));
            kinematics::advance(&mut vehicles[0], &roads, 1.0 / 30.0);
            assert!(!vehicles[0].footprint(specs, 0.1).overlaps(&standing), "at {:.1} m", vehicles[0].s);
            least_m = least_m.min((vehicles[1].s - vehicles[0].s).abs());
        }
        assert!(vehicles[0].shift.is_none() && vehicles[0].s > vehicles[1].s + 10.0 && least_m < 0.3);
    }
}
