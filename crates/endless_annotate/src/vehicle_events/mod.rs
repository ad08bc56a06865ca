//! What happens to one vehicle: sensors that it carries, under CARLA's names for them.

mod body_size;
mod collision;
mod lane_invasion;
mod mark_grid;

pub use body_size::BodySize;
pub use collision::{CollisionEvent, CollisionSensor};
pub use lane_invasion::{LaneInvasionEvent, LaneInvasionSensor};
