//! Pedestrian crossings on junction arms and between junctions.

use super::cut::{BEFORE_CROSSING_M, CROSSING_M, without_crossing};
use super::plan::{Arm, Plan, Rule, Street, StreetCrossing, on_road};
use crate::character::Layout;
use endless_road::{Crossing, CrossingId, RoadNetwork};
use endless_world::SignalId;
use endless_world::math::f64::wrap_angle;

/// Adds crossings and moves the stop lines of arms that have none.
pub(crate) fn add_crossings(plan: &mut Plan, network: &mut RoadNetwork, layout: &Layout) {
    for n in 0..plan.nodes.len() {
        let node = plan.nodes[n].clone();
        // A junction of two main roads without signals still has a crossing on its first arm.
        for (k, &arm) in node.arms.iter().enumerate() {
            let wanted = node.rule == Rule::Signals || layout.zebra_everywhere || !node.main[k];
            let cut = plan.arm_cut(arm);
            if wanted {
                let s = plan.arm_s(arm, cut + BEFORE_CROSSING_M + CROSSING_M / 2.0);
                let signal = node.signals.get(k).map(|_| walk_signal(network, &node.signals, k));
                add(plan, network, arm.street, s, signal);
            } else {
                plan.streets[arm.street].stops[arm.end] = without_crossing(cut);
            }
        }
    }
    for street in 0..plan.streets.len() {
        let (from, to) = plan.streets[street].lane_range();
        if to - from >= layout.mid_block_from_m && plan.streets[street].profile.lanes <= 2 {
            let straight = straight_place(&plan.streets[street], (from + to) / 2.0, (to - from) / 4.0);
            if let Some(s) = straight {
                add(plan, network, street, s, None);
            }
        }
    }
}

/// The place nearest to `middle`, within `reach`, at which a street does not bend.
fn straight_place(street: &Street, middle: f64, reach: f64) -> Option<f64> {
    let bends = |s: f64| wrap_angle(street.heading(s + 9.0) - street.heading(s - 9.0)).abs();
    (0..=16).flat_map(|i| [1.0, -1.0].map(|sign| middle + sign * reach * f64::from(i) / 16.0)).find(|&s| bends(s) < 0.1)
}

/// Walk signals are numbered right after the vehicle signals of their junction.
fn walk_signal(network: &mut RoadNetwork, vehicles: &[SignalId], k: usize) -> SignalId {
    let id = SignalId(vehicles[0].0 + vehicles.len() as u16 + k as u16);
    network.signal_groups = network.signal_groups.max(id.0 + 1);
    id
}

fn add(plan: &mut Plan, network: &mut RoadNetwork, street: usize, s: f64, signal: Option<SignalId>) {
    let id = CrossingId(u16::try_from(network.crossings.len()).expect("few crossings"));
    let street = &mut plan.streets[street];
    let kerb = street.profile.kerb();
    let ends = [street.point(s, kerb), street.point(s, -kerb)].map(on_road);
    network.crossings.push(Crossing { ends, width_m: CROSSING_M, signal, cuts: Vec::new() });
    street.crossings.push(StreetCrossing { s, width: CROSSING_M, id, signal });
}

impl Plan {
    /// The crossing on an arm, if it has one.
    pub(crate) fn arm_crossing(&self, arm: Arm) -> Option<StreetCrossing> {
        let street = &self.streets[arm.street];
        let limit = street.stops[arm.end];
        street
            .crossings
            .iter()
            .copied()
            .find(|c| if arm.end == 0 { c.s < limit } else { street.length() - c.s < limit })
    }
}
