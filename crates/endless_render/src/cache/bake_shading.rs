//! The passes of a bake that shade what the samples see: which pixels are uniform, light, BSDFs, layers.

use super::bake_pass::BakePass;
use super::gbuffer_sample::{GBufferSample, share_lamp_light};
use super::gbuffer_shading::{PrimarySample, gbuffer_bsdf, shade_sample, shows_signal};
use super::primary::PrimaryHits;
use crate::accel::Hit;
use crate::material::Bsdf;
use crate::pixel_layers::{LayerImages, PixelLayers};
use crate::sampling::SAMPLES;
use crate::scene::SurfaceInteraction;
use glam::Vec3A;
use rayon::prelude::*;

impl BakePass<'_> {
    /// Shades every sample; those of a uniform pixel share the lamp light of its centre.
    pub(super) fn shade(&self, primary: &PrimaryHits, irradiance: &[Vec3A], uniform: &[bool]) -> Vec<GBufferSample> {
        self.stats.add(primary.hits.len() as u64);
        let mut samples: Vec<GBufferSample> = (0..primary.hits.len())
            .into_par_iter()
            .map(|i| {
                let sample = i % SAMPLES;
                let primary = PrimarySample {
                    ray: self.ray_of(i),
                    hit: primary.hits[i],
                    sun_free: primary.sun_free[i],
                    irradiance: irradiance[i],
                    sample,
                    asks_lamps: sample == 0 || !uniform[i / SAMPLES],
                };
                shade_sample(&self.tracer, &primary, self.pixel_angle)
            })
            .collect();
        if self.tracer.environment.night {
            samples.par_chunks_mut(SAMPLES).zip(uniform).filter(|(_, u)| **u).for_each(|(s, _)| share_lamp_light(s));
        }
        samples
    }

    /// The BSDF of every uniform pixel's centre.
    pub(super) fn bsdfs(&self, samples: &[GBufferSample], uniform: &[bool]) -> Vec<Bsdf> {
        samples
            .par_chunks_exact(SAMPLES)
            .zip(uniform)
            .enumerate()
            .map(|(pixel, (group, &uniform))| {
                if !uniform {
                    return Bsdf::matte(Vec3A::ZERO, Vec3A::Z);
                }
                let ray = self.ray_of(pixel * SAMPLES);
                let point = SurfaceInteraction::new(&self.tracer.still.instances, &ray, &group[0].hit);
                gbuffer_bsdf(&point, self.tracer.environment, 0, self.pixel_angle)
            })
            .collect()
    }

    /// Whether a pixel's samples lie on one flat piece of one surface.
    fn is_uniform(&self, pixel: usize, hits: &[Option<Hit>]) -> bool {
        let point = |s: usize| {
            let hit = hits[s].as_ref()?;
            Some(SurfaceInteraction::new(&self.tracer.still.instances, &self.ray_of(pixel * SAMPLES + s), hit))
        };
        let Some(centre) = point(0).filter(|centre| !shows_signal(centre)) else { return false };
        (1..SAMPLES).map(point).all(|p| {
            p.is_some_and(|p| {
                std::ptr::eq(p.instance, centre.instance)
                    && p.material == centre.material
                    && p.normal.dot(centre.normal) > 0.995
                    && (p.position - centre.position).dot(centre.geometric_normal).abs() < 0.02
            })
        })
    }

    /// Which pixels are uniform.
    pub(super) fn uniform(&self, primary: &PrimaryHits) -> Vec<bool> {
        let pixels = primary.hits.par_chunks_exact(SAMPLES).enumerate();
        pixels.map(|(pixel, hits)| self.is_uniform(pixel, hits)).collect()
    }

    /// What each pixel's centre shows in all layers but RGB.
    pub(super) fn layers(&self, samples: &[GBufferSample]) -> LayerImages {
        let pixels = samples.chunks_exact(SAMPLES).enumerate();
        pixels
            .map(|(pixel, group)| {
                if group[0].is_sky() {
                    return PixelLayers::SKY;
                }
                let ray = self.ray_of(pixel * SAMPLES);
                let point = SurfaceInteraction::new(&self.tracer.still.instances, &ray, &group[0].hit);
                PixelLayers::new(self.camera, &ray, &point)
            })
            .collect()
    }
}
