//! People on foot: they walk to random places for ever, keep to their right, step around one another, and cross roads
//! at crossings when they may.

use crate::body_contact::{Bound, bound, bounds_of_bodies, bounds_of_strip, nearest_within};
use crate::bus_errand::{BusErrand, Ride};
use crate::company::Company;
use crate::crossing::{CrossingPedestrian, CrossingState, signal_of};
use crate::incident::RoadWalk;
use crate::jaywalk::{Jaywalk, Roadway};
use crate::pedestrian_avoidance::{avoid, crowd, follow, give_way, somebody_comes};
use crate::people_grid::{Passer, PeopleGrid};
use crate::roads::Roads;
use crate::sitting::Rest;
use crate::walk_strip::{APART_M, BODY_M, DirectedEdge, Footway, SIDEWAYS_APART_M, height, unit_vector};
use endless_road::{CrossingId, WalkEdgeId, WalkGraph, WalkKind, WalkNodeId};
use endless_world::math::f64::{atan2, wrap_angle};
use endless_world::walking::{Footsteps, PedestrianSpec};
use endless_world::{Gait, SignalAspect, SignalState, Stream};
use glam::{DVec2, DVec3};
use std::collections::VecDeque;

/// Distance ahead at which pedestrians aim, metres.
const AIM_M: f64 = 1.6;
/// Pedestrians this near to the beginning of their next crossing request it, metres.
const KERB_M: f64 = 2.0;
/// Turning rate, rad/s.
const TURN_RATE: f64 = 3.5;
/// Most acceleration, m/s².
const ACCELERATION: f64 = 2.5;
/// How much less somebody keeps to their place across the strip for each one who is near.
const CROWD_EASE: f64 = 0.25;
/// Who meets somebody is at least this far right of the middle, metres: two pass one another then.
const PASSES_M: f64 = 0.28;
/// Where the middles of bodies have less room than this to either side, metres, people walk in single file.
const NARROW_M: f64 = 0.5;
/// Who has stood before somebody for so long tries to get past, seconds.
const STUCK_S: f64 = 1.5;
/// Who wants to go slower than this waits, m/s; and who has been stuck in a crowd for so long, seconds, lets others through as they do.
const WAITS_MPS: f64 = 0.3;
const LETS_THROUGH_S: f64 = 5.0;
/// Who has been stuck in a crowd for so long turns back, sooner or later: after so much more in the mean, seconds.
const PATIENT_S: f64 = 6.0;
const GIVES_UP_S: f64 = 10.0;
/// Who has been stuck in a crowd for so long turns their shoulders and squeezes through, seconds.
const SQUEEZES_S: f64 = 3.0;
/// By so much they turn them, radians.
const SHOULDERS_RAD: f64 = 1.1;
/// Whom a vehicle that stands on a crossing has kept on the road for so long goes back to the kerb, seconds: drivers wait for
/// them, and that vehicle may wait for these drivers.
const HELD_UP_S: f64 = 12.0;

/// Where nobody sees anybody.
const NOWHERE: DVec2 = DVec2::splat(1e7);

#[derive(Debug, Clone)]
pub(crate) struct Walker {
    pub(crate) variant: u64,
    pub(crate) spec: PedestrianSpec,
    pub(crate) stream: Stream,
    /// Whether they come to what is looked at.
    pub(crate) drawn: bool,
    /// Comfortable speed, m/s.
    pub(crate) pace: f64,
    /// Preferred position across the strip: 0 middle, 1 right edge.
    pub(crate) side: f64,
    pub(crate) from: WalkNodeId,
    /// The edge underfoot, then those to come, each with the node it leads to.
    pub(crate) way: VecDeque<(WalkEdgeId, WalkNodeId)>,
    /// Whether they came to the edge underfoot from a sidewalk, not over a road.
    pub(crate) around_corner: bool,
    /// How many edges they have walked.
    pub(crate) passed: u32,
    pub(crate) position: DVec2,
    pub(crate) velocity: DVec2,
    /// The velocity that they would have if nobody were in the way.
    pub(crate) intent: DVec2,
    pub(crate) height: f64,
    pub(crate) yaw: f64,
    pub(crate) walked: f64,
    pub(crate) gait: Gait,
    pub(crate) steps: Footsteps,
    /// Seconds for which somebody has stood in the way, and the turn tried to get past, radians.
    pub(crate) stuck: (f64, f64),
    /// Seconds for which they have been stuck in a crowd, less those in which they got on.
    pub(crate) crowded_s: f64,
    /// Seconds for which they have stood on a crossing before a vehicle.
    pub(crate) held_up_s: f64,
    /// Whether they cross roads away from crossings, and such a crossing.
    pub(crate) jaywalks: bool,
    /// Whether they jog.
    pub(crate) jogs: bool,
    pub(crate) jaywalk: Option<Box<Jaywalk>>,
    /// Those with whom they walk.
    pub(crate) company: Option<Box<Company>>,
    /// What they have to do with buses.
    pub(crate) bus: BusErrand,
    /// A rest on a bench, and seconds until they would sit down again.
    pub(crate) rest: Option<Box<Rest>>,
    pub(crate) rests_again_s: f64,
    /// A way over the road, away from crossings.
    pub(crate) road_walk: Option<RoadWalk>,
}

