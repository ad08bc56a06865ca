//! Repairs defects of networks from real data and odd geometry, and tells the user.

use super::import_context::ImportContext;
use crate::cut::cut_range;
use crate::{CrossingId, LaneId, RoadNetwork, WalkKind};
use endless_world::math::f64::wrap_angle;

/// Lanes that meet at more than this are no way on, degrees; and those further apart than this, metres.
const MOST_KINK_DEG: f64 = 6.0;
const MOST_GAP_M: f64 = 0.04;

/// Unhooks connectors that do not fit their lanes, and takes away crossings that cross nothing.
pub(super) fn mend(network: &mut RoadNetwork, context: &mut ImportContext<'_>) {
    unhook(network, context);
    drop_unused_crossings(network);
}

fn unhook(network: &mut RoadNetwork, context: &mut ImportContext<'_>) {
    for i in 0..network.lanes.len() {
        let lane = &network.lanes[i];
        let end = lane.centerline.at(lane.centerline.length());
        let fits = |next: &LaneId| {
            let start = network.lane(*next).centerline.at(0.0);
            let kink = wrap_angle(start.heading_rad - end.heading_rad).abs().to_degrees();
            kink <= MOST_KINK_DEG && end.position.distance(start.position) <= MOST_GAP_M
        };
        let kept: Vec<LaneId> = lane.successors.iter().copied().filter(fits).collect();
        if kept.len() < lane.successors.len() {
            let at = end.position;
            context.note(
                format!("({:.0}, {:.0}) m", if context.mirrored { -at.x } else { at.x }, at.y),
                "roads meet at an angle or so close to one another that a way between them cannot be driven",
            );
            network.lanes[i].successors = kept;
        }
    }
}

fn drop_unused_crossings(network: &mut RoadNetwork) {
    let used: Vec<bool> = network
        .crossings
        .iter()
        .map(|crossing| network.lanes.iter().any(|lane| cut_range(crossing, lane).is_some()))
        .collect();
    let mut new_id = Vec::with_capacity(used.len());
    let mut count = 0u16;
    for used in &used {
        new_id.push(used.then_some(CrossingId(count)));
        count += u16::from(*used);
    }
    for edge in &mut network.walk.edges {
        if let WalkKind::Crossing(id) = edge.kind {
            edge.kind = new_id[id.index()].map_or(WalkKind::Sidewalk, WalkKind::Crossing);
        }
    }
    let mut keep = used.iter();
    network.crossings.retain(|_| keep.next().copied().unwrap_or(true));
}
