//! Grants the right of way at junctions.
//!
//! A vehicle needs the right of way (a [`RightOfWay`]) to cross the line before a junction: its signal or sign allows it, those with
//! priority are far enough away, and there is room for it beyond. Where the ways of two vehicles overlap they pass in
//! the order in which they got it, so nobody waits in a circle and no two bodies meet.

use super::entry_request::{
    EntryRequest, STANDS_MPS, approach_control, aspect, goes_before, request, sign_allows, stopping_m, travel_s,
    yields_to,
};
use crate::driver::STANDING_GAP_M;
use crate::exit_pressure::pressures_s;
use crate::gridlock;
use crate::occupancy::{Leader, Occupancy};
use crate::overlap::SweptApproach;
use crate::queue_tail::{Queued, queue_tail_m};
use crate::roads::{Roads, WIDE_M};
use crate::vehicle::{RightOfWay, Vehicle};
use endless_road::swept::LONG_M;
use endless_road::{JunctionId, LaneId, TrafficControl, Turn};
use endless_world::{SignalAspect, SignalState};

/// Room kept free behind the leader beyond a junction, metres; and before a queue in which somebody has stood so long, seconds, no more
/// than the shortest gap of those who stand: a queue that gets on by one car leaves that car's length and one such gap.
const SPARE_M: f64 = 2.5;
const LEAST_SPARE_M: f64 = STANDING_GAP_M[0];
const LONG_STAND_S: f64 = 100.0;
/// What another vehicle needs, metres.
const ANOTHER_M: f64 = 8.0;
/// Share of a lane that who comes to it leaves free where one gets off it by a change of lanes alone.
const RING_SHARE: f64 = 0.5;
/// Seconds of waiting after which room on the next road alone is enough.
const CHANCE_S: f64 = 40.0;
/// Who joins a ring leaves that much for so long, a light's whole cycle, seconds.
const JOINS_RING_S: f64 = 75.0;
/// Room is kept for who has waited at the line for so long, or has somebody behind it who has, seconds.
const STARVES_S: f64 = 20.0;
/// For who needs more room than most, and has waited for a light's whole cycle, the road beyond stays empty if it would not hold
/// another one, too, seconds.
const RESERVES_S: f64 = 60.0;
/// They follow a queue that moves off, as if it went on for so long, seconds.
const MOVES_ON_S: f64 = 4.0;
/// Roads beyond a junction are looked along this far, metres; and so many of them, where they are short.
const SEEN_M: f64 = 60.0;
const MOST_ROADS: usize = 3;
/// Who has waited for so long for room beyond a junction looks for another way, and again after as long, seconds: in a
/// roundabout that is full, or around a block, all would wait for one another for ever.
const DETOUR_S: f64 = 15.0;
/// Who has the right of way and has stood this long before the junction, while nobody passed who goes first, is held up by something
/// else, seconds.
const HELD_UP_S: f64 = 4.0;

/// Slower than this somebody at a line waits there, m/s.
const WAITS_MPS: f64 = 0.3;
/// Slower than this nobody has got off yet, m/s.
const CREEPS_MPS: f64 = 1.0;
/// Who has it and has stood this long behind somebody who got it later lets others go first, seconds; those may be so near, metres.
const SHUT_IN_S: f64 = 20.0;
const AT_LINE_M: f64 = 0.8;

/// Gives and takes back the right of way through junctions.
#[derive(Debug, Clone, Default)]
pub(crate) struct JunctionController {
    order: u64,
    requests: Vec<EntryRequest>,
    /// Vehicles with the right of way, by junction.
    holders: Vec<Vec<usize>>,
}

impl JunctionController {
    pub(crate) fn holders(&self, junction: JunctionId) -> &[usize] {
        &self.holders[junction.index()]
    }

