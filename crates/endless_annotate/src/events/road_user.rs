//! Those who move, as relations and events see them.

use super::{Footprint, RoadFacts};
use crate::activity::STANDS_MPS;
use endless_world::{Actor, Behaviour, InstanceId, Motion, WorldState};
use glam::Vec3Swizzles as _;

/// Somebody who moves, at an instant.
#[derive(Debug, Clone, Copy)]
pub(super) struct RoadUser {
    pub(super) id: InstanceId,
    pub(super) rider_id: Option<InstanceId>,
    /// In a vehicle or on a two-wheeler, rather than on foot.
    pub(super) drives: bool,
    pub(super) speed_mps: f32,
    pub(super) behaviour: Behaviour,
    /// Of those whose size is known.
    pub(super) footprint: Option<Footprint>,
}

impl RoadUser {
    fn new(actor: &Actor, road: &RoadFacts) -> Self {
        Self {
            id: actor.id,
            rider_id: actor.rider_id,
            drives: matches!(actor.motion, Motion::Vehicle(_)),
            speed_mps: actor.velocity_mps.xy().length(),
            behaviour: actor.behaviour,
            footprint: road.half_sizes.get(&actor.id).map(|&half| Footprint::of(actor, half)),
        }
    }

    /// Everybody, by ascending id.
    pub(super) fn all(state: &WorldState, road: &RoadFacts) -> Vec<Self> {
        state.actors.iter().map(|actor| Self::new(actor, road)).collect()
    }

    pub(super) fn stands(&self) -> bool {
        self.speed_mps < STANDS_MPS
    }

    /// Half of its length, metres.
    pub(super) fn half_length_m(&self) -> f32 {
        self.footprint.map_or(0.0, |footprint| footprint.half.x)
    }
}
