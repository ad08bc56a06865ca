//! Light that arrives by way of other surfaces, computed once a scene: probes in the air for what moves, and a
//! gathered, denoised irradiance for every sample of the still picture.

mod denoise;
mod gather;
mod harmonics;
mod probes;

pub(crate) use denoise::{Guide, denoise};
pub(crate) use gather::{PATTERN_SIDE, gather8, turn};
pub(crate) use probes::{Air, ProbeGrid};
