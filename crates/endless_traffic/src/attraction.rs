//! Attracts traffic to wide roads, and to what cameras see.
//!
//! A camera's view of a quiet town is empty most of the time. Given what is looked at, more vehicles and people begin near
//! it, and choose their ways so that they pass through it or stay near. Without, only demand counts.

use crate::demand::lane_demand;
use crate::focus::{Focus, STEP_M, count_in, samples};
use crate::queues::Queues;
use endless_road::{LaneId, RoadNetwork, WalkKind};
use endless_world::Stream;
use endless_world::math::f64::{exp, pow};
use glam::{DVec2, DVec3, Vec3};
use std::sync::Arc;

/// Density where the cameras look over that far away, less 1.
const DENSITY: f64 = 36.0;
/// Drivers weigh what lies this far ahead e times less, metres.
const FORESIGHT_M: f64 = 250.0;
/// Mean speed in town as a share of the limit, lights and queues included.
const USUAL_SHARE: f64 = 0.42;
/// Seconds from the spawn to the middle of a short recording.
const DRIVE_S: f64 = 28.0;
/// A departure is good if the way is looked at this much before and after that time, metres.
const AROUND_M: f64 = 60.0;
/// Rounds after which what lies ahead is known well enough: a lane a round.
const ROUNDS: usize = 40;
/// Least share of its usual likelihood that a way away from all places keeps.
const LEAST: f64 = 0.03;
/// Lane that a vehicle has in a jam that still moves, metres.
pub(crate) const ROOM_M: f64 = 7.0;
/// A view is full with so many vehicles as a share of those for which there is room; a small one with a few, or when it is packed.
const FULL: f64 = 0.5;
const FEW: f64 = 8.0;
const PACKED: f64 = 0.8;
/// Places within this distance of an errand or the end of a crossing are near it, metres.
const NEAR_M: f64 = 9.0;
/// How many times as many people there are near a crossing, and near an errand.
const AT_CROSSING: f64 = 2.0;
const AT_ERRAND: f64 = 4.0;
/// Share of the usual likelihood that nodes out of sight keep as goals of those who come to be seen.
const UNSEEN_GOAL: f64 = 0.02;

/// Attraction of lanes and of places for people.
#[derive(Debug, Clone, Default)]
pub(crate) struct Attraction {
    pub(crate) focus: Focus,
    demand: Vec<f64>,
    /// Factors on the likelihood of ways that lead on round a roundabout.
    going_round: Arc<[f64]>,
    pub(crate) queues: Queues,
    /// Worth of going on with each lane, by view.
    worth_by_view: Vec<Vec<f64>>,
    /// The same of all views that are not full; empty where nothing is looked at, or all is full.
    worth: Vec<f64>,
    /// A bit for each view that is full.
    full: u32,
    /// Relative frequency of each node of the walk network as a goal: of anybody, of those who come to what is seen.
    goals: [Vec<f64>; 2],
    /// Ends of crossings, and errands.
    busy: [Vec<DVec2>; 2],
}

impl Attraction {
    /// With the factors of the map's roundabouts.
    pub(crate) fn new(network: &RoadNetwork, going_round: Arc<[f64]>, focus: &Focus, errands: &[Vec3]) -> Self {
        let crossings = network.crossings.iter().flat_map(|crossing| crossing.ends).map(DVec3::truncate);
        let errands = errands.iter().map(|at| at.as_dvec3().truncate());
        let busy = [crossings.collect(), errands.collect()];
        let demand = lane_demand(network);
        let mut attraction = Self {
            focus: focus.clone(),
            demand,
            going_round,
            queues: Queues::new(network),
            worth_by_view: Vec::new(),
            worth: Vec::new(),
            full: 0,
            goals: Default::default(),
            busy,
        };
        let usual: Vec<f64> = network.walk.nodes.iter().map(|at| attraction.bustle(at.truncate())).collect();
        let mut seen = vec![UNSEEN_GOAL; network.walk.nodes.len()];
        for (number, edge) in network.walk.edges.iter().enumerate() {
            let places = focus.walk_places(number);
            let (Some(first), Some(last)) = (places.first(), places.last()) else { continue };
            for (node, bits) in edge.nodes.iter().zip([first, last]) {
                if edge.kind == WalkKind::Sidewalk && *bits != 0 {
                    seen[node.index()] = 1.0;
                }
            }
        }
        let of_seen = usual.iter().zip(seen).map(|(usual, seen)| usual * seen).collect();
        attraction.goals = [usual, of_seen];
        attraction.worth_by_view = focus.views().map(|view| attraction.lane_attraction(network, view)).collect();
        attraction.unite();
        attraction
    }

    /// Takes notice of those who are in sight or come into it, given the views that see each: who comes to what is seen avoids
    /// a view that is full until there is room again, so that no jam grows before a camera.
    pub(crate) fn notice(&mut self, seen: impl Iterator<Item = u32>) {
        if self.worth_by_view.is_empty() {
            return;
        }
        let mut counts = vec![0.0; self.worth_by_view.len()];
        for bits in seen {
            count_in(&mut counts, bits);
        }
        let room = self.focus.seen_m().into_iter().map(|[lanes, _]| lanes / ROOM_M);
        let views = room.zip(counts).enumerate();
        let is_full = |(room, count): (f64, f64)| count > (FULL * room).max(FEW.min(PACKED * room));
        let full = views.fold(0, |bits, (view, filled)| bits | u32::from(is_full(filled)) << view);
        if full != self.full {
            self.full = full;
            self.unite();
        }
    }

