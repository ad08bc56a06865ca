//! The pass of a bake that shades what the samples see: those of eight neighbouring pixels at a time, whose rays run side
//! by side.

use super::bake_pass::BakePass;
use super::gbuffer_row::GBufferRow;
use super::gbuffer_shading::{Air, PrimarySample, SampleLight, gbuffer_bsdfs, is_shaded, sky_sample, surface_sample};
use super::lamp_mask::{lamp_sum, lamps_free32};
use super::primary_hits::{PrimaryHits, PrimaryRow, RowSurfaces};
use super::shaded_pixel::{ShadedPixel, ShadedSample};
use crate::accel::{Hit, Ray, RayStream, first_lanes, lanes};
use crate::camera_rays::{aims8, is_nowhere};
use crate::material::{Bsdf, PackedBsdf};
use crate::octahedron;
use crate::pixel_layers::{LayerImages, PixelLayers};
use crate::rgb9e5::Rgb9e5;
use crate::sampling::SAMPLES;
use crate::scene::SurfaceInteraction;
use crate::shade::{MIRROR_THRESHOLD, halos, halos8, mirror_footprint, mirror_ray, shade_hit8, sun_light};
use endless_scene::Surface;
use glam::Vec3A;
use rayon::prelude::*;
use wide::f32x8;

/// Samples of eight pixels: lane 8 × sample + pixel.
const LANES: usize = 8 * SAMPLES;
/// Share of what is around a plant that its leaves see past each other, as gathered light has it in the mean.
const OPEN_TO_LEAVES: f32 = 0.5;
/// The same of walls, from which sills, balconies and eaves stand out.
const OPEN_TO_WALLS: f32 = 0.93;
/// Normals of walls rise or fall by less.
const UPRIGHT: f32 = 0.5;
/// Times eight pixels' bits: the lanes of their samples but the centres.
const NOT_CENTRES: u32 = 0x0101_0100;

impl BakePass<'_> {
    /// Shades all pixels, which needs what `surfaces` tell of each row, and tells what their centres show in all layers but
    /// RGB.
    pub(super) fn shade(
        &self,
        primary: &PrimaryHits,
        surfaces: Vec<RowSurfaces>,
        irradiance: &[[Rgb9e5; SAMPLES]],
    ) -> (Vec<GBufferRow>, LayerImages) {
        self.stats.add((primary.uniform.len() * SAMPLES) as u64);
        let width = self.width();
        let PrimaryHits { distances, sun_free, uniform, .. } = primary;
        let rows = surfaces.into_par_iter().enumerate().map(|(y, surfaces)| {
            let pixels = y * width..(y + 1) * width;
            let (distances, sun_free) = (&distances[pixels.clone()], &sun_free[pixels.clone()]);
            let row = PrimaryRow { distances, sun_free, uniform: &uniform[pixels.clone()], surfaces: &surfaces };
            self.shade_row(row, irradiance.get(pixels), y)
        });
        let (rows, layers): (Vec<GBufferRow>, Vec<LayerImages>) = rows.unzip();
        (rows, LayerImages::of_rows(self.settings.layers, layers))
    }

    /// Shades a row. Of a uniform pixel the centre is shaded, and where it mirrors the third sample, too; they share the air
    /// before the centre and the lamp light there.
    pub(super) fn shade_row(
        &self,
        primary: PrimaryRow<'_>,
        irradiance: Option<&[[Rgb9e5; SAMPLES]]>,
        y: usize,
    ) -> (GBufferRow, LayerImages) {
        let width = self.width();
        let mut row = GBufferRow::for_pixels((0..width).map(|x| primary.pixel(x)));
        let night = self.tracer.environment.night;
        let mut layers = LayerImages::with_capacity(self.settings.layers, width);
        // Large, so it is never moved.
        let eight = &mut PixelEight::new(self);
        for first in (0..width).step_by(8) {
            let count = (width - first).min(8);
            eight.look_at(primary, irradiance, [first, y], count);
            eight.shade();
            for pixel in 0..count {
                let samples = std::array::from_fn(|sample| eight.shaded(pixel, sample));
                row.push(&ShadedPixel::new(&primary.pixel(first + pixel), samples));
                let seen = eight.layers(pixel);
                layers.push(&seen.with_shadow(self.still_shadow(&primary.pixel(first + pixel))));
            }
            if night {
                for (x, bsdf) in (first..).zip(eight.bsdfs()).take(count) {
                    row.push_bsdf(x, bsdf);
                }
            }
        }
        row.shrink(night);
        (row, layers)
    }
}

/// Light near a point as the probes tell of it.
fn ambient(pass: &BakePass<'_>, point: &SurfaceInteraction<'_>) -> Vec3A {
    pass.tracer.ambient(point.position + point.geometric_normal * 0.25, point.normal)
}