    pub(crate) fn step(
        &mut self,
        roads: &Roads,
        occupancy: &Occupancy,
        signals: &[SignalState],
        vehicles: &mut [Vehicle],
        step_s: f64,
    ) {
        release(roads, occupancy, signals, vehicles, step_s);
        release_behind(roads, occupancy, vehicles);
        self.holders.resize(roads.network.junctions.len(), Vec::new());
        for list in &mut self.holders {
            list.clear();
        }
        for (i, vehicle) in vehicles.iter().enumerate() {
            for right_of_way in &vehicle.rights_of_way {
                self.holders[right_of_way.junction.index()].push(i);
            }
        }
        for (junction, holders) in self.holders.iter().enumerate() {
            let junction = JunctionId(junction as u16);
            for (k, &one) in holders.iter().enumerate() {
                holders[k + 1..].iter().for_each(|&other| ahead_goes_first(roads, vehicles, junction, [one, other]));
            }
        }
        self.shut_in_go_last(roads, occupancy, vehicles);
        let mut requests = std::mem::take(&mut self.requests);
        requests.clear();
        for (i, vehicle) in vehicles.iter_mut().enumerate() {
            match request(roads, signals, vehicle, i) {
                Some(request) => {
                    let waits = vehicle.speed < WAITS_MPS && request.at_the_line();
                    vehicle.waited_s = if waits { vehicle.waited_s + step_s } else { 0.0 };
                    requests.push(EntryRequest { waited_s: vehicle.waited_s, ..request });
                }
                None => vehicle.waited_s = if stands_with_turn(vehicle) { vehicle.waited_s + step_s } else { 0.0 },
            }
            let halts = vehicle.kerb_halt.is_some() || vehicle.order.is_some();
            vehicle.stands_s = if !halts && vehicle.speed < CREEPS_MPS { vehicle.stands_s + step_s } else { 0.0 };
        }
        let pressures_s = pressures_s(roads, occupancy, vehicles, &requests);
        requests.iter_mut().zip(pressures_s).for_each(|(request, pressure_s)| request.pressure_s = pressure_s);
        // Who has waited longest is asked first, or others might take the room beyond for ever.
        requests.sort_by(|a, b| b.pressure_s.total_cmp(&a.pressure_s));
        let has_room = |request: &EntryRequest| self.has_exit_space(roads, occupancy, vehicles, &requests, request);
        // Who stands at a line without room beyond goes nowhere: others neither wait for them nor let them go first.
        let goes_nowhere: Vec<bool> =
            requests.iter().map(|r| r.speed < STANDS_MPS && r.at_the_line() && !has_room(r)).collect();
        let gridlocked = gridlock::circles(roads, occupancy, vehicles, &requests, &goes_nowhere);
        for (k, request) in requests.iter().enumerate() {
            let others = requests.iter().zip(&goes_nowhere).enumerate();
            let mut others = others
                .filter(|&(l, (r, &goes_nowhere))| l != k && r.junction == request.junction && !goes_nowhere)
                .map(|(_, (r, _))| r);
            let comes_first = sign_allows(roads, request)
                && !occupancy.crosses_claimed(roads, &request.lanes)
                && is_next(roads, occupancy, vehicles, request.vehicle, request.junction, request.distance);
            let moves_on = gridlocked.binary_search(&k).is_ok() || is_waited_for(roads, occupancy, vehicles, request);
            if comes_first && !moves_on && !self.has_exit_space(roads, occupancy, vehicles, &requests, request) {
                if (request.waited_s / DETOUR_S).floor() > ((request.waited_s - step_s) / DETOUR_S).floor().max(0.0) {
                    take_another_way(roads, &mut vehicles[request.vehicle], request.lanes[0]);
                }
                continue;
            }
            let lets_others_go = !vehicles[request.vehicle].order.is_some_and(|order| order.heedless);
            let mut clear = || {
                self.clear_of_holders(roads, vehicles, request)
                    && others.all(|other| {
                        let lets_me_go = || yields_to(roads, vehicles, other, request);
                        !yields_to(roads, vehicles, request, other)
                            && (goes_before(roads, vehicles, request, other) || lets_me_go())
                    })
            };
            let finds_room = || sweeps_free_ground(roads, occupancy, &vehicles[request.vehicle], &request.lanes);
            let fits = comes_first && (!lets_others_go || clear()) && finds_room();
            if fits {
                self.order += 1;
                let vehicle = &mut vehicles[request.vehicle];
                vehicle.rights_of_way.push(RightOfWay {
                    junction: request.junction,
                    order: self.order,
                    lanes: request.lanes.clone(),
                    exit: request.exit,
                    entered: false,
                    stood_s: 0.0,
                });
                self.holders[request.junction.index()].push(request.vehicle);
            }
        }
        self.requests = requests;
    }

