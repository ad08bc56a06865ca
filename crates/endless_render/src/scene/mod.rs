//! What there is to see: the still town, the cast that moves in it, and both at one instant.

mod ambient_occlusion;
mod cast;
mod frame_scene;
mod model;
mod static_scene;
mod surface_point;
mod velocity;

pub use cast::Cast;
pub use frame_scene::FrameScene;
pub(crate) use frame_scene::MovingObject;
pub(crate) use model::{Body, Instance, Shape};
pub use static_scene::StaticScene;
pub(crate) use surface_point::{Facet, SurfacePoint};
pub(crate) use velocity::Velocity;
