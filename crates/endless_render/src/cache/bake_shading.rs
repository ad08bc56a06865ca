//! The pass of a bake that shades what the samples see: those of eight neighbouring pixels at a time, whose rays run side
//! by side.

use super::bake_pass::BakePass;
use super::gbuffer_sample::GBufferSample;
use super::gbuffer_shading::{Air, PrimarySample, SampleLight, gbuffer_bsdf, sky_sample, surface_sample};
use super::lamp_mask::{lamp_sum, lamps_free32};
use super::primary::{PrimaryHits, place};
use crate::accel::{RayStream, first_lanes, lanes};
use crate::material::Bsdf;
use crate::sampling::SAMPLES;
use crate::scene::SurfaceInteraction;
use crate::shade::{MIRROR_THRESHOLD, halos8, mirror_footprint, mirror_ray, shade_hit8, sun_light};
use glam::Vec3A;
use rayon::prelude::*;
use wide::f32x8;

/// Samples of eight pixels: lane 8 × sample + pixel.
const LANES: usize = 8 * SAMPLES;
/// Times eight pixels' bits: the lanes of their samples that are second of a pair.
const SECONDS: u32 = 0x0100_0100;
/// Times eight pixels' bits: the lanes of their samples but the centres.
const NOT_CENTRES: u32 = 0x0101_0100;

/// What shading makes of the samples.
pub(super) struct ShadedSamples {
    /// Four a pixel.
    pub(super) samples: Vec<GBufferSample>,
    /// At night, the BSDF of each uniform pixel's centre; by day, none.
    pub(super) bsdfs: Vec<Bsdf>,
}

impl BakePass<'_> {
    /// Shades every sample but the second of each pair of a uniform pixel, which is lit as the first. The first of both
    /// pairs share the air before the pixel's centre and the lamp light there.
    pub(super) fn shade(&self, primary: &PrimaryHits, irradiance: &[Vec3A]) -> ShadedSamples {
        self.stats.add(primary.hits.len() as u64);
        let pixels = primary.uniform.len();
        let eights = (0..pixels.div_ceil(8)).into_par_iter();
        let eight = |i| PixelEight::new(self, primary, irradiance, 8 * i);
        let (mut samples, mut bsdfs) = (Vec::new(), Vec::new());
        if self.tracer.environment.night {
            let both = |eight: PixelEight<'_>| (eight.shaded(), eight.bsdfs());
            eights.map(|i| both(eight(i))).unzip_into_vecs(&mut samples, &mut bsdfs);
        } else {
            eights.map(|i| eight(i).shaded()).collect_into_vec(&mut samples);
        }
        let (mut samples, mut bsdfs) = (samples.into_flattened(), bsdfs.into_flattened());
        samples.truncate(pixels * SAMPLES);
        bsdfs.truncate(pixels);
        ShadedSamples { samples, bsdfs }
    }
}

