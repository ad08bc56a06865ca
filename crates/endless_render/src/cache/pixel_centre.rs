//! The centre of a pixel, at which light is found that its samples share.

use crate::material::PackedBsdf;
use crate::scene::ShadingPoint;

/// Pixels whose light is found together: four rows of eight.
pub(super) const BLOCK: usize = 32;
/// Their centres; `None` where a pixel has no light of its own.
pub(super) type CentreBlock<'a> = [Option<PixelCentre<'a>>; BLOCK];

/// A pixel's centre in a row.
#[derive(Clone, Copy)]
pub(super) struct PixelCentre<'a> {
    pub(super) facet: ShadingPoint,
    /// At night.
    pub(super) bsdf: Option<&'a PackedBsdf>,
    pub(super) lamps_free: u32,
}
