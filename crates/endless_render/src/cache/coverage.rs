//! What moves in front of a pixel, and which of its samples must be shaded to tell the pixel's colour.

use super::bake::CameraBake;
use super::gbuffer_shading::gbuffer_bsdf;
use super::moving_hits::MovingHits;
use crate::accel::{Hit, Ray};
use crate::pixel_layers::PixelLayers;
use crate::sampling::SAMPLES;
use crate::scene::{FrameScene, SurfaceInteraction};
use crate::shade::MovingSample;
use endless_scene::Surface;
use glam::{Vec2, Vec3A};
use std::ops::Range;

/// What moves and covers a pixel's centre.
#[derive(Debug, Clone, Copy)]
pub(super) struct CoveredCentre {
    /// What it shows.
    pub(super) layers: PixelLayers,
    /// Where the ray met it.
    pub(super) hit: Hit,
    /// From there to the sun, if shadows are wanted and it does not face away.
    pub(super) to_sun: Option<Ray>,
}

/// Coverage of a pixel by moving objects.
pub(super) struct Coverage {
    /// What covers the pixel's centre, if it does.
    pub(super) centre: Option<CoveredCentre>,
    /// Number of samples that they cover.
    pub(super) samples: usize,
    /// Way of what covers it in the image while the shutter is open, pixels.
    pub(super) way: Vec2,
    /// Where the samples to shade stand in the list.
    pub(super) shaded: Range<usize>,
    /// Light of the covered samples, once known: their sum.
    pub(super) light: Vec3A,
}

impl Coverage {
    /// Nothing.
    pub(super) const NONE: Self = Self { centre: None, samples: 0, way: Vec2::ZERO, shaded: 0..0, light: Vec3A::ZERO };

    /// What rays found in front of a pixel; adds the samples to shade to a list.
    pub(super) fn new<'a>(
        bake: &CameraBake,
        frame: &'a FrameScene,
        rays: &[Ray; SAMPLES],
        found: &MovingHits,
        list: &mut Vec<MovingSample<'a>>,
    ) -> Self {
        let first = list.len();
        let mut samples = 0;
        let mut centre = None;
        for (sample, (ray, hit)) in rays.iter().zip(&found.primary).enumerate() {
            let Some(hit) = hit else { continue };
            samples += 1;
            let piece = |hit: &Hit| (hit.instance, hit.triangle);
            let same = |seen: &MovingSample<'_>| found.primary[seen.sample].as_ref().map(piece) == Some(piece(hit));
            if let Some(seen) = list[first..].iter_mut().find(|seen| same(seen)) {
                seen.stands_for += 1;
                continue;
            }
            let point = SurfaceInteraction::new(&frame.instances, ray, hit);
            if sample == 0 {
                let bsdf = || gbuffer_bsdf(&point, &bake.lighting.environment, 0, bake.pixel_angle);
                let layers = PixelLayers::new(bake.wanted, &bake.camera, ray, &point, bsdf);
                centre = Some(CoveredCentre { layers, hit: *hit, to_sun: bake.sun_ray(&point) });
            }
            match list[first..].iter_mut().find(|seen| tells(seen, &point)) {
                Some(seen) => seen.stands_for += 1,
                None => list.push(MovingSample { point, sample, stands_for: 1 }),
            }
        }
        let way = |seen: &MovingSample<'_>| bake.way_in_image(seen.point.position, seen.point.instance.velocity);
        let way = list.get(first).map_or(Vec2::ZERO, way);
        Self { centre, samples, way, shaded: first..list.len(), light: Vec3A::ZERO }
    }

    /// The sample that tells the whole pixel, if one does.
    pub(super) fn told_by(&self, seen: &[MovingSample<'_>]) -> Option<usize> {
        let alone = self.shaded.len() == 1 && usize::from(seen[self.shaded.start].stands_for) == SAMPLES;
        alone.then_some(self.shaded.start)
    }
}

/// Whether a sample's light is as good as that of another on the same smooth piece of something that moves. On shiny
/// curves, and on glass, which shows what has edges of its own, two samples are not told by one.
fn tells(seen: &MovingSample<'_>, other: &SurfaceInteraction<'_>) -> bool {
    let point = &seen.point;
    let cosine = point.normal.dot(other.normal);
    if !std::ptr::eq(point.material, other.material) || point.instance.id != other.instance.id || cosine <= 0.96 {
        return false;
    }
    let alike = match point.material.surface {
        Surface::CarGlass => 2,
        Surface::CarPaint | Surface::Chrome | Surface::Painted if cosine <= 0.995 => 2,
        _ => SAMPLES as u8,
    };
    seen.stands_for < alike
}
