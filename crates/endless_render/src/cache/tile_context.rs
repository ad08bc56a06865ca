//! The state that the pixels of a tile depend on at an instant.

use super::moving_hits::MovingHits;
use super::still_pixel::StillPixel;
use super::tile_work::TileWork;
use crate::accel::Ray;
use crate::sampling::SAMPLES;
use crate::scene::FrameScene;
use crate::shade::Tracer;

/// The scene at an instant, and what of it can matter to a tile.
#[derive(Clone, Copy)]
pub(super) struct TileContext<'a> {
    /// Its moving part is `frame`.
    pub(super) tracer: &'a Tracer<'a>,
    pub(super) frame: &'a FrameScene,
    pub(super) work: &'a TileWork,
    /// Angle of a pixel, radians.
    pub(super) pixel_angle: f32,
}

/// A pixel's samples, and what their rays towards what moves found.
#[derive(Clone, Copy)]
pub(super) struct PixelSamples<'a> {
    pub(super) rays: &'a [Ray; SAMPLES],
    pub(super) still: StillPixel<'a>,
    pub(super) found: &'a MovingHits,
}