/// Eight neighbouring pixels; the last ones may lie beyond the picture.
struct PixelEight<'a> {
    pass: &'a BakePass<'a>,
    samples: [PrimarySample; LANES],
    /// What the samples see that are not lit as another; none of the sky.
    surfaces: [Option<(SurfaceInteraction<'a>, Bsdf)>; LANES],
    /// The samples that lie in the picture, a bit each.
    inside: u32,
    /// The pixels that are uniform, a bit each.
    uniform: u32,
}

impl<'a> PixelEight<'a> {
    fn new(pass: &'a BakePass<'a>, primary: &PrimaryHits, irradiance: &[Vec3A], first: usize) -> Self {
        let count = (primary.uniform.len() - first).min(8);
        let directions = pass.directions_of(first, count);
        let samples = std::array::from_fn(|lane| {
            let index = first * SAMPLES + place(8 * (lane / 8) + (lane % 8).min(count - 1));
            PrimarySample {
                ray: pass.ray_along(&directions[lane / 8], lane % 8),
                hit: primary.hits[index],
                sun_free: primary.sun_free[index],
                irradiance: irradiance[index],
            }
        });
        let uniform = primary.uniform[first..first + count].iter().rev().fold(0, |bits, u| bits << 1 | u32::from(*u));
        let inside = first_lanes(count);
        let seconds = uniform * SECONDS;
        let surfaces = std::array::from_fn(|lane| {
            let PrimarySample { ray, hit: Some(hit), .. } = &samples[lane] else { return None };
            if seconds >> lane & 1 == 1 {
                return None;
            }
            let point = SurfaceInteraction::new(&pass.tracer.still.instances, ray, hit);
            let bsdf = gbuffer_bsdf(&point, pass.tracer.environment, lane / 8, pass.pixel_angle);
            Some((point, bsdf))
        });
        Self { pass, samples, surfaces, inside, uniform }
    }

    /// The lanes whose samples share what is known of their pixel's centre.
    fn sharing(&self) -> u32 {
        self.uniform * NOT_CENTRES
    }

    fn shaded(&self) -> [GBufferSample; LANES] {
        let tracer = &self.pass.tracer;
        let environment = tracer.environment;
        let halos = self.halos();
        let mirrors = self.mirrors();
        let lamps = if environment.night { self.lamps() } else { [(0, Vec3A::ZERO); LANES] };
        let sharing = self.sharing();
        let mut air = [Air { transmittance: 1.0, glow: Vec3A::ZERO }; LANES];
        let mut shaded = [GBufferSample::sky(Vec3A::ZERO); LANES];
        for lane in lanes(self.inside) {
            let primary = &self.samples[lane];
            let shares = sharing >> lane & 1 == 1;
            let Some(hit) = &primary.hit else {
                shaded[place(lane)] = sky_sample(environment, &primary.ray, halos[lane]);
                continue;
            };
            let Some((point, bsdf)) = &self.surfaces[lane] else {
                shaded[place(lane)] = shaded[place(lane - 8)].seen_by(primary.sun_free, hit);
                continue;
            };
            air[lane] = match shares {
                true => air[lane % 8],
                false => Air::before(environment, &primary.ray, hit.t, halos[lane]),
            };
            let (lamps_free, lamp_light) = lamps[if shares { lane % 8 } else { lane }];
            let direct = if environment.night { lamp_light } else { sun_light(environment, point, bsdf) };
            let lamps_free = if shares { 0 } else { lamps_free };
            let light = SampleLight { air: air[lane], direct, lamps_free, mirror: mirrors[lane] };
            shaded[place(lane)] = surface_sample(primary, hit, point, bsdf, &light);
        }
        shaded
    }

    /// BSDFs of the uniform pixels' centres.
    fn bsdfs(&self) -> [Bsdf; 8] {
        std::array::from_fn(|pixel| match &self.surfaces[pixel] {
            Some((_, bsdf)) if self.uniform >> pixel & 1 == 1 => bsdf.clone(),
            _ => Bsdf::matte(Vec3A::ZERO, Vec3A::Z),
        })
    }

    /// Glow of lamps before the samples that do not share that of their centre.
    fn halos(&self) -> [Vec3A; LANES] {
        let mut halos = [Vec3A::ZERO; LANES];
        let sharing = self.sharing();
        for (row, (eight, glow)) in self.samples.chunks(8).zip(halos.chunks_mut(8)).enumerate() {
            if self.inside & !sharing & 0xff << (8 * row) == 0 {
                continue;
            }
            let directions = [0, 1, 2].map(|axis| f32x8::new(std::array::from_fn(|i| eight[i].ray.direction[axis])));
            let distance = |i: usize| eight[i].hit.as_ref().map_or(f32::MAX, |hit| hit.t);
            let distances = f32x8::new(std::array::from_fn(distance));
            glow.copy_from_slice(&halos8(&self.pass.tracer, eight[0].ray.origin, &directions, distances));
        }
        halos
    }

    /// What the samples' coats mirror, and how far they see.
    fn mirrors(&self) -> [(Vec3A, f32); LANES] {
        let tracer = &self.pass.tracer;
        let mut mirrors = [(Vec3A::ZERO, 0.0); LANES];
        let mut rays = RayStream::<SAMPLES>::NONE;
        let mut asked = 0u32;
        let mut weights = [Vec3A::ZERO; LANES];
        let mut footprints_m = [0.0; LANES];
        for lane in lanes(self.inside) {
            let Some((point, bsdf)) = &self.surfaces[lane] else { continue };
            weights[lane] = bsdf.coat_reflectance(-point.direction);
            if weights[lane].max_element() >= MIRROR_THRESHOLD {
                asked |= 1 << lane;
                rays.set(lane, &mirror_ray(point, bsdf));
                footprints_m[lane] = mirror_footprint(point.distance, bsdf.coat_roughness, self.pass.pixel_angle);
            }
        }
        if asked == 0 {
            return mirrors;
        }
        let struck = tracer.closest32(&rays, asked);
        for (row, struck) in struck.iter().enumerate() {
            let active = (asked >> (8 * row)) as u8;
            if active == 0 {
                continue;
            }
            let eight = std::array::from_fn(|i| rays.ray(8 * row + i));
            let footprints_m = std::array::from_fn(|i| footprints_m[8 * row + i]);
            let light = shade_hit8(tracer, &eight, struck, active, &footprints_m);
            for i in lanes(u32::from(active)) {
                let reach = struck[i].map_or(f32::MAX, |struck| struck.hit.t);
                mirrors[8 * row + i] = (weights[8 * row + i] * light[i], reach);
            }
        }
        mirrors
    }

    /// Which lamps light the samples that do not share the light of their centre, a bit each, and their light.
    fn lamps(&self) -> [(u32, Vec3A); LANES] {
        let tracer = &self.pass.tracer;
        let facets = std::array::from_fn(|lane| self.surfaces[lane].as_ref().map(|(point, _)| point.facet()));
        let free = lamps_free32(tracer, &facets, self.inside & !self.sharing());
        std::array::from_fn(|lane| {
            let light = self.surfaces[lane].as_ref().filter(|_| free[lane] != 0);
            let sum = light.map_or(Vec3A::ZERO, |(point, bsdf)| lamp_sum(tracer, &point.facet(), bsdf, free[lane]));
            (free[lane], sum)
        })
    }
}
