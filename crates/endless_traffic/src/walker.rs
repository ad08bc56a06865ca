//! People on foot: they walk to random places for ever, keep to their right, step around one another, and cross roads
//! at crossings when they may.

use super::walk_strip::{BODY_M, DirectedEdge, height, unit_vector};
use crate::crossing::{CrossingPedestrian, CrossingState, signal_of};
use crate::incident::RoadWalk;
use crate::roads::Roads;
use endless_road::{CrossingId, WalkEdgeId, WalkGraph, WalkKind, WalkNodeId};
use endless_world::math::f64::{atan2, wrap_angle};
use endless_world::walking::Footsteps;
use endless_world::{Gait, SignalAspect, SignalState, Stream};
use glam::{DVec2, DVec3};
use std::collections::VecDeque;

/// Distance within which pedestrians notice others, metres.
const SIGHT_M: f64 = 5.0;
/// Distance ahead at which pedestrians aim, metres.
const AIM_M: f64 = 1.6;
/// Pedestrians this near to the beginning of their next crossing request it, metres.
const KERB_M: f64 = 2.0;
/// Turning rate, rad/s.
const TURN_RATE: f64 = 3.5;
/// Most acceleration, m/s².
const ACCELERATION: f64 = 2.5;
/// Who has been stuck in a crowd for so long turns back, seconds.
const GIVES_UP_S: f64 = 25.0;

#[derive(Debug, Clone)]
pub(crate) struct Walker {
    pub(crate) variant: u64,
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
    pub(crate) position: DVec2,
    pub(crate) velocity: DVec2,
    pub(crate) height: f64,
    pub(crate) yaw: f64,
    pub(crate) walked: f64,
    pub(crate) gait: Gait,
    pub(crate) steps: Footsteps,
    /// Seconds for which somebody has stood in the way, and the turn tried to get past, radians.
    pub(crate) stuck: (f64, f64),
    /// Seconds for which they have been stuck in a crowd, less those in which they got on.
    pub(crate) crowded_s: f64,
    /// A way over the road, away from crossings.
    pub(crate) road_walk: Option<RoadWalk>,
}

/// The surroundings of pedestrians.
pub(crate) struct WalkerView<'a> {
    pub(crate) roads: &'a Roads,
    pub(crate) graph: &'a WalkGraph,
    pub(crate) signals: &'a [SignalState],
    /// Positions and velocities of people who go their own ways.
    pub(crate) others: &'a [(DVec2, DVec2)],
}

/// Moves everybody on by one step, one after the other.
pub(crate) fn step(scene: &WalkerView<'_>, walkers: &mut [Walker], crossings: &mut [CrossingState], step_s: f64) {
    for i in 0..walkers.len() {
        if walkers[i].road_walk.is_some() {
            continue;
        }
        let near: Vec<(DVec2, DVec2)> = walkers
            .iter()
            .enumerate()
            .filter(|(j, w)| *j != i && w.position.distance_squared(walkers[i].position) < SIGHT_M * SIGHT_M)
            .map(|(_, w)| (w.position, w.velocity))
            .chain(
                scene
                    .others
                    .iter()
                    .copied()
                    .filter(|(at, _)| at.distance_squared(walkers[i].position) < SIGHT_M * SIGHT_M),
            )
            .collect();
        walkers[i].step(scene, &near, crossings, step_s);
    }
    for state in crossings.iter_mut() {
        state.people.clear();
        state.wanted = false;
    }
    for walker in walkers.iter().filter(|walker| walker.road_walk.is_none()) {
        if let Some((id, person)) = walker.crossing(scene.roads) {
            crossings[id.index()].people.push(person);
        } else if let Some(id) = walker.next_crossing(scene.roads) {
            crossings[id.index()].wanted = true;
        }
    }
}

impl Walker {
    fn strip(&self, roads: &Roads) -> DirectedEdge {
        let (edge, to) = self.way[0];
        DirectedEdge::new(roads, self.from, edge, to)
    }

    fn next_strip(&self, roads: &Roads) -> Option<DirectedEdge> {
        let &(edge, to) = self.way.get(1)?;
        Some(DirectedEdge::new(roads, self.way[0].1, edge, to))
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
        light.is_none_or(|a| a == SignalAspect::Green) && !crossings[id.index()].danger
    }

