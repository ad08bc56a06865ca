//! Commands of a batch: variants `[index, fields]`, each in an array of one.

use super::actor::ActorDescription;
use super::geometry::{Location, Transform, Vector3D};
use super::value::{array, element};
use super::vehicle::{VehicleAckermannControl, VehicleControl, VehiclePhysicsControl, WalkerControl};
use super::{Wire, WireError};
use rmpv::Value;

/// How deep commands may be nested in what is done after a spawn.
const DEEPEST: usize = 8;

/// Another actor, or a new one.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SpawnActor {
    /// What it shall be.
    pub description: ActorDescription,
    /// Where; relative to the parent if there is one.
    pub transform: Transform,
    /// Whom it hangs on.
    pub parent: Option<u32>,
    /// How it hangs there. Peers leave this byte uninitialised: it says nothing.
    pub attachment: u8,
    /// Where it hangs there, since 0.9.16.
    pub socket: String,
    /// What is done next, with the new actor in place of actor 0.
    pub do_after: Vec<Command>,
}

impl SpawnActor {
    fn read(fields: &[Value], depth: usize) -> Result<Self, WireError> {
        let field = |index| element(fields, index, "SpawnActor");
        let description = ActorDescription::from_value(field(0)?)?;
        let transform = Transform::from_value(field(1)?)?;
        let parent = fields.get(2).map(Option::<u32>::from_value).transpose()?.flatten();
        // 0.9.15 has what is done next in the place of the attachment.
        let before_sockets = fields.get(3).is_some_and(Value::is_array);
        let (attachment, socket, do_after) = match before_sockets {
            true => (0, String::new(), fields.get(3)),
            false => (
                fields.get(3).and_then(|byte| u8::from_value(byte).ok()).unwrap_or(0),
                fields.get(4).map(String::from_value).transpose()?.unwrap_or_default(),
                fields.get(5),
            ),
        };
        let do_after = match do_after {
            Some(list) => {
                array(list, "commands")?.iter().map(|one| Command::read(one, depth + 1)).collect::<Result<_, _>>()
            }
            None => Ok(Vec::new()),
        }?;
        Ok(Self { description, transform, parent, attachment, socket, do_after })
    }

    fn fields(&self) -> Vec<Value> {
        vec![
            self.description.to_value(),
            self.transform.to_value(),
            self.parent.to_value(),
            self.attachment.to_value(),
            self.socket.to_value(),
            self.do_after.to_value(),
        ]
    }
}