/// The surroundings of pedestrians.
pub(crate) struct WalkerView<'a> {
    pub(crate) roads: &'a Roads,
    pub(crate) graph: &'a WalkGraph,
    pub(crate) signals: &'a [SignalState],
    pub(crate) roadway: &'a Roadway,
    /// Positions and velocities of people who go their own ways.
    pub(crate) others: &'a [(DVec2, DVec2)],
}

/// Moves everybody on by one step, one after the other.
pub(crate) fn step(scene: &WalkerView<'_>, walkers: &mut [Walker], crossings: &mut [CrossingState], step_s: f64) {
    let own = walkers.iter().map(Walker::seen);
    let others = scene.others.iter().map(|&(at, velocity)| Passer { at, velocity, intent: velocity, passed: 0 });
    let stands = |at: DVec2| Passer { at, velocity: DVec2::ZERO, intent: DVec2::ZERO, passed: 0 };
    let knees = walkers.iter().filter_map(|walker| walker.rest.as_deref()?.knees()).map(stands);
    let mut people: Vec<Passer> = own.chain(others).chain(knees).collect();
    let grid = PeopleGrid::new(&people);
    let (mut numbers, mut near) = (Vec::new(), Vec::new());
    for (i, walker) in walkers.iter_mut().enumerate() {
        if walker.road_walk.is_some() || walker.bus.is_inside() {
            continue;
        }
        grid.nearest(&people, i, &mut numbers);
        near.clear();
        near.extend(numbers.iter().map(|(_, other)| people[*other as usize]));
        if let Some(ride) = walker.bus.ride {
            match ride {
                Ride::GettingOn(through) => walker.go_through(scene.roads, through, true, &near, step_s),
                Ride::GettingOff(through) => walker.go_through(scene.roads, through, false, &near, step_s),
                Ride::Inside(_) => {}
            }
            people[i] = walker.seen();
            continue;
        }
        if walker.is_at_bench() {
            walker.step_at_bench(scene.roads, &near, step_s);
            people[i] = walker.seen();
            continue;
        }
        let company = walker.company.as_deref().map_or_else(Vec::new, |company| company.others(&people, i));
        walker.step(scene, i, &near, &company, crossings, step_s);
        people[i] = walker.seen();
    }
    crossings.iter_mut().for_each(CrossingState::look_again);
    let walks = |walker: &&Walker| walker.road_walk.is_none() && walker.bus.ride.is_none() && !walker.is_at_bench();
    for walker in walkers.iter().filter(walks) {
        if let Some((id, person)) = walker.crossing(scene.roads) {
            crossings[id.index()].people.push(person);
        } else if let Some(id) = walker.next_crossing(scene.roads) {
            let state = &mut crossings[id.index()];
            state.wanted = signal_of(scene.roads, id).is_some() || !state.lets_drivers_go;
        }
    }
}

