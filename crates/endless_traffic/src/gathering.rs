//! Brings traffic to where the cameras look before the first frame is recorded, when nobody sees it.
//!
//! A video may last seconds, and a way through a town takes minutes: who begins somewhere and goes where the cameras look
//! would mostly come too late, or have passed. So during the warm-up those who are out of sight and not on their way into it
//! are set down again on the roads that lead into sight, as they become free; early on also in sight. From frame 0 on, nobody
//! is moved in any other way than by driving and walking.

use crate::attraction::ROOM_M;
use crate::bus_errand::BusErrand;
use crate::focus::{STEP_M, count_in, samples};
use crate::kinematics;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use crate::walk_strip::{BODY_M, height};
use crate::walker::Walker;
use endless_road::swept::OrientedRectangle;
use endless_road::{LaneId, WalkEdgeId, WalkGraph, WalkKind};
use endless_world::Stream;
use endless_world::math::f64::{atan2, sin_cos};
use endless_world::walking::{Footsteps, PedestrianSpec};
use glam::DVec2;

/// Roads lead into sight from this far before it, metres.
pub(crate) const LEADS_M: f64 = 110.0;
/// Sidewalk that a person needs where they are seen, metres.
const WALK_M: f64 = 2.5;
/// Vehicles are set down in sight up to this long before the first frame, and out of sight up to that, seconds.
const LAST_IN_SIGHT_S: f64 = 3.0;
const LAST_S: f64 = 1.0;
/// People are set down so long before the first frame, seconds.
const PEOPLE_S: [f64; 2] = [8.0, 5.0];
/// Who will be in sight after so many metres stays on the way, before that and from then on.
const COMING_M: [f64; 2] = [12.0, LEADS_M];
/// Places tried for somebody in a second.
const TRIES: usize = 120;
/// Vehicles that found no room in a view, after which it counts as full for a second.
const MISSES: u32 = 3;
/// Gap to those ahead and behind of who is set down, metres, and what is added for their speed, seconds and m/s².
const GAP_M: f64 = 2.5;
const GAP_S: f64 = 0.5;
const GAP_BRAKING_MPS2: f64 = 2.5;
/// Room kept to other bodies, metres.
const CLEAR_M: f64 = 0.5;
/// Who is set down drives at this share of the usual speed; in a queue, at this speed at most, m/s.
const PACE: f64 = 0.6;
const QUEUE_MPS: f64 = 2.0;
/// Braking that is left to who is set down before the end of a lane, m/s².
const BRAKING_MPS2: f64 = 1.5;
/// Whose centres are this far apart do not touch, metres.
const FAR_M: f64 = 24.0;
/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 3.0;

/// A place of a lane in sight, or from which the way leads into it.
#[derive(Debug, Clone, Copy)]
struct LaneSlot {
    lane: LaneId,
    s: f64,
    views: u32,
    in_sight: bool,
}

/// A place of a sidewalk in sight.
#[derive(Debug, Clone, Copy)]
struct WalkSlot {
    edge: WalkEdgeId,
    /// From its first node, metres.
    along: f64,
    views: u32,
    weight: f64,
}

/// What it takes to gather traffic.
#[derive(Debug, Clone)]
pub(crate) struct Gathering {
    parked: Vec<OrientedRectangle>,
    people: Vec<PedestrianSpec>,
    stream: Stream,
    lane_slots: Vec<LaneSlot>,
    walk_slots: Vec<WalkSlot>,
    /// Vehicles and people for whom there is room in each view.
    room: Vec<[f64; 2]>,
}

impl Gathering {
    /// Among these parked vehicles, of the person of each walker; `None` where nothing is looked at.
    pub(crate) fn new(
        roads: &Roads,
        parked: &[OrientedRectangle],
        people: impl Iterator<Item = PedestrianSpec>,
        seed: u64,
    ) -> Option<Self> {
        let focus = &roads.attraction.focus;
        if focus.share() <= 0.0 {
            return None;
        }
        let room = focus.seen_m().into_iter().map(|[lanes, walks]| [lanes / ROOM_M, walks / WALK_M]).collect();
        Some(Self {
            parked: parked.to_vec(),
            people: people.collect(),
            stream: Stream::named(seed, "traffic.gathering", &[]),
            lane_slots: lane_slots(roads),
            walk_slots: walk_slots(roads),
            room,
        })
    }

