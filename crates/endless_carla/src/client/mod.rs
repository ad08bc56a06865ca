//! A client of CARLA servers: makes a dataset of what a server simulates and renders, as the paper's section 4.3 does.
//!
//! ```text
//!  endless generate            server                    its map, actors, sensors
//!      │  load map, weather ──────►│
//!      │  spawn in batches ───────►│       cast
//!      │  poses of our traffic ───►│       driver   (or a TrafficManager drives)
//!      │  tick ───────────────────►│
//!      │◄──── snapshot, 3 pictures a camera         all of one frame, or it is asked for again
//!      ▼
//!  world state, sensor frames      instances: whose pixels these are
//! ```

mod address;
mod body;
mod boxes;
mod camera;
mod cast;
mod connection;
mod driver;
mod error;
mod fleet;
mod instances;
mod lights;
mod map;
mod patience;
mod payload;
mod picture;
mod server;
mod session;
mod simulator;
mod sites;
mod still;
mod subscription;
mod task;
mod traffic_manager;
mod weather;
mod world;

pub use address::Address;
pub use map::CarlaMap;
pub use patience::StopFlag;
pub use server::CarlaSettings;
pub use simulator::CarlaSimulator;