    fn unite(&mut self) {
        let open = |(view, _): &(usize, &Vec<f64>)| self.full >> view & 1 == 0;
        let mut views = self.worth_by_view.iter().enumerate().filter(open).map(|(_, worth)| worth);
        let Some(first) = views.next() else {
            self.worth.clear();
            return;
        };
        let mut worth = first.clone();
        for other in views {
            worth.iter_mut().zip(other).for_each(|(a, b)| *a = a.max(*b));
        }
        self.worth = worth;
    }

    /// Relative density of people wanted at a place: 1 where there is nothing to do.
    pub(crate) fn bustle(&self, at: DVec2) -> f64 {
        let near = |places: &[DVec2]| places.iter().any(|place| place.distance_squared(at) < NEAR_M * NEAR_M);
        let [crossings, errands] = &self.busy;
        let factor = |of: &[DVec2], times: f64| if near(of) { times } else { 1.0 };
        factor(crossings, AT_CROSSING) * factor(errands, AT_ERRAND)
    }

    /// Whether somebody is one of those who come to what is seen. Where nothing is, chance is not asked.
    pub(crate) fn draws(&self, stream: &mut Stream) -> bool {
        let share = self.focus.share();
        share > 0.0 && stream.chance(share)
    }

    /// Relative density of people wanted at a place that is looked at, or not.
    pub(crate) fn density(&self, at: DVec2, seen: bool) -> f64 {
        self.bustle(at) * if seen { 1.0 + DENSITY } else { 1.0 }
    }

    /// Weights of the nodes of the walk network as goals, of those who come to what is seen or of anybody.
    pub(crate) fn goals(&self, drawn: bool) -> &[f64] {
        &self.goals[usize::from(drawn)]
    }

    /// Factors on the likelihood of each of the lanes that may be taken next.
    pub(crate) fn preference(&self, choices: &[LaneId], drawn: bool) -> Vec<f64> {
        let open =
            |lane: &LaneId| self.going_round.get(lane.index()).copied().unwrap_or(1.0) * self.queues.openness(*lane);
        if !drawn || self.worth.is_empty() {
            let demand = |lane: &LaneId| self.demand.get(lane.index()).copied().unwrap_or(1.0);
            return choices.iter().map(|lane| demand(lane) * open(lane)).collect();
        }
        let worth = |lane: &LaneId| self.worth.get(lane.index()).copied().unwrap_or(1.0);
        let best = choices.iter().map(worth).fold(1e-9, f64::max);
        let share = |lane: &LaneId| worth(lane) / best;
        let likelihood = |lane: &LaneId| LEAST + (1.0 - LEAST) * pow(share(lane), 6.0);
        choices.iter().map(|lane| likelihood(lane) * open(lane)).collect()
    }

    /// Relative density of vehicles wanted at a place on a lane. Of those who come to what is seen so that they are there when
    /// the recording begins: what counts is where the best way from here leads in the time of the warm-up.
    pub(crate) fn departure_density(&self, network: &RoadNetwork, lane: LaneId, s: f64, drawn: bool) -> f64 {
        if !drawn || self.worth.is_empty() {
            return self.demand.get(lane.index()).copied().unwrap_or(1.0);
        }
        let reach = network.lane(lane).speed_limit_mps * USUAL_SHARE * DRIVE_S;
        let (mut lane, mut s) = (network.lane(lane), s + (reach - AROUND_M).max(0.0));
        let (mut seen, samples) = (0, (2.0 * AROUND_M / STEP_M) as u32);
        for _ in 0..samples {
            while s > lane.centerline.length() {
                let Some(next) = self.best(&lane.successors) else { return 1.0 };
                s -= lane.centerline.length();
                lane = network.lane(next);
            }
            seen += u32::from(self.focus.on_lane(lane.id.index(), s) != 0);
            s += STEP_M;
        }
        1.0 + DENSITY * f64::from(seen) / f64::from(samples)
    }

    /// The lane among these that is worth most.
    pub(crate) fn best(&self, lanes: &[LaneId]) -> Option<LaneId> {
        let worth = |lane: &LaneId| self.worth.get(lane.index()).copied().unwrap_or(0.0);
        lanes.iter().copied().max_by(|a, b| worth(a).total_cmp(&worth(b)))
    }

    /// Metres in sight of a view that the best way from the beginning of each lane will have, the sooner the better.
    fn lane_attraction(&self, network: &RoadNetwork, view: u32) -> Vec<f64> {
        let own = |lane: &endless_road::Lane| -> f64 {
            let length = lane.centerline.length();
            let places = self.focus.lane_places(lane.id.index());
            let piece = length / places.len().max(1) as f64;
            let seen = samples(length).zip(places).filter(|(_, bits)| *bits >> view & 1 == 1);
            seen.map(|(s, _)| piece * exp(-s / FORESIGHT_M)).sum()
        };
        let own: Vec<f64> = network.lanes.iter().map(own).collect();
        let mut worth = own.clone();
        for _ in 0..ROUNDS {
            worth = network
                .lanes
                .iter()
                .map(|lane| {
                    let next = lane.successors.iter().map(|n| worth[n.index()]).fold(0.0, f64::max);
                    own[lane.id.index()] + exp(-lane.centerline.length() / FORESIGHT_M) * next
                })
                .collect();
        }
        worth
    }
}
