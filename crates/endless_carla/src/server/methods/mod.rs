//! The methods of the protocol, by what they are about.

mod actors;
mod batch;
mod bones;
mod controls;
mod environment;
mod lights;
mod map;
mod rays;
mod recorder;
mod sensors;
mod traffic_manager;
mod world;

use super::call::Method;
use std::collections::BTreeMap;

/// All that are supported, by name.
pub(super) fn all() -> BTreeMap<&'static str, Method> {
    [
        world::METHODS,
        map::METHODS,
        rays::METHODS,
        recorder::METHODS,
        actors::METHODS,
        batch::METHODS,
        bones::METHODS,
        controls::METHODS,
        environment::METHODS,
        lights::METHODS,
        sensors::METHODS,
        traffic_manager::METHODS,
    ]
    .into_iter()
    .flatten()
    .copied()
    .collect()
}