    /// Who is shut in behind others lets all go first who have the right of way too.
    fn shut_in_go_last(&mut self, roads: &Roads, occupancy: &Occupancy, vehicles: &mut [Vehicle]) {
        for junction in (0..self.holders.len()).map(|place| JunctionId(place as u16)) {
            for place in 0..self.holders(junction).len() {
                let i = self.holders(junction)[place];
                if self.is_shut_in(roads, occupancy, vehicles, junction, i) {
                    self.order += 1;
                    let held = vehicles[i].rights_of_way.iter_mut().find(|g| g.junction == junction);
                    held.into_iter().for_each(|g| (g.order, g.stood_s) = (self.order, 0.0));
                }
            }
        }
    }

    /// Room to stand beyond the junction, clear of it and of its crossings. Where the road to the next junction is too
    /// short for that, there must be room beyond the next one too, or a body would be left standing in this one.
    fn has_exit_space(
        &self,
        roads: &Roads,
        occupancy: &Occupancy,
        vehicles: &[Vehicle],
        requests: &[EntryRequest],
        request: &EntryRequest,
    ) -> bool {
        let me = &vehicles[request.vehicle];
        let route = me.route.iter().copied().skip(me.here);
        let crossings = &roads.table(request.exit).cuts;
        let crossing_end = crossings.iter().filter(|c| c.range.0 < 12.0).map(|c| c.range.1).fold(0.0, f64::max);
        // Who joins a ring leaves room for one of those in it: when all its pieces are full, nobody gets on. Not for ever.
        let patient = request.waited_s < CHANCE_S;
        let [before, exit] = [request.before, request.exit].map(|lane| roads.table(lane));
        let left = if exit.leads_back && !before.leads_back {
            if request.waited_s < JOINS_RING_S { RING_SHARE * exit.length } else { ANOTHER_M }
        } else if patient && request.control == TrafficControl::Yield {
            ANOTHER_M
        } else {
            0.0
        };
        let starving = longest_starving(requests, request);
        let kept = kept_free_m(vehicles, starving);
        let mut reserved = is_reserved(vehicles, starving);
        let mut needed = crossing_end + 2.0 * me.half_length + spare_m(request) + left + kept;
        let mut behind = Some(request.junction);
        let mut lanes = route.skip_while(|&l| l != request.exit).peekable();
        for _ in 0..MOST_ROADS {
            let Some(&first) = lanes.peek() else { return true };
            let (mut length, mut queue) = (0.0, Vec::new());
            while let Some(lane) = lanes.next_if(|&l| length < SEEN_M && roads.table(l).junction.is_none()) {
                for o in occupancy.on(lane).iter().filter(|o| o.vehicle != request.vehicle) {
                    let stop_m = vehicles.get(o.vehicle).map_or(0.0, Vehicle::firm_stop_m);
                    let moves_off_m = if patient { 0.0 } else { o.speed * MOVES_ON_S };
                    queue.push(Queued {
                        vehicle: o.vehicle,
                        rear: length + o.rear,
                        front: length + o.front,
                        goes_on_m: stop_m + moves_off_m,
                        filters: o.filters,
                    });
                }
                length += roads.table(lane).length;
            }
            let ends_at_line = lanes.peek().is_some_and(|&next| roads.table(next).junction.is_some());
            let line_m = if ends_at_line { length } else { f64::INFINITY };
            let mut free = queue_tail_m(&mut queue, line_m).min(length).min(SEEN_M);
            for &other in behind.map_or(&[][..], |junction| self.holders(junction)) {
                let heads_there =
                    vehicles[other].rights_of_way.iter().any(|g| Some(g.junction) == behind && g.exit == first);
                if heads_there && other != request.vehicle && !occupancy.covers_any(other, &[first]) {
                    free -= 2.0 * vehicles[other].half_length + SPARE_M;
                }
            }
            let most = length - 0.5;
            let holds_both = most >= needed || !std::mem::take(&mut reserved);
            if free < needed.min(most) || !holds_both {
                return false;
            }
            // Who has waited long takes the chance, or never would where one short road follows another.
            if most >= needed || request.waited_s > CHANCE_S {
                return true;
            }
            behind = lanes.peek().and_then(|&l| roads.table(l).junction);
            while lanes.next_if(|&l| roads.table(l).junction.is_some()).is_some() {}
            needed = 2.0 * me.half_length + SPARE_M;
        }
        true
    }

