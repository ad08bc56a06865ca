//! The scene: its static part, its moving part at one instant, and hits of rays on both.

mod ambient_occlusion;
mod deformable_mesh;
mod deformation;
mod frame_scene;
mod geometry;
mod hit_normals;
mod instance;
mod moving_object;
mod posed_mesh;
mod static_scene;
mod surface_interaction;
mod surface_query;
mod triangle_normals;
mod triangle_points;
mod velocity;

pub use deformable_mesh::DeformableMesh;
pub use deformation::Deformation;
pub use frame_scene::{FrameDescription, FrameScene};
pub use geometry::Geometry;
pub(crate) use hit_normals::normals_of_hits;
pub use instance::Instance;
pub(crate) use moving_object::MovingVolume;
pub use moving_object::{Footprint, MovingObject};
pub use static_scene::StaticScene;
pub(crate) use surface_interaction::{ShadingPoint, SurfaceInteraction, ray_origins8};
pub use surface_query::SurfacePoint;
pub(crate) use triangle_normals::{Normals8, TriangleNormals};
pub(crate) use triangle_points::TriangleHits;
pub use velocity::RigidVelocity;