    /// Sets down those who are not where the cameras look, `left_s` seconds before the first frame. Called once a second.
    pub(crate) fn step(
        &mut self,
        roads: &Roads,
        graph: &WalkGraph,
        vehicles: &mut [Vehicle],
        walkers: &mut [Walker],
        left_s: f64,
    ) {
        if left_s > LAST_S {
            self.gather_vehicles(roads, vehicles, left_s > LAST_IN_SIGHT_S);
        }
        if left_s < PEOPLE_S[0] && left_s > PEOPLE_S[1] {
            self.gather_people(roads, graph, walkers);
        }
    }

    fn gather_vehicles(&mut self, roads: &Roads, vehicles: &mut [Vehicle], in_sight: bool) {
        let coming_m = COMING_M[usize::from(!in_sight)];
        let mut counts = vec![0.0; self.room.len()];
        let mut idle = Vec::new();
        let mut misses = vec![0; self.room.len()];
        for (i, vehicle) in vehicles.iter().enumerate() {
            let views = views_ahead(roads, vehicle, coming_m);
            count_in(&mut counts, views);
            // Who parks, or comes from there, stays.
            let parks = vehicle.kerb_halt.is_some_and(|halt| halt.bay.is_some());
            if views == 0 && vehicle.drawn && !parks {
                idle.push(i);
            }
        }
        for i in idle {
            for view in self.emptiest(&counts, 0) {
                if misses[view] > MISSES {
                    continue;
                }
                let slots: Vec<LaneSlot> = self
                    .lane_slots
                    .iter()
                    .filter(|s| s.views >> view & 1 == 1 && (in_sight || !s.in_sight))
                    .copied()
                    .collect();
                if let Some(slot) = self.free_slot(roads, vehicles, i, &slots) {
                    set_down(&mut vehicles[i], roads, slot.0, slot.1);
                    count_in(&mut counts, views_ahead(roads, &vehicles[i], coming_m));
                    break;
                }
                misses[view] += 1;
            }
        }
    }

    /// The views that have room left for vehicles (0) or people (1), the emptiest first.
    fn emptiest(&self, counts: &[f64], kind: usize) -> Vec<usize> {
        let mut views: Vec<usize> =
            (0..counts.len()).filter(|&view| counts[view] + 1.0 <= self.room[view][kind]).collect();
        // Large views get more, but small ones are not left empty.
        let fill = |view: usize| counts[view] / self.room[view][kind].sqrt();
        views.sort_by(|&a, &b| fill(a).total_cmp(&fill(b)));
        views
    }

    /// One of these places in which a vehicle fits, and its speed there.
    fn free_slot(
        &mut self,
        roads: &Roads,
        vehicles: &[Vehicle],
        i: usize,
        slots: &[LaneSlot],
    ) -> Option<(LaneSlot, f64)> {
        if slots.is_empty() {
            return None;
        }
        let me_half = vehicles[i].half_length;
        (0..TRIES).find_map(|_| {
            let slot = slots[self.stream.below(slots.len())];
            let pace = pace(roads, me_half, &slot);
            let speeds = [pace, pace.min(QUEUE_MPS)];
            speeds.into_iter().find(|&speed| self.fits(roads, vehicles, i, &slot, speed)).map(|speed| (slot, speed))
        })
    }

    fn fits(&self, roads: &Roads, vehicles: &[Vehicle], i: usize, slot: &LaneSlot, speed: f64) -> bool {
        let me = &vehicles[i];
        let table = roads.table(slot.lane);
        let half = me.half_length;
        let on_crossing =
            table.cuts.iter().any(|cut| cut.range.0 < slot.s + half + 2.0 && cut.range.1 > slot.s - half - 2.0);
        if !roads.allowed(me.asset.model)[slot.lane.index()]
            || slot.s < half + 1.0
            || slot.s > table.length - half - 3.0
            || on_crossing
        {
            return false;
        }
        let on = roads.network.lane(slot.lane).centerline.at(slot.s);
        let (sin, cos) = sin_cos(on.heading_rad);
        let along = DVec2::new(cos, sin);
        let body = OrientedRectangle::new(
            &roads.specs[me.asset.model.index()],
            on.position.truncate(),
            on.heading_rad,
            CLEAR_M,
        );
        let clear_of = |(k, other): (usize, &Vehicle)| {
            let apart = other.pose.position.as_dvec3() - on.position;
            let (d, bodies) = (apart.truncate(), half + other.half_length);
            if k == i || d.length() > 3.0 * FAR_M || apart.z.abs() > STOREY_M {
                return true;
            }
            // Who is ahead or behind on this lane, or comes to it, keeps a gap; who is beside it must not touch.
            let ahead = along.dot(d);
            let [slow, fast] = if ahead > 0.0 { [other.speed, speed] } else { [speed, other.speed] };
            let closing = (fast * fast - slow * slow).max(0.0) / (2.0 * GAP_BRAKING_MPS2);
            let reach = bodies + GAP_M + GAP_S * fast + closing;
            let in_line = along.perp_dot(d).abs() < 2.4 && ahead.abs() < reach;
            !in_line && !body.overlaps(&other.footprint(&roads.specs, CLEAR_M))
        };
        vehicles.iter().enumerate().all(clear_of)
            && self.parked.iter().all(|other| other.center.distance(body.center) > FAR_M || !body.overlaps(other))
    }