    /// Whether somebody stands behind one who got the right of way later, and is in nobody's way yet: who waits for the one behind
    /// would wait for ever if the one ahead waits for them.
    fn is_shut_in(
        &self,
        roads: &Roads,
        occupancy: &Occupancy,
        vehicles: &[Vehicle],
        junction: JunctionId,
        i: usize,
    ) -> bool {
        let me = &vehicles[i];
        let Some(mine) = me.right_of_way_at(junction).filter(|g| g.stood_s > SHUT_IN_S) else { return false };
        let later = |other: usize| vehicles[other].right_of_way_at(junction).filter(|g| g.order > mine.order);
        let leader = occupancy.leader(roads, vehicles, i, me.half_length + ANOTHER_M);
        let Some(ahead) = leader.map(|l| l.vehicle).filter(|&l| l < vehicles.len() && later(l).is_some()) else {
            return false;
        };
        let stands_in_way = |other: usize, lanes: &[LaneId]| {
            mine.lanes.iter().any(|&lane| {
                let Some(to_lane) = me.distance_to(roads, lane) else { return false };
                let conflicts = roads.table(lane).conflicts(me.long() || vehicles[other].long()).iter();
                let mut shared = conflicts.filter(|c| lanes.contains(&c.other));
                shared
                    .any(|c| to_lane + c.range.0 < me.half_length + AT_LINE_M && to_lane + c.range.1 > -me.half_length)
            })
        };
        let others = self.holders(junction).iter().filter(|&&other| other != i && other != ahead);
        !others.copied().any(|other| later(other).is_some_and(|g| stands_in_way(other, &g.lanes)))
    }

    /// Those who have the right of way already and priority will be out of the way in time.
    fn clear_of_holders(&self, roads: &Roads, vehicles: &[Vehicle], request: &EntryRequest) -> bool {
        let me = &vehicles[request.vehicle];
        let mut base = request.distance;
        for &lane in &request.lanes {
            for &other in self.holders(request.junction) {
                let them = &vehicles[other];
                let conflicts = roads.table(lane).conflicts(me.long() || them.long());
                for conflict in conflicts.iter().filter(|c| c.gives_way) {
                    let uses =
                        them.right_of_way_at(request.junction).is_some_and(|g| g.lanes.contains(&conflict.other));
                    if other == request.vehicle || !uses {
                        continue;
                    }
                    let Some(distance) = them.distance_to(roads, conflict.other) else { continue };
                    let to_clear = distance + conflict.other_range.1 + them.half_length;
                    let arrival = travel_s(base + conflict.range.0, me.speed, me.driver.accelerate);
                    if to_clear > 0.0 && travel_s(to_clear, them.speed, 0.8) > arrival {
                        return false;
                    }
                }
            }
            base += roads.table(lane).length;
        }
        true
    }
}

