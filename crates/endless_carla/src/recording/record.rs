//! What packets hold.

use super::bytes::{RecordingError, Stored, read_list, records, write_list};

/// What an actor is, as recordings tell it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RecordedActorType {
    /// The spectator, props.
    #[default]
    Other = 0,
    /// `vehicle.*`.
    Vehicle = 1,
    /// `walker.*`.
    Walker = 2,
    /// `traffic.traffic_light`.
    TrafficLight = 3,
    /// All others of `traffic.*`.
    TrafficSign = 4,
    /// `sensor.*`.
    Sensor = 5,
}

impl RecordedActorType {
    /// Of a blueprint's name.
    pub fn of(id: &str) -> Self {
        match id.split('.').next() {
            Some("vehicle") => Self::Vehicle,
            Some("walker") => Self::Walker,
            Some("sensor") => Self::Sensor,
            Some("traffic") if id == "traffic.traffic_light" => Self::TrafficLight,
            Some("traffic") => Self::TrafficSign,
            _ => Self::Other,
        }
    }
}

records! {
    /// The beginning of a frame.
    FrameStart {
        /// From 1 on.
        id: u64,
        /// Until the next one, seconds.
        duration_s: f64,
        /// Since the first one, seconds.
        elapsed_s: f64,
    }
    /// An attribute of an actor.
    RecordedAttribute {
        /// As [`crate::wire::AttributeType`].
        kind: u8,
        /// Its name.
        id: String,
        /// Its value.
        value: String,
    }
    /// An actor hangs on another from now on.
    RecordedParent {
        /// Who hangs.
        child: u32,
        /// On whom.
        parent: u32,
    }
    /// Two have met.
    RecordedCollision {
        /// Number of the collision.
        id: u32,
        /// Who.
        first: u32,
        /// Whom; 0 for what is no actor.
        second: u32,
        /// Whether the first has the role `hero`.
        first_is_hero: bool,
        /// Whether the second has.
        second_is_hero: bool,
    }
    /// Where an actor is.
    RecordedPosition {
        /// Whose.
        actor: u32,
        /// Centimetres.
        location: [f32; 3],
        /// Roll, pitch and yaw, degrees.
        rotation: [f32; 3],
    }
    /// What a traffic light shows.
    RecordedLightState {
        /// Whose.
        actor: u32,
        /// Its group stands still.
        frozen: bool,
        /// Since it changed, seconds.
        elapsed_s: f32,
        /// 0 red, 1 yellow, 2 green, 3 off, 4 unknown.
        state: u8,
    }
    /// How a vehicle is driven.
    RecordedVehicle {
        /// Whose.
        actor: u32,
        /// -1 to 1.
        steer: f32,
        /// 0 to 1.
        throttle: f32,
        /// 0 to 1.
        brake: f32,
        /// Holds the rear wheels.
        hand_brake: bool,
        /// -1 backwards.
        gear: i32,
    }
    /// How a walker walks.
    RecordedWalker {
        /// Whose.
        actor: u32,
        /// Metres a second.
        speed: f32,
    }
    /// The lights of a vehicle.
    RecordedVehicleLights {
        /// Whose.
        actor: u32,
        /// Bits of CARLA's vehicle lights.
        lights: u32,
    }
    /// A lamp of the map.
    RecordedSceneLight {
        /// Its number.
        light: i32,
        /// Its intensity.
        intensity: f32,
        /// Red, green, blue, opacity; 0 to 1.
        color: [f32; 4],
        /// Whether it is on.
        active: bool,
        /// Its group.
        group: u8,
    }
    /// How an actor moves.
    RecordedKinematics {
        /// Whose.
        actor: u32,
        /// Metres a second.
        velocity: [f32; 3],
        /// Degrees a second.
        angular_velocity: [f32; 3],
    }
    /// The box of an actor, or where vehicles stand at a light or sign.
    RecordedBox {
        /// Whose.
        actor: u32,
        /// Centimetres: in the frame of the actor; that of lights and signs in the world.
        origin: [f32; 3],
        /// Half its size, centimetres.
        extent: [f32; 3],
    }
    /// How long a traffic light shows its colours.
    RecordedLightTimes {
        /// Whose.
        actor: u32,
        /// Seconds.
        green_s: f32,
        /// Seconds.
        yellow_s: f32,
        /// Seconds.
        red_s: f32,
    }
}

/// An actor that has come.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RecordedActor {
    /// Its number.
    pub id: u32,
    /// As [`RecordedActorType`].
    pub kind: u8,
    /// Centimetres.
    pub location: [f32; 3],
    /// Roll, pitch and yaw, degrees.
    pub rotation: [f32; 3],
    /// Number of its blueprint.
    pub uid: u32,
    /// Name of its blueprint.
    pub blueprint: String,
    /// All of them.
    pub attributes: Vec<RecordedAttribute>,
}

impl RecordedActor {
    /// Whether it has the role `hero`.
    pub fn is_hero(&self) -> bool {
        self.attributes.iter().any(|attribute| attribute.id == "role_name" && attribute.value == "hero")
    }
}

impl Stored for RecordedActor {
    fn write(&self, out: &mut Vec<u8>) {
        self.id.write(out);
        self.kind.write(out);
        self.location.write(out);
        self.rotation.write(out);
        self.uid.write(out);
        self.blueprint.write(out);
        let most = self.attributes.len().min(u16::MAX.into());
        (most as u16).write(out);
        write_list(&self.attributes[..most], out);
    }

    fn read(bytes: &mut &[u8]) -> Result<Self, RecordingError> {
        Ok(Self {
            id: u32::read(bytes)?,
            kind: u8::read(bytes)?,
            location: Stored::read(bytes)?,
            rotation: Stored::read(bytes)?,
            uid: u32::read(bytes)?,
            blueprint: String::read(bytes)?,
            attributes: {
                let count = u16::read(bytes)?;
                read_list(count.into(), bytes)?
            },
        })
    }
}
