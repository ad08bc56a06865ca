//! One pixel, or eight side by side, that see the same kind of surface.

use super::per_pixel::PerPixel;
use crate::scene::SurfaceInteraction;
use wide::f32x8;

/// Pixels that see the same kind of surface, and the numbers that its pattern is made of.
pub(super) trait PixelGroup {
    type Number: PerPixel;

    /// A number of what each pixel sees.
    fn each(&self, of: impl Fn(&SurfaceInteraction<'_>) -> f32) -> Self::Number;

    /// The width of each pixel on the surface, metres.
    fn footprint_m(&self) -> Self::Number;

    /// Where each lies on the map, metres.
    #[inline]
    fn plan(&self) -> [Self::Number; 2] {
        [self.each(|point| point.position.x), self.each(|point| point.position.y)]
    }

    /// Texture coordinates of each.
    #[inline]
    fn uv(&self) -> [Self::Number; 2] {
        [self.each(|point| point.uv.x), self.each(|point| point.uv.y)]
    }
}

/// One pixel.
pub(super) struct OnePixel<'a, 'b> {
    pub(super) point: &'a SurfaceInteraction<'b>,
    pub(super) footprint_m: f32,
}

/// Eight pixels side by side.
pub(super) struct EightPixels<'a, 'b> {
    pub(super) points: [&'a SurfaceInteraction<'b>; 8],
    pub(super) footprints_m: f32x8,
}

impl PixelGroup for OnePixel<'_, '_> {
    type Number = f32;

    #[inline]
    fn each(&self, of: impl Fn(&SurfaceInteraction<'_>) -> f32) -> f32 {
        of(self.point)
    }

    #[inline]
    fn footprint_m(&self) -> f32 {
        self.footprint_m
    }
}

impl PixelGroup for EightPixels<'_, '_> {
    type Number = f32x8;

    #[inline]
    fn each(&self, of: impl Fn(&SurfaceInteraction<'_>) -> f32) -> f32x8 {
        f32x8::new(self.points.map(of))
    }

    #[inline]
    fn footprint_m(&self) -> f32x8 {
        self.footprints_m
    }
}