macro_rules! commands {
    ($($(#[$meta:meta])* $name:ident { $($(#[$field_meta:meta])* $field:ident: $type:ty),* } = $index:literal;)*) => {
        /// One command of a batch.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Command {
            /// Makes an actor.
            SpawnActor(Box<SpawnActor>),
            $($(#[$meta])* $name {
                $($(#[$field_meta])* $field: $type,)*
            },)*
        }

        impl Command {
            fn read(value: &Value, depth: usize) -> Result<Self, WireError> {
                if depth > DEEPEST {
                    return Err(WireError::new(format!("commands nested at most {DEEPEST} deep"), value));
                }
                let variant = array(element(array(value, "command")?, 0, "a command")?, "command")?;
                let index = element(variant, 0, "a command")?;
                let fields = array(element(variant, 1, "a command")?, "command")?;
                match u32::from_value(index)? {
                    0 => Ok(Self::SpawnActor(Box::new(SpawnActor::read(fields, depth)?))),
                    $($index => {
                        let mut fields = fields.iter();
                        let missing = || WireError::new(concat!("all fields of ", stringify!($name)), value);
                        Ok(Self::$name { $($field: Wire::from_value(fields.next().ok_or_else(missing)?)?,)* })
                    })*
                    _ => Err(WireError { expected: "a command that is known".to_owned(), actual: format!("number {index}") }),
                }
            }

            fn variant(&self) -> (u32, Vec<Value>) {
                match self {
                    Self::SpawnActor(spawn) => (0, spawn.fields()),
                    $(Self::$name { $($field),* } => ($index, vec![$($field.to_value()),*]),)*
                }
            }
        }
    };
}

commands! {
    /// Takes an actor away.
    DestroyActor {
        /// Whom.
        actor: u32
    } = 1;
    /// Drives a vehicle.
    ApplyVehicleControl {
        /// Whom.
        actor: u32,
        /// How.
        control: VehicleControl
    } = 2;
    /// Drives a vehicle through its controller.
    ApplyVehicleAckermannControl {
        /// Whom.
        actor: u32,
        /// How.
        control: VehicleAckermannControl
    } = 3;
    /// Makes a walker walk.
    ApplyWalkerControl {
        /// Whom.
        actor: u32,
        /// How.
        control: WalkerControl
    } = 4;
    /// Makes a vehicle of other things.
    ApplyVehiclePhysicsControl {
        /// Whom.
        actor: u32,
        /// Of what.
        physics: Box<VehiclePhysicsControl>
    } = 5;
    /// Puts an actor somewhere.
    ApplyTransform {
        /// Whom.
        actor: u32,
        /// Where.
        transform: Transform
    } = 6;
    /// Puts a walker somewhere, walking.
    ApplyWalkerState {
        /// Whom.
        actor: u32,
        /// Where.
        transform: Transform,
        /// m/s.
        speed: f32
    } = 7;
    /// Gives an actor a velocity.
    ApplyTargetVelocity {
        /// Whom.
        actor: u32,
        /// m/s.
        velocity: Vector3D
    } = 8;
    /// Makes an actor turn.
    ApplyTargetAngularVelocity {
        /// Whom.
        actor: u32,
        /// Degrees a second.
        angular_velocity: Vector3D
    } = 9;
    /// Knocks an actor.
    ApplyImpulse {
        /// Whom.
        actor: u32,
        /// N s.
        impulse: Vector3D
    } = 10;
    /// Pushes an actor for a frame.
    ApplyForce {
        /// Whom.
        actor: u32,
        /// Newtons.
        force: Vector3D
    } = 11;
    /// Knocks an actor round.
    ApplyAngularImpulse {
        /// Whom.
        actor: u32,
        /// N m s.
        impulse: Vector3D
    } = 12;
    /// Turns an actor for a frame.
    ApplyTorque {
        /// Whom.
        actor: u32,
        /// N m.
        torque: Vector3D
    } = 13;
    /// Whether an actor moves by physics.
    SetSimulatePhysics {
        /// Whom.
        actor: u32,
        /// Whether.
        enabled: bool
    } = 14;
    /// Whether an actor falls.
    SetEnableGravity {
        /// Whom.
        actor: u32,
        /// Whether.
        enabled: bool
    } = 15;
    /// Whether the traffic manager drives; the client has told it by itself.
    SetAutopilot {
        /// Whom.
        actor: u32,
        /// Whether.
        enabled: bool
    } = 16;
    /// Whether telemetry is shown.
    ShowDebugTelemetry {
        /// Whom.
        actor: u32,
        /// Whether.
        enabled: bool
    } = 17;
    /// Switches a vehicle's lights.
    SetVehicleLightState {
        /// Whom.
        actor: u32,
        /// Bits.
        lights: u32
    } = 18;
    /// Puts an actor somewhere, turned as it is.
    ApplyLocation {
        /// Whom.
        actor: u32,
        /// Where.
        location: Location
    } = 19;
    /// A line for the console of the engine.
    ConsoleCommand {
        /// The line.
        command: String
    } = 20;
    /// Switches a traffic light.
    SetTrafficLightState {
        /// Whom.
        actor: u32,
        /// 0 red, 1 yellow, 2 green, 3 off, 4 unknown.
        state: u8
    } = 21;
}

impl Command {
    /// Whom it is about: 0 stands for the actor that was spawned before it.
    pub fn actor(&self) -> Option<u32> {
        match self {
            Self::SpawnActor(_) | Self::ConsoleCommand { .. } => None,
            Self::DestroyActor { actor }
            | Self::ApplyVehicleControl { actor, .. }
            | Self::ApplyVehicleAckermannControl { actor, .. }
            | Self::ApplyWalkerControl { actor, .. }
            | Self::ApplyVehiclePhysicsControl { actor, .. }
            | Self::ApplyTransform { actor, .. }
            | Self::ApplyWalkerState { actor, .. }
            | Self::ApplyTargetVelocity { actor, .. }
            | Self::ApplyTargetAngularVelocity { actor, .. }
            | Self::ApplyImpulse { actor, .. }
            | Self::ApplyForce { actor, .. }
            | Self::ApplyAngularImpulse { actor, .. }
            | Self::ApplyTorque { actor, .. }
            | Self::SetSimulatePhysics { actor, .. }
            | Self::SetEnableGravity { actor, .. }
            | Self::SetAutopilot { actor, .. }
            | Self::ShowDebugTelemetry { actor, .. }
            | Self::SetVehicleLightState { actor, .. }
            | Self::ApplyLocation { actor, .. }
            | Self::SetTrafficLightState { actor, .. } => Some(*actor),
        }
    }
}

impl Wire for Command {
    fn to_value(&self) -> Value {
        let (index, fields) = self.variant();
        Value::Array(vec![Value::Array(vec![Value::from(index), Value::Array(fields)])])
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        Self::read(value, 0)
    }
}

#[cfg(test)]
mod tests;
