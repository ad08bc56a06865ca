//! The centre of a pixel, at which light is found that its samples share.

use crate::material::PackedBsdf;
use crate::scene::ShadingPoint;

/// A pixel's centre in a row.
#[derive(Clone, Copy)]
pub(super) struct PixelCentre<'a> {
    pub(super) facet: ShadingPoint,
    /// At night.
    pub(super) bsdf: Option<&'a PackedBsdf>,
    pub(super) lamps_free: u32,
}