    fn gather_people(&mut self, roads: &Roads, graph: &WalkGraph, walkers: &mut [Walker]) {
        let mut counts = vec![0.0; self.room.len()];
        let mut idle = Vec::new();
        for (i, walker) in walkers.iter().enumerate() {
            let views = views_of(roads, walker);
            count_in(&mut counts, views);
            // Groups stay where they are, and who sits.
            if views == 0 && walker.drawn && walker.company.is_none() && walker.rest.is_none() {
                idle.push(i);
            }
        }
        for i in idle {
            for view in self.emptiest(&counts, 1) {
                let seen: Vec<WalkSlot> =
                    self.walk_slots.iter().filter(|s| s.views >> view & 1 == 1).copied().collect();
                if self.walk_there(roads, graph, walkers, i, &seen) {
                    count_in(&mut counts, views_of(roads, &walkers[i]));
                    break;
                }
            }
        }
    }

    /// Sets a person down on one of these places; whether there was room.
    fn walk_there(
        &mut self,
        roads: &Roads,
        graph: &WalkGraph,
        walkers: &mut [Walker],
        i: usize,
        slots: &[WalkSlot],
    ) -> bool {
        let weights: Vec<f64> = slots.iter().map(|slot| slot.weight).collect();
        if slots.is_empty() {
            return false;
        }
        let walk = &roads.network.walk;
        for _ in 0..TRIES {
            let slot = slots[self.stream.weighted(&weights)];
            let edge = &walk.edges[slot.edge.index()];
            let [first, last] = edge.nodes.map(|node| walk.nodes[node.index()].truncate());
            let length = first.distance(last);
            let along = (slot.along + self.stream.range_f64(-0.5, 0.5) * STEP_M).clamp(0.05 * length, 0.95 * length);
            let nodes = if self.stream.chance(0.5) { edge.nodes } else { [edge.nodes[1], edge.nodes[0]] };
            let ahead = (last - first).normalize_or(DVec2::X) * if nodes[0] == edge.nodes[0] { 1.0 } else { -1.0 };
            let room = (0.5 * edge.width_m - BODY_M).max(0.1);
            let position = first.lerp(last, along / length.max(1e-6)) - ahead.perp() * (walkers[i].side * room);
            let apart = |(k, other): (usize, &Walker)| k == i || other.position.distance(position) > 1.0;
            if !walkers.iter().enumerate().all(apart) {
                continue;
            }
            let walker = &mut walkers[i];
            let yaw = atan2(ahead.y, ahead.x);
            walker.from = nodes[0];
            walker.around_corner = false;
            walker.way = [(slot.edge, nodes[1])].into();
            (walker.position, walker.yaw, walker.velocity) = (position, yaw, DVec2::ZERO);
            walker.height = height(roads, nodes[0], walker.way[0], position);
            walker.steps = Footsteps::new(&self.people[i], position, yaw);
            (walker.stuck, walker.crowded_s, walker.jaywalk) = ((0.0, 0.0), 0.0, None);
            walker.bus = BusErrand::default();
            walker.plan(roads, graph);
            return true;
        }
        false
    }
}

