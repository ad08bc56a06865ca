//! The passes of a bake: primary rays, gathered light, shading, labels.

use super::bake_stats::BakeStats;
use super::gbuffer_sample::GBufferSample;
use super::gbuffer_shading::{PrimarySample, gbuffer_bsdf, shade_sample};
use super::sun_rays::{sun_can_light, sun_origin};
use crate::accel::{Hit, Ray};
use crate::camera_rays::sample_ray;
use crate::indirect::{DenoiseGuide, PATTERN_SIDE, denoise, gather8, turn};
use crate::material::Bsdf;
use crate::pixel_layers::{LayerImages, PixelLayers};
use crate::sampling::SAMPLES;
use crate::scene::SurfaceInteraction;
use crate::settings::RenderSettings;
use crate::shade::{Tracer, footprint_m};
use endless_world::PinholeCamera;
use glam::Vec3A;
use rayon::prelude::*;

/// What the first pass found for each sample.
pub(super) struct PrimaryHits {
    hits: Vec<Option<Hit>>,
    sun_free: Vec<u8>,
}

/// The passes of a bake.
pub(super) struct BakePass<'a> {
    pub(super) tracer: Tracer<'a>,
    pub(super) camera: &'a PinholeCamera,
    pub(super) pixel_angle: f32,
    pub(super) settings: &'a RenderSettings,
    pub(super) stats: &'a BakeStats,
}

