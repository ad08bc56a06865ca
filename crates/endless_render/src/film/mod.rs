//! From radiance to pixels: exposure, tone curve, glare, rain in front of the lens.

mod exposure;
mod glare;
mod rain;
mod tone;

pub(crate) use exposure::exposure;
pub(crate) use glare::with_glare;
pub(crate) use rain::Rain;
pub(crate) use tone::ToneCurve;
