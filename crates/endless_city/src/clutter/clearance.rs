//! Where vehicles and walkers come.

use endless_road::{RoadNetwork, WalkKind};
use endless_world::Stream;
use endless_world::math::segment::share_along;
use glam::{DVec2, DVec3};

/// Besides half a lane's width, metres: bodies overhang lanes, most in junctions.
const BESIDE_LANE_M: f64 = 0.25;
const BESIDE_JUNCTION_LANE_M: f64 = 1.2;
/// Walkers keep to one side of a sidewalk by at most this share of the half in which their middles stay, and are this wide
/// about it, metres.
const WALKED_SHARE: f64 = 0.85;
const WALKER_M: f64 = 0.28;
/// Besides half the width of crossings, metres.
const BESIDE_CROSSING_M: f64 = 0.8;

/// A line with ground on both sides of it that stays free.
#[derive(Debug, Clone, Copy)]
struct Strip {
    ends: [DVec2; 2],
    half_m: f64,
}

/// The strips near a place.
#[derive(Debug, Clone, Default)]
pub(super) struct Clearance {
    strips: Vec<Strip>,
    /// Those of lanes and sidewalks: beside them is where clutter is in the way of sight. With their mean heights.
    borders: Vec<(Strip, f64)>,
    /// How often each of them is chosen: long and near ones more.
    weights: Vec<f64>,
}

impl Clearance {
    /// Of lanes, crossings and ways on foot that come within `reach_m` of a place.
    pub(super) fn around(network: &RoadNetwork, place: DVec2, reach_m: f64) -> Self {
        let (mut strips, mut borders) = (Vec::new(), Vec::new());
        for lane in &network.lanes {
            let beside = if lane.junction.is_some() { BESIDE_JUNCTION_LANE_M } else { BESIDE_LANE_M };
            let half_m = 0.5 * lane.width_m + beside;
            for ends in lane.centerline.points().windows(2) {
                let strip = Strip { ends: [ends[0].truncate(), ends[1].truncate()], half_m };
                strips.push(strip);
                if lane.junction.is_none() {
                    borders.push((strip, 0.5 * (ends[0].z + ends[1].z)));
                }
            }
        }
        let crossings = network.crossings.iter();
        strips.extend(crossings.map(|crossing| Strip {
            ends: crossing.ends.map(DVec3::truncate),
            half_m: 0.5 * crossing.width_m + BESIDE_CROSSING_M,
        }));
        let walk = &network.walk;
        for edge in &walk.edges {
            let ends = edge.nodes.map(|node| walk.nodes[node.index()]);
            let half_m = match edge.kind {
                WalkKind::Sidewalk => WALKED_SHARE * (0.5 * edge.width_m - 0.25).max(0.1) + WALKER_M,
                WalkKind::Crossing(_) => 0.5 * edge.width_m + BESIDE_CROSSING_M,
            };
            let strip = Strip { ends: ends.map(DVec3::truncate), half_m };
            strips.push(strip);
            if edge.kind == WalkKind::Sidewalk {
                borders.push((strip, 0.5 * (ends[0].z + ends[1].z)));
            }
        }
        strips.retain(|strip| strip.distance(place) < reach_m);
        borders.retain(|(strip, _)| strip.distance(place) < reach_m);
        let weight = |(strip, _): &(Strip, f64)| strip.ends[0].distance(strip.ends[1]) / strip.distance(place).max(8.0);
        let weights = borders.iter().map(weight).collect();
        Self { strips, borders, weights }
    }

    /// A place just outside a lane or sidewalk, for what takes a disc of this radius; `None` if there are none.
    pub(super) fn border(&self, random: &mut Stream, radius_m: f64) -> Option<DVec3> {
        if self.borders.is_empty() {
            return None;
        }
        let (Strip { ends: [a, b], half_m }, height) = self.borders[random.weighted(&self.weights)];
        let aside = half_m + radius_m + random.range_f64(0.0, 0.4);
        let side = if random.chance(0.5) { aside } else { -aside };
        let place = a.lerp(b, random.f64()) + (b - a).normalize_or_zero().perp() * side;
        Some(place.extend(height))
    }

    /// Whether nobody comes within a distance of a place.
    pub(super) fn is_free(&self, place: DVec2, radius_m: f64) -> bool {
        self.strips.iter().all(|strip| strip.distance(place) >= strip.half_m + radius_m)
    }
}

impl Strip {
    /// From its line.
    fn distance(&self, place: DVec2) -> f64 {
        let [a, b] = self.ends;
        let along = b - a;
        place.distance(a + along * share_along(place, a, b))
    }
}
