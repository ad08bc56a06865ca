//! What surfaces look like: procedural detail in world space, filtered by the pixel's footprint so that nothing
//! aliases, and the reflection model that lights it.

mod bsdf;
mod bsdf8;
mod building;
mod cabin;
mod evaluate;
mod ground;
pub(crate) mod noise;
mod noise8;
mod noise_batch;
mod noise_questions;
mod object;
mod packed_bsdf;
mod per_pixel;
mod pixel_group;
mod reflection8;
mod wet;
mod window;

pub(crate) use bsdf::Bsdf;
pub(crate) use bsdf8::Bsdf8;
pub use cabin::occupants;
pub(crate) use evaluate::{evaluate_bsdf, evaluate_bsdfs};
pub(crate) use packed_bsdf::PackedBsdf;
pub(crate) use reflection8::Reflection8;
