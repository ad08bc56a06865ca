//! The light of a block of pixels. Samples on surfaces of one kind are shaded eight at a time, wherever in the block they
//! lie; rays to lamps and into mirrors run thirty-two at a time.

use super::block_light::{BlockLight, BlockMirror, KeptLight};
use super::gbuffer_sample::{Mirror, MirrorSample};
use super::gbuffer_shading::gbuffer_bsdfs;
use super::lamp_mask::{lamp_sum, lamps_free32};
use super::row_block::{BLOCK, BlockPoint, RowBlock};
use super::sky_sample::sky_samples8;
use crate::accel::RayStream;
use crate::camera_rays::{is_nowhere, sample_ray};
use crate::material::{Bsdf, PackedBsdf, Reflection8};
use crate::pixel_layers::PixelLayers;
use crate::rgb9e5::Rgb9e5;
use crate::sampling::SAMPLES;
use crate::shade::{
    MIRROR_THRESHOLD, halos, halos8, mirror_footprint, mirror_ray, shade_hit8, sharp_share, soft_mirror,
};
use crate::vec3x8::{Vec3x8, lane_of, side_by_side};
use glam::Vec3A;
use std::mem::discriminant;
use wide::f32x8;

/// Samples whose rays run together.
const TOGETHER: usize = 32;
/// The sample of a uniform pixel that is shaded besides the centre where that mirrors.
pub(super) const THIRD: usize = 2;

/// Up to eight points that are shaded together.
type Eight<'a, 'b> = [Option<&'b BlockPoint<'a>>; 8];

/// What reaches eight points from the lights, and what is before them.
struct Light8 {
    transmittance: f32x8,
    /// What the air adds: of sun and sky, and of lamps.
    glow: Vec3x8,
    /// That of all lamps, where another sample has told it.
    lamps: Option<Vec3x8>,
    /// Else the lamps that light each, a bit each.
    lamps_free: [u32; 8],
}

