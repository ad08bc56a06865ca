use super::*;
use crate::wire::{
    ActorAttributeValue, AttributeType, GearPhysicsControl, Rotation, VehicleTelemetryData, WalkerBones,
    WheelPhysicsControl,
};
use proptest::collection::vec;
use proptest::prelude::*;

fn number() -> impl Strategy<Value = f32> {
    -1e6..1e6f32
}

fn vector() -> impl Strategy<Value = Vector3D> {
    (number(), number(), number()).prop_map(|(x, y, z)| Vector3D { x, y, z })
}

fn transform() -> impl Strategy<Value = Transform> {
    (vector(), number(), number(), number())
        .prop_map(|(location, pitch, yaw, roll)| Transform { location, rotation: Rotation { pitch, yaw, roll } })
}

fn control() -> impl Strategy<Value = VehicleControl> {
    (number(), number(), number(), any::<[bool; 3]>(), any::<i32>()).prop_map(
        |(throttle, steer, brake, flags, gear)| {
            let [hand_brake, reverse, manual_gear_shift] = flags;
            VehicleControl { throttle, steer, brake, hand_brake, reverse, manual_gear_shift, gear }
        },
    )
}

fn physics() -> impl Strategy<Value = VehiclePhysicsControl> {
    (vec(number(), 4), vec(vector(), 0..5), any::<bool>()).prop_map(|(numbers, points, flag)| VehiclePhysicsControl {
        max_rpm: numbers[0],
        mass: numbers[1],
        use_gear_autobox: flag,
        forward_gears: vec![GearPhysicsControl { ratio: numbers[2], ..GearPhysicsControl::default() }; points.len()],
        wheels: points
            .iter()
            .map(|position| WheelPhysicsControl {
                position: position.clone(),
                radius: numbers[3],
                ..Default::default()
            })
            .collect(),
        ..VehiclePhysicsControl::default()
    })
}

fn description() -> impl Strategy<Value = ActorDescription> {
    (any::<u32>(), "[a-z.]{0,12}", vec(("[a-z]{0,5}", "[a-z]{0,5}"), 0..3)).prop_map(|(uid, id, attributes)| {
        let attribute = |(id, value)| ActorAttributeValue { id, kind: AttributeType::Float, value };
        ActorDescription { uid, id, attributes: attributes.into_iter().map(attribute).collect() }
    })
}

/// Any command that does not spawn.
fn simple() -> impl Strategy<Value = Command> {
    let actor = any::<u32>;
    prop_oneof![
        actor().prop_map(|actor| Command::DestroyActor { actor }),
        (actor(), control()).prop_map(|(actor, control)| Command::ApplyVehicleControl { actor, control }),
        (actor(), vec(number(), 5)).prop_map(|(actor, n)| Command::ApplyVehicleAckermannControl {
            actor,
            control: VehicleAckermannControl {
                steer: n[0],
                steer_speed: n[1],
                speed: n[2],
                acceleration: n[3],
                jerk: n[4]
            },
        }),
        (actor(), vector(), number(), any::<bool>()).prop_map(|(actor, direction, speed, jump)| {
            Command::ApplyWalkerControl { actor, control: WalkerControl { direction, speed, jump } }
        }),
        (actor(), physics())
            .prop_map(|(actor, physics)| { Command::ApplyVehiclePhysicsControl { actor, physics: Box::new(physics) } }),
        (actor(), transform()).prop_map(|(actor, transform)| Command::ApplyTransform { actor, transform }),
        (actor(), transform(), number()).prop_map(|(actor, transform, speed)| Command::ApplyWalkerState {
            actor,
            transform,
            speed
        }),
        (actor(), vector()).prop_map(|(actor, velocity)| Command::ApplyTargetVelocity { actor, velocity }),
        (actor(), vector())
            .prop_map(|(actor, angular_velocity)| Command::ApplyTargetAngularVelocity { actor, angular_velocity }),
        (actor(), vector()).prop_map(|(actor, impulse)| Command::ApplyImpulse { actor, impulse }),
        (actor(), vector()).prop_map(|(actor, force)| Command::ApplyForce { actor, force }),
        (actor(), vector()).prop_map(|(actor, impulse)| Command::ApplyAngularImpulse { actor, impulse }),
        (actor(), vector()).prop_map(|(actor, torque)| Command::ApplyTorque { actor, torque }),
        (actor(), any::<bool>()).prop_map(|(actor, enabled)| Command::SetSimulatePhysics { actor, enabled }),
        (actor(), any::<bool>()).prop_map(|(actor, enabled)| Command::SetEnableGravity { actor, enabled }),
        (actor(), any::<bool>()).prop_map(|(actor, enabled)| Command::SetAutopilot { actor, enabled }),
        (actor(), any::<bool>()).prop_map(|(actor, enabled)| Command::ShowDebugTelemetry { actor, enabled }),
        (actor(), any::<u32>()).prop_map(|(actor, lights)| Command::SetVehicleLightState { actor, lights }),
        (actor(), vector()).prop_map(|(actor, location)| Command::ApplyLocation { actor, location }),
        "[a-z ]{0,9}".prop_map(|command| Command::ConsoleCommand { command }),
        (actor(), any::<u8>()).prop_map(|(actor, state)| Command::SetTrafficLightState { actor, state }),
    ]
}

