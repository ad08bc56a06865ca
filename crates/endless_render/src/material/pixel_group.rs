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

impl<'a, 'b> EightPixels<'a, 'b> {
    /// Those wanted of eight pixels, each with its width on the surface, metres; the first of them stands in for the
    /// others. `None` where none is wanted.
    pub(super) fn of(
        points: &[Option<&'a SurfaceInteraction<'b>>; 8],
        footprints_m: &[f32; 8],
        wanted: &[bool; 8],
    ) -> Option<Self> {
        let first = wanted.iter().position(|wanted| *wanted)?;
        let first_point = points[first]?;
        let own = |i: usize| if wanted[i] { i } else { first };
        Some(Self {
            points: std::array::from_fn(|i| points[own(i)].unwrap_or(first_point)),
            footprints_m: f32x8::new(std::array::from_fn(|i| footprints_m[own(i)])),
        })
    }
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
