//! The pass of a bake that makes all layers but RGB.

use super::bake_pass::BakePass;
use super::gbuffer_sample::GBufferSample;
use crate::pixel_layers::{LayerImages, PixelLayers};
use crate::sampling::SAMPLES;
use crate::scene::SurfaceInteraction;
use rayon::prelude::*;

impl BakePass<'_> {
    /// What each pixel's centre shows in all layers but RGB.
    pub(super) fn layers(&self, samples: &[GBufferSample]) -> LayerImages {
        let pixels = samples.par_chunks_exact(SAMPLES).enumerate();
        let layers: Vec<PixelLayers> = pixels
            .map(|(pixel, group)| {
                if group[0].is_sky() {
                    return PixelLayers::SKY;
                }
                let ray = self.ray_of(pixel * SAMPLES);
                let point = SurfaceInteraction::new(&self.tracer.still.instances, &ray, &group[0].hit);
                PixelLayers::new(self.camera, &ray, &point)
            })
            .collect();
        layers.into_iter().collect()
    }
}
