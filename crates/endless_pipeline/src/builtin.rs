//! The built-in city: towns, traffic and the ray tracer joined.

mod actors;
mod bake_cache;
mod bake_key;
mod bodies;
mod carrier_fit;
mod helped_once;
mod hits_folder;
mod instant;
mod kept_hits;
mod key_bakes;
mod lookout;
mod map;
mod map_features;
mod moving_cameras;
mod repainted;
mod rig;
mod road_facts;
mod scene_boxes;
mod scene_frame;
mod scene_variant;
mod session;
mod shapes;
mod simulator;
mod track_fit;

pub use bake_cache::BakeCache;
pub use map::BuiltinMap;
pub use scene_boxes::SceneBoxes;
pub use simulator::BuiltinSimulator;
