//! The ray tracer: what a camera sees of a town, traced on the CPU.
//!
//! [`Blas`] and [`Accel`] answer which triangle a ray meets first, or whether it meets any.

mod accel;

pub use accel::{Accel, Blas, Hit, Ray};
