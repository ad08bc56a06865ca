//! The buffers of a frame while it is rendered.

use super::bake::CameraBake;
use super::coverage::CoveredCentre;
use super::developed_frame::DevelopedFrame;
use super::moving_centre::MovingCentre;
use crate::film::{BlurScratch, Streak, blur, with_glare};
use crate::pixel_layers::LayerImages;
use crate::scene::{FrameScene, StaticScene};
use endless_world::math::UnfusedVec3A;
use glam::Vec3A;

/// One pixel of a frame.
pub(super) struct FramePixel {
    pub(super) radiance: Vec3A,
    /// What moves and covers the pixel's centre.
    pub(super) covered: Option<CoveredCentre>,
    /// On what stands still there, if that may have changed.
    pub(super) shadow: Option<u8>,
    /// Moving light that is blurred, if it moves fast enough.
    pub(super) streak: Option<Streak>,
}

/// The picture, its depth and its labels: those of the static scene, until pixels are set.
pub(super) struct FrameBuffer {
    /// Full radiance, where the film needs it (rain, lens, glare, blur).
    radiance: Option<Vec<Vec3A>>,
    /// The pixels whose radiance is no longer that of the still picture.
    touched: Vec<u32>,
    /// What moves fast, by pixel.
    streaks: Vec<(u32, Streak)>,
    rgb: Vec<[u8; 3]>,
    layers: LayerImages,
    /// Centres that something that moves covers, where a layer needs them.
    centres: Option<Vec<MovingCentre>>,
}

impl FrameBuffer {
    /// The still picture.
    pub(super) fn new(bake: &CameraBake) -> Self {
        let keeps = bake.film.response.rain.is_some()
            || bake.film.response.spreads_light()
            || bake.film.response.shutter_s > 0.0;
        Self {
            radiance: keeps.then(|| bake.film.radiance_pool.take(|| bake.film.radiance.clone())),
            touched: Vec::new(),
            streaks: Vec::new(),
            rgb: if bake.film.response.spreads_light() {
                Vec::with_capacity(bake.film.radiance.len())
            } else {
                bake.film.rgb.clone()
            },
            layers: bake.gbuffer.layers.clone(),
            centres: (bake.wanted.needs_neighbours() || bake.wanted.shadow).then(Vec::new),
        }
    }

    /// Sets a pixel.
    pub(super) fn set(&mut self, bake: &CameraBake, [x, y]: [u32; 2], pixel: &FramePixel) {
        let i = y as usize * bake.camera.size.width as usize + x as usize;
        match &mut self.radiance {
            Some(radiance) => {
                radiance[i] = pixel.radiance;
                self.touched.push(i as u32);
            }
            None => self.rgb[i] = bake.film.response.tone.apply(pixel.radiance),
        }
        if let Some(CoveredCentre { layers, hit, to_sun }) = pixel.covered {
            self.layers.set(i, &layers);
            self.centres.iter_mut().for_each(|centres| centres.push(MovingCentre { pixel: i as u32, hit, to_sun }));
        } else if let Some(shadow) = pixel.shadow {
            self.layers.set_shadow(i, shadow);
        }
        self.streaks.extend(pixel.streak.map(|streak| (i as u32, streak)));
    }

    /// Shadows, blur, rain, lens, glare, tone curve.
    pub(super) fn develop(mut self, bake: &CameraBake, still: &StaticScene, frame: &FrameScene) -> DevelopedFrame {
        let centres = self.centres.take().unwrap_or_default();
        if let Some(shadows) = bake.moving_shadows(still, frame, &centres) {
            for (centre, shadow) in centres.iter().zip(shadows) {
                self.layers.set_shadow(centre.pixel as usize, shadow);
            }
        }
        let frame = frame.frame;
        if let Some(mut radiance) = self.radiance.take() {
            self.blur(bake, &mut radiance);
            if let Some(rain) = &bake.film.response.rain {
                let mut wet = |i: usize, share: f32| {
                    radiance[i] = radiance[i].lerp_unfused(rain.radiance, share);
                    self.touched.push(i as u32);
                };
                let ground = |i: usize| {
                    let seen = self.layers.at(i);
                    (seen == bake.gbuffer.layers.at(i) && bake.gbuffer.pixel(i).is_level()).then_some(seen.depth)
                };
                rain.splash(frame, &bake.camera, ground, &mut wet);
                rain.draw(frame, &bake.camera, self.layers.depth(), wet);
            }
            match bake.film.response.post_process.as_ref().filter(|post| post.has_lens()) {
                Some(post) => {
                    let mut through = bake.film.response.lens_scratch.take(Vec::new);
                    post.lens(&radiance, &mut through);
                    self.expose(bake, &through);
                    bake.film.response.lens_scratch.give(through);
                }
                None => self.expose(bake, &radiance),
            }
            for i in self.touched {
                radiance[i as usize] = bake.film.radiance[i as usize];
            }
            bake.film.radiance_pool.give(radiance);
        }
        bake.film.darken(&mut self.rgb);
        DevelopedFrame { frame, rgb: self.rgb, layers: self.layers, centres }
    }

    fn blur(&mut self, bake: &CameraBake, radiance: &mut [Vec3A]) {
        if self.streaks.is_empty() {
            return;
        }
        // Something else that is nearer by more than a thing's own unevenness.
        let hidden = |pixel: usize, streak: &Streak| {
            let seen = self.layers.at(pixel);
            seen.instance.id != streak.id && seen.depth < 0.98 * streak.depth - 0.3
        };
        let mut scratch = bake.film.response.blur_scratch.take(BlurScratch::default);
        blur(
            bake.camera.size,
            &mut self.streaks,
            &bake.film.radiance,
            hidden,
            radiance,
            &mut self.touched,
            &mut scratch,
        );
        bake.film.response.blur_scratch.give(scratch);
    }

    /// Glare and tone curve.
    fn expose(&mut self, bake: &CameraBake, radiance: &[Vec3A]) {
        if !bake.film.response.spreads_light() {
            for &i in &self.touched {
                self.rgb[i as usize] = bake.film.response.tone.apply(radiance[i as usize]);
            }
        } else if bake.film.response.glare > 0.0 {
            with_glare(bake.camera.size, radiance, bake.film.response.glare, |row| {
                bake.film.response.tone.append(row, &mut self.rgb);
            });
        } else {
            bake.film.response.tone.append(radiance, &mut self.rgb);
        }
    }
}
