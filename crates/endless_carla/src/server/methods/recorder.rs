//! The recorder and the replayer.

use crate::recording::{LogReader, RecordingError, blocked_actors, collisions, file_info};
use crate::rpc::Answer;
use crate::server::call::{Call, CallResult, Method};
use crate::server::call_error::CallError;
use crate::server::recorder::ReplayRequest;
use crate::server::world::World;
use crate::wire::{Location, Rotation, Transform};
use std::fs::File;
use std::io::BufReader;

pub(super) const METHODS: &[(&str, Method)] = &[
    ("start_recorder", start_recorder),
    ("stop_recorder", stop_recorder),
    ("show_recorder_file_info", show_recorder_file_info),
    ("show_recorder_collisions", show_recorder_collisions),
    ("show_recorder_actors_blocked", show_recorder_actors_blocked),
    ("replay_file", replay_file),
    ("stop_replayer", stop_replayer),
    ("set_replayer_time_factor", set_replayer_time_factor),
    ("set_replayer_ignore_hero", set_replayer_ignore_hero),
    ("set_replayer_ignore_spectator", set_replayer_ignore_spectator),
];

/// Gives the path of the file.
fn start_recorder(world: &mut World, call: &Call<'_>) -> CallResult {
    let (name, tells_more): (String, bool) = (call.request.argument(0)?, call.request.optional(1)?);
    Ok(Answer::of(&world.start_recorder(&name, tells_more)?))
}

fn stop_recorder(world: &mut World, _: &Call<'_>) -> CallResult {
    world.stop_recorder();
    Ok(Answer::Void)
}

/// What is told of a recording; one that is not there or none is told of, too, as by CARLA.
fn show(
    world: &World,
    call: &Call<'_>,
    tell: impl FnOnce(&mut LogReader<BufReader<File>>) -> Result<String, RecordingError>,
) -> CallResult {
    let name: String = call.request.argument(0)?;
    let path = world.recordings.path(&name)?;
    let text = match File::open(&path) {
        Err(_) => format!("File {} not found on server\n", path.display()),
        Ok(file) => match LogReader::new(BufReader::new(file)).and_then(|mut log| tell(&mut log)) {
            Ok(text) => text,
            Err(error @ RecordingError::NoRecording) => format!("{error}\n"),
            Err(error) => return Err(CallError::refused(format!("'{name}': {error}"))),
        },
    };
    Ok(Answer::of(&text))
}

fn show_recorder_file_info(world: &mut World, call: &Call<'_>) -> CallResult {
    let all: bool = call.request.optional(1)?;
    show(world, call, |log| file_info(log, all))
}

/// The kinds come as the numbers of their letters.
fn show_recorder_collisions(world: &mut World, call: &Call<'_>) -> CallResult {
    let kind = |place| call.request.argument(place).map(|letter: u8| char::from(letter));
    let (first, second) = (kind(1)?, kind(2)?);
    show(world, call, |log| collisions(log, first, second))
}

fn show_recorder_actors_blocked(world: &mut World, call: &Call<'_>) -> CallResult {
    let (least_s, least_cm): (f64, f64) = (call.request.argument(1)?, call.request.argument(2)?);
    show(world, call, |log| blocked_actors(log, least_s, least_cm))
}

/// Clients before 0.9.16 leave the offset out.
fn replay_file(world: &mut World, call: &Call<'_>) -> CallResult {
    let behind = Transform {
        location: Location { x: -10.0, y: 0.0, z: 5.0 },
        rotation: Rotation { pitch: -25.0, yaw: 0.0, roll: 0.0 },
    };
    let request = ReplayRequest {
        name: call.request.argument(0)?,
        start_s: call.request.argument(1)?,
        duration_s: call.request.argument(2)?,
        follow: call.request.argument(3)?,
        sensors: call.request.optional(4)?,
        offset: if call.request.arguments.len() > 5 { call.request.argument(5)? } else { behind },
    };
    Ok(Answer::of(&world.replay_file(request)?))
}

fn stop_replayer(world: &mut World, call: &Call<'_>) -> CallResult {
    world.stop_replayer(call.request.optional(0)?);
    Ok(Answer::Void)
}

fn set_replayer_time_factor(world: &mut World, call: &Call<'_>) -> CallResult {
    world.recordings.set_time_factor(call.request.argument(0)?);
    Ok(Answer::Void)
}

fn set_replayer_ignore_hero(world: &mut World, call: &Call<'_>) -> CallResult {
    world.recordings.ignore_hero(call.request.argument(0)?);
    Ok(Answer::Void)
}

fn set_replayer_ignore_spectator(world: &mut World, call: &Call<'_>) -> CallResult {
    world.recordings.ignore_spectator(call.request.argument(0)?);
    Ok(Answer::Void)
}