/// The share of it that what is close by leaves, which is not in the probes.
fn open(point: &SurfaceInteraction<'_>) -> f32 {
    match point.material.surface {
        Surface::Foliage => OPEN_TO_LEAVES,
        _ if point.normal.z.abs() < UPRIGHT => OPEN_TO_WALLS * point.ambient_occlusion,
        _ => point.ambient_occlusion,
    }
}

/// Whether points, of which the first and the last are given, lie near each other on one flat piece of a plane.
fn is_one_plane<'a>(
    from: &SurfaceInteraction<'_>,
    to: &SurfaceInteraction<'_>,
    mut points: impl Iterator<Item = &'a SurfaceInteraction<'a>>,
) -> bool {
    /// Far less than from probe to probe.
    const WIDE_M: f32 = 1.0;
    let same = |p: &SurfaceInteraction<'_>| {
        p.normal == from.normal && (p.position - from.position).dot(from.geometric_normal).abs() < 0.02
    };
    (to.position - from.position).length_squared() < WIDE_M * WIDE_M && points.all(same)
}

/// Whether two samples of a pixel may have one light: they lie on one smooth surface, or among leaves.
fn alike(pass: &BakePass<'_>, row: &RowSurfaces, x: usize, [a, b]: [usize; 2], first: &Hit, second: &Hit) -> bool {
    let mesh = |hit: &Hit| &*pass.tracer.still.instances[hit.instance as usize].geometry.mesh;
    let material = |hit: &Hit| mesh(hit).triangle_materials[hit.triangle as usize];
    if first.instance != second.instance || material(first) != material(second) {
        return false;
    }
    match mesh(first).materials[usize::from(material(first))].surface {
        Surface::SignalLens(_) => false,
        Surface::Foliage => a == 0 && b == 3 || a == 1 && b == 2,
        _ => {
            let normal = |sample: usize| octahedron::unpack(row.normals[x][sample].shading);
            normal(a).dot(normal(b)) > 0.98 && (first.t - second.t).abs() < 0.05 * first.t
        }
    }
}

/// Eight neighbouring pixels, one after the other; the last ones may lie beyond the picture.
struct PixelEight<'a> {
    pass: &'a BakePass<'a>,
    samples: [PrimarySample; LANES],
    /// What the samples see that are not lit as another; none of the sky.
    points: [Option<SurfaceInteraction<'a>>; LANES],
    /// The BSDFs of these points.
    bsdfs: [Option<Bsdf>; LANES],
    /// Of a uniform pixel, nothing but of those samples that tell it.
    shaded: [ShadedSample; LANES],
    /// The samples that lie in the picture and are not told by another, a bit each; more of those that may be.
    asked: u32,
    /// The pixels that are uniform, a bit each.
    uniform: u32,
    /// For each sample the one of its pixel whose light it has: itself, where it is shaded.
    told_by: [u8; LANES],
}

impl<'a> PixelEight<'a> {
    /// Which look at nothing yet.
    fn new(pass: &'a BakePass<'a>) -> Self {
        let nothing = PrimarySample { ray: Ray::NONE, hit: None, irradiance: Vec3A::ZERO };
        Self {
            pass,
            samples: [nothing; LANES],
            points: [const { None }; LANES],
            bsdfs: [const { None }; LANES],
            shaded: [ShadedSample::sky(Vec3A::ZERO); LANES],
            asked: 0,
            uniform: 0,
            told_by: [0; LANES],
        }
    }

    /// Turns to `count` pixels of the row `y`, of whose samples it is known what light was gathered there, or which the
    /// probes tell.
    fn look_at(
        &mut self,
        primary: PrimaryRow<'_>,
        irradiance: Option<&[[Rgb9e5; SAMPLES]]>,
        [first, y]: [usize; 2],
        count: usize,
    ) {
        let pass = self.pass;
        let bits =
            |of: &dyn Fn(usize) -> bool| (0..count).rev().fold(0, |bits, i| bits << 1 | u32::from(of(first + i)));
        self.uniform = bits(&|x| primary.uniform[x]);
        // The light of probes is that of the centre wherever a pixel is uniform or of nothing but sky.
        let simple = match irradiance {
            Some(_) => 0,
            None => bits(&|x| primary.uniform[x] || primary.distances[x] == [f32::MAX; SAMPLES]),
        };
        self.asked = first_lanes(count) & !(simple * NOT_CENTRES);
        for sample in 0..SAMPLES {
            let lanes_of = |bits: u32| lanes(bits).map(move |pixel| (pixel, 8 * sample + pixel));
            for (pixel, lane) in lanes_of(if sample > 0 { simple } else { 0 }) {
                self.told_by[lane] = pixel as u8;
            }
            let asked = self.asked >> (8 * sample) & 0xff;
            if asked == 0 {
                continue;
            }
            let aims = aims8(pass.camera, first as u32, (first + count) as u32, y as u32, sample);
            for (pixel, lane) in lanes_of(asked) {
                let x = first + pixel;
                let gathered = irradiance.map(|irradiance| irradiance[x][sample].get());
                self.look_along(pass.ray_along(&aims, pixel), primary, gathered, (x, pixel, lane));
            }
            if irradiance.is_none() {
                self.ask_probes(sample);
            }
            let seen = |pixel: usize| self.points[8 * sample + pixel].as_ref().filter(|_| asked >> pixel & 1 == 1);
            let points = std::array::from_fn(seen);
            let bsdfs = gbuffer_bsdfs(&points, pass.tracer.environment, sample, pass.pixel_angle);
            for (own, bsdf) in self.bsdfs[8 * sample..].iter_mut().zip(bsdfs) {
                *own = bsdf;
            }
        }
    }

