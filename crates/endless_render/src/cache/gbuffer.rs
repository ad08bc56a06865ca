//! The primary hits of a fixed camera, by sample and by pixel.

use super::bake_pass::BakePass;
use super::bake_shading::ShadedSamples;
use super::bake_stats::timed;
use super::gbuffer_pixel::GBufferPixel;
use super::gbuffer_sample::GBufferSample;
use super::irradiance::IrradiancePass;
use crate::material::Bsdf;
use crate::pixel_layers::LayerImages;
use crate::sampling::SAMPLES;
use glam::Vec3A;

/// The G-buffer of what stands still: all by pixel, row-major.
pub(super) struct GBuffer {
    /// Four a pixel.
    pub(super) samples: Vec<GBufferSample>,
    /// What is asked most of each pixel's samples.
    pub(super) pixels: Vec<GBufferPixel>,
    /// All four samples of the pixel lie on one smooth piece that gives no light of its own: what moves does the same to
    /// the light of all four, so that is found once.
    pub(super) uniform: Vec<bool>,
    /// At night, the BSDF of each uniform pixel's centre: vehicle lights sweep much of the picture.
    pub(super) bsdfs: Vec<Bsdf>,
    /// What each pixel's centre shows in all layers but RGB.
    pub(super) layers: LayerImages,
    /// Gathered at each sample, klx, if it is kept.
    pub(super) irradiance: Vec<[f32; 3]>,
}

impl GBuffer {
    /// Traces and shades what stands still.
    pub(super) fn bake(pass: &BakePass<'_>) -> Self {
        let primary = timed("primary", || pass.trace());
        let irradiance = timed("gather", || IrradiancePass { bake: pass, primary: &primary }.gather());
        let ShadedSamples { samples, bsdfs } = timed("shade", || pass.shade(&primary, &irradiance));
        let layers = timed("layers", || pass.layers(&samples));
        let pixels = samples.as_chunks().0.iter().map(GBufferPixel::new).collect();
        let kept = irradiance.iter().filter(|_| pass.settings.keep_irradiance).map(Vec3A::to_array).collect();
        Self { samples, pixels, uniform: primary.uniform, bsdfs, layers, irradiance: kept }
    }

    /// The samples of a pixel.
    pub(super) fn samples_of(&self, pixel: usize) -> &[GBufferSample] {
        &self.samples[pixel * SAMPLES..][..SAMPLES]
    }
}
