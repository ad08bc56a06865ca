//! The surface of every lane.

use super::lane_types::{is_unpaved, is_walked, lane_type};
use super::sampled::{LaneKey, SampledDocument};
use crate::{LaneSurface, LaneType};
use glam::DVec3;

/// Narrower than this there is nothing to see, metres.
const SLIVER_M: f64 = 0.01;
/// Sidewalks of files that give lanes no heights lie this much above the road, metres.
pub(super) const KERB_M: f64 = 0.15;

/// How much sidewalks are raised beyond what the file says.
pub(super) fn sidewalk_lift(sampled: &SampledDocument<'_>) -> f64 {
    let stated = sampled.keys().any(|(_, lane)| is_walked(&lane.kind) && !lane.heights.is_empty());
    if stated { 0.0 } else { KERB_M }
}

/// One strip or more for every lane that is paved.
pub(super) fn lane_surfaces(sampled: &SampledDocument<'_>) -> Vec<LaneSurface> {
    let lift = sidewalk_lift(sampled);
    let mut lane_surfaces = Vec::new();
    for (key, record) in sampled.keys() {
        let Some(kind) = lane_type(&record.kind) else { continue };
        let Some(lane) = sampled.lane(key) else { continue };
        let road = &sampled.document.roads[key.road];
        let up = DVec3::Z * if kind == LaneType::Sidewalk { lift } else { 0.0 };
        let start = road.sections[key.section].s;
        let stations = stations(sampled, key);
        // A segment belongs to a strip if it has some width; a strip is all on a bridge or not at all.
        let state = |i: usize| {
            let wide = lane.width[i].max(lane.width[i + 1]) > SLIVER_M;
            let middle = 0.5 * (stations[i] + stations[i + 1]);
            let bridge = road.bridges.iter().any(|&(from, to)| from <= middle && middle <= to);
            let at = record.materials.partition_point(|material| material.0 <= middle - start);
            let unpaved = at > 0 && is_unpaved(&record.materials[at - 1].1);
            wide.then_some((bridge, unpaved))
        };
        let mut from = 0;
        while from + 1 < stations.len() {
            let here = state(from);
            let mut to = from + 1;
            while to + 1 < stations.len() && state(to) == here {
                to += 1;
            }
            if let Some((bridge, unpaved)) = here {
                lane_surfaces.push(LaneSurface {
                    kind,
                    left: lane.left[from..=to].iter().map(|p| *p + up).collect(),
                    right: lane.right[from..=to].iter().map(|p| *p + up).collect(),
                    in_junction: road.junction.is_some(),
                    unpaved,
                    bridge,
                });
            }
            from = to;
        }
    }
    lane_surfaces
}

fn stations<'a>(sampled: &'a SampledDocument<'_>, key: LaneKey) -> &'a [f64] {
    sampled.sections[key.road][key.section].as_ref().map_or(&[], |section| &section.stations)
}
