//! Lanes along streets.

use super::curve::line_through;
use super::plan::StreetPlan;
use crate::{Lane, LaneId, RoadNetwork, Turn};

/// Distance between points of centre lines, metres.
const STEP_M: f64 = 2.5;

/// Lays the lanes of every street between its stop lines.
pub(super) fn add(plan: &mut StreetPlan, network: &mut RoadNetwork) {
    for street in &mut plan.streets {
        street.lanes = vec![None; street.section.bands.len()];
    }
    let hidden: Vec<bool> = inside(plan);
    for (i, street) in plan.streets.iter_mut().enumerate() {
        if hidden[i] {
            continue;
        }
        let stations = street.stations(street.stops[0], street.length() - street.stops[1], STEP_M);
        for forward in [true, false] {
            let bands = street.section.lanes(forward);
            let base = network.lanes.len();
            let id = |k: usize| LaneId((base + k) as u32);
            for (k, &band) in bands.iter().enumerate() {
                let t = street.section.middle(band);
                let mut points: Vec<_> = stations.iter().map(|&s| street.point(s, t)).collect();
                if !forward {
                    points.reverse();
                }
                street.lanes[band] = Some(id(k));
                network.lanes.push(Lane {
                    id: id(k),
                    centerline: line_through(points),
                    width_m: street.section.bands[band].width_m,
                    speed_limit_mps: street.speed_mps,
                    successors: Vec::new(),
                    predecessors: Vec::new(),
                    left: (k > 0).then(|| id(k - 1)),
                    right: (k + 1 < bands.len()).then(|| id(k + 1)),
                    junction: None,
                    turn: Turn::Straight,
                    end_control: street.control[usize::from(forward)],
                });
            }
        }
    }
}

/// Streets that lie inside a junction whole: they are its asphalt, and have no lanes of their own.
pub(super) fn inside(plan: &StreetPlan) -> Vec<bool> {
    let mut hidden = vec![false; plan.streets.len()];
    for &street in plan.intersections.iter().flat_map(|k| &k.inside) {
        hidden[street] = true;
    }
    hidden
}
