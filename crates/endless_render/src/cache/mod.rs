//! The fixed-camera cache: the still town is shaded once a video, and a frame retraces only what can have changed.
//!
//! A frame is defined without the cache: every sample of every pixel is the light of a still surface, as the moving
//! world shades, mirrors and lights it now, or the light of a moving surface in front of it
//! ([`CameraBake::render_uncached`]). The cache only leaves out work whose result is known: per tile of pixels it asks
//! which moving objects could touch it (by being seen, by shadow, by contact, in a mirror, by their lights), always
//! erring towards more, and copies the rest. A test proves that both give the same bytes.

mod affected;
mod bake;
mod beam_box;
mod canvas;
mod centre;
mod compose;
mod contact;
mod cover;
mod covers;
mod frame;
mod mirror;
mod row;
mod spare;
mod still_pixel;
mod still_sample;
mod sweep;
#[cfg(test)]
mod tests;
mod tile;

pub use bake::{BakeStats, CameraBake, RenderSettings};
