//! The ray tracer: what a fixed surveillance camera sees of a town, fast and exact on a CPU.
//!
//! ```text
//! Town ─ StaticScene ──────────┐
//! CameraSite, RenderSettings ──┴─ CameraBake ──┐
//! WorldState, Cast ──────────────── FrameScene ┴─ render → SensorFrame
//! ```
//! A [`StaticScene`] is loaded once a map, a [`CameraBake`] made once a camera and scene (it holds the fixed-camera
//! cache), a [`FrameScene`] once a frame. Rendering is a pure function of the three: call it from as many threads as
//! there are frames to make.
//!
//! Rooms: `accel` finds what rays meet; `scene` holds what there is; `light` and `material` give it its look; `shade`
//! puts them together; `indirect` and `cache` remember what does not change; `film` makes pixels of light.

mod accel;
mod cache;
mod eight;
mod film;
mod indirect;
mod light;
mod material;
mod octahedron;
mod sampling;
mod scene;
mod shade;

pub use accel::{Accel, Blas, Hit, Hits, Ray, RayBundle};
pub use cache::{BakeStats, CameraBake, RenderSettings};
pub use scene::{Cast, FrameScene, StaticScene};
