//! Snapshots of the world: where all actors are, and what they do.

use super::message::{SensorHeader, push_floats, push_transform};
use crate::wire::{Transform, Vector3D};

/// What a snapshot tells of its episode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EpisodeHeader {
    /// The episode.
    pub id: u64,
    /// Seconds on the server's clock.
    pub platform_timestamp: f64,
    /// Seconds since the frame before.
    pub delta_seconds: f32,
    /// Another map begins with this snapshot.
    pub map_change: bool,
    /// Lamps of the map have changed.
    pub light_update: bool,
}

/// What a snapshot tells of an actor.
#[derive(Debug, Clone, PartialEq)]
pub struct ActorRecord {
    /// Whose.
    pub id: u32,
    /// In the world.
    pub transform: Transform,
    /// Metres a second.
    pub velocity: Vector3D,
    /// Degrees a second.
    pub angular_velocity: Vector3D,
    /// Metres a second squared.
    pub acceleration: Vector3D,
    /// By kind of actor.
    pub state: ActorRecordState,
}

/// What only actors of a kind have.
#[derive(Debug, Clone, PartialEq)]
pub enum ActorRecordState {
    /// Sensors, props and all others.
    Other,
    /// A vehicle.
    Vehicle(VehicleRecord),
    /// A person.
    Walker(WalkerRecord),
    /// A traffic light.
    Light(LightRecord),
    /// A traffic sign, by its number in the OpenDRIVE file.
    Sign(String),
}

/// A vehicle.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct VehicleRecord {
    /// 0 to 1.
    pub throttle: f32,
    /// −1 to 1, to the right.
    pub steer: f32,
    /// 0 to 1.
    pub brake: f32,
    /// Pulled.
    pub hand_brake: bool,
    /// Driving backwards.
    pub reverse: bool,
    /// Gears are shifted by hand.
    pub manual_gear_shift: bool,
    /// −1 for reverse, 0 for neutral.
    pub gear: i32,
    /// Kilometres an hour.
    pub speed_limit: f32,
    /// 0 red, 1 yellow, 2 green: of the light at which it is.
    pub traffic_light_state: u8,
    /// The light at which it is.
    pub traffic_light: Option<u32>,
}

/// A person.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct WalkerRecord {
    /// Where to.
    pub direction: Vector3D,
    /// Metres a second.
    pub speed: f32,
    /// In the air.
    pub jump: bool,
}

/// A traffic light.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LightRecord {
    /// Number of its signal in the OpenDRIVE file.
    pub sign_id: String,
    /// Seconds.
    pub green_time: f32,
    /// Seconds.
    pub yellow_time: f32,
    /// Seconds.
    pub red_time: f32,
    /// Seconds in this state.
    pub elapsed_time: f32,
    /// Its place in its group.
    pub pole_index: u32,
    /// It stays as it is.
    pub frozen: bool,
    /// 0 red, 1 yellow, 2 green.
    pub state: u8,
}

/// Of the header of an episode, bytes.
pub(super) const EPISODE_SIZE: usize = 36;
/// Of a record, bytes.
pub(super) const RECORD_SIZE: usize = 119;
/// Of what differs by kind, bytes.
pub(super) const STATE_SIZE: usize = 54;
/// Of the number of a sign, bytes.
pub(super) const SIGN_SIZE: usize = 32;
/// The state of all who are told of.
const ACTIVE: u8 = 1;

/// A message of the stream of snapshots.
pub fn snapshot(header: &SensorHeader, episode: &EpisodeHeader, actors: &[ActorRecord]) -> Vec<u8> {
    let mut message = header.begin(EPISODE_SIZE + RECORD_SIZE * actors.len());
    message.extend(episode.id.to_le_bytes());
    message.extend(episode.platform_timestamp.to_le_bytes());
    message.extend(episode.delta_seconds.to_le_bytes());
    // The origin of large maps.
    message.extend([0; 12]);
    message.extend((u32::from(episode.map_change) | u32::from(episode.light_update) << 1).to_le_bytes());
    actors.iter().for_each(|actor| push_record(&mut message, actor));
    message
}