    /// Turns to one sample of a pixel `x` of the row.
    fn look_along(
        &mut self,
        ray: Ray,
        primary: PrimaryRow<'_>,
        gathered: Option<Vec3A>,
        (x, pixel, lane): (usize, usize, usize),
    ) {
        let (pass, sample) = (self.pass, lane / 8);
        let hit = primary.pixel(x).hit(sample);
        self.told_by[lane] = lane as u8;
        self.points[lane] = None;
        self.samples[lane] = PrimarySample { ray, hit, irradiance: gathered.unwrap_or(Vec3A::ZERO) };
        let Some(hit) = &hit else { return };
        if self.uniform >> pixel & 1 == 1 && !is_shaded(sample, self.surface(pixel)) {
            self.shaded[lane] = ShadedSample::sky(Vec3A::ZERO);
            return;
        }
        if gathered.is_none()
            && let Some(alike) = self.alike(primary.surfaces, x, lane)
        {
            self.told_by[lane] = alike;
            return;
        }
        self.points[lane] = Some(SurfaceInteraction::new(&pass.tracer.still.instances, &ray, hit));
    }

    /// The light at one sample of each of the pixels, as the probes tell of it: along a plane it changes evenly.
    fn ask_probes(&mut self, sample: usize) {
        let asked = lanes(self.asked & 0xff << (8 * sample));
        let seen = asked.filter(|&lane| self.points[lane].is_some()).fold(0u32, |bits, lane| bits | 1 << lane);
        let points = || lanes(seen).filter_map(|lane| self.points[lane].as_ref().map(|point| (lane, point)));
        let (Some((first, from)), Some((last, to))) = (points().next(), points().last()) else { return };
        let (way, pass) = (to.position - from.position, self.pass);
        let even = last > first + 1 && is_one_plane(from, to, points().map(|(_, point)| point));
        let ends = even.then(|| (ambient(pass, from), ambient(pass, to)));
        let light = |point: &SurfaceInteraction<'_>| match ends {
            Some((first, last)) => {
                first + (last - first) * ((point.position - from.position).dot(way) / way.length_squared())
            }
            None => ambient(pass, point),
        };
        for lane in lanes(seen) {
            let Some(point) = &self.points[lane] else { continue };
            self.samples[lane].irradiance = light(point) * open(point);
        }
    }

    /// What a sample sees that is not lit as another.
    fn surface(&self, lane: usize) -> Option<(&SurfaceInteraction<'a>, &Bsdf)> {
        self.points[lane].as_ref().zip(self.bsdfs[lane].as_ref())
    }

    /// The light of a pixel's sample.
    fn shaded(&self, pixel: usize, sample: usize) -> &ShadedSample {
        &self.shaded[usize::from(self.told_by[8 * sample + pixel])]
    }

    /// An earlier sample of the same pixel `x` of the row that may tell the light of this one.
    fn alike(&self, row: &RowSurfaces, x: usize, lane: usize) -> Option<u8> {
        let hit = self.samples[lane].hit.as_ref()?;
        let may_tell = |&other: &usize| {
            let shaded = usize::from(self.told_by[other]) == other;
            let before = self.samples[other].hit.as_ref().filter(|_| shaded);
            before.is_some_and(|before| alike(self.pass, row, x, [other / 8, lane / 8], before, hit))
        };
        (lane % 8..lane).step_by(8).find(may_tell).map(|other| other as u8)
    }

    /// The lanes whose samples share what is known of their pixel's centre.
    fn sharing(&self) -> u32 {
        self.uniform * NOT_CENTRES
    }

    fn shade(&mut self) {
        let tracer = &self.pass.tracer;
        let environment = tracer.environment;
        let halos = self.halos();
        let mirrors = self.mirrors();
        let lamps = if environment.night { self.lamps() } else { [(0, Vec3A::ZERO); LANES] };
        let sharing = self.sharing();
        let mut air = [Air { transmittance: 1.0, glow: Vec3A::ZERO }; LANES];
        for lane in lanes(self.asked) {
            let primary = &self.samples[lane];
            let shares = sharing >> lane & 1 == 1;
            if usize::from(self.told_by[lane]) != lane {
                continue;
            }
            let Some(hit) = &primary.hit else {
                self.shaded[lane] = sky_sample(environment, &primary.ray, halos[lane]);
                continue;
            };
            let Some((point, bsdf)) = self.surface(lane) else { continue };
            air[lane] = match shares {
                true => air[lane % 8],
                false => Air::before(environment, &primary.ray, hit.t, halos[lane]),
            };
            let (lamps_free, lamp_light) = lamps[if shares { lane % 8 } else { lane }];
            let direct = if environment.night { lamp_light } else { sun_light(environment, point, bsdf) };
            let lamps_free = if shares { 0 } else { lamps_free };
            let light = SampleLight { air: air[lane], direct, lamps_free, mirror: mirrors[lane] };
            self.shaded[lane] = surface_sample(primary.irradiance, point, bsdf, &light);
        }
    }

    /// BSDFs of the uniform pixels' centres.
    fn bsdfs(&self) -> [Option<PackedBsdf>; 8] {
        std::array::from_fn(|pixel| {
            let centre = self.surface(pixel).filter(|_| self.uniform >> pixel & 1 == 1);
            centre.map(|(_, bsdf)| PackedBsdf::new(bsdf))
        })
    }

    /// What a pixel's centre shows in all layers but RGB.
    fn layers(&self, pixel: usize) -> PixelLayers {
        let BakePass { settings, camera, .. } = self.pass;
        let seen = |(point, bsdf): (&SurfaceInteraction<'_>, &Bsdf)| {
            PixelLayers::new(settings.layers, camera, &self.samples[pixel].ray, point, || bsdf.clone())
        };
        let nothing = if is_nowhere(&self.samples[pixel].ray) { PixelLayers::UNLIT } else { PixelLayers::SKY };
        self.surface(pixel).map_or(nothing, seen)
    }

    /// Glow of lamps before the samples that do not share that of their centre.
    fn halos(&self) -> [Vec3A; LANES] {
        let mut all = [Vec3A::ZERO; LANES];
        let sharing = self.sharing();
        for (row, (eight, glow)) in self.samples.chunks(8).zip(all.chunks_mut(8)).enumerate() {
            if self.asked & !sharing & 0xff << (8 * row) == 0 {
                continue;
            }
            let directions = [0, 1, 2].map(|axis| f32x8::new(std::array::from_fn(|i| eight[i].ray.direction[axis])));
            let distance = |i: usize| eight[i].hit.as_ref().map_or(f32::MAX, |hit| hit.t);
            let distances = f32x8::new(std::array::from_fn(distance));
            if self.pass.camera.lens.is_central() {
                let lens = Vec3A::from(self.pass.camera.position);
                glow.copy_from_slice(&halos8(&self.pass.tracer, lens, &directions, distances));
            } else {
                for (glow, PrimarySample { ray, hit, .. }) in glow.iter_mut().zip(eight) {
                    *glow = halos(&self.pass.tracer, ray, hit.as_ref().map_or(f32::MAX, |hit| hit.t));
                }
            }
        }
        all
    }

    /// What the samples' coats mirror, and how far they see.
    fn mirrors(&self) -> [(Vec3A, f32); LANES] {
        let tracer = &self.pass.tracer;
        let mut mirrors = [(Vec3A::ZERO, 0.0); LANES];
        let mut rays = RayStream::<SAMPLES>::NONE;
        let mut asked = 0u32;
        let mut weights = [Vec3A::ZERO; LANES];
        let mut footprints_m = [0.0; LANES];
        for lane in lanes(self.asked) {
            let Some((point, bsdf)) = self.surface(lane) else { continue };
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
        let surface = |lane: usize| self.surface(lane).filter(|_| self.asked >> lane & 1 == 1);
        let facets = std::array::from_fn(|lane| surface(lane).map(|(point, _)| point.facet()));
        let free = lamps_free32(tracer, &facets, self.asked & !self.sharing());
        std::array::from_fn(|lane| {
            let light = surface(lane).filter(|_| free[lane] != 0);
            let sum = light.map_or(Vec3A::ZERO, |(point, bsdf)| lamp_sum(tracer, &point.facet(), bsdf, free[lane]));
            (free[lane], sum)
        })
    }
}