    fn step(&mut self, scene: &WalkerView<'_>, near: &[(DVec2, DVec2)], crossings: &mut [CrossingState], step_s: f64) {
        let roads = scene.roads;
        self.advance_route(scene, crossings);
        let strip = self.strip(roads);
        let next = self.next_strip(roads);
        let (along, _) = strip.local(self.position);
        let kerb = matches!(next.map(|n| n.kind), Some(WalkKind::Crossing(_)));
        let mut pace = self.pace;
        if let Some((id, person)) = self.crossing(roads) {
            let light = signal_of(roads, id).map(|s| scene.signals[s].aspect);
            if matches!(light, Some(SignalAspect::Yellow | SignalAspect::Red)) {
                // The light changes: hurry.
                pace = (1.5 * pace).min(if self.steps.can_run() { 2.6 } else { 1.9 });
            }
            if crossings[id.index()].step_is_unsafe(person) {
                pace = 0.0;
            }
        }
        // Aim at a point further on, on the right-hand side of the strip, around the corner if that is near.
        let keep = |s: &DirectedEdge| -self.side * s.half_width;
        let ahead = along + AIM_M;
        let target = match next {
            _ if ahead <= strip.length => strip.point(ahead.max(0.3), keep(&strip)),
            Some(n) if !kerb => n.point((ahead - strip.length).min(n.length), keep(&n)),
            _ => strip.point(strip.length, keep(&strip)),
        };
        let to_target = target - self.position;
        if kerb && to_target.length() < 0.9 {
            // At the kerb: stand and wait.
            pace *= ((to_target.length() - 0.25) / 0.65).clamp(0.0, 1.0);
        }
        let mut wanted = to_target.normalize_or_zero() * pace;
        if pace > 0.3 && self.velocity.length() < 0.15 {
            self.stuck.0 += step_s;
            self.crowded_s += step_s;
            if self.crowded_s > GIVES_UP_S && strip.kind == WalkKind::Sidewalk {
                self.turn_back();
            }
            if self.stuck.0 > 1.5 {
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
        let chosen = self.avoid(wanted, near, &strip, next.as_ref().filter(|_| !kerb));
        let change = chosen - self.velocity;
        self.velocity += change.clamp_length_max(ACCELERATION * step_s);
        self.advance(near, &strip, next.as_ref().filter(|_| !kerb), kerb, step_s);
        self.turn(&strip, next.as_ref().filter(|_| kerb), step_s);
        self.steps.advance(self.position, self.yaw, self.velocity, step_s);
        self.height = height(roads, self.from, self.way[0], self.position);
    }

    /// Takes the next edge when the end of this one is near, and plans a new way when it ends.
    fn advance_route(&mut self, scene: &WalkerView<'_>, crossings: &[CrossingState]) {
        if self.way.len() < 2 {
            self.plan(scene.roads, scene.graph);
        }
        let strip = self.strip(scene.roads);
        let left = strip.length - strip.local(self.position).0;
        let Some(next) = self.next_strip(scene.roads) else { return };
        let passes = match next.kind {
            WalkKind::Crossing(id) => left < KERB_M && self.may_cross(scene, id, crossings),
            WalkKind::Sidewalk => left < 0.35 || (left < 1.5 && next.outside(self.position) <= 0.0),
        };
        if passes && let Some((_, node)) = self.way.pop_front() {
            self.from = node;
        }
    }

    /// Back to where the edge underfoot began; what was planned is forgotten.
    fn turn_back(&mut self) {
        let (edge, to) = self.way[0];
        self.way = [(edge, self.from)].into();
        self.from = to;
        self.crowded_s = 0.0;
    }

    /// A way to a random place, after what is planned.
    pub(crate) fn plan(&mut self, roads: &Roads, graph: &WalkGraph) {
        let start = self.way.back().map_or(self.from, |w| w.1);
        for _ in 0..20 {
            let goal = WalkNodeId(self.stream.weighted(roads.attraction.goals(self.drawn)) as u32);
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

    /// Moves, but never into somebody, and not off the sidewalk to get past them.
    fn advance(
        &mut self,
        near: &[(DVec2, DVec2)],
        strip: &DirectedEdge,
        next: Option<&DirectedEdge>,
        waits: bool,
        step_s: f64,
    ) {
        let outside = |p: DVec2| strip.outside(p).min(next.map_or(f64::INFINITY, |n| n.outside(p)));
        let here = outside(self.position);
        // On a crossing there is room for a body beside those who come the other way.
        let most = if strip.kind == WalkKind::Sidewalk { here } else { here.max(BODY_M) };
        let leaves = |velocity: DVec2| outside(self.position + velocity * step_s) > most + 1e-9;
        if leaves(self.velocity) {
            let slides = std::iter::once(strip).chain(next).map(|s| s.along * self.velocity.dot(s.along));
            if let Some(slide) = slides.into_iter().find(|&v| !leaves(v)) {
                self.velocity = slide;
            }
        }
        let goal = self.position + self.velocity * step_s;
        let blocked = near.iter().any(|(p, _)| {
            let after = goal.distance(*p);
            after < 2.0 * BODY_M + 0.02 && after < self.position.distance(*p)
        });
        if blocked {
            self.velocity = DVec2::ZERO;
        } else {
            self.walked += self.position.distance(goal);
            self.position = goal;
        }
        let speed = self.velocity.length();
        self.gait = self.steps.gait(speed, waits);
    }

    fn turn(&mut self, strip: &DirectedEdge, waits_for: Option<&DirectedEdge>, step_s: f64) {
        let speed = self.velocity.length();
        let facing = if speed > 0.25 {
            self.velocity
        } else if let Some(next) = waits_for {
            next.along
        } else if speed > 0.05 {
            strip.along
        } else {
            return;
        };
        let off = wrap_angle(atan2(facing.y, facing.x) - self.yaw);
        self.yaw = wrap_angle(self.yaw + (off * 5.0).clamp(-TURN_RATE, TURN_RATE) * step_s);
    }
}