/// Of two on the same way through a junction who is ahead goes first: a rider who has the right of way may have let somebody go
/// before it. Others would wait for the one behind, and it for them. Whom the one ahead need not wait for now has waited for the
/// one behind, on the same way; not for one that is longer.
fn ahead_goes_first(roads: &Roads, vehicles: &mut [Vehicle], junction: JunctionId, pair: [usize; 2]) {
    let way = |i: usize| vehicles[i].right_of_way_at(junction).map(|g| (&g.lanes, g.order));
    let (Some(one), Some(other)) = (way(pair[0]), way(pair[1])) else { return };
    if one.0 != other.0 {
        return;
    }
    let [Some(one_to_go), Some(other_to_go)] = pair.map(|i| vehicles[i].distance_to(roads, one.0[0])) else { return };
    let [one, other] = [(pair[0], one.1), (pair[1], other.1)];
    let [(ahead, first), (behind, second)] = if one_to_go < other_to_go { [one, other] } else { [other, one] };
    if first > second && (!vehicles[ahead].long() || vehicles[behind].long()) {
        for (i, order) in [(ahead, second), (behind, first)] {
            let held = vehicles[i].rights_of_way.iter_mut().find(|g| g.junction == junction);
            held.into_iter().for_each(|g| g.order = order);
        }
    }
}

/// Whether the last one on the road beyond a junction waits for somebody whose rear still stands in the junction before, as on a piece
/// of road that is too short for it, and who waits for room there.
fn is_waited_for(roads: &Roads, occupancy: &Occupancy, vehicles: &[Vehicle], request: &EntryRequest) -> bool {
    let me = &vehicles[request.vehicle];
    let last = || occupancy.on(request.exit).iter().min_by(|a, b| a.rear.total_cmp(&b.rear));
    let waits_for_me = |them: &Vehicle| {
        me.rights_of_way.iter().filter(|mine| mine.entered && mine.junction != request.junction).any(|mine| {
            let theirs = them.right_of_way_at(mine.junction).filter(|theirs| theirs.order > mine.order);
            let meets = |&lane: &LaneId| {
                let mut conflicts = roads.table(lane).conflicts(me.long() || them.long()).iter();
                conflicts.any(|conflict| mine.lanes.contains(&conflict.other))
            };
            theirs.is_some_and(|theirs| theirs.lanes.iter().any(meets))
        })
    };
    request.waited_s > CHANCE_S && last().and_then(|last| vehicles.get(last.vehicle)).is_some_and(waits_for_me)
}

/// Whether somebody who waited at a line has the right of way now, and has not got off yet: who loses it again has waited all the
/// while, or those who come later would go first again and again.
fn stands_with_turn(vehicle: &Vehicle) -> bool {
    let has_turn = vehicle.rights_of_way.iter().any(|right_of_way| !right_of_way.entered);
    has_turn && vehicle.waited_s > 0.0 && vehicle.speed < WAITS_MPS
}

/// Whether nobody stands where a long vehicle sweeps that turns on these lanes: who has had the right of way and lost it may
/// stand further on than where one waits.
fn sweeps_free_ground(roads: &Roads, occupancy: &Occupancy, me: &Vehicle, lanes: &[LaneId]) -> bool {
    let stands_there = |swept: &SweptApproach| {
        let from = roads.table(swept.lane).length - swept.last_m;
        occupancy.on(swept.lane).iter().any(|o| o.front > from && o.speed < STANDS_MPS)
    };
    (2.0 * me.half_length < LONG_M && 2.0 * me.half_width < WIDE_M)
        || !lanes.iter().any(|&lane| roads.table(lane).sweeps.approaches.iter().any(stands_there))
}

