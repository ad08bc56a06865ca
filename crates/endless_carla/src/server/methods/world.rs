//! Episodes, settings and time.

use crate::rpc::Answer;
use crate::server::call::{Call, CallResult, Method};
use crate::server::call_error::CallError;
use crate::server::world::World;
use crate::wire::{EpisodeInfo, EpisodeSettings, OpendriveGenerationParameters};

pub(super) const METHODS: &[(&str, Method)] = &[
    ("get_episode_info", get_episode_info),
    ("set_episode_settings", set_episode_settings),
    ("tick_cue", tick_cue),
    ("load_new_episode", load_new_episode),
    ("copy_opendrive_to_file", copy_opendrive_to_file),
];

fn get_episode_info(world: &mut World, _: &Call<'_>) -> CallResult {
    let token = world.token(world.episode.stream());
    Ok(Answer::of(&EpisodeInfo { id: world.episode.id, token: vec![token] }))
}

/// Gives the current frame: clients wait for the snapshot of the frame that they are told.
fn set_episode_settings(world: &mut World, call: &Call<'_>) -> CallResult {
    /// The longest step that physics can follow, seconds.
    const LONGEST_S: f64 = 10.0;
    let settings: EpisodeSettings = call.request.argument(0)?;
    if let Some(step_s) = settings.fixed_delta_seconds
        && !(0.0..=LONGEST_S).contains(&step_s)
    {
        return Err(CallError::refused(format!("fixed_delta_seconds must be from 0 to {LONGEST_S}, not {step_s}")));
    }
    world.set_settings(settings);
    Ok(Answer::of(&world.episode.frame))
}

fn tick_cue(world: &mut World, call: &Call<'_>) -> CallResult {
    Ok(Answer::of(&world.tick(call.caller.id)))
}

fn load_new_episode(world: &mut World, call: &Call<'_>) -> CallResult {
    let (map, reset_settings, layers): (String, bool, u16) =
        (call.request.argument(0)?, call.request.argument(1)?, call.request.argument(2)?);
    world.load(&map, reset_settings, layers)?;
    Ok(Answer::Void)
}

/// Takes an OpenDRIVE text, to be loaded as the map `OpenDriveMap`. Of the parameters only that on pedestrians has a meaning:
/// roads end and are as smooth here as they are in our own towns.
fn copy_opendrive_to_file(world: &mut World, call: &Call<'_>) -> CallResult {
    let text: String = call.request.argument(0)?;
    let parameters: OpendriveGenerationParameters = call.request.optional(1)?;
    world.shelf.give(&text, parameters.enable_pedestrian_navigation)?;
    Ok(Answer::Void)
}
