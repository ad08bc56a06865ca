//! Light that arrives by way of other surfaces, computed once a scene: probes in the air for what moves, and a
//! gathered, denoised irradiance for every sample of the still picture.

mod denoise;
mod gather;
mod harmonics;
mod hit_tape;
mod indirect_hits;
mod probe_bake;
mod probe_grid;
mod probe_map;

pub(crate) use denoise::{DenoiseGuide, KERNEL, denoise, surface_weight};
pub(crate) use gather::{GatherPoint, PATTERN_SIDE, gather8, turn};
pub(crate) use hit_tape::{HitTape, RayEnd};
pub use indirect_hits::IndirectHits;
pub(crate) use indirect_hits::{IndirectRays, PROBE_BOUNCES, TapeStack};
pub(crate) use probe_grid::{ProbeGrid, ProbeRegion};
pub(crate) use probe_map::{Cell, ProbeMap};