impl Walker {
    /// Somebody who stands on an edge between two nodes and is about to go to the second.
    pub(crate) fn new(
        roads: &Roads,
        spec: &PedestrianSpec,
        (edge, nodes): (WalkEdgeId, [WalkNodeId; 2]),
        position: DVec2,
        stream: Stream,
    ) -> Self {
        let [from, to] = nodes;
        let [a, b] = nodes.map(|n| roads.network.walk.nodes[n.index()].truncate());
        let along = (b - a).normalize_or(DVec2::X);
        let yaw = atan2(along.y, along.x);
        Self {
            variant: 0,
            spec: *spec,
            stream,
            drawn: false,
            pace: f64::from(spec.walk_mps),
            side: 0.5,
            from,
            way: [(edge, to)].into(),
            around_corner: no_kerb_at(roads, from),
            passed: 0,
            position,
            velocity: DVec2::ZERO,
            intent: DVec2::ZERO,
            height: height(roads, from, (edge, to), position),
            yaw,
            walked: 0.0,
            gait: Gait::Stand,
            steps: Footsteps::new(spec, position, yaw),
            stuck: (0.0, 0.0),
            crowded_s: 0.0,
            held_up_s: 0.0,
            jaywalks: false,
            jogs: false,
            jaywalk: None,
            company: None,
            bus: BusErrand::default(),
            rest: None,
            rests_again_s: 0.0,
            road_walk: None,
        }
    }

    /// As others see them.
    fn seen(&self) -> Passer {
        let at = if self.bus.is_inside() { NOWHERE } else { self.position };
        Passer { at, velocity: self.velocity, intent: self.intent, passed: self.passed }
    }

    fn strip(&self, roads: &Roads) -> DirectedEdge {
        if let Some(strip) = self.jaywalk.as_deref().and_then(Jaywalk::strip) {
            return strip;
        }
        let (edge, to) = self.way[0];
        let strip = DirectedEdge::new(roads, self.from, edge, to);
        if self.around_corner { DirectedEdge { round_m: f64::INFINITY, ..strip } } else { strip }
    }

    fn next_strip(&self, roads: &Roads) -> Option<DirectedEdge> {
        let &(edge, to) = self.way.get(1).filter(|_| !self.on_roadway())?;
        let next = DirectedEdge::new(roads, self.way[0].1, edge, to);
        let here = roads.network.walk.edges[self.way[0].0.index()].kind;
        let corner = here == WalkKind::Sidewalk && next.kind == WalkKind::Sidewalk;
        Some(if corner { DirectedEdge { round_m: f64::INFINITY, ..next } } else { next })
    }

    /// The crossing underfoot.
    pub(crate) fn crossing(&self, roads: &Roads) -> Option<(CrossingId, CrossingPedestrian)> {
        let strip = self.strip(roads);
        let WalkKind::Crossing(id) = strip.kind else { return None };
        let [a, b] = roads.network.crossings[id.index()].ends.map(DVec3::truncate);
        let along = (b - a).normalize_or_zero();
        let direction = along.dot(strip.along).signum();
        Some((
            id,
            CrossingPedestrian { along_m: (self.position - a).dot(along), direction, speed: self.velocity.length() },
        ))
    }

    /// The crossing at whose beginning they stand or will be in a moment.
    pub(crate) fn next_crossing(&self, roads: &Roads) -> Option<CrossingId> {
        let WalkKind::Crossing(id) = self.next_strip(roads)?.kind else { return None };
        let strip = self.strip(roads);
        (strip.length - strip.local(self.position).0 < KERB_M).then_some(id)
    }

    fn may_cross(&self, scene: &WalkerView<'_>, id: CrossingId, crossings: &[CrossingState]) -> bool {
        let light = signal_of(scene.roads, id).map(|s| scene.signals[s].aspect);
        let state = &crossings[id.index()];
        let lets_drivers_go = light.is_none() && state.lets_drivers_go;
        light.is_none_or(|a| a == SignalAspect::Green) && !state.danger && !lets_drivers_go
    }