fn command() -> impl Strategy<Value = Command> {
    simple().prop_recursive(3, 12, 3, |inner| {
        (description(), transform(), proptest::option::of(any::<u32>()), any::<u8>(), "[a-z]{0,4}", vec(inner, 0..3))
            .prop_map(|(description, transform, parent, attachment, socket, do_after)| {
                let spawn = SpawnActor { description, transform, parent, attachment, socket, do_after };
                Command::SpawnActor(Box::new(spawn))
            })
    })
}

/// Any msgpack value, some of them shaped a little like commands.
fn value() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Nil),
        any::<bool>().prop_map(Value::from),
        (0..24i64).prop_map(Value::from),
        any::<i64>().prop_map(Value::from),
        any::<u64>().prop_map(Value::from),
        any::<f32>().prop_map(Value::from),
        any::<f64>().prop_map(Value::from),
        "[a-z]{0,6}".prop_map(Value::from),
        vec(any::<u8>(), 0..6).prop_map(Value::from),
    ];
    leaf.prop_recursive(6, 64, 8, |inner| {
        prop_oneof![
            vec(inner.clone(), 0..8).prop_map(Value::Array),
            (0..24u32, vec(inner.clone(), 0..8)).prop_map(|(index, fields)| {
                Value::Array(vec![Value::Array(vec![Value::from(index), Value::Array(fields)])])
            }),
            vec((inner.clone(), inner), 0..3).prop_map(Value::Map),
        ]
    })
}

proptest! {
    #[test]
    fn commands_come_back_as_they_went(command in command()) {
        prop_assert_eq!(Command::from_value(&command.to_value()), Ok(command));
    }

    #[test]
    fn no_value_makes_us_panic(value in value()) {
        let _ = Command::from_value(&value);
        let _ = VehicleControl::from_value(&value);
        let _ = VehiclePhysicsControl::from_value(&value);
        let _ = VehicleTelemetryData::from_value(&value);
        let _ = WalkerBones::from_value(&value);
    }
}

fn spawn_of(fields: Vec<Value>) -> Result<Command, WireError> {
    Command::from_value(&Value::Array(vec![Value::Array(vec![Value::from(0), Value::Array(fields)])]))
}

#[test]
fn spawning_is_understood_in_both_versions_whatever_the_attachment() {
    let inner = Command::SetAutopilot { actor: 0, enabled: true };
    let spawn = SpawnActor { parent: Some(3), do_after: vec![inner.clone()], ..SpawnActor::default() };
    let fields = spawn.fields();

    let old = vec![fields[0].clone(), fields[1].clone(), fields[2].clone(), fields[5].clone()];
    assert_eq!(spawn_of(old), Ok(Command::SpawnActor(Box::new(spawn.clone()))));

    for attachment in [Value::from(160), Value::from(-7), Value::from(1u64 << 40), Value::Nil] {
        let mut new = fields.clone();
        new[3] = attachment;
        let Ok(Command::SpawnActor(read)) = spawn_of(new) else { panic!("not read") };
        assert_eq!((read.parent, read.do_after.as_slice()), (Some(3), [inner.clone()].as_slice()));
    }
}

#[test]
fn spawns_within_spawns_end_somewhere() {
    let mut command = Command::DestroyActor { actor: 1 };
    for _ in 0..DEEPEST {
        command = Command::SpawnActor(Box::new(SpawnActor { do_after: vec![command], ..SpawnActor::default() }));
    }
    assert!(Command::from_value(&command.to_value()).is_ok());
    command = Command::SpawnActor(Box::new(SpawnActor { do_after: vec![command], ..SpawnActor::default() }));
    assert!(Command::from_value(&command.to_value()).is_err());
}

#[test]
fn commands_that_are_not_known_are_errors() {
    let variant = |index: u32| Value::Array(vec![Value::Array(vec![Value::from(index), Value::Array(vec![])])]);
    assert!(Command::from_value(&variant(22)).is_err());
    assert!(Command::from_value(&variant(1)).is_err());
}

#[test]
fn a_control_with_a_timestamp_is_still_a_control() {
    let mut value = VehicleControl { throttle: 0.5, gear: 2, ..VehicleControl::default() }.to_value();
    if let Value::Array(fields) = &mut value {
        fields.push(Value::from(12.5));
    }
    assert_eq!(VehicleControl::from_value(&value).map(|control| control.gear), Ok(2));
}
