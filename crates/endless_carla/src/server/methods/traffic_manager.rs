//! Where traffic managers run: in clients, who tell each other through the server.

use crate::rpc::Answer;
use crate::server::call::{Call, CallResult, Method};
use crate::server::world::World;

pub(super) const METHODS: &[(&str, Method)] = &[
    ("is_traffic_manager_running", is_traffic_manager_running),
    ("get_traffic_manager_running", get_traffic_manager_running),
    ("add_traffic_manager_running", add_traffic_manager_running),
    ("destroy_traffic_manager", destroy_traffic_manager),
];

fn is_traffic_manager_running(world: &mut World, call: &Call<'_>) -> CallResult {
    let port: u16 = call.request.argument(0)?;
    Ok(Answer::of(&world.traffic_managers.contains_key(&port)))
}

/// Its host and port; `("", 0)` if there is none.
fn get_traffic_manager_running(world: &mut World, call: &Call<'_>) -> CallResult {
    let port: u16 = call.request.argument(0)?;
    let found = world.traffic_managers.get(&port).map_or((String::new(), 0), |host| (host.clone(), port));
    Ok(Answer::of(&found))
}

/// Gives whether the port was free.
fn add_traffic_manager_running(world: &mut World, call: &Call<'_>) -> CallResult {
    let (host, port): (String, u16) = call.request.argument(0)?;
    let is_free = !world.traffic_managers.contains_key(&port);
    if is_free {
        world.traffic_managers.insert(port, host);
    }
    Ok(Answer::of(&is_free))
}

fn destroy_traffic_manager(world: &mut World, call: &Call<'_>) -> CallResult {
    let port: u16 = call.request.argument(0)?;
    world.traffic_managers.remove(&port);
    Ok(Answer::Void)
}
