//! World positions of the keypoints of built-in people.

use endless_annotate::WorldKeypoints;
use endless_asset::{Anatomy, Catalogue};
use endless_world::{Actor, BodyKeypoints, InstanceId, Motion, WorldState};
use std::collections::BTreeMap;

/// The skeletons of people on foot, by their ids, and the seated bodies of riders, by those of their vehicles.
pub(super) struct Skeletons {
    on_foot: BTreeMap<InstanceId, Anatomy>,
    /// In the object frame of the vehicle.
    riding: BTreeMap<InstanceId, BodyKeypoints>,
}

impl Skeletons {
    /// Of all who move.
    pub(super) fn of(catalogue: &Catalogue, moving: &[Actor]) -> Self {
        let on_foot = moving.iter().filter_map(|a| Some((a.id, catalogue.anatomy(a.asset.person()?))));
        let riding = moving.iter().filter(|a| a.rider_id.is_some()).filter_map(|a| {
            let vehicle = a.asset.vehicle()?;
            Some((a.id, catalogue.vehicle(vehicle.model)?.rider_keypoints(vehicle.variant)?))
        });
        Self { on_foot: on_foot.collect(), riding: riding.collect() }
    }

    /// Keypoints of people and riders at an instant.
    pub(super) fn bodies(&self, state: &WorldState) -> WorldKeypoints {
        state.actors.iter().filter_map(|actor| self.of_actor(actor)).collect()
    }

    /// Whose keypoints come with an actor, and where they are.
    fn of_actor(&self, actor: &Actor) -> Option<(InstanceId, BodyKeypoints)> {
        let (id, body) = match &actor.motion {
            Motion::Walker(motion) => (actor.id, self.on_foot.get(&actor.id)?.keypoints(motion)),
            Motion::Vehicle(_) => (actor.rider_id?, *self.riding.get(&actor.id)?),
        };
        let world_from_object = actor.pose.world_from_object();
        Some((id, body.map(|p| world_from_object.transform_point3(p))))
    }
}
