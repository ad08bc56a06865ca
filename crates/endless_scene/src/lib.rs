//! The parts of a scene as plain data: triangle meshes, materials, street lamps.
//!
//! A [`Mesh`] has a table of [`Material`]s and names one for each triangle. A material names what the surface is made of
//! ([`Surface`]), its colour and its semantic class; the renderer gives it a BSDF. A [`MeshBuilder`] makes meshes face by
//! face.
//!
//! ```
//! use endless_scene::{Material, MeshBuilder, Surface};
//! use endless_world::ClassTag;
//! use glam::Vec3;
//!
//! let concrete = Material::new(Surface::Concrete, [0.5, 0.5, 0.48], ClassTag::Static);
//! let mut builder = MeshBuilder::new();
//! builder.cuboid(Vec3::new(-0.5, -0.5, 0.0), Vec3::new(0.5, 0.5, 1.0), concrete);
//! let block = builder.finish();
//! assert_eq!(block.triangles.len(), 12);
//! assert_eq!(block.materials, [concrete]);
//! ```

mod material;
mod mesh;
mod street_lamp;

pub use material::{LensAspect, LightSlot, Material, Surface};
pub use mesh::{Mesh, MeshBuilder};
pub use street_lamp::StreetLamp;
