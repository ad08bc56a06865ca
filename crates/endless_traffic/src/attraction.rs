//! Attracts traffic to the places that cameras see.
//!
//! A camera's view of a quiet town is empty most of the time. Given the places that are recorded, more vehicles and
//! people begin near them, and choose their ways so that they pass or stay near them. Without such places nothing is
//! preferred.

use endless_road::{LaneId, RoadNetwork};
use endless_world::math::f64::{exp, pow};
use glam::{DVec2, Vec3};

/// Reach of an attraction, metres.
const REACH_M: f64 = 70.0;
/// Density at such a place over that far away, less 1.
const DENSITY: f64 = 36.0;
/// Drivers weigh what lies this far ahead e times less, metres.
const FORESIGHT_M: f64 = 250.0;
/// Mean speed in town as a share of the limit, lights and queues included.
const USUAL_SHARE: f64 = 0.42;
/// Seconds from the spawn to the middle of a short recording.
const DRIVE_S: f64 = 28.0;
/// A departure is good if the way is near a place this much before and after that time, metres.
const AROUND_M: f64 = 60.0;
/// Rounds after which what lies ahead is known well enough: a lane a round.
const ROUNDS: usize = 40;
/// Distance between samples of a lane, metres.
const STEP_M: f64 = 5.0;
/// Least share of its usual likelihood that a way away from all places keeps.
const LEAST: f64 = 0.03;

/// Attraction of places, lanes and walk edges.
#[derive(Debug, Clone, Default)]
pub(crate) struct Attraction {
    places: Vec<DVec2>,
    /// Worth of going on with each lane; empty without places.
    worth: Vec<f64>,
    /// Relative frequency of each node of the walk network as a goal.
    goals: Vec<f64>,
}

impl Attraction {
    pub(crate) fn new(network: &RoadNetwork, focus: &[Vec3]) -> Self {
        let places = focus.iter().map(|p| p.as_dvec3().truncate()).collect();
        let mut attraction = Self { places, worth: Vec::new(), goals: Vec::new() };
        attraction.goals = network.walk.nodes.iter().map(|n| attraction.density(n.truncate())).collect();
        if !attraction.places.is_empty() {
            attraction.worth = attraction.lane_attraction(network);
        }
        attraction
    }

    /// Relative density of traffic wanted at a point: 1 far from all places.
    pub(crate) fn density(&self, at: DVec2) -> f64 {
        1.0 + DENSITY * self.nearness(at)
    }

    /// 1 at a place, 0 far away.
    fn nearness(&self, at: DVec2) -> f64 {
        let nearest = self.places.iter().map(|p| p.distance_squared(at)).fold(f64::INFINITY, f64::min);
        exp(-nearest / (REACH_M * REACH_M))
    }

    /// Weights of the nodes of the walk network as goals.
    pub(crate) fn goals(&self) -> &[f64] {
        &self.goals
    }

    /// Factors on the likelihood of each of the lanes that may be taken next.
    pub(crate) fn preference(&self, choices: &[LaneId]) -> Vec<f64> {
        let worth = |lane: &LaneId| self.worth.get(lane.index()).copied().unwrap_or(1.0);
        let best = choices.iter().map(worth).fold(1e-9, f64::max);
        let share = |lane: &LaneId| worth(lane) / best;
        choices.iter().map(|lane| LEAST + (1.0 - LEAST) * pow(share(lane), 6.0)).collect()
    }

    /// Relative density of vehicles wanted at a place on a lane, so that they are near when the recording begins: what
    /// counts is where the best way from here leads in the time of the warm-up.
    pub(crate) fn departure_density(&self, network: &RoadNetwork, lane: LaneId, s: f64) -> f64 {
        if self.worth.is_empty() {
            return 1.0;
        }
        let reach = network.lane(lane).speed_limit_mps * USUAL_SHARE * DRIVE_S;
        let (mut lane, mut s) = (network.lane(lane), s + (reach - AROUND_M).max(0.0));
        let (mut near, samples) = (0.0, (2.0 * AROUND_M / STEP_M) as u32);
        for _ in 0..samples {
            while s > lane.centerline.length() {
                let worth = |l: &&LaneId| self.worth[l.index()];
                let next = lane.successors.iter().max_by(|a, b| worth(a).total_cmp(&worth(b)));
                let Some(&next) = next else { return 1.0 };
                s -= lane.centerline.length();
                lane = network.lane(next);
            }
            near += self.nearness(lane.centerline.at(s).position.truncate());
            s += STEP_M;
        }
        1.0 + DENSITY * near / f64::from(samples)
    }

    /// Metres near the places that the best way from the beginning of each lane will have, the sooner the better.
    fn lane_attraction(&self, network: &RoadNetwork) -> Vec<f64> {
        let own: Vec<f64> = network
            .lanes
            .iter()
            .map(|lane| {
                let length = lane.centerline.length();
                let n = (length / STEP_M).ceil().max(1.0);
                (0..n as usize)
                    .map(|i| {
                        let s = length * (i as f64 + 0.5) / n;
                        let at = lane.centerline.at(s).position.truncate();
                        length / n * self.nearness(at) * exp(-s / FORESIGHT_M)
                    })
                    .sum()
            })
            .collect();
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