/// Room that who asks wants behind the leader beyond the junction, metres. At lights nobody makes do with less: those who get green next
/// would find a rear in their way.
fn spare_m(request: &EntryRequest) -> f64 {
    let makes_do = request.pressure_s > LONG_STAND_S && !matches!(request.control, TrafficControl::Signal(_));
    if makes_do { LEAST_SPARE_M } else { SPARE_M }
}

/// Who has waited longest to get where somebody else would go from another road, or has others behind who have, for long, and longer
/// than they: nobody keeps room for those behind or beside them, who wait until they have gone.
fn longest_starving<'a>(requests: &'a [EntryRequest], request: &EntryRequest) -> Option<&'a EntryRequest> {
    let starves = |r: &&EntryRequest| r.pressure_s > STARVES_S.max(request.pressure_s) && r.at_the_line();
    let there = requests.iter().filter(|r| r.exit == request.exit && r.before != request.before);
    there.filter(starves).max_by(|a, b| a.pressure_s.total_cmp(&b.pressure_s))
}

/// Room beyond the junction that is kept for who starves, metres: where there is room for few, and lights let others go first whenever
/// there is any, they would never get on.
fn kept_free_m(vehicles: &[Vehicle], starving: Option<&EntryRequest>) -> f64 {
    starving.map_or(0.0, |starving| 2.0 * vehicles[starving.vehicle].half_length + SPARE_M)
}

/// Whether the room beyond is for a long vehicle that has waited so long for it that others leave all of it: on a short piece of
/// road there is hardly ever as much when its light is green.
fn is_reserved(vehicles: &[Vehicle], starving: Option<&EntryRequest>) -> bool {
    starving.is_some_and(|starving| starving.pressure_s > RESERVES_S) && kept_free_m(vehicles, starving) > ANOTHER_M
}

/// Whether the vehicle directly ahead on the approach, whose line is `distance` metres from the front bumper, has the right of
/// way already. A rider beside it who waits for the way of another lane is in another queue.
fn is_next(
    roads: &Roads,
    occupancy: &Occupancy,
    vehicles: &[Vehicle],
    i: usize,
    junction: JunctionId,
    distance: f64,
) -> bool {
    let me = &vehicles[i];
    let leaders = occupancy.leaders(roads, me, i, distance + me.half_length);
    let goes = |leader: &Leader| {
        let ahead = vehicles.get(leader.vehicle);
        leader.gap > distance || ahead.is_some_and(|ahead| ahead.right_of_way_at(junction).is_some())
    };
    let elsewhere = |leader: &Leader| vehicles.get(leader.vehicle).is_some_and(|v| !me.route.contains(&v.lane()));
    leaders.ahead.is_none_or(|leader| goes(&leader))
        && leaders.beside.is_none_or(|leader| goes(&leader) || elsewhere(&leader))
}

/// Chooses another lane through a junction, if there is any, and a way from there on.
fn take_another_way(roads: &Roads, vehicle: &mut Vehicle, connector: LaneId) {
    // Ahead: a way round may come through the same lane again.
    let first = vehicle.here + 1;
    let Some(place) = vehicle.route.iter().skip(first).position(|&lane| lane == connector) else { return };
    let place = first + place;
    let allowed = roads.allowed(vehicle.asset.model);
    let may_go = |lane: LaneId| allowed[lane.index()] && roads.network.lane(lane).turn != Turn::UTurn;
    let before = roads.network.lane(vehicle.route[place - 1]);
    let others: Vec<LaneId> =
        before.successors.iter().copied().filter(|&lane| lane != connector && may_go(lane)).collect();
    if others.is_empty() {
        return;
    }
    let other = *vehicle.stream.pick(&others);
    vehicle.route.truncate(place);
    vehicle.route.push_back(other);
    vehicle.rights_of_way.retain(|right_of_way| right_of_way.entered);
    vehicle.plan(roads);
}

