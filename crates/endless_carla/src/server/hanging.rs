//! What hangs on spring arms.

use super::actor::ServerActor;
use super::episode::Episode;
use super::spring_arm::SpringArm;
use crate::frames;
use crate::wire::Transform;
use endless_world::ClassTag;

/// What hangs on an arm stays so far before walls, metres.
const BEFORE_WALLS_M: f64 = 0.12;

impl Episode {
    /// Hangs an actor that has a parent on an arm.
    pub(super) fn hang(&mut self, id: u32, arm: Option<SpringArm>) {
        if let Some(actor) = self.actors.get_mut(&id) {
            actor.arm = arm;
        }
        self.carry_attached();
    }

    /// Time passes: all arms turn after their parents.
    pub(super) fn turn_arms(&mut self, step_s: f64) {
        let armed = self.actors.values().filter(|actor| actor.arm.is_some());
        let turned: Vec<(u32, f64)> = armed
            .filter_map(|actor| {
                let parent = self.actors.get(&actor.told.parent_id)?;
                Some((actor.told.id, parent.transform.rotation.yaw.into()))
            })
            .collect();
        for (id, yaw_deg) in turned {
            if let Some(arm) = self.actors.get_mut(&id).and_then(|actor| actor.arm.as_mut()) {
                arm.turn(yaw_deg, step_s);
            }
        }
    }

    /// Where something is that hangs on an arm: nearer to its parent where a wall is between them.
    pub(super) fn on_arm(&self, arm: &SpringArm, parent: &ServerActor, own: &Transform) -> Transform {
        let mut end = arm.end(&parent.transform, own);
        if arm.is_ghost {
            return end;
        }
        let middle = Transform { location: parent.told.bounding_box.location.clone(), ..Transform::default() };
        let from = frames::from_carla(&frames::attached(&parent.transform, &middle).location).as_dvec3();
        let way = frames::from_carla(&end.location).as_dvec3() - from;
        let is_wall = |tag: ClassTag| tag != ClassTag::Vegetation;
        if let Some(free_m) = self.map.free_way(from, way, is_wall) {
            let place = from + way.normalize_or_zero() * (free_m - BEFORE_WALLS_M).max(0.0);
            end.location = frames::to_carla(place.as_vec3());
        }
        end
    }
}
