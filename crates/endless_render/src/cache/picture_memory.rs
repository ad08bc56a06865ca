//! The memory of a picture of a camera that moves, handed on to its next picture: fresh memory costs a fault a page.

use super::gbuffer_row::GBufferRow;
use crate::sampling::SAMPLES;
use glam::Vec3A;

/// Large arrays of a picture, whatever they hold: all of it is written anew. Empty at first.
#[derive(Default)]
pub(crate) struct PictureMemory {
    pub(super) distances: Vec<[f32; SAMPLES]>,
    pub(super) sun_free: Vec<[u8; SAMPLES]>,
    pub(super) uniform: Vec<bool>,
    pub(super) radiance: Vec<Vec3A>,
    pub(super) rows: Vec<GBufferRow>,
}

impl PictureMemory {
    /// For a picture of so many pixels and rows.
    pub(super) fn resized(mut self, pixels: usize, rows: usize) -> Self {
        self.distances.resize(pixels, [f32::MAX; SAMPLES]);
        self.sun_free.resize(pixels, [0; SAMPLES]);
        self.uniform.resize(pixels, false);
        self.radiance.resize(pixels, Vec3A::ZERO);
        self.rows.resize_with(rows, GBufferRow::default);
        self
    }
}