/// Takes the right of way back from those who have passed, from those who can and must still stop, and from those who are held up
/// before they come to the junction: others might wait for them, and they for those.
fn release(roads: &Roads, occupancy: &Occupancy, signals: &[SignalState], vehicles: &mut [Vehicle], step_s: f64) {
    for i in 0..vehicles.len() {
        let mut rights_of_way = std::mem::take(&mut vehicles[i].rights_of_way);
        let vehicle = &vehicles[i];
        rights_of_way.retain_mut(|right_of_way| {
            let lets_pass = || !right_of_way.entered && waits_for_who_passes(roads, vehicles, i, right_of_way);
            let stands = vehicle.speed < 0.05 && !lets_pass();
            right_of_way.stood_s = if stands { right_of_way.stood_s + step_s } else { 0.0 };
            if occupancy.covers_any(i, &right_of_way.lanes) {
                right_of_way.entered = true;
                return true;
            }
            if right_of_way.entered {
                return false;
            }
            let Some(to_line) = vehicle.distance_to(roads, right_of_way.lanes[0]) else { return false };
            let distance = to_line - vehicle.half_length;
            if right_of_way.stood_s > HELD_UP_S {
                return false;
            }
            let control = approach_control(roads, vehicle, right_of_way.lanes[0]);
            let aspect = aspect(control, signals).filter(|_| !vehicle.takes_no_notice(control));
            let stops = aspect.is_some_and(|aspect| aspect != SignalAspect::Green);
            // Who still stands when the light is red has come too late.
            let late = aspect == Some(SignalAspect::Red) && vehicle.speed < 0.5;
            // Who turns left may go in the yellow after waiting for those who come towards it.
            let waits_to_clear = aspect == Some(SignalAspect::Yellow)
                && roads.network.lane(right_of_way.lanes[0]).turn == Turn::Left
                && distance < 3.0;
            !(late || (stops && distance > stopping_m(vehicle.speed) && !waits_to_clear))
        });
        vehicles[i].rights_of_way = rights_of_way;
    }
}

/// Whether somebody drives through the junction who got the right of way earlier, and has not been where both pass yet: whoever waits
/// for them is held up by nothing else, and would lose the turn as they are gone.
fn waits_for_who_passes(roads: &Roads, vehicles: &[Vehicle], i: usize, mine: &RightOfWay) -> bool {
    let passes = |them: &Vehicle| {
        let first = them.right_of_way_at(mine.junction).filter(|theirs| theirs.entered && theirs.order < mine.order);
        first.is_some_and(|theirs| {
            let long = vehicles[i].long() || them.long();
            let mut shared = mine.lanes.iter().flat_map(|&lane| roads.table(lane).conflicts(long));
            shared.any(|conflict| {
                let to_there =
                    them.distance_to(roads, conflict.other).filter(|_| theirs.lanes.contains(&conflict.other));
                to_there.is_some_and(|to_there| to_there + conflict.other_range.1 + them.half_length > 0.0)
            })
        })
    };
    vehicles.iter().any(|them| them.speed > STANDS_MPS && passes(them))
}

/// Takes it back from those behind somebody on the approach who has none, who lost it or changed lanes before them: would they
/// go first, they would wait for one who waits for them.
fn release_behind(roads: &Roads, occupancy: &Occupancy, vehicles: &mut [Vehicle]) {
    let mut taken = true;
    while std::mem::take(&mut taken) {
        for i in 0..vehicles.len() {
            let mut rights_of_way = std::mem::take(&mut vehicles[i].rights_of_way);
            let before = rights_of_way.len();
            rights_of_way.retain(|right_of_way| {
                let to_line = vehicles[i].distance_to(roads, right_of_way.lanes[0]).filter(|_| !right_of_way.entered);
                to_line.is_none_or(|to_line| {
                    let distance = to_line - vehicles[i].half_length;
                    is_next(roads, occupancy, vehicles, i, right_of_way.junction, distance)
                })
            });
            taken |= rights_of_way.len() < before;
            vehicles[i].rights_of_way = rights_of_way;
        }
    }
}

#[cfg(test)]
mod tests;