impl BakePass<'_> {
    fn width(&self) -> usize {
        self.camera.size.width as usize
    }

    fn ray_of(&self, sample_index: usize) -> Ray {
        let pixel = sample_index / SAMPLES;
        sample_ray(self.camera, (pixel % self.width()) as u32, (pixel / self.width()) as u32, sample_index % SAMPLES)
    }

    /// Visibility of every sample, and of the sun's disc from there, in packets of eight neighbours.
    pub(super) fn trace(&self) -> PrimaryHits {
        let total = self.camera.size.pixels() * SAMPLES;
        let mut hits = vec![None; total];
        let mut sun_free = vec![0u8; total];
        let row = self.width() * SAMPLES;
        hits.par_chunks_mut(row).zip(sun_free.par_chunks_mut(row)).enumerate().for_each(|(y, (hits, free))| {
            for sample in 0..SAMPLES {
                for first in (0..self.width()).step_by(8) {
                    self.trace_eight(y as u32, first, sample, hits, free);
                }
            }
        });
        self.stats.add(total as u64 * 2);
        PrimaryHits { hits, sun_free }
    }

    fn trace_eight(&self, y: u32, first: usize, sample: usize, hits: &mut [Option<Hit>], free: &mut [u8]) {
        let count = (self.width() - first).min(8);
        let rays: [Ray; 8] =
            std::array::from_fn(|i| sample_ray(self.camera, (first + i.min(count - 1)) as u32, y, sample));
        let found = self.tracer.still.accel.closest8(&rays, ((1u16 << count) - 1) as u8);
        for i in 0..count {
            hits[(first + i) * SAMPLES + sample] = found[i];
        }
        let Some(sun) = &self.tracer.environment.sun else { return };
        let mut lit = 0u8;
        let origins: [Vec3A; 8] = std::array::from_fn(|i| {
            let Some(hit) = found[i].filter(|_| i < count) else { return Vec3A::ZERO };
            let point = SurfaceInteraction::new(&self.tracer.still.instances, &rays[i], &hit);
            lit |= u8::from(sun_can_light(&point, sun.direction)) << i;
            sun_origin(&point.facet(), sun.direction)
        });
        for (bit, &direction) in sun.disc[sample].iter().enumerate() {
            let to_sun = origins.map(|origin| Ray { origin, direction, tmax: f32::MAX });
            let blocked = self.tracer.still.accel.occluded8(&to_sun, lit);
            for i in 0..count {
                free[(first + i) * SAMPLES + sample] |= ((lit & !blocked) >> i & 1) << bit;
            }
        }
    }

    /// Gathered and denoised irradiance of every sample.
    pub(super) fn irradiance(&self, primary: &PrimaryHits) -> Vec<Vec3A> {
        const SKY: DenoiseGuide = DenoiseGuide { position: Vec3A::ZERO, normal: Vec3A::ZERO, reach_m: 1.0 };
        let width = self.width();
        let mut all = vec![Vec3A::ZERO; primary.hits.len()];
        for sample in 0..SAMPLES {
            let mut guides = vec![SKY; self.camera.size.pixels()];
            let mut light = vec![Vec3A::ZERO; guides.len()];
            guides.par_chunks_mut(width).zip(light.par_chunks_mut(width)).enumerate().for_each(
                |(y, (guides, light))| {
                    // Every fourth pixel of 32 shares a pattern of rays.
                    for block in (0..width).step_by(8 * PATTERN_SIDE) {
                        for first in block..(block + PATTERN_SIDE).min(width) {
                            self.gather_eight(primary, y, first, sample, guides, light);
                        }
                    }
                },
            );
            let clean = denoise(width, &guides, light, 5);
            all.par_chunks_mut(SAMPLES).zip(clean).for_each(|(pixel, light)| pixel[sample] = light);
        }
        self.stats.add(primary.hits.len() as u64 * u64::from(self.settings.gather_rays) * 2);
        all
    }

    /// Gathers for eight pixels of a row, [`PATTERN_SIDE`] apart.
    fn gather_eight(
        &self,
        primary: &PrimaryHits,
        y: usize,
        first: usize,
        sample: usize,
        guides: &mut [DenoiseGuide],
        light: &mut [Vec3A],
    ) {
        let column = |i: usize| first + i * PATTERN_SIDE;
        let points: [Option<SurfaceInteraction<'_>>; 8] = std::array::from_fn(|i| {
            let index = (y * self.width() + column(i)) * SAMPLES + sample;
            let hit = primary.hits[..(y + 1) * self.width() * SAMPLES].get(index)?.as_ref()?;
            Some(SurfaceInteraction::new(&self.tracer.still.instances, &self.ray_of(index), hit))
        });
        let turn = turn(first, y, sample, self.settings.pattern);
        let gathered = gather8(&self.tracer, &points, turn, self.settings.gather_rays);
        for (i, point) in points.iter().enumerate() {
            let Some(point) = point else { continue };
            let reach_m = footprint_m(point, self.pixel_angle).max(0.01);
            guides[column(i)] = DenoiseGuide { position: point.position, normal: point.normal, reach_m };
            light[column(i)] = gathered[i];
        }
    }

    /// Shades every sample.
    pub(super) fn shade(&self, primary: &PrimaryHits, irradiance: &[Vec3A]) -> Vec<GBufferSample> {
        self.stats.add(primary.hits.len() as u64);
        (0..primary.hits.len())
            .into_par_iter()
            .map(|i| {
                let primary = PrimarySample {
                    ray: self.ray_of(i),
                    hit: primary.hits[i],
                    sun_free: primary.sun_free[i],
                    irradiance: irradiance[i],
                    sample: i % SAMPLES,
                };
                shade_sample(&self.tracer, &primary, self.pixel_angle)
            })
            .collect()
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
    fn is_uniform(&self, pixel: usize, group: &[GBufferSample]) -> bool {
        if group.iter().any(GBufferSample::is_sky) {
            return false;
        }
        let point = |s: usize| {
            SurfaceInteraction::new(&self.tracer.still.instances, &self.ray_of(pixel * SAMPLES + s), &group[s].hit)
        };
        if group[0].flags & GBufferSample::LENS != 0 {
            return false;
        }
        let centre = point(0);
        (1..SAMPLES).map(point).all(|p| {
            std::ptr::eq(p.instance, centre.instance)
                && p.material == centre.material
                && p.normal.dot(centre.normal) > 0.995
                && (p.position - centre.position).dot(centre.geometric_normal).abs() < 0.02
        })
    }

    /// Which pixels are uniform.
    pub(super) fn uniform(&self, samples: &[GBufferSample]) -> Vec<bool> {
        let pixels = samples.par_chunks_exact(SAMPLES).enumerate();
        pixels.map(|(pixel, group)| self.is_uniform(pixel, group)).collect()
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
