//! From radiance to pixels: exposure, tone curve, glare, rain in front of the lens, motion
//! blur; what lens, sensor and recorder do.

mod defocus;
mod droplets;
mod exposure;
mod finish;
mod glare;
mod mix;
mod motion_blur;
mod rain;
mod sensor_noise;
mod smudges;
mod timestamp;
mod tone;

pub(crate) use exposure::{Exposure, black_level, exposure};
pub(crate) use finish::PostProcess;
pub(crate) use glare::with_glare;
pub(crate) use mix::{mix_rgb, mix_values};
pub(crate) use motion_blur::{BlurScratch, LEAST_PX, LONGEST_PX, Streak, blur};
pub(crate) use rain::Rain;
pub(crate) use tone::{ToneCurve, srgb};
