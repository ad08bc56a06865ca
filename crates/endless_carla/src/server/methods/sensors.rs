//! Where streams are.

use crate::rpc::Answer;
use crate::server::call::{Call, CallResult, Method};
use crate::server::world::World;
use crate::wire::Bytes;

pub(super) const METHODS: &[(&str, Method)] = &[("get_sensor_token", get_sensor_token)];

/// The client is about to connect: the next tick waits a little for it.
fn get_sensor_token(world: &mut World, call: &Call<'_>) -> CallResult {
    let stream: u32 = call.request.argument(0)?;
    world.hub.expect(stream);
    let token: Vec<Bytes> = vec![world.token(stream)];
    Ok(Answer::of(&token))
}