fn push_record(message: &mut Vec<u8>, actor: &ActorRecord) {
    let begin = message.len();
    message.extend(actor.id.to_le_bytes());
    message.push(ACTIVE);
    push_transform(message, &actor.transform);
    for Vector3D { x, y, z } in [&actor.velocity, &actor.angular_velocity, &actor.acceleration] {
        push_floats(message, &[*x, *y, *z]);
    }
    debug_assert_eq!(message.len() - begin, RECORD_SIZE - STATE_SIZE);
    match &actor.state {
        ActorRecordState::Other => {}
        ActorRecordState::Vehicle(vehicle) => push_vehicle(message, vehicle),
        ActorRecordState::Walker(WalkerRecord { direction, speed, jump }) => {
            push_floats(message, &[direction.x, direction.y, direction.z, *speed]);
            message.push((*jump).into());
        }
        ActorRecordState::Light(light) => {
            push_sign(message, &light.sign_id);
            push_floats(message, &[light.green_time, light.yellow_time, light.red_time, light.elapsed_time]);
            message.extend(light.pole_index.to_le_bytes());
            message.extend([u8::from(light.frozen), light.state]);
        }
        ActorRecordState::Sign(id) => push_sign(message, id),
    }
    message.resize(begin + RECORD_SIZE, 0);
}

fn push_vehicle(message: &mut Vec<u8>, vehicle: &VehicleRecord) {
    push_floats(message, &[vehicle.throttle, vehicle.steer, vehicle.brake]);
    message.extend([vehicle.hand_brake, vehicle.reverse, vehicle.manual_gear_shift].map(u8::from));
    message.extend(vehicle.gear.to_le_bytes());
    message.extend(vehicle.speed_limit.to_le_bytes());
    message.extend([vehicle.traffic_light_state, u8::from(vehicle.traffic_light.is_some())]);
    message.extend(vehicle.traffic_light.unwrap_or(0).to_le_bytes());
    // It has not failed.
    message.push(0);
}

/// At most 31 bytes, and zeros.
fn push_sign(message: &mut Vec<u8>, id: &str) {
    let bytes = &id.as_bytes()[..id.len().min(SIGN_SIZE - 1)];
    message.extend(bytes);
    message.resize(message.len() + SIGN_SIZE - bytes.len(), 0);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_are_as_long_as_clients_count_on() {
        let header = SensorHeader { type_id: 17, frame: 3, timestamp: 0.5, transform: Transform::default() };
        let episode = EpisodeHeader {
            id: 1,
            platform_timestamp: 0.0,
            delta_seconds: 0.05,
            map_change: true,
            light_update: false,
        };
        let states = [
            ActorRecordState::Other,
            ActorRecordState::Vehicle(VehicleRecord { traffic_light: Some(7), ..VehicleRecord::default() }),
            ActorRecordState::Walker(WalkerRecord::default()),
            ActorRecordState::Light(LightRecord {
                sign_id: "a long number ".repeat(9),
                state: 2,
                ..LightRecord::default()
            }),
            ActorRecordState::Sign("205".to_owned()),
        ];
        let zero = Vector3D::default;
        let record = |(id, state): (u32, &ActorRecordState)| ActorRecord {
            id,
            transform: Transform::default(),
            velocity: zero(),
            angular_velocity: zero(),
            acceleration: zero(),
            state: state.clone(),
        };
        let records: Vec<ActorRecord> = (10..).zip(&states).map(record).collect();
        let message = snapshot(&header, &episode, &records);
        assert_eq!(message.len(), 84 + 119 * 5);
        assert_eq!(message[80..84], [1, 0, 0, 0]);
        let of = |k: usize| &message[84 + 119 * k..][..119];
        assert!((0..5).all(|k| of(k)[0] == 10 + k as u8 && of(k)[4] == 1));
        // The light's number follows what else is told of a vehicle.
        assert_eq!(of(1)[65 + 25..65 + 29], [7, 0, 0, 0]);
        assert_eq!((of(3)[65 + 53], of(3)[65 + 31]), (2, 0));
    }
}
