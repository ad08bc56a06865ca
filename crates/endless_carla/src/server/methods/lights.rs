//! Traffic lights.

use crate::map::{LightState, LightTimes};
use crate::rpc::Answer;
use crate::server::call::{Call, Method};
use crate::server::call_error::CallError;
use crate::server::world::World;
use crate::wire::BoundingBox;

type Result = std::result::Result<Answer, CallError>;

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

fn set_traffic_light_state(world: &mut World, call: &Call<'_>) -> Result {
    let (id, state): (u32, u8) = (call.request.argument(0)?, call.request.argument(1)?);
    let light = world.episode.light(id)?;
    let state = LightState::from_number(state).ok_or_else(|| CallError::refused("a light shows 0 to 3"))?;
    world.episode.lights.set_state(light, state);
    Ok(Answer::Void)
}

fn seconds(call: &Call<'_>) -> std::result::Result<f32, CallError> {
    let seconds: f32 = call.request.argument(1)?;
    let fine = (0.0..=LONGEST_S).contains(&seconds);
    if fine { Ok(seconds) } else { Err(CallError::refused(format!("a light shows a colour for 0 to {LONGEST_S} s"))) }
}

fn set_traffic_light_green_time(world: &mut World, call: &Call<'_>) -> Result {
    let (light, green_s) = (world.episode.light(call.request.argument(0)?)?, seconds(call)?);
    let times = world.episode.lights.times(light);
    world.episode.lights.set_times(light, LightTimes { green_s, ..times });
    Ok(Answer::Void)
}

fn set_traffic_light_yellow_time(world: &mut World, call: &Call<'_>) -> Result {
    let (light, yellow_s) = (world.episode.light(call.request.argument(0)?)?, seconds(call)?);
    let times = world.episode.lights.times(light);
    world.episode.lights.set_times(light, LightTimes { yellow_s, ..times });
    Ok(Answer::Void)
}

fn set_traffic_light_red_time(world: &mut World, call: &Call<'_>) -> Result {
    let (light, red_s) = (world.episode.light(call.request.argument(0)?)?, seconds(call)?);
    let times = world.episode.lights.times(light);
    world.episode.lights.set_times(light, LightTimes { red_s, ..times });
    Ok(Answer::Void)
}

fn freeze_traffic_light(world: &mut World, call: &Call<'_>) -> Result {
    let light = world.episode.light(call.request.argument(0)?)?;
    world.episode.lights.freeze(light, call.request.argument(1)?);
    Ok(Answer::Void)
}

fn freeze_all_traffic_lights(world: &mut World, call: &Call<'_>) -> Result {
    world.episode.lights.freeze_all(call.request.argument(0)?);
    Ok(Answer::Void)
}

fn reset_traffic_light_group(world: &mut World, call: &Call<'_>) -> Result {
    let light = world.episode.light(call.request.argument(0)?)?;
    world.episode.lights.reset_group(light);
    Ok(Answer::Void)
}

fn reset_all_traffic_lights(world: &mut World, _: &Call<'_>) -> Result {
    world.episode.lights.reset_all();
    Ok(Answer::Void)
}

/// All lights of the same junction, the one itself included.
fn get_group_traffic_lights(world: &mut World, call: &Call<'_>) -> Result {
    let light = world.episode.light(call.request.argument(0)?)?;
    let group = world.episode.lights.group(light);
    Ok(Answer::of(&world.episode.light_actors(&group)))
}

/// Where vehicles stand at the light, in the world.
fn get_light_boxes(world: &mut World, call: &Call<'_>) -> Result {
    let light = world.episode.light(call.request.argument(0)?)?;
    let boxes: Vec<BoundingBox> =
        world.episode.map.roads.traffic_lights().get(light).map_or_else(Vec::new, |light| light.trigger_boxes.clone());
    Ok(Answer::of(&boxes))
}
