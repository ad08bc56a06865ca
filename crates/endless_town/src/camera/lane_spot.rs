//! Places on lanes from which a street, a junction or a highway is seen.

use super::candidate::HIGHWAY_MPS;
use crate::geometry::unit;
use endless_road::{Lane, RoadNetwork};
use endless_world::math::f64::{exp, ln};
use endless_world::{Stream, ViewSubject};
use glam::{DVec2, DVec3};

/// What cameras look at, by frequency, where all views are wanted.
const SUBJECTS: [(ViewSubject, f64); 4] = [
    (ViewSubject::Street, 0.4),
    (ViewSubject::Junction, 0.28),
    (ViewSubject::Highway, 0.22),
    (ViewSubject::Square, 0.1),
];
/// Cameras at a junction stand so far before its stop line, metres.
const BEFORE_JUNCTION_M: [f64; 2] = [3.0, 60.0];
/// Shorter lanes are no place, metres.
const SHORTEST_LANE_M: f64 = 12.0;

/// Between two lengths, short ones as often as long ones.
pub(super) fn log_between(low: f64, high: f64, random: &mut Stream) -> f64 {
    exp(random.range_f64(ln(low), ln(high)))
}

/// A kind of view that a town has.
pub(super) struct TownView<'l> {
    pub(super) subject: ViewSubject,
    pub(super) frequency: f64,
    /// The lanes from which it is seen, and what traffic is expected on each.
    lanes: Vec<(&'l Lane, f64)>,
}

impl<'l> TownView<'l> {
    /// Those that are wanted; all, if a town has none of these.
    pub(super) fn all(network: &'l RoadNetwork, open_spaces: bool, wanted: &[ViewSubject]) -> Vec<Self> {
        let at_junction = |l: &Lane| l.successors.iter().any(|&next| network.lane(next).junction.is_some());
        let traffic = |l: &Lane| l.centerline.length() * (l.speed_limit_mps / 11.0).clamp(0.6, 1.6);
        let of = |&(subject, frequency): &(ViewSubject, f64)| {
            let seen_from = |l: &&Lane| match subject {
                ViewSubject::Street => l.speed_limit_mps < HIGHWAY_MPS,
                ViewSubject::Junction => at_junction(l),
                ViewSubject::Highway => l.speed_limit_mps >= HIGHWAY_MPS,
                ViewSubject::Square => open_spaces || !network.crossings.is_empty(),
            };
            let open_road = |l: &&Lane| l.junction.is_none() && l.centerline.length() > SHORTEST_LANE_M;
            let lanes = network.lanes.iter().filter(open_road).filter(seen_from).map(|l| (l, traffic(l))).collect();
            Self { subject, frequency, lanes }
        };
        let (wanted, others): (Vec<Self>, Vec<Self>) = SUBJECTS
            .iter()
            .map(of)
            .filter(|view| !view.lanes.is_empty())
            .partition(|view| wanted.contains(&view.subject));
        if wanted.is_empty() { others } else { wanted }
    }

    /// The same from lanes that are near a place, if there are any.
    pub(super) fn near(&self, at: DVec2, within_m: f64) -> Option<Self> {
        let close = |(lane, _): &&(&Lane, f64)| lane.centerline.project(at).1.abs() < within_m;
        let lanes: Vec<(&Lane, f64)> = self.lanes.iter().filter(close).copied().collect();
        (!lanes.is_empty()).then_some(Self { lanes, ..*self })
    }

    /// A place where traffic is likely.
    pub(super) fn spot(&self, random: &mut Stream) -> LaneSpot<'l> {
        let weights: Vec<f64> = self.lanes.iter().map(|lane| lane.1).collect();
        let lane = self.lanes[random.weighted(&weights)].0;
        let length = lane.centerline.length();
        if self.subject != ViewSubject::Junction {
            return LaneSpot { lane, s: length * random.f64(), ahead: None };
        }
        let before = log_between(BEFORE_JUNCTION_M[0], BEFORE_JUNCTION_M[1], random).min(length);
        LaneSpot { lane, s: length - before, ahead: Some(before + random.range_f64(-4.0, 16.0)) }
    }
}

/// A place on a lane, and which way from it one looks.
#[derive(Clone, Copy)]
pub(super) struct LaneSpot<'l> {
    pub(super) lane: &'l Lane,
    pub(super) s: f64,
    /// Distance of what one must look at, where that matters.
    ahead: Option<f64>,
}

impl LaneSpot<'_> {
    /// A place on the road ahead, or behind.
    pub(super) fn aim(&self, distances: [f64; 2], random: &mut Stream) -> DVec3 {
        let drawn = log_between(distances[0], distances[1], random) * if random.chance(0.5) { 1.0 } else { -1.0 };
        let ahead = self.ahead.unwrap_or(drawn);
        let line = &self.lane.centerline;
        let end = (self.s + ahead).clamp(0.0, line.length());
        let place = line.at(end);
        let forward = unit(place.heading_rad);
        let width = self.lane.width_m;
        let across = forward.perp() * random.range_f64(-1.2 * width, 1.2 * width);
        (place.position.truncate() + forward * (self.s + ahead - end) + across).extend(place.position.z)
    }
}
