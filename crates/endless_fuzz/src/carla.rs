//! Requests of CARLA's clients: values, requests and commands, or an error of one line.

use crate::mutate;
use crate::target::{FuzzTarget, one_line};
use endless_carla::rpc::{Request, read_value};
use endless_carla::wire::{
    ActorDescription, Command, EpisodeSettings, Transform, VehicleControl, VehiclePhysicsControl, WeatherParameters,
    Wire,
};
use rmpv::Value;

/// What a client sends to a server, one request after the other.
pub const CARLA: FuzzTarget = FuzzTarget { name: "carla", judge: requests, mutate: mutate::binary };

fn requests(mut bytes: &[u8]) -> Result<(), String> {
    loop {
        let message = match read_value(&mut bytes) {
            Ok(message) => message,
            Err(error) if error.is_end() => return Ok(()),
            Err(error) => return one_line(&error),
        };
        match Request::from_message(&message) {
            Ok(request) => request.arguments.iter().try_for_each(argument)?,
            Err(error) => one_line(&error)?,
        }
    }
}

/// Whatever it is meant to be.
fn argument(value: &Value) -> Result<(), String> {
    for command in value.as_array().into_iter().flatten() {
        read::<Command>(command)?;
    }
    read::<ActorDescription>(value)?;
    read::<EpisodeSettings>(value)?;
    read::<Transform>(value)?;
    read::<VehicleControl>(value)?;
    read::<VehiclePhysicsControl>(value)?;
    read::<WeatherParameters>(value)
}

/// What is read says the same when it is written and read again.
fn read<T: Wire>(value: &Value) -> Result<(), String> {
    match T::from_value(value) {
        Ok(own) => {
            let written = own.to_value();
            let again = T::from_value(&written).map_err(|error| format!("as written: {error}"))?.to_value();
            // NaN is unlike itself, but looks the same.
            let same = format!("{written:?}") == format!("{again:?}");
            if same { Ok(()) } else { Err(format!("other as written: {written} and {again}")) }
        }
        Err(error) => one_line(&error),
    }
}
