//! Ray tracing: the first triangle of many placed meshes that a ray hits, or whether it hits any.
//!
//! Two levels: a [`Blas`] per mesh, shared by its instances, and a [`Tlas`] over the instances. Both are trees of
//! eight-wide nodes (`node`), built as binary trees by `obvhs` and collapsed by `collapse`.
//!
//! ```text
//! Tlas ── BvhNode ─┬─ TlasEntry ── object_from_world ── Blas ── BvhNode ─┬─ TriangleGroup ×n
//!                  └─ BvhNode …                                          └─ BvhNode …
//! ```
//!
//! The hit of a ray is a function of the geometry alone: neither the shape of the trees, nor refitting, nor tracing
//! rays in packets changes a bit of it. `triangle` and `ray` say why.

mod blas;
#[cfg(test)]
mod brute;
mod collapse;
mod leaf_triangles;
mod node;
mod octants;
mod packet;
mod packet_ray;
mod packet_traversal;
mod ray;
mod single;
mod stack;
mod stream;
#[cfg(test)]
mod tests;
mod tlas;
mod triangle;

pub use blas::Blas;
pub(crate) use blas::GeometryUse;
pub(crate) use node::corners;
pub use ray::{Hit, Ray};
pub use stream::{RayStream, StreamHits};
pub(crate) use stream::{first_lanes, lane_mask, lanes};
pub use tlas::Tlas;
pub(crate) use tlas::world_bounds;
