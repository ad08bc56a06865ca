//! Traffic lights.

use crate::map::LightTimes;
use crate::rpc::Answer;
use crate::server::call::{Call, CallResult, Method};
use crate::server::call_error::CallError;
use crate::server::world::World;
use crate::wire::BoundingBox;

pub(super) const METHODS: &[(&str, Method)] = &[
    ("set_traffic_light_state", set_traffic_light_state),
    ("set_traffic_light_green_time", set_traffic_light_green_time),
    ("set_traffic_light_yellow_time", set_traffic_light_yellow_time),
    ("set_traffic_light_red_time", set_traffic_light_red_time),
    ("freeze_traffic_light", freeze_traffic_light),
    ("freeze_all_traffic_lights", freeze_all_traffic_lights),
    ("reset_traffic_light_group", reset_traffic_light_group),
    ("reset_all_traffic_lights", reset_all_traffic_lights),
    ("get_group_traffic_lights", get_group_traffic_lights),
    ("get_light_boxes", get_light_boxes),
];

/// Longest time that a light may be told to show a colour, seconds.
const LONGEST_S: f32 = 86_400.0;

fn set_traffic_light_state(world: &mut World, call: &Call<'_>) -> CallResult {
    world.episode.set_light_state(call.request.argument(0)?, call.request.argument(1)?)?;
    Ok(Answer::Void)
}

/// How long a light shows a colour.
fn set_time(world: &mut World, call: &Call<'_>, of: fn(&mut LightTimes) -> &mut f32) -> CallResult {
    let light = world.episode.light(call.request.argument(0)?)?;
    let seconds: f32 = call.request.argument(1)?;
    if !(0.0..=LONGEST_S).contains(&seconds) {
        return Err(CallError::refused(format!("a light shows a colour for 0 to {LONGEST_S} s")));
    }
    let mut times = world.episode.lights.times(light);
    *of(&mut times) = seconds;
    world.episode.lights.set_times(light, times);
    Ok(Answer::Void)
}

fn set_traffic_light_green_time(world: &mut World, call: &Call<'_>) -> CallResult {
    set_time(world, call, |times| &mut times.green_s)
}

fn set_traffic_light_yellow_time(world: &mut World, call: &Call<'_>) -> CallResult {
    set_time(world, call, |times| &mut times.yellow_s)
}

fn set_traffic_light_red_time(world: &mut World, call: &Call<'_>) -> CallResult {
    set_time(world, call, |times| &mut times.red_s)
}

fn freeze_traffic_light(world: &mut World, call: &Call<'_>) -> CallResult {
    let light = world.episode.light(call.request.argument(0)?)?;
    world.episode.lights.freeze(light, call.request.argument(1)?);
    Ok(Answer::Void)
}

fn freeze_all_traffic_lights(world: &mut World, call: &Call<'_>) -> CallResult {
    world.episode.lights.freeze_all(call.request.argument(0)?);
    Ok(Answer::Void)
}

fn reset_traffic_light_group(world: &mut World, call: &Call<'_>) -> CallResult {
    let light = world.episode.light(call.request.argument(0)?)?;
    world.episode.lights.reset_group(light);
    Ok(Answer::Void)
}

fn reset_all_traffic_lights(world: &mut World, _: &Call<'_>) -> CallResult {
    world.episode.lights.reset_all();
    Ok(Answer::Void)
}

/// All lights of the same junction, the one itself included.
fn get_group_traffic_lights(world: &mut World, call: &Call<'_>) -> CallResult {
    let light = world.episode.light(call.request.argument(0)?)?;
    let group = world.episode.lights.group(light);
    let actors: Vec<u32> = group.iter().filter_map(|&light| world.episode.light_ids.get(light).copied()).collect();
    Ok(Answer::of(&actors))
}

/// Where vehicles stand at the light, in the world.
fn get_light_boxes(world: &mut World, call: &Call<'_>) -> CallResult {
    let light = world.episode.light(call.request.argument(0)?)?;
    let boxes: Vec<BoundingBox> =
        world.episode.map.roads.traffic_lights().get(light).map_or_else(Vec::new, |light| light.trigger_boxes.clone());
    Ok(Answer::of(&boxes))
}
