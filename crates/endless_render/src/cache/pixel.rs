//! One pixel of a frame, from its static samples and the moving objects.

use super::bake::CameraBake;
use super::centre_light::CentreLight;
use super::compose::compose;
use super::coverage::Coverage;
use super::frame_buffer::FramePixel;
use super::mirror::MirroredLight;
use super::moving_hits::MovingHits;
use super::still_pixel::StillPixel;
use super::sweep::beams_on_samples;
use super::tile::TILE;
use super::tile_context::{PixelSamples, TileContext};
use crate::camera_rays::measured_depth;
use crate::film::{LEAST_PX, Streak};
use crate::light::HaloGrid;
use crate::sampling::SAMPLES;
use crate::scene::FrameScene;
use crate::shade::MovingSample;
use glam::Vec3A;

impl CameraBake {
    /// One pixel, given its samples, the light that these share if it is uniform, what its mirrors show of what moves,
    /// and the light of what of that covers it.
    pub(super) fn pixel(
        &self,
        context: &TileContext<'_>,
        samples: &PixelSamples<'_>,
        centre: Option<&CentreLight>,
        mut mirrored: MirroredLight,
        coverage: &Coverage,
    ) -> FramePixel {
        let PixelSamples { rays, still, found } = *samples;
        if coverage.samples == SAMPLES {
            let radiance = coverage.light / SAMPLES as f32;
            let streak = self.streak(context.frame, samples, coverage, radiance);
            return FramePixel { radiance, covered: coverage.centre, shadow: None, streak };
        }
        // The samples of a uniform pixel share what their mirrors show in pairs.
        if centre.is_some() {
            for s in (1..SAMPLES).step_by(2) {
                mirrored[s] = mirrored[s - 1];
            }
        }
        let mut sum = coverage.light;
        for s in (0..SAMPLES).filter(|&s| found.primary[s].is_none()) {
            let moving = (still.sun_free[s] & !found.sun_blocked[s], mirrored[s]);
            sum += compose(context, centre, &still, moving, &rays[s], s);
        }
        if centre.is_none() {
            sum += beams_on_samples(context, samples);
        }
        let uncovered = SAMPLES - coverage.samples;
        let swept = centre.map_or(Vec3A::ZERO, |light| light.swept * (uncovered as f32 / SAMPLES as f32));
        let radiance = sum / SAMPLES as f32 + swept;
        let streak = self.streak(context.frame, samples, coverage, radiance);
        FramePixel { radiance, covered: coverage.centre, shadow: Some(self.shadow(&still, found)), streak }
    }

    /// What moves in a pixel of some radiance, if it moves far enough to blur.
    fn streak(
        &self,
        frame: &FrameScene,
        samples: &PixelSamples<'_>,
        coverage: &Coverage,
        radiance: Vec3A,
    ) -> Option<Streak> {
        let way = coverage.way;
        if way.length_squared() < LEAST_PX * LEAST_PX {
            return None;
        }
        let (light, cover) = (coverage.light / SAMPLES as f32, coverage.samples as f32 / SAMPLES as f32);
        let nearest = samples.found.primary.iter().flatten().min_by(|a, b| a.t.total_cmp(&b.t))?;
        let behind = (cover < 1.0).then(|| (radiance - light) / (1.0 - cover));
        let id = frame.instances[nearest.instance as usize].id;
        Some(Streak { id, light, cover, behind, way, depth: measured_depth(&self.camera, &samples.rays[0], nearest.t) })
    }

    /// Glow of lamps in the air before something that moves, at a place of the tile whose first pixel is given.
    pub(super) fn halo(&self, (x0, y0): (u32, u32), place: usize, seen: &MovingSample<'_>) -> Vec3A {
        let place = place as u32;
        let at = |halos: &HaloGrid| halos.at(x0 + place % TILE, y0 + place / TILE, seen.point.distance);
        self.halos.as_ref().map_or(Vec3A::ZERO, at)
    }

    /// Where a tile ends in the picture.
    pub(super) fn tile_end(&self, x0: u32, y0: u32) -> (u32, u32) {
        ((x0 + TILE).min(self.camera.size.width), (y0 + TILE).min(self.camera.size.height))
    }
}

/// Radiance of a uniform pixel towards which nothing that moves was found and whose lamps are all free; `radiance` is
/// that of the still picture.
pub(super) fn undisturbed(
    still: &StillPixel<'_>,
    radiance: Vec3A,
    light: Option<&CentreLight>,
    found: &MovingHits,
) -> Option<Vec3A> {
    let light = light.filter(|light| light.direct.is_none() && found.is_nothing())?;
    Some(radiance + still.sample(0).ambient.get() * (light.contact - 1.0) + light.swept)
}
