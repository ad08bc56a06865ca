//! What surfaces look like: procedural detail in world space, filtered by the pixel's footprint so that nothing
//! aliases, and the reflection model that lights it.

mod bsdf;
mod building;
mod cabin;
mod ground;
mod look;
mod look8;
pub(crate) mod noise;
mod thing;
mod wet;
mod window;

pub(crate) use look::{Look, look};
pub(crate) use look8::Look8;
