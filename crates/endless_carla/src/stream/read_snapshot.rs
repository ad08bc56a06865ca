//! Snapshots of the world as a client reads them.

use super::message::ByteReader;
use super::snapshot::{
    ActorRecord, ActorRecordState, EPISODE_SIZE, EpisodeHeader, LightRecord, RECORD_SIZE, SIGN_SIZE, STATE_SIZE,
    VehicleRecord, WalkerRecord,
};

/// What a record's last bytes stand for, which they do not say themselves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecordKind {
    /// Sensors, props and all others.
    Other,
    /// A vehicle.
    Vehicle,
    /// A person.
    Walker,
    /// A traffic light.
    Light,
    /// A traffic sign.
    Sign,
}

/// Reads what follows the header of a snapshot's message, given the kinds of actors. Bytes after the last whole record
/// are passed over; `None` if not even the episode's header is there.
pub fn read_snapshot(payload: &[u8], kind: impl Fn(u32) -> RecordKind) -> Option<(EpisodeHeader, Vec<ActorRecord>)> {
    let (header, records) = payload.split_at_checked(EPISODE_SIZE)?;
    let mut header = ByteReader(header);
    let (id, platform_timestamp, delta_seconds) = (header.u64(), header.f64(), header.f32());
    let [_origin_x, _origin_y, _origin_z, flags] = [(); 4].map(|()| header.u32());
    let episode = EpisodeHeader {
        id,
        platform_timestamp,
        delta_seconds,
        map_change: flags & 1 != 0,
        light_update: flags & 2 != 0,
    };
    Some((episode, records.chunks_exact(RECORD_SIZE).map(|record| read_record(record, &kind)).collect()))
}

fn read_record(record: &[u8], kind: &impl Fn(u32) -> RecordKind) -> ActorRecord {
    let mut bytes = ByteReader(record);
    let id = bytes.u32();
    let [_state] = bytes.take();
    let transform = bytes.transform();
    let (velocity, angular_velocity, acceleration) = (bytes.vector(), bytes.vector(), bytes.vector());
    debug_assert_eq!(bytes.0.len(), STATE_SIZE);
    let state = match kind(id) {
        RecordKind::Other => ActorRecordState::Other,
        RecordKind::Vehicle => ActorRecordState::Vehicle(read_vehicle(&mut bytes)),
        RecordKind::Walker => {
            let (direction, speed) = (bytes.vector(), bytes.f32());
            let [jump] = bytes.take();
            ActorRecordState::Walker(WalkerRecord { direction, speed, jump: jump != 0 })
        }
        RecordKind::Light => {
            let sign_id = read_sign(&mut bytes);
            let [green_time, yellow_time, red_time, elapsed_time] = [(); 4].map(|()| bytes.f32());
            let pole_index = bytes.u32();
            let [frozen, state] = bytes.take();
            ActorRecordState::Light(LightRecord {
                sign_id,
                green_time,
                yellow_time,
                red_time,
                elapsed_time,
                pole_index,
                frozen: frozen != 0,
                state,
            })
        }
        RecordKind::Sign => ActorRecordState::Sign(read_sign(&mut bytes)),
    };
    ActorRecord { id, transform, velocity, angular_velocity, acceleration, state }
}

fn read_vehicle(bytes: &mut ByteReader<'_>) -> VehicleRecord {
    let [throttle, steer, brake] = [(); 3].map(|()| bytes.f32());
    let [hand_brake, reverse, manual_gear_shift] = bytes.take().map(|flag: u8| flag != 0);
    let gear = i32::from_le_bytes(bytes.take());
    let speed_limit = bytes.f32();
    let [traffic_light_state, has_light] = bytes.take();
    let light = bytes.u32();
    let traffic_light = (has_light != 0).then_some(light);
    VehicleRecord {
        throttle,
        steer,
        brake,
        hand_brake,
        reverse,
        manual_gear_shift,
        gear,
        speed_limit,
        traffic_light_state,
        traffic_light,
    }
}

fn read_sign(bytes: &mut ByteReader<'_>) -> String {
    let id: [u8; SIGN_SIZE] = bytes.take();
    let end = id.iter().position(|byte| *byte == 0).unwrap_or(SIGN_SIZE);
    String::from_utf8_lossy(&id[..end]).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stream::{SensorHeader, snapshot};
    use crate::wire::{Rotation, Transform, Vector3D};
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vector3D> {
        prop::array::uniform3(-900.0f32..900.0).prop_map(|[x, y, z]| Vector3D { x, y, z })
    }

    fn state() -> impl Strategy<Value = ActorRecordState> {
        prop_oneof![
            Just(ActorRecordState::Other),
            (0.0f32..1.0, -1.0f32..1.0, any::<bool>(), -1i32..7, prop::option::of(any::<u32>())).prop_map(
                |(throttle, steer, reverse, gear, traffic_light)| ActorRecordState::Vehicle(VehicleRecord {
                    throttle,
                    steer,
                    reverse,
                    gear,
                    traffic_light,
                    speed_limit: 30.0,
                    ..VehicleRecord::default()
                })
            ),
            (vector(), 0.0f32..4.0, any::<bool>())
                .prop_map(|(direction, speed, jump)| ActorRecordState::Walker(WalkerRecord { direction, speed, jump })),
            ("[a-z0-9]{0,31}", 0.0f32..60.0, 0u8..5).prop_map(|(sign_id, green_time, state)| {
                ActorRecordState::Light(LightRecord {
                    sign_id,
                    green_time,
                    state,
                    pole_index: 3,
                    ..LightRecord::default()
                })
            }),
            "[a-z0-9]{0,31}".prop_map(ActorRecordState::Sign),
        ]
    }

    fn kind(state: &ActorRecordState) -> RecordKind {
        match state {
            ActorRecordState::Other => RecordKind::Other,
            ActorRecordState::Vehicle(_) => RecordKind::Vehicle,
            ActorRecordState::Walker(_) => RecordKind::Walker,
            ActorRecordState::Light(_) => RecordKind::Light,
            ActorRecordState::Sign(_) => RecordKind::Sign,
        }
    }

    proptest! {
        #[test]
        fn what_was_written_is_read(
            actors in prop::collection::vec((vector(), vector(), state()), 0..6),
            id in any::<u64>(),
            map_change in any::<bool>(),
        ) {
            let record = |(id, (at, velocity, state)): (u32, &(Vector3D, Vector3D, ActorRecordState))| ActorRecord {
                id,
                transform: Transform { location: at.clone(), rotation: Rotation { pitch: 1.0, yaw: at.x, roll: 2.0 } },
                velocity: velocity.clone(),
                angular_velocity: at.clone(),
                acceleration: velocity.clone(),
                state: state.clone(),
            };
            let records: Vec<ActorRecord> = (0..).zip(&actors).map(record).collect();
            let header = SensorHeader { type_id: 17, frame: 1, timestamp: 0.1, transform: Transform::default() };
            let episode =
                EpisodeHeader { id, platform_timestamp: 1.5, delta_seconds: 0.05, map_change, light_update: false };
            let message = snapshot(&header, &episode, &records);
            let read = read_snapshot(&message[SensorHeader::SIZE..], |id| kind(&records[id as usize].state));
            prop_assert_eq!(read, Some((episode, records)));
        }

        #[test]
        fn any_bytes_are_a_snapshot_or_none(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
            let _ = read_snapshot(&bytes, |id| [RecordKind::Light, RecordKind::Vehicle][id as usize % 2]);
        }
    }
}
