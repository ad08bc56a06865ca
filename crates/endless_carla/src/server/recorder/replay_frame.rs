//! Frames of a recording that is replayed.

use crate::recording::{
    FrameStart, LogReader, Packet, RecordedActor, RecordedLightState, RecordedParent, RecordedPosition,
    RecordedSceneLight, RecordedVehicle, RecordedVehicleLights, RecordedWalker, RecordingError,
};
use std::io::{Read, Seek};

/// A frame, as far as it is replayed.
#[derive(Default)]
pub(super) struct ReplayFrame {
    pub(super) start: FrameStart,
    pub(super) created: Vec<RecordedActor>,
    pub(super) destroyed: Vec<u32>,
    pub(super) parents: Vec<RecordedParent>,
    pub(super) positions: Vec<RecordedPosition>,
    pub(super) light_states: Vec<RecordedLightState>,
    pub(super) vehicles: Vec<RecordedVehicle>,
    pub(super) walkers: Vec<RecordedWalker>,
    pub(super) vehicle_lights: Vec<RecordedVehicleLights>,
    pub(super) scene_lights: Vec<RecordedSceneLight>,
}

impl ReplayFrame {
    /// The next one of a recording; none at its end.
    pub(super) fn read<R: Read + Seek>(log: &mut LogReader<R>) -> Result<Option<Self>, RecordingError> {
        let mut frame = Self::default();
        let mut has_begun = false;
        while let Some(packet) = log.packet()? {
            match packet {
                Packet::FrameStart(start) => (frame.start, has_begun) = (start, true),
                Packet::FrameEnd if has_begun => return Ok(Some(frame)),
                Packet::Created(list) => frame.created.extend(list),
                Packet::Destroyed(list) => frame.destroyed.extend(list),
                Packet::Parents(list) => frame.parents.extend(list),
                Packet::Positions(list) => frame.positions.extend(list),
                Packet::LightStates(list) => frame.light_states.extend(list),
                Packet::Vehicles(list) => frame.vehicles.extend(list),
                Packet::Walkers(list) => frame.walkers.extend(list),
                Packet::VehicleLights(list) => frame.vehicle_lights.extend(list),
                Packet::SceneLights(list) => frame.scene_lights.extend(list),
                _ => {}
            }
        }
        Ok(None)
    }
}

/// Between two places, by a share from 0 to 1; turns go the shorter way.
pub(super) fn between(a: &RecordedPosition, b: &RecordedPosition, share: f32) -> RecordedPosition {
    let straight = |a: f32, b: f32| a + share * (b - a);
    let turned = |a: f32, b: f32| a + share * ((b - a + 180.0).rem_euclid(360.0) - 180.0);
    let pairs =
        |a: [f32; 3], b: [f32; 3], mix: &dyn Fn(f32, f32) -> f32| [mix(a[0], b[0]), mix(a[1], b[1]), mix(a[2], b[2])];
    RecordedPosition {
        actor: a.actor,
        location: pairs(a.location, b.location, &straight),
        rotation: pairs(a.rotation, b.rotation, &turned),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_go_the_shorter_way() {
        let at = |x, yaw| RecordedPosition { actor: 1, location: [x, 0.0, 0.0], rotation: [0.0, 0.0, yaw] };
        assert_eq!(between(&at(0.0, 170.0), &at(100.0, -170.0), 0.5), at(50.0, 180.0));
        assert_eq!(between(&at(0.0, -170.0), &at(100.0, 170.0), 0.25), at(25.0, -175.0));
        assert_eq!(between(&at(0.0, 10.0), &at(8.0, 20.0), 0.0), at(0.0, 10.0));
    }
}
