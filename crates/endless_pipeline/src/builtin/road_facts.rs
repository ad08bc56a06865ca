//! What relations and events are judged by in built-in towns.

use endless_annotate::{LaneCrossing, LaneFacts, RoadFacts};
use endless_asset::Catalogue;
use endless_road::{RoadNetwork, TrafficControl};
use endless_world::Actor;
use glam::Vec2;

/// Half length and half width of somebody on foot, metres.
const PERSON: Vec2 = Vec2::new(0.2, 0.25);

/// The lanes of a network and the sizes of vehicles and people.
pub(super) fn road_facts<'a>(
    network: &RoadNetwork,
    catalogue: &Catalogue,
    actors: impl Iterator<Item = &'a Actor>,
) -> RoadFacts {
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
    let half_size = |actor: &Actor| match actor.asset.vehicle() {
        Some(vehicle) => {
            let spec = &catalogue.vehicle(vehicle.model)?.spec;
            Some((actor.id, 0.5 * Vec2::new(spec.length_m, spec.width_m)))
        }
        None => Some((actor.id, PERSON)),
    };
    RoadFacts { lanes, half_sizes: actors.filter_map(half_size).collect() }
}
