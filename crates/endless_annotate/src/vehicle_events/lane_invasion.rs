//! Lane markings that one vehicle crosses.

use super::BodySize;
use super::mark_grid::MarkGrid;
use crate::{MarkAttributes, MarkFeature};
use endless_world::{InstanceId, WorldState};
use glam::{DVec2, Vec2};
use serde::{Deserialize, Serialize};

/// A corner of the carrier has come over painted lines since the frame before, as in CARLA.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LaneInvasionEvent {
    /// Simulation frame.
    pub frame: u32,
    /// Seconds since frame 0.
    pub time_s: f64,
    /// The lines, as `map.json` has them, each once: by ascending place in the map's list.
    pub crossed_lane_markings: Vec<MarkAttributes>,
}

/// Notices when a vehicle comes over painted lines along roads, in world states that follow one another. The gaps of a broken
/// line belong to it.
#[derive(Debug, Clone)]
pub struct LaneInvasionSensor {
    carrier: InstanceId,
    size: BodySize,
    marks: MarkGrid,
    corners: Option<Vec<Vec2>>,
}

impl LaneInvasionSensor {
    /// Carried by this vehicle of this size, on a map with these lines.
    pub fn new(carrier: InstanceId, size: BodySize, marks: &[MarkFeature]) -> Self {
        Self { carrier, size, marks: MarkGrid::new(marks), corners: None }
    }

    /// What the carrier's corners have crossed on their way to the next state: one event, or none.
    pub fn observe(&mut self, state: &WorldState) -> Option<LaneInvasionEvent> {
        let own = state.actors.iter().find(|actor| actor.id == self.carrier);
        let now = own.map(|own| self.size.footprints(own).flat_map(|part| part.corners()).collect());
        let before = std::mem::replace(&mut self.corners, now);
        let (own, before, now) = (own?, before?, self.corners.as_ref()?);
        let ways: Vec<[DVec2; 2]> = before.iter().zip(now).map(|(a, b)| [a.as_dvec2(), b.as_dvec2()]).collect();
        let crossed_lane_markings: Vec<MarkAttributes> =
            self.marks.crossed(&ways, own.pose.position.z.into()).cloned().collect();
        (!crossed_lane_markings.is_empty()).then_some(LaneInvasionEvent {
            frame: state.frame,
            time_s: state.time_s,
            crossed_lane_markings,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PaintColor;
    use endless_world::{Actor, Behaviour, Motion, ObjectClass, Pose, VehicleModelId, VehicleMotion, VehicleRef};
    use glam::{DVec3, Vec3};

    fn state(frame: u32, y: f32) -> WorldState {
        let car = Actor {
            id: InstanceId(1),
            rider_id: None,
            class: ObjectClass::Car,
            asset: VehicleRef { model: VehicleModelId(0), variant: 0 }.into(),
            pose: Pose::level(Vec3::new(frame as f32, y, 0.0), 0.0),
            velocity_mps: Vec3::new(10.0, 0.0, 0.0),
            motion: Motion::Vehicle(VehicleMotion::default()),
            behaviour: Behaviour::default(),
            parked: false,
        };
        WorldState { frame, time_s: 0.1 * f64::from(frame), actors: vec![car], signals: Vec::new() }
    }

    #[test]
    fn a_lane_change_crosses_the_line_twice() {
        let attributes = MarkAttributes { id: 7, broken: true, color: PaintColor::Yellow, width_m: 0.12 };
        let line = vec![DVec3::new(-50.0, 2.0, 0.0), DVec3::new(50.0, 2.0, 0.0)];
        let marks = [MarkFeature { attributes: attributes.clone(), pieces: vec![line] }];
        let mut sensor = LaneInvasionSensor::new(InstanceId(1), BodySize::rigid(Vec2::new(2.0, 0.9)), &marks);
        // Left side at y + 0.9, right side at y − 0.9.
        let ys = [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5];
        let told: Vec<LaneInvasionEvent> = (0..).zip(ys).filter_map(|(i, y)| sensor.observe(&state(i, y))).collect();
        assert_eq!(told.iter().map(|event| event.frame).collect::<Vec<_>>(), [3, 6]);
        assert!(told.iter().all(|event| event.crossed_lane_markings == [attributes.clone()]));
        // Who has been away has not crossed what lies between.
        let gone = WorldState { actors: Vec::new(), ..state(8, 0.0) };
        assert!(sensor.observe(&gone).is_none() && sensor.observe(&state(9, 0.0)).is_none());
    }
}