    fn step(
        &mut self,
        scene: &WalkerView<'_>,
        number: usize,
        near: &[Passer],
        company: &[Passer],
        crossings: &mut [CrossingState],
        step_s: f64,
    ) {
        let roads = scene.roads;
        if !self.cross_roadway(roads, scene.roadway, number, step_s) {
            self.advance_route(scene, crossings);
        }
        let on_crossing = self.on_crossing(roads, crossings, step_s);
        let strip = self.strip(roads);
        let next = self.next_strip(roads);
        let (along, _) = strip.local(self.position);
        let own_kerb = self.kerb_ahead(&strip, AIM_M);
        let kerb = own_kerb.is_some() || matches!(next.map(|n| n.kind), Some(WalkKind::Crossing(_)));
        let mut pace = self.pace;
        if let Some((id, held_up)) = on_crossing {
            let light = signal_of(roads, id).map(|s| scene.signals[s].aspect);
            if matches!(light, Some(SignalAspect::Yellow | SignalAspect::Red)) {
                // The light changes: hurry.
                pace = (1.5 * pace).min(if self.steps.can_run() { 2.6 } else { 1.9 }).max(pace);
            }
            if held_up {
                pace = 0.0;
            }
        }
        pace *= self.keeps_together(&strip, company, step_s);
        let talks_at = self.talks_at(&strip, step_s);
        let (bus_at, bus_from) = self.waits_for_bus(roads, &strip, near, step_s).unzip();
        let bench_at = self.comes_to_bench(step_s);
        if let Some(on_roadway) = self.pace_on_roadway(scene.roadway, number) {
            pace = on_roadway;
        }
        // Aim at a point further on, on the right-hand side of the strip, around the corner if that is near.
        // In a crowd they stay beside those who are there, but make room for those who come the other way.
        let makes_room = somebody_comes(self.position, strip.along, near);
        let crowd = if makes_room { 0 } else { crowd(self.position, near).saturating_sub(company.len()) };
        let ease = 1.0 / (1.0 + CROWD_EASE * crowd as f64);
        let keep = |s: &DirectedEdge, ahead: f64, step: usize| {
            if s.half_width < NARROW_M {
                return -PASSES_M.min(s.half_width);
            }
            let here = s.local(self.position).1.clamp(-s.half_width, s.half_width);
            let beside_who_comes = if makes_room { PASSES_M.min(s.half_width) } else { 0.0 };
            let middle = -(self.side * s.half_width).max(beside_who_comes);
            let place = self.company.as_deref().map_or(middle, |company| company.beside(middle, s.half_width));
            let left = here + (place - here) * ease;
            let is_sidewalk = s.kind == WalkKind::Sidewalk && !self.on_roadway();
            if is_sidewalk { roads.benches.kept_before(self.way[step].0, s, self.position, ahead, left) } else { left }
        };
        // Whom they stop goes to the right first.
        let share = if makes_room { (self.velocity.length() / self.pace).clamp(0.2, 1.0) } else { 1.0 };
        let ahead = along + AIM_M * share;
        let target = match next {
            _ if ahead <= strip.length => strip.point(ahead.max(0.3), keep(&strip, ahead, 0)),
            Some(n) if !kerb => {
                let ahead = (ahead - strip.length).min(n.length);
                n.point(ahead, keep(&n, ahead, 1))
            }
            _ => strip.point(strip.length, keep(&strip, strip.length, 0)),
        };
        let target = bus_at.or(bench_at).or(talks_at).or(own_kerb).unwrap_or(target);
        let to_target = target - self.position;
        if (kerb || talks_at.is_some() || bus_at.is_some()) && to_target.length() < 0.9 {
            // At the kerb: stand and wait.
            pace *= ((to_target.length() - 0.25) / 0.65).clamp(0.0, 1.0);
        }
        let mut wanted = to_target.normalize_or_zero() * pace;
        self.intent = strip.along * pace;
        if pace > 0.3 && self.velocity.length() < 0.15 {
            self.stuck.0 += step_s;
            self.crowded_s += step_s;
            // Who has stepped onto the road is expected to go on.
            let off_road = strip.kind == WalkKind::Sidewalk || along < 0.0;
            let gives_up = self.crowded_s > PATIENT_S && self.stream.chance(step_s / GIVES_UP_S);
            if gives_up && off_road && !self.on_roadway() {
                self.turn_back(roads);
            }
            if self.stuck.0 > STUCK_S {
                // Face to face: step aside or back, and try again.
                self.stuck = (0.5, self.stream.range_f64(-2.4, 1.6));
            }
        } else {
            self.stuck.0 = (self.stuck.0 - step_s).max(0.0);
            self.crowded_s = (self.crowded_s - step_s).max(0.0);
        }
        if self.stuck.0 > 0.0 && self.stuck.1 != 0.0 {
            wanted = unit_vector(self.stuck.1).rotate(wanted) * 0.5;
        } else {
            self.stuck.1 = 0.0;
        }
        let way = Footway { strip: &strip, next: next.as_ref().filter(|_| !kerb) };
        // Who does not want to get on, or does not, lets others through.
        let stays = pace < WAITS_MPS || self.crowded_s > LETS_THROUGH_S;
        let makes_way = if stays { give_way(self.position, near) } else { DVec2::ZERO };
        // Who overtakes on a narrow sidewalk would stand in the way of those who come.
        let in_file =
            makes_room && self.stuck.0 <= 0.0 && strip.kind == WalkKind::Sidewalk && strip.half_width < NARROW_M;
        let free = if in_file {
            follow(self.position, wanted, near)
        } else {
            avoid(self.position, wanted, near, self.apart_m(), &way)
        };
        let change = free + makes_way - self.velocity;
        self.velocity += change.clamp_length_max(ACCELERATION * step_s);
        self.advance(roads, near, &way, kerb, step_s);
        let waits_for = self.jaywalk.as_deref().and_then(Jaywalk::waits_for).or(bus_from);
        let talks_to = talks_at.and_then(|_| self.talks_to(company));
        if talks_to.is_some() {
            self.talk();
        }
        self.turn(&strip, talks_to.or(waits_for).or(next.filter(|_| kerb).map(|next| next.along)), step_s);
        self.steps.advance(self.position, self.yaw, self.velocity, step_s);
        self.height = self.height_on_roadway().unwrap_or_else(|| height(roads, self.from, self.way[0], self.position));
    }