/// The views that see a vehicle now or in the next metres of its planned way.
pub(crate) fn views_ahead(roads: &Roads, vehicle: &Vehicle, coming_m: f64) -> u32 {
    let focus = &roads.attraction.focus;
    if focus.views().is_empty() {
        return 0;
    }
    let mut views = focus.on_lane(vehicle.lane().index(), vehicle.s);
    for (lane, base) in vehicle.ahead(roads) {
        let length = roads.table(lane).length;
        let places = samples(length).zip(focus.lane_places(lane.index()));
        views |= places.filter(|(s, _)| (0.0..coming_m).contains(&(base + s))).fold(0, |all, (_, bits)| all | bits);
    }
    views
}

/// The views that see a person.
fn views_of(roads: &Roads, walker: &Walker) -> u32 {
    let (edge, _) = walker.way[0];
    let walk = &roads.network.walk;
    let [a, b] = walk.edges[edge.index()].nodes.map(|node| walk.nodes[node.index()].truncate());
    let along = (walker.position - a).dot((b - a).normalize_or(DVec2::X));
    roads.attraction.focus.on_walk(edge.index(), along)
}

/// A speed at which others drive at a place, from which half a vehicle's length before it one can stop before the lane's end,
/// m/s.
fn pace(roads: &Roads, half_length: f64, slot: &LaneSlot) -> f64 {
    let table = roads.table(slot.lane);
    let to_end = (table.length - slot.s - half_length - 1.0).max(0.0);
    (PACE * table.speed_at(slot.s)).min((2.0 * BRAKING_MPS2 * to_end).sqrt())
}

/// Puts a vehicle on its way from a place at a speed, m/s.
fn set_down(vehicle: &mut Vehicle, roads: &Roads, slot: LaneSlot, speed: f64) {
    vehicle.route = [slot.lane].into();
    vehicle.here = 0;
    vehicle.s = slot.s;
    vehicle.speed = speed;
    vehicle.acceleration = 0.0;
    vehicle.shift = None;
    vehicle.tail = None;
    vehicle.intent = None;
    vehicle.filtering = None;
    vehicle.rights_of_way.clear();
    vehicle.waited_s = 0.0;
    vehicle.roll = 0.0;
    vehicle.plan(roads);
    kinematics::settle(vehicle, roads);
}

/// Every place of a lane outside junctions that is in sight, or from which the best way leads into it soon.
fn lane_slots(roads: &Roads) -> Vec<LaneSlot> {
    let focus = &roads.attraction.focus;
    let mut slots = Vec::new();
    for lane in roads.network.lanes.iter().filter(|lane| lane.junction.is_none()) {
        let length = roads.table(lane.id).length;
        for (s, &bits) in samples(length).zip(focus.lane_places(lane.id.index())) {
            let views = if bits == 0 { first_seen(roads, lane.id, s) } else { bits };
            if views != 0 {
                slots.push(LaneSlot { lane: lane.id, s, views, in_sight: bits != 0 });
            }
        }
    }
    slots
}

/// The views that first see who goes on from a place of a lane, if that is soon.
fn first_seen(roads: &Roads, lane: LaneId, s: f64) -> u32 {
    let focus = &roads.attraction.focus;
    let (mut lane, mut base) = (lane, -s);
    while base < LEADS_M {
        let length = roads.table(lane).length;
        let places = samples(length).zip(focus.lane_places(lane.index()));
        let ahead = places.filter(|(at, bits)| **bits != 0 && base + at > 0.0).map(|(at, bits)| (base + at, *bits));
        if let Some((_, bits)) = ahead.into_iter().find(|(distance, _)| *distance < LEADS_M) {
            return bits;
        }
        base += length;
        let Some(next) = roads.attraction.best(&roads.network.lane(lane).successors) else { return 0 };
        lane = next;
    }
    0
}

/// Every place of a sidewalk in sight.
fn walk_slots(roads: &Roads) -> Vec<WalkSlot> {
    let walk = &roads.network.walk;
    let mut slots = Vec::new();
    for (number, edge) in walk.edges.iter().enumerate().filter(|(_, edge)| edge.kind == WalkKind::Sidewalk) {
        let [a, b] = edge.nodes.map(|node| walk.nodes[node.index()].truncate());
        let length = a.distance(b);
        for (along, &views) in samples(length).zip(roads.attraction.focus.walk_places(number)) {
            if views != 0 {
                let weight = roads.attraction.bustle(a.lerp(b, along / length.max(1e-6)));
                slots.push(WalkSlot { edge: WalkEdgeId(number as u32), along, views, weight });
            }
        }
    }
    slots
}
