//! The server: our city behind CARLA's protocol.
//!
//! ```text
//! clients ── rpc::listen ──► Engine ── methods ──► World ──► Episode: actors, time, weather, lights
//!                              │ once a frame
//!                              ├──► sensing: cameras, LiDARs and all others measure the city
//!                              └──► StreamHub ──► sessions: what sensors measure, then the snapshot
//! ```
//! One thread owns the world. In synchronous mode it moves on when a client says so, else with the clock.

mod actor;
mod call;
mod call_error;
mod drawn_boxes;
mod engine;
mod episode;
mod error;
mod friction;
mod given_map;
mod gripping;
mod hanging;
mod lamps;
mod loaded_map;
mod map_layer;
mod map_objects;
mod methods;
mod moving;
mod obstacles;
mod quality_level;
mod recorder;
mod scenery;
mod sensing;
mod sensor_model;
mod settings;
mod signals;
mod spawn;
mod spring_arm;
mod vehicle_actor;
mod version;
mod walker_actor;
mod walker_bones;
mod weather;
mod world;

use crate::rpc::listen;
use crate::stream::{StreamHub, listen_for_sessions};
use endless_interchange::MapLibrary;
use engine::Engine;
use loaded_map::MapShelf;
use recorder::Recordings;
use std::net::{SocketAddr, TcpListener};
use std::sync::Arc;
use std::sync::mpsc::sync_channel;
use std::thread;
use world::World;

pub use error::ServerError;
pub use quality_level::QualityLevel;
pub use settings::ServerSettings;
pub use version::VERSION;

/// Requests that wait.
const QUEUE: usize = 4096;

/// A server that has its ports and its first map.
pub struct Server {
    engine: Engine,
    address: SocketAddr,
}

impl Server {
    /// Loads the map, and opens the ports when all is ready.
    ///
    /// # Errors
    /// When a port cannot be had or the map cannot be loaded.
    pub fn bind(settings: &ServerSettings, library: MapLibrary) -> Result<Self, ServerError> {
        let open = |port: u16| {
            let address = SocketAddr::new(settings.bind, port);
            TcpListener::bind(address).map_err(|source| ServerError::Listen { address, source })
        };
        let both = || {
            let rpc = open(settings.port)?;
            let next = if settings.port == 0 { 0 } else { settings.port.saturating_add(1) };
            Ok::<_, ServerError>((rpc, open(next)?))
        };
        // Ports in use are told of at once, and then closed again: who connects before the map is there would wait, and many
        // scripts wait two seconds only.
        drop(both()?);
        let hub = Arc::new(StreamHub::default());
        let (sender, events) = sync_channel(QUEUE);
        let mut world = World::new(settings, MapShelf::new(library), Arc::clone(&hub))?;
        world.recordings = Recordings::new(settings.recordings.clone());
        let (rpc, streams) = both()?;
        let address = rpc.local_addr().map_err(ServerError::Thread)?;
        world.stream_port = streams.local_addr().map_err(ServerError::Thread)?.port();
        let standing = Arc::clone(&world.standing);
        let engine = Engine::new(world, events);
        let spawn = |name: &str, work: Box<dyn FnOnce() + Send>| {
            thread::Builder::new().name(name.to_owned()).spawn(work).map(drop).map_err(ServerError::Thread)
        };
        spawn("rpc", Box::new(move || listen(&rpc, &sender, &standing)))?;
        spawn("streams", Box::new(move || listen_for_sessions(&streams, &hub)))?;
        Ok(Self { engine, address })
    }

    /// Where it listens for requests.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Serves for ever.
    pub fn run(self) {
        self.engine.run();
    }
}