    /// The crossing underfoot, and whether a vehicle keeps them from going on. Where it has done so for long, they turn back.
    fn on_crossing(&mut self, roads: &Roads, crossings: &[CrossingState], step_s: f64) -> Option<(CrossingId, bool)> {
        let look = |walker: &Self| {
            walker.crossing(roads).map(|(id, person)| (id, crossings[id.index()].step_is_unsafe(person)))
        };
        let seen = look(self);
        self.held_up_s = if seen.is_some_and(|(_, held_up)| held_up) { self.held_up_s + step_s } else { 0.0 };
        if self.held_up_s < HELD_UP_S {
            return seen;
        }
        self.held_up_s = 0.0;
        self.turn_back(roads);
        look(self)
    }

    /// Takes the next edge when the end of this one is near, and plans a new way when it ends.
    fn advance_route(&mut self, scene: &WalkerView<'_>, crossings: &[CrossingState]) {
        if self.way.len() < 2 {
            self.plan(scene.roads, scene.graph);
        }
        if self.bus.waits() || self.rest.is_some() {
            return;
        }
        let strip = self.strip(scene.roads);
        let left = strip.length - strip.local(self.position).0;
        let Some(next) = self.next_strip(scene.roads) else { return };
        let passes = match next.kind {
            // Who stands beside the crossing comes to its beginning first.
            WalkKind::Crossing(id) => {
                let before_it = next.local(self.position).1.abs() < next.half_width + BODY_M;
                left < KERB_M && (before_it || left < 0.35) && self.may_cross(scene, id, crossings)
            }
            WalkKind::Sidewalk => left < 0.35 || (left < 1.5 && next.outside(self.position) <= 0.0),
        };
        if passes && let Some((_, node)) = self.way.pop_front() {
            self.from = node;
            self.passed += 1;
            self.around_corner = strip.kind == WalkKind::Sidewalk && next.kind == WalkKind::Sidewalk;
            if next.kind == WalkKind::Sidewalk {
                self.want_to_cross(scene.roads);
            }
        }
    }

    /// Whether they turn their shoulders to get through a crowd (Yamamoto, Yanagisawa, Feliciani and Nishinari 2019, "Body-rotation
    /// behavior of pedestrians for collision avoidance in passing and cross flow").
    fn squeezes(&self) -> bool {
        self.crowded_s > SQUEEZES_S
    }

    /// How far they stay from the middles of others, metres.
    fn apart_m(&self) -> f64 {
        if self.squeezes() { SIDEWAYS_APART_M } else { APART_M }
    }

    /// Whether a crowd has kept them from getting on for so long, seconds.
    pub(crate) fn is_stuck_in_crowd(&self, for_s: f64) -> bool {
        self.crowded_s > for_s
            && !self.on_roadway()
            && self.road_walk.is_none()
            && self.bus.ride.is_none()
            && !self.is_at_bench()
    }

    /// Back to where the edge underfoot began; what was planned is forgotten, and so are those with whom they walked.
    pub(crate) fn turn_back(&mut self, roads: &Roads) {
        let (edge, to) = self.way[0];
        self.way = [(edge, self.from)].into();
        self.from = to;
        self.crowded_s = 0.0;
        (self.jaywalk, self.company) = (None, None);
        self.around_corner = no_kerb_at(roads, self.from);
    }

