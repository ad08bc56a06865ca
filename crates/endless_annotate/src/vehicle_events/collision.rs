//! Collisions of one actor with others.

use super::BodySize;
use crate::Footprint;
use crate::rounding::{ten_thousandths, thousandths};
use endless_world::{Actor, InstanceId, ObjectClass, WorldState};
use glam::Vec3Swizzles as _;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// Those whose grounds differ more in height pass over one another, metres.
const STOREY_M: f32 = 2.5;

/// The carrier touches somebody in a frame: one event for each of them and each frame, as in CARLA.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CollisionEvent {
    /// Simulation frame.
    pub frame: u32,
    /// Seconds since frame 0.
    pub time_s: f64,
    /// Whom it touches.
    pub other: InstanceId,
    /// What that is.
    pub class: ObjectClass,
    /// Whether they did not touch in the frame before.
    pub begins: bool,
    /// Where the other pushes the carrier: a horizontal unit vector in the world.
    pub normal: [f64; 3],
    /// How fast they come nearer along the normal, m/s; below 0 if they part. Bodies have no masses and do not bounce: the
    /// impulse that stops them is this, times m₁ m₂ / (m₁ + m₂), along the normal.
    pub closing_speed_mps: f64,
    /// How deep they overlap along the normal, metres.
    pub depth_m: f64,
}

/// Notices whom an actor touches, in world states that follow one another. Bodies are rectangles on
/// the ground, those of trailers rectangles of their own.
#[derive(Debug, Clone)]
pub struct CollisionSensor {
    carrier: InstanceId,
    sizes: BTreeMap<InstanceId, BodySize>,
    still: Vec<Actor>,
    /// Nobody touches another whose middle is farther away, metres.
    reach_m: f32,
    touched: BTreeSet<InstanceId>,
}

impl CollisionSensor {
    /// Carried by this actor. `sizes` are those of everybody who can be touched and of the carrier; `still` are those that
    /// world states leave out: parked vehicles.
    pub fn new(carrier: InstanceId, sizes: BTreeMap<InstanceId, BodySize>, still: Vec<Actor>) -> Self {
        let own_m = sizes.get(&carrier).map_or(0.0, |size| size.half.length());
        let reach_m = own_m + sizes.values().map(|size| size.half.length()).fold(0.0, f32::max);
        Self { carrier, sizes, still, reach_m, touched: BTreeSet::new() }
    }

    /// Whom the carrier touches in the next state, by ascending id; nobody while it is not there.
    pub fn observe(&mut self, state: &WorldState) -> Vec<CollisionEvent> {
        let before = std::mem::take(&mut self.touched);
        let Some(own) = state.actors.iter().find(|actor| actor.id == self.carrier) else { return Vec::new() };
        let bodies: Vec<Footprint> = self.footprints(own).collect();
        let others = self.still.iter().chain(&state.actors).filter(|other| other.id != self.carrier);
        let near = others.filter(|other| {
            let apart = other.pose.position - own.pose.position;
            apart.z.abs() < STOREY_M && apart.xy().length() < self.reach_m
        });
        let mut events: Vec<CollisionEvent> = near
            .filter_map(|other| {
                let contacts = self.footprints(other).flat_map(|touched| {
                    bodies
                        .iter()
                        .filter_map(move |body| Some((body.contact(&touched)?, touched.velocity - body.velocity)))
                });
                let ((normal, depth_m), nearer) = contacts.max_by(|a, b| a.0.1.total_cmp(&b.0.1))?;
                let closing = nearer.dot(normal);
                Some(CollisionEvent {
                    frame: state.frame,
                    time_s: state.time_s,
                    other: other.id,
                    class: other.class,
                    begins: !before.contains(&other.id),
                    normal: [ten_thousandths(normal.x), ten_thousandths(normal.y), 0.0],
                    closing_speed_mps: thousandths(closing),
                    depth_m: thousandths(depth_m),
                })
            })
            .collect();
        events.sort_by_key(|event| event.other);
        self.touched = events.iter().map(|event| event.other).collect();
        events
    }

    /// None for those of no size.
    fn footprints(&self, actor: &Actor) -> impl Iterator<Item = Footprint> + use<> {
        self.sizes.get(&actor.id).map(|size| size.footprints(actor)).into_iter().flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{Behaviour, Motion, Pose, VehicleModelId, VehicleMotion, VehicleRef};
    use glam::{Vec2, Vec3};

    fn car(id: u16, at: Vec3, speed_mps: f32) -> Actor {
        Actor {
            id: InstanceId(id),
            rider_id: None,
            class: ObjectClass::Car,
            asset: VehicleRef { model: VehicleModelId(0), variant: 0 }.into(),
            pose: Pose::level(at, 0.0),
            velocity_mps: Vec3::new(speed_mps, 0.0, 0.0),
            motion: Motion::Vehicle(VehicleMotion { speed_mps, ..VehicleMotion::default() }),
            behaviour: Behaviour::default(),
            parked: false,
        }
    }

    #[test]
    fn a_car_runs_into_a_parked_one() {
        let parked = Actor { parked: true, ..car(1, Vec3::new(10.0, 0.5, 0.0), 0.0) };
        let size = BodySize::rigid(Vec2::new(2.0, 0.9));
        let sizes = (1..5).map(|id| (InstanceId(id), size)).collect();
        let mut sensor = CollisionSensor::new(InstanceId(3), sizes, vec![parked]);
        let mut told = Vec::new();
        for frame in 0..8 {
            let x = frame as f32;
            // Another passes over a bridge at the same place.
            let actors = vec![car(2, Vec3::new(x, 0.0, 6.0), 10.0), car(3, Vec3::new(x, 0.0, 0.0), 10.0)];
            let state = WorldState { frame, time_s: 0.1 * f64::from(frame), actors, signals: Vec::new() };
            told.extend(sensor.observe(&state));
        }
        // Bumpers meet at x = 6; from then on, every frame.
        assert_eq!(told.iter().map(|event| (event.frame, event.begins)).collect::<Vec<_>>(), [(6, true), (7, false)]);
        let hit = &told[1];
        assert_eq!((hit.other, hit.class, hit.normal), (InstanceId(1), ObjectClass::Car, [-1.0, 0.0, 0.0]));
        assert_eq!((hit.closing_speed_mps, hit.depth_m), (10.0, 1.0));
        let alone = WorldState { frame: 9, time_s: 0.9, actors: Vec::new(), signals: Vec::new() };
        assert!(sensor.observe(&alone).is_empty(), "who is not there touches nobody");
    }
}
