//! What a server tells of a town, so that the code that CARLA has in its client works on it: places to spawn, traffic
//! lights and signs, speed limits, and the mesh on which pedestrians find their way. Its roads are an OpenDRIVE file.

mod carla_map;
mod georeference;
mod ground;
mod lane_index;
mod light_cycle;
mod light_plan;
mod navmesh;
mod signals;
mod spawn;
mod speed_limits;
mod surface;

pub use carla_map::CarlaMap;
pub use light_cycle::{LightCycle, LightState, LightTimes};
pub use navmesh::NavigationMesh;
pub use signals::{SignKind, TrafficLight, TrafficSign};