    /// A way to a random place, after what is planned.
    pub(crate) fn plan(&mut self, roads: &Roads, graph: &WalkGraph) {
        let start = self.way.back().map_or(self.from, |w| w.1);
        if let (Some(company), Some(&(edge, _))) = (&mut self.company, self.way.front()) {
            company.plan_talk(edge);
        }
        for _ in 0..20 {
            let weights = roads.attraction.goals(self.drawn);
            let stream = self.company.as_deref_mut().map_or(&mut self.stream, Company::goals);
            let goal = WalkNodeId(stream.weighted(weights) as u32);
            let way = graph.shortest(&roads.network.walk, start, goal);
            // Nobody turns on the spot if there is another way.
            let turns = way.first().is_some_and(|w| self.way.back().is_some_and(|b| b.0 == w.0));
            let avoidable = turns && graph.edges_at(start).len() > 1;
            if !way.is_empty() && !avoidable {
                self.way.extend(way);
                return;
            }
        }
        if let Some(&edge) = graph.edges_at(start).first() {
            let [a, b] = roads.network.walk.edges[edge.index()].nodes;
            self.way.push_back((edge, if a == start { b } else { a }));
        }
    }

    /// Moves, but never into somebody or a parked vehicle, and not off the sidewalk to get past them.
    fn advance(&mut self, roads: &Roads, near: &[Passer], way: &Footway<'_>, waits: bool, step_s: f64) {
        let here = way.outside(self.position);
        // On a crossing there is room for a body beside those who come the other way.
        let beside = if way.strip.kind == WalkKind::Sidewalk { 0.0 } else { BODY_M };
        let stays = |v: &DVec2| way.outside(self.position + *v * step_s) <= here.max(beside) + 1e-9;
        let bodies = self.bounds_of_bodies(roads, near, self.apart_m(), step_s);
        let along_edges = |strip: &DirectedEdge| {
            let edges = bounds_of_strip(strip, self.position, beside, step_s);
            nearest_within(&[&bodies[..], &edges].concat(), self.velocity)
        };
        let free = std::iter::once_with(|| nearest_within(&bodies, self.velocity));
        let mut candidates = free.chain(std::iter::once(way.strip).chain(way.next).map(along_edges));
        self.velocity = candidates.find(stays).unwrap_or(DVec2::ZERO);
        let step = self.velocity * step_s;
        self.walked += step.length();
        self.position += step;
        self.gait = self.steps.gait(self.velocity.length(), waits);
    }

    /// The bounds that people near by and parked vehicles put on their velocity for a step.
    pub(crate) fn bounds_of_bodies(&self, roads: &Roads, near: &[Passer], apart_m: f64, step_s: f64) -> Vec<Bound> {
        let mut bounds = bounds_of_bodies(self.position, near, apart_m, step_s);
        let parked = self.way.iter().take(2).flat_map(|(edge, _)| roads.parked_beside.around(*edge, self.position));
        bounds.extend(parked.map(|(direction, room_m)| bound(direction, room_m, step_s)));
        bounds
    }

    fn turn(&mut self, strip: &DirectedEdge, waits_for: Option<DVec2>, step_s: f64) {
        let speed = self.velocity.length();
        let facing = if speed > 0.25 {
            self.velocity
        } else if let Some(ahead) = waits_for {
            ahead
        } else if speed > 0.05 {
            strip.along
        } else {
            return;
        };
        let facing = if self.squeezes() { unit_vector(SHOULDERS_RAD).rotate(facing) } else { facing };
        let off = wrap_angle(atan2(facing.y, facing.x) - self.yaw);
        self.yaw = wrap_angle(self.yaw + (off * 5.0).clamp(-TURN_RATE, TURN_RATE) * step_s);
    }
}

/// Whether no crossing begins near a node.
fn no_kerb_at(roads: &Roads, node: WalkNodeId) -> bool {
    const NEAR_M: f64 = 4.0;
    let at = roads.network.walk.nodes[node.index()].truncate();
    let mut ends = roads.network.crossings.iter().flat_map(|crossing| crossing.ends);
    !ends.any(|end| end.truncate().distance_squared(at) < NEAR_M * NEAR_M)
}

#[cfg(test)]
mod tests;