impl RowBlock<'_> {
    /// Shades all that the block looks at. Of a uniform pixel in gathered light the third sample is shaded, too, where the
    /// centre mirrors; they share the air before the centre and the lamp light there.
    pub(super) fn shade(&mut self, light: &mut BlockLight) {
        light.mirrors.clear();
        self.shade_skies(light);
        for together in by_surface(&self.points).chunks(TOGETHER) {
            let points: Vec<&BlockPoint<'_>> = together.iter().map(|&i| &self.points[usize::from(i)]).collect();
            let lamps = self.lamps(&points);
            for (k, points) in points.chunks(8).enumerate() {
                let eight: Eight<'_, '_> = std::array::from_fn(|i| points.get(i).copied());
                let lit = self.light_at(&eight, lamps.as_ref().map(|lamps| &lamps[8 * k..8 * k + 8]));
                self.keep(&eight, &lit, light);
            }
        }
        self.shade_thirds(light);
        self.trace_mirrors(light);
    }

    /// What met nothing.
    fn shade_skies(&self, light: &mut BlockLight) {
        for skies in self.skies.chunks(8) {
            let seen = sky_samples8(
                &self.pass.tracer,
                self.pass.camera,
                &std::array::from_fn(|i| &skies[i.min(skies.len() - 1)].ray),
            );
            let four = [0, 1, 2].map(|k| (seen[k] + seen[k] + seen[k] + seen[k]) / f32x8::splat(SAMPLES as f32));
            let alone = f32x8::new(std::array::from_fn(|i| f32::from(skies[i.min(skies.len() - 1)].alone)));
            let alone = alone.simd_gt(f32x8::ZERO);
            let seen = [0, 1, 2].map(|k| alone.select(four[k], seen[k]));
            let packed = Rgb9e5::pack8(&seen);
            for (i, sky) in skies.iter().enumerate() {
                let lane = usize::from(sky.lane);
                light.set(lane, KeptLight::sky(packed[i]));
                light.sky[lane] = lane_of(&seen, i);
                if lane < BLOCK {
                    light.layers[lane] = if is_nowhere(&sky.ray) { PixelLayers::UNLIT } else { PixelLayers::SKY };
                    light.bsdfs[lane] = None;
                }
            }
        }
    }

    /// At night, which lamps light up to thirty-two points, a bit each.
    fn lamps(&self, points: &[&BlockPoint<'_>]) -> Option<[u32; TOGETHER]> {
        self.pass.tracer.environment.night.then(|| {
            let facets = std::array::from_fn(|i| points.get(i).map(|point| point.surface.facet()));
            lamps_free32(&self.pass.tracer, &facets, ((1u64 << points.len()) - 1) as u32)
        })
    }

    /// The air before eight points, and the lamps that light them.
    fn light_at(&self, eight: &Eight<'_, '_>, lamps_free: Option<&[u32]>) -> Light8 {
        let tracer = &self.pass.tracer;
        let fog = &tracer.environment.fog;
        let directions = columns(eight, |point| point.surface.direction);
        let number =
            |of: fn(&BlockPoint<'_>) -> f32| f32x8::new(eight.map(|point| point.map_or(0.0, |point| of(point))));
        let distances = number(|point| point.surface.distance);
        let transmittance = fog.transmittance8(number(|point| point.origin.z), directions[2], distances);
        let mut glow = fog.in_scatter8(&directions, transmittance);
        if tracer.environment.halos() {
            let halos = self.halos(eight, &directions, distances);
            glow = std::array::from_fn(|k| glow[k] + halos[k]);
        }
        let lamps_free = lamps_free.map_or([0; 8], |free| std::array::from_fn(|i| free[i]));
        Light8 { transmittance, glow, lamps: None, lamps_free }
    }

    /// Glow of lamps before eight points.
    fn halos(&self, eight: &Eight<'_, '_>, directions: &Vec3x8, distances: f32x8) -> Vec3x8 {
        let (tracer, camera) = (&self.pass.tracer, self.pass.camera);
        let glow = match camera.lens.is_central() {
            true => halos8(tracer, Vec3A::from(camera.position), directions, distances),
            false => eight
                .map(|point| point.map_or(Vec3A::ZERO, |point| halos(tracer, &point.ray(), point.surface.distance))),
        };
        side_by_side(glow)
    }

    /// Shades eight points, and keeps what is seen of them; what they mirror is not traced yet.
    fn keep(&self, eight: &Eight<'_, '_>, lit: &Light8, light: &mut BlockLight) {
        let (pass, uniform) = (self.pass, &self.row.primary.uniform[self.first..]);
        let environment = pass.tracer.environment;
        let surfaces = eight.map(|point| point.map(|point| &point.surface));
        let samples = eight.map(|point| point.map_or(0, BlockPoint::sample));
        let bsdfs = gbuffer_bsdfs(&surfaces, environment, &samples, pass.pixel_angle);
        let views = columns(eight, |point| -point.surface.direction);
        let reflection = Reflection8::new(&bsdfs.each_ref().map(Option::as_ref), &views);
        let direct = match (&lit.lamps, &environment.sun) {
            (Some(shared), _) => *shared,
            (None, _) if environment.night => {
                let sum = |i: usize| match (eight[i], &bsdfs[i]) {
                    (Some(point), Some(bsdf)) if lit.lamps_free[i] != 0 => {
                        lamp_sum(&pass.tracer, &point.surface.facet(), bsdf, lit.lamps_free[i])
                    }
                    _ => Vec3A::ZERO,
                };
                side_by_side(std::array::from_fn(sum))
            }
            (None, Some(sun)) => reflection.lit_by(sun.illuminance, sun.direction),
            (None, None) => [f32x8::ZERO; 3],
        };
        let emission = reflection.emission();
        let ambient = reflection.lit_by_ambient(&columns(eight, |point| point.irradiance));
        let left = lit.transmittance;
        let mut rest: Vec3x8 = std::array::from_fn(|k| emission[k] * left + lit.glow[k]);
        let mut weights = reflection.coat_reflectance();
        if self.row.irradiance.is_none() {
            let soft = self.soften(eight, &bsdfs, &mut weights);
            rest = std::array::from_fn(|k| rest[k] + soft[k] * left);
        }
        let parts: [Vec3x8; 3] = [rest, ambient.map(|axis| axis * left), direct.map(|axis| axis * left)];
        let [rest, ambient, shone] = parts.each_ref().map(Rgb9e5::pack8);
        let mirrors = weights[0].fast_max(weights[1]).fast_max(weights[2]).simd_ge(f32x8::splat(MIRROR_THRESHOLD));
        let mirrors = mirrors.to_bitmask();
        for (i, point) in eight.iter().enumerate() {
            let (Some(point), Some(bsdf)) = (point, &bsdfs[i]) else { continue };
            let (lane, surface) = (usize::from(point.lane), &point.surface);
            let mut kept = KeptLight::new([rest[i], ambient[i], shone[i]]);
            (kept.lamps_free, kept.is_lens) = (lit.lamps_free[i], surface.is_signal_lens());
            light.set(lane, kept);
            if lane < BLOCK {
                let wanted = pass.settings.layers;
                light.layers[lane] = PixelLayers::new(wanted, pass.camera, &point.ray(), surface, || bsdf.clone());
                let is_asked = environment.night && uniform[lane];
                light.bsdfs[lane] = is_asked.then(|| PackedBsdf::new(bsdf));
            }
            let parts = || parts.each_ref().map(|part| lane_of(part, i));
            if point.sample() == THIRD && uniform[lane % BLOCK] {
                light.thirds[lane % BLOCK] = parts();
            }
            if mirrors >> i & 1 == 1 {
                light.push_mirror(BlockMirror {
                    lane: point.lane,
                    ray: mirror_ray(surface, bsdf),
                    weight: lane_of(&weights, i),
                    roughness: bsdf.coat_roughness,
                    footprint_m: mirror_footprint(surface.distance, bsdf.coat_roughness, pass.pixel_angle),
                    transmittance: left.as_array()[i],
                    glow: lane_of(&lit.glow, i),
                    lamps: lane_of(&direct, i),
                    light: parts(),
                    sample: MirrorSample::NONE,
                });
            }
        }
    }

    /// Where a coat's mirror is hardly seen before what lies under it, it shows the soft light of the probes: gives that light
    /// and takes its share from the weights. In the light of probes alone.
    fn soften(&self, eight: &Eight<'_, '_>, bsdfs: &[Option<Bsdf>; 8], weights: &mut Vec3x8) -> Vec3x8 {
        let uniform = &self.row.primary.uniform[self.first..];
        let mut soft = [Vec3A::ZERO; 8];
        for (i, point) in eight.iter().enumerate() {
            let (Some(point), Some(bsdf)) = (point, &bsdfs[i]) else { continue };
            let weight = lane_of(weights, i);
            if weight.max_element() < MIRROR_THRESHOLD {
                continue;
            }
            let share = if uniform[usize::from(point.lane) % BLOCK] { 1.0 } else { 0.5 };
            let sharp = sharp_share(share, weight, bsdf);
            let sharp = if sharp * weight.max_element() < MIRROR_THRESHOLD { 0.0 } else { sharp };
            if sharp < 1.0 {
                soft[i] = weight * soft_mirror(&self.pass.tracer, &point.surface, bsdf) * (1.0 - sharp);
                for (axis, kept) in weights.iter_mut().zip((weight * sharp).to_array()) {
                    axis.as_mut_array()[i] = kept;
                }
            }
        }
        side_by_side(soft)
    }

    /// The third samples of the uniform pixels whose centres mirror, in gathered light.
    fn shade_thirds(&mut self, light: &mut BlockLight) {
        let (first, row) = (self.first, self.row);
        let from = self.points.len();
        let mut centres = Vec::new();
        for (centre, mirror) in light.mirrors.iter().enumerate() {
            let pixel = usize::from(mirror.lane);
            if pixel >= BLOCK || !row.primary.uniform[first + pixel] {
                continue;
            }
            let (x, lane) = (first + pixel, BLOCK * THIRD + pixel);
            let Some((hit, gathered)) = row.primary.pixel(x).hit(THIRD).zip(row.gathered(x, THIRD)) else { continue };
            let ray = sample_ray(self.pass.camera, x as u32, row.y as u32, THIRD);
            self.told_by[lane] = lane as u16;
            self.push_point(&ray, &hit, gathered, lane);
            centres.push(centre);
        }
        for (points, centres) in self.points[from..].chunks(8).zip(centres.chunks(8)) {
            let eight: Eight<'_, '_> = std::array::from_fn(|i| points.get(i));
            let of = |i: usize| centres.get(i).map(|&centre| &light.mirrors[centre]);
            let vectors = |of_centre: fn(&BlockMirror) -> Vec3A| {
                side_by_side(std::array::from_fn(|i| of(i).map_or(Vec3A::ZERO, of_centre)))
            };
            let lit = Light8 {
                transmittance: f32x8::new(std::array::from_fn(|i| of(i).map_or(0.0, |centre| centre.transmittance))),
                glow: vectors(|centre| centre.glow),
                lamps: self.pass.tracer.environment.night.then(|| vectors(|centre| centre.lamps)),
                lamps_free: [0; 8],
            };
            self.keep(&eight, &lit, light);
        }
    }

    /// What the samples' coats mirror, and how far they see.
    fn trace_mirrors(&self, light: &mut BlockLight) {
        let tracer = &self.pass.tracer;
        for mirrors in light.mirrors.chunks_mut(TOGETHER) {
            let mut rays = RayStream::<SAMPLES>::NONE;
            for (lane, mirror) in mirrors.iter().enumerate() {
                rays.set(lane, &mirror.ray);
            }
            let struck = tracer.closest32(&rays, ((1u64 << mirrors.len()) - 1) as u32);
            for (mirrors, struck) in mirrors.chunks_mut(8).zip(&struck) {
                let own = |i: usize| &mirrors[i.min(mirrors.len() - 1)];
                let (rays, footprints_m) =
                    (std::array::from_fn(|i| own(i).ray), std::array::from_fn(|i| own(i).footprint_m));
                let active = ((1u16 << mirrors.len()) - 1) as u8;
                let seen = shade_hit8(tracer, &rays, struck, active, &footprints_m);
                for (i, mirror) in mirrors.iter_mut().enumerate() {
                    mirror.sample = MirrorSample::new(&Mirror {
                        light: mirror.weight * seen[i] * mirror.transmittance,
                        weight: mirror.weight * mirror.transmittance,
                        direction: mirror.ray.direction,
                        reach: struck[i].map_or(f32::MAX, |struck| struck.hit.t),
                        roughness: mirror.roughness,
                    });
                }
            }
        }
    }
}

/// The points by the kind of their surface; those of one kind in their order.
fn by_surface(points: &[BlockPoint<'_>]) -> Vec<u16> {
    let kind = |point: &BlockPoint<'_>| discriminant(&point.surface.material.surface);
    let mut order = Vec::with_capacity(points.len());
    let mut kinds = Vec::new();
    for point in points {
        if !kinds.contains(&kind(point)) {
            kinds.push(kind(point));
        }
    }
    for own in kinds {
        order.extend((0..points.len() as u16).filter(|&i| kind(&points[usize::from(i)]) == own));
    }
    order
}

/// A vector of each point.
fn columns(eight: &Eight<'_, '_>, of: impl Fn(&BlockPoint<'_>) -> Vec3A) -> Vec3x8 {
    side_by_side(eight.map(|point| point.map_or(Vec3A::ZERO, &of)))
}
