//! The world states that a detector has seen.

use endless_road::RoadNetwork;
use endless_road::swept::OrientedRectangle;
use endless_world::{Actor, InstanceId, VehicleSpec, WorldState};
use glam::DVec2;

/// World states that follow one another from frame 0 on.
#[derive(Debug)]
pub(super) struct StateHistory<'a> {
    pub(super) network: &'a RoadNetwork,
    pub(super) specs: &'a [VehicleSpec],
    pub(super) fps: f64,
    pub(super) states: Vec<WorldState>,
}

impl StateHistory<'_> {
    /// Everybody in a vehicle, by ascending id.
    pub(super) fn vehicles(&self) -> Vec<InstanceId> {
        let driven = |actor: &&Actor| actor.asset.vehicle().is_some();
        let ids = self.states.iter().flat_map(|state| state.actors.iter().filter(driven).map(|actor| actor.id));
        let mut ids: Vec<InstanceId> = ids.collect();
        ids.sort_unstable();
        ids.dedup();
        ids
    }

    /// Somebody in a frame.
    pub(super) fn actor(&self, frame: usize, id: InstanceId) -> Option<&Actor> {
        let actors = &self.states.get(frame)?.actors;
        actors.binary_search_by_key(&id, |actor| actor.id).ok().map(|place| &actors[place])
    }

    /// The ground under somebody: people are squares of half a metre.
    pub(super) fn body(&self, actor: &Actor) -> OrientedRectangle {
        let (at, yaw) = (actor.pose.position.as_dvec3().truncate(), f64::from(actor.pose.yaw_rad));
        match actor.asset.vehicle() {
            Some(vehicle) => OrientedRectangle::new(&self.specs[vehicle.model.index()], at, yaw, 0.0),
            None => OrientedRectangle::of(DVec2::splat(0.25), at, yaw),
        }
    }

    /// The ground under a vehicle in a frame.
    pub(super) fn body_at(&self, frame: usize, id: InstanceId) -> Option<OrientedRectangle> {
        self.actor(frame, id).map(|actor| self.body(actor))
    }
}
