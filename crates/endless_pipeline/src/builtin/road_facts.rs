//! What relations and events are judged by in built-in towns.

use endless_annotate::{BodySize, LaneCrossing, LaneFacts, RoadFacts};
use endless_asset::Catalogue;
use endless_road::{RoadNetwork, TrafficControl};
use endless_world::{Actor, InstanceId};
use glam::Vec2;
use std::collections::BTreeMap;

/// Half length and half width of somebody on foot, metres.
const PERSON: Vec2 = Vec2::new(0.2, 0.25);

/// The lanes of a network and the sizes of those who move.
pub(super) fn road_facts(network: &RoadNetwork, catalogue: &Catalogue, moving: &[Actor]) -> RoadFacts {
    let mut lanes: Vec<LaneFacts> = network
        .lanes
        .iter()
        .map(|lane| LaneFacts {
            length_m: lane.centerline.length() as f32,
            signal: match lane.end_control {
                TrafficControl::Signal(signal) => Some(signal),
                _ => None,
            },
            successors: lane.successors.iter().map(|next| next.0).collect(),
            crossings: Vec::new(),
        })
        .collect();
    for (crossing, place) in (0u16..).zip(&network.crossings) {
        for cut in &place.cuts {
            let (begin, end) = cut.range;
            lanes[cut.lane.index()].crossings.push(LaneCrossing { crossing, range_m: (begin as f32, end as f32) });
        }
    }
    let half_sizes = body_sizes(catalogue, moving.iter()).into_iter().map(|(id, size)| (id, size.half)).collect();
    RoadFacts { lanes, half_sizes }
}

/// How large actors are on the ground.
pub(super) fn body_sizes<'a>(
    catalogue: &Catalogue,
    actors: impl Iterator<Item = &'a Actor>,
) -> BTreeMap<InstanceId, BodySize> {
    let size = |actor: &Actor| match actor.asset.vehicle() {
        Some(vehicle) => Some((actor.id, BodySize::of(&catalogue.vehicle(vehicle.model)?.spec))),
        None => Some((actor.id, BodySize::rigid(PERSON))),
    };
    actors.filter_map(size).collect()
}
