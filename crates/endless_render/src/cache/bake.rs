//! The still picture of one camera in one scene.

use super::compose::{sun_can_light, sun_origin};
use super::spare::Spare;
use super::still_pixel::StillPixel;
use super::still_sample::{StillSample, shade_still, share_lamp_light, still_light, still_look};
use super::tile::{BLOCK, TILE, TileBounds, TileBundles};
use crate::accel::{Hit, Ray};
use crate::film::Finish;
use crate::film::{LONGEST_PX, Pad, Rain, ToneCurve, black_level, exposure};
use crate::indirect::{Air, Guide, PATTERN_SIDE, ProbeGrid, denoise, gather8, turn};
use crate::light::{Environment, HaloGrid, LampMaps, Lamps};
use crate::material::{Look, noise};
use crate::sampling::{SAMPLE_OFFSETS, SAMPLES};
use crate::scene::{RigidVelocity, StaticScene, SurfacePoint};
use crate::shade::{Tracer, footprint_m};
use endless_world::{
    CameraLook, CameraSite, ClassTag, FAR_PLANE_M, ImageSize, InstanceId, InstancePixel, PinholeCamera, TimeOfDay,
    Weather,
};
use glam::{Vec2, Vec3A};
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// What decides a camera's picture of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct RenderSettings {
    /// Weather.
    pub weather: Weather,
    /// Time of day.
    pub time_of_day: TimeOfDay,
    /// The scene's seed.
    pub seed: u64,
    /// Image size.
    pub size: ImageSize,
    /// Rays that gather indirect light for each of a pixel's samples; 4 is clean after denoising.
    pub gather_rays: u32,
    /// Which of many equal patterns the gathering rays follow: pictures that differ in nothing else differ by the grain
    /// that is left.
    pub pattern: u32,
    /// What lens, sensor and recorder do to the picture.
    pub look: CameraLook,
    /// Frames a second, for the recorder's clock.
    pub fps: f64,
    /// Keep what [`CameraBake::render_uncached`] needs (12 bytes a sample).
    pub keep_irradiance: bool,
}

impl RenderSettings {
    /// As clean as datasets are by default, at 30 frames a second.
    pub fn new(weather: Weather, time_of_day: TimeOfDay, seed: u64, size: ImageSize) -> Self {
        Self {
            weather,
            time_of_day,
            seed,
            size,
            gather_rays: 4,
            pattern: 0,
            look: CameraLook::CLEAN,
            fps: 30.0,
            keep_irradiance: false,
        }
    }
}

/// Rays traced, for reports.
#[derive(Debug, Default)]
pub struct BakeStats {
    rays: AtomicU64,
}

impl BakeStats {
    /// Rays traced since the bake began, indirect ones counted with their shadow rays; an estimate from the counts of samples.
    pub fn rays(&self) -> u64 {
        self.rays.load(Ordering::Relaxed)
    }

    pub(super) fn add(&self, rays: u64) {
        self.rays.fetch_add(rays, Ordering::Relaxed);
    }
}

/// The fixed-camera cache of one camera in one scene.
pub struct CameraBake {
    pub(super) camera: PinholeCamera,
    /// What lens, sensor and recorder do to a picture, if they do anything.
    pub(super) finish: Option<Finish>,
    pub(super) environment: Environment,
    pub(super) probes: ProbeGrid,
    /// Angle of a pixel, radians.
    pub(super) pixel_angle: f32,
    /// Four a pixel, row-major.
    pub(super) samples: Vec<StillSample>,
    /// What is asked most of each pixel's samples.
    pub(super) pixels: Vec<StillPixel>,
    /// All four samples of the pixel lie on one smooth piece that gives no light of its own: what moves does the same to
    /// the light of all four, so that is found once.
    pub(super) uniform: Vec<bool>,
    pub(super) radiance: Vec<Vec3A>,
    /// The part of `radiance` that objects standing near darken.
    pub(super) ambient: Vec<[f32; 3]>,
    pub(super) rgb: Vec<[u8; 3]>,
    pub(super) depth: Vec<f32>,
    pub(super) instance: Vec<InstancePixel>,
    pub(super) tone: ToneCurve,
    pub(super) rain: Option<Rain>,
    /// How long the shutter is open.
    pub(super) shutter_s: f32,
    pub(super) glare: f32,
    pub(super) tiles: Vec<TileBounds>,
    pub(super) tile_bundles: Vec<TileBundles>,
    pub(super) tile_columns: u32,
    pub(super) tile_rows: u32,
    pub(super) blocks: Vec<TileBounds>,
    pub(super) block_bundles: Vec<TileBundles>,
    pub(super) block_columns: u32,
    /// Height of the lowest surface in view.
    pub(super) lowest: f32,
    /// At night, the look of each uniform pixel's centre: vehicle lights sweep much of the picture.
    pub(super) looks: Vec<Look>,
    pub(super) lamp_maps: LampMaps,
    /// Where lamps glow in the air.
    pub(super) halos: Option<HaloGrid>,
    /// Per sample, if kept.
    pub(super) irradiance: Vec<[f32; 3]>,
    pub(super) stats: BakeStats,
    /// Copies of `radiance`.
    pub(super) spare: Spare<Vec<Vec3A>>,
    pub(super) blur_pads: Spare<Pad>,
}

impl CameraBake {
    /// Traces and shades the still town as this camera sees it.
    pub fn bake(still: &StaticScene, settings: &RenderSettings, site: &CameraSite) -> Self {
        let camera = PinholeCamera::new(site, settings.size).with_distortion(settings.look.distortion);
        let pixel_angle = 1.0 / camera.intrinsics.fx;
        let (low, high, ground) = viewed_area(still, &camera);
        let environment = Environment::new(settings.weather, settings.time_of_day, settings.seed, ground);
        let lamps = if environment.night { still.lamps.all() } else { &[] };
        let lamp_maps = LampMaps::bake(&still.accel, lamps, low, high, Lamps::range_m());
        let air = Air { low, high, ground, pattern: settings.pattern };
        let probes = ProbeGrid::bake(still, &environment, &lamp_maps, &air);
        let stats = BakeStats::default();
        let tracer =
            Tracer { still, moving: None, environment: &environment, lamp_maps: &lamp_maps, probes: Some(&probes) };
        let pass = Pass { tracer, camera: &camera, pixel_angle, settings, stats: &stats };
        let seen = pass.trace();
        let irradiance = pass.irradiance(&seen);
        let mut samples = pass.shade(&seen, &irradiance);
        let tile_columns = settings.size.width.div_ceil(TILE);
        let tile_rows = settings.size.height.div_ceil(TILE);
        let tiles = pass.tile_bounds(&samples, tile_columns, tile_rows);
        let (blocks, block_columns) = join_tiles(&tiles, tile_columns, tile_rows);
        let sun = environment.sun.as_ref().map(|sun| sun.direction);
        let bundles = |bounds: &[TileBounds]| bounds.iter().map(|b| b.bundles(sun)).collect();
        let (tile_bundles, block_bundles) = (bundles(&tiles), bundles(&blocks));
        let (uniform, depth, instance) = pass.labels(&samples);
        if environment.night {
            samples.par_chunks_mut(SAMPLES).zip(&uniform).filter(|(_, u)| **u).for_each(|(s, _)| share_lamp_light(s));
        }
        let lowest = blocks.iter().map(|b| b.points.low.z).fold(f32::INFINITY, f32::min);
        let looks = if environment.night { pass.looks(&samples, &uniform) } else { Vec::new() };
        let halos = environment.halos().then(|| {
            HaloGrid::bake(settings.size.width, settings.size.height, |x, y, distance| {
                let direction = Vec3A::from(camera.ray_through(x, y));
                let ray = Ray { origin: Vec3A::from(camera.position), direction, tmax: f32::MAX };
                super::still_sample::halos(&tracer, &ray, distance)
            })
        });
        drop(seen);
        let pixels = samples.as_chunks().0.iter().map(StillPixel::new).collect();
        let (radiance, ambient): (Vec<Vec3A>, Vec<[f32; 3]>) = samples
            .par_chunks(SAMPLES)
            .map(|pixel| {
                let (radiance, ambient) = still_light(pixel, &environment);
                (radiance, ambient.to_array())
            })
            .unzip();
        let width = settings.size.width as usize;
        let black = black_level(&radiance, |i| {
            let (ray, still) = (sample_ray(&camera, (i % width) as u32, (i / width) as u32, 0), &samples[i * SAMPLES]);
            let fog = &environment.fog;
            let left = fog.transmittance(ray.origin, ray.direction, still.hit.t);
            if still.is_sky() { Vec3A::ZERO } else { fog.in_scatter(ray.direction, left) }
        });
        let exposure = exposure(&radiance, black, environment.exposure_key);
        let tone = ToneCurve::new(exposure, environment.white_balance(), black);
        let rgb = radiance.iter().map(|&r| tone.apply(r)).collect();
        let rain = rain(&environment, exposure, settings.seed);
        let glare = environment.glare;
        let keep = settings.keep_irradiance;
        Self {
            camera,
            probes,
            pixel_angle,
            samples,
            pixels,
            uniform,
            radiance,
            ambient,
            rgb,
            depth,
            instance,
            tone,
            rain,
            glare,
            shutter_s: settings.look.shutter_s.min(1.0 / settings.fps as f32),
            finish: Finish::new(&settings.look, settings.size, settings.fps, settings.seed, environment.rain > 0.0),
            tiles,
            tile_bundles,
            tile_columns,
            tile_rows,
            blocks,
            block_bundles,
            block_columns,
            lowest,
            looks,
            lamp_maps,
            halos,
            irradiance: if keep { irradiance.iter().map(Vec3A::to_array).collect() } else { Vec::new() },
            environment,
            stats,
            spare: Spare::default(),
            blur_pads: Spare::default(),
        }
    }

    /// The camera.
    pub fn camera(&self) -> &PinholeCamera {
        &self.camera
    }

    /// Counters.
    pub fn stats(&self) -> &BakeStats {
        &self.stats
    }

    /// Whether all of a frame must be developed again: glare and lens change every pixel.
    pub(super) fn spreads_light(&self) -> bool {
        self.glare > 0.0 || self.finish.as_ref().is_some_and(Finish::has_lens)
    }

    /// Way in the image of a point that moves, while the shutter is open, pixels.
    pub(super) fn way_in_image(&self, point: Vec3A, velocity: RigidVelocity) -> Vec2 {
        if self.shutter_s == 0.0 || velocity == RigidVelocity::ZERO {
            return Vec2::ZERO;
        }
        let half = velocity.at(point) * (0.5 * self.shutter_s);
        let at = |p: Vec3A| self.camera.project(p.into()).map(|(at, _)| at);
        match (at(point - half), at(point + half)) {
            (Some(from), Some(to)) => (to - from).clamp_length_max(LONGEST_PX),
            _ => Vec2::ZERO,
        }
    }

    /// The ray of a pixel's sample.
    pub(super) fn ray(&self, x: u32, y: u32, sample: usize) -> Ray {
        sample_ray(&self.camera, x, y, sample)
    }
}

/// Unit ray from the lens through a pixel's sample.
pub(super) fn sample_ray(camera: &PinholeCamera, x: u32, y: u32, sample: usize) -> Ray {
    let offset = SAMPLE_OFFSETS[sample];
    let direction = camera.ray_through(x as f32 + 0.5 + offset.x, y as f32 + 0.5 + offset.y);
    Ray { origin: Vec3A::from(camera.position), direction: Vec3A::from(direction), tmax: f32::MAX }
}

/// Rain in front of the lens: as bright as the picture's own surroundings make drops.
fn rain(environment: &Environment, exposure: f32, seed: u64) -> Option<Rain> {
    (environment.rain > 0.0).then(|| {
        let radiance =
            if environment.night { Vec3A::new(1.0, 0.9, 0.78) * (0.16 / exposure) } else { environment.sky.mean * 1.1 };
        let slant = (noise::cell1(seed as u32, 5) - 0.5) * 0.3;
        Rain { drops: (2200.0 * environment.rain) as u32, radiance, slant, seed }
    })
}

/// Rectangle of ground that a camera sees within the reach of probes, and the height of that ground.
fn viewed_area(still: &StaticScene, camera: &PinholeCamera) -> (Vec2, Vec2, f32) {
    let eye = Vec2::new(camera.position.x, camera.position.y);
    let (mut low, mut high, mut ground) = (eye - 6.0, eye + 6.0, camera.position.z - 3.0);
    let size = camera.size;
    for row in 0..12 {
        for column in 0..16 {
            let (x, y) =
                (size.width as f32 * (column as f32 + 0.5) / 16.0, size.height as f32 * (row as f32 + 0.5) / 12.0);
            let direction = Vec3A::from(camera.ray_through(x, y));
            let ray = Ray { origin: Vec3A::from(camera.position), direction, tmax: 110.0 };
            if let Some(hit) = still.accel.closest(&ray) {
                let p = ray.origin + ray.direction * hit.t;
                low = low.min(Vec2::new(p.x, p.y) - 4.0);
                high = high.max(Vec2::new(p.x, p.y) + 4.0);
                ground = ground.min(p.z);
            }
        }
    }
    (low, high, ground)
}

fn join_tiles(tiles: &[TileBounds], columns: u32, rows: u32) -> (Vec<TileBounds>, u32) {
    let (block_columns, block_rows) = (columns.div_ceil(BLOCK), rows.div_ceil(BLOCK));
    let mut blocks = vec![TileBounds::EMPTY; (block_columns * block_rows) as usize];
    for (i, tile) in tiles.iter().enumerate() {
        let (x, y) = (i as u32 % columns / BLOCK, i as u32 / columns / BLOCK);
        blocks[(y * block_columns + x) as usize].join(tile);
    }
    (blocks, block_columns)
}

/// What the first pass found for each sample.
struct Seen {
    hits: Vec<Option<Hit>>,
    sun_free: Vec<u8>,
}

/// The passes of a bake.
struct Pass<'a> {
    tracer: Tracer<'a>,
    camera: &'a PinholeCamera,
    pixel_angle: f32,
    settings: &'a RenderSettings,
    stats: &'a BakeStats,
}

impl Pass<'_> {
    fn width(&self) -> usize {
        self.camera.size.width as usize
    }

    fn ray_of(&self, sample_index: usize) -> Ray {
        let pixel = sample_index / SAMPLES;
        sample_ray(self.camera, (pixel % self.width()) as u32, (pixel / self.width()) as u32, sample_index % SAMPLES)
    }

    /// Visibility of every sample, and of the sun's disc from there, in packets of eight neighbours.
    fn trace(&self) -> Seen {
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
        Seen { hits, sun_free }
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
            let point = SurfacePoint::new(&self.tracer.still.instances, &rays[i], &hit);
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
    fn irradiance(&self, seen: &Seen) -> Vec<Vec3A> {
        const SKY: Guide = Guide { position: Vec3A::ZERO, normal: Vec3A::ZERO, reach_m: 1.0 };
        let width = self.width();
        let mut all = vec![Vec3A::ZERO; seen.hits.len()];
        for sample in 0..SAMPLES {
            let mut guides = vec![SKY; self.camera.size.pixels()];
            let mut light = vec![Vec3A::ZERO; guides.len()];
            guides.par_chunks_mut(width).zip(light.par_chunks_mut(width)).enumerate().for_each(
                |(y, (guides, light))| {
                    // Every fourth pixel of 32 shares a pattern of rays.
                    for block in (0..width).step_by(8 * PATTERN_SIDE) {
                        for first in block..(block + PATTERN_SIDE).min(width) {
                            self.gather_eight(seen, y, first, sample, guides, light);
                        }
                    }
                },
            );
            let clean = denoise(width, &guides, light, 5);
            all.par_chunks_mut(SAMPLES).zip(clean).for_each(|(pixel, light)| pixel[sample] = light);
        }
        self.stats.add(seen.hits.len() as u64 * u64::from(self.settings.gather_rays) * 2);
        all
    }

    /// Gathers for eight pixels of a row, [`PATTERN_SIDE`] apart.
    fn gather_eight(
        &self,
        seen: &Seen,
        y: usize,
        first: usize,
        sample: usize,
        guides: &mut [Guide],
        light: &mut [Vec3A],
    ) {
        let column = |i: usize| first + i * PATTERN_SIDE;
        let points: [Option<SurfacePoint<'_>>; 8] = std::array::from_fn(|i| {
            let index = (y * self.width() + column(i)) * SAMPLES + sample;
            let hit = seen.hits[..(y + 1) * self.width() * SAMPLES].get(index)?.as_ref()?;
            Some(SurfacePoint::new(&self.tracer.still.instances, &self.ray_of(index), hit))
        });
        let turn = turn(first, y, sample, self.settings.pattern);
        let gathered = gather8(&self.tracer, &points, turn, self.settings.gather_rays);
        for (i, point) in points.iter().enumerate() {
            let Some(point) = point else { continue };
            let reach_m = footprint_m(point, self.pixel_angle).max(0.01);
            guides[column(i)] = Guide { position: point.position, normal: point.normal, reach_m };
            light[column(i)] = gathered[i];
        }
    }

    /// Shades every sample.
    fn shade(&self, seen: &Seen, irradiance: &[Vec3A]) -> Vec<StillSample> {
        self.stats.add(seen.hits.len() as u64);
        (0..seen.hits.len())
            .into_par_iter()
            .map(|i| {
                let ray = self.ray_of(i);
                still_sample(
                    &self.tracer,
                    &ray,
                    seen.hits[i].as_ref(),
                    seen.sun_free[i],
                    irradiance[i],
                    i % SAMPLES,
                    self.pixel_angle,
                )
            })
            .collect()
    }

    fn tile_bounds(&self, samples: &[StillSample], columns: u32, rows: u32) -> Vec<TileBounds> {
        (0..columns * rows)
            .into_par_iter()
            .map(|tile| {
                let mut bounds = TileBounds::EMPTY;
                let (x0, y0) = (tile % columns * TILE, tile / columns * TILE);
                for y in y0..(y0 + TILE).min(self.camera.size.height) {
                    for x in x0..(x0 + TILE).min(self.camera.size.width) {
                        for sample in 0..SAMPLES {
                            let i = (y as usize * self.width() + x as usize) * SAMPLES + sample;
                            self.add_to_bounds(&mut bounds, &samples[i], i);
                        }
                    }
                }
                bounds
            })
            .collect()
    }

    fn add_to_bounds(&self, bounds: &mut TileBounds, still: &StillSample, index: usize) {
        if still.is_sky() {
            return;
        }
        let ray = self.ray_of(index);
        let position = ray.origin + ray.direction * still.hit.t;
        bounds.points.add(position);
        if still.sun_free != 0 {
            bounds.sunlit.add(position);
        }
        bounds.lens |= still.flags & StillSample::LENS != 0;
        if still.mirrors() {
            bounds.mirrors.add(position);
            bounds.mirror_directions.add(Vec3A::from(still.mirror_direction));
            bounds.mirror_reach = bounds.mirror_reach.max(still.mirror_t);
        }
    }

    /// The look of every uniform pixel's centre.
    fn looks(&self, samples: &[StillSample], uniform: &[bool]) -> Vec<Look> {
        samples
            .par_chunks_exact(SAMPLES)
            .zip(uniform)
            .enumerate()
            .map(|(pixel, (group, &uniform))| {
                if !uniform {
                    return Look::matte(Vec3A::ZERO, Vec3A::Z);
                }
                let ray = self.ray_of(pixel * SAMPLES);
                let point = SurfacePoint::new(&self.tracer.still.instances, &ray, &group[0].hit);
                still_look(&point, self.tracer.environment, 0, self.pixel_angle)
            })
            .collect()
    }

    /// Whether a pixel's samples lie on one flat piece of one surface.
    fn is_uniform(&self, pixel: usize, group: &[StillSample]) -> bool {
        if group.iter().any(StillSample::is_sky) {
            return false;
        }
        let point = |s: usize| {
            SurfacePoint::new(&self.tracer.still.instances, &self.ray_of(pixel * SAMPLES + s), &group[s].hit)
        };
        if group[0].flags & StillSample::LENS != 0 {
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

    /// Uniformity, depth, class and instance of every pixel.
    fn labels(&self, samples: &[StillSample]) -> (Vec<bool>, Vec<f32>, Vec<InstancePixel>) {
        let mut uniform = Vec::with_capacity(self.camera.size.pixels());
        let mut depth = Vec::with_capacity(self.camera.size.pixels());
        let mut instance = Vec::with_capacity(self.camera.size.pixels());
        for (pixel, group) in samples.chunks_exact(SAMPLES).enumerate() {
            let centre = &group[0];
            uniform.push(self.is_uniform(pixel, group));
            if centre.is_sky() {
                depth.push(FAR_PLANE_M);
                instance.push(InstancePixel { tag: ClassTag::Sky, id: InstanceId::STUFF });
                continue;
            }
            let ray = self.ray_of(pixel * SAMPLES);
            let point = SurfacePoint::new(&self.tracer.still.instances, &ray, &centre.hit);
            depth.push(planar_depth(self.camera, &ray, centre.hit.t));
            instance.push(InstancePixel { tag: point.tag(), id: point.instance.id });
        }
        (uniform, depth, instance)
    }
}

/// Shades a sample, surface or sky.
pub(super) fn still_sample(
    tracer: &Tracer<'_>,
    ray: &Ray,
    hit: Option<&Hit>,
    sun_free: u8,
    irradiance: Vec3A,
    sample: usize,
    pixel_angle: f32,
) -> StillSample {
    match hit {
        Some(hit) => shade_still(tracer, ray, hit, sun_free, irradiance, sample, pixel_angle),
        None => {
            let environment = tracer.environment;
            let halos = super::still_sample::halos(tracer, ray, f32::MAX);
            let sky = environment.sky.radiance(ray.direction);
            // Fog and rain fill the whole way to the sky; thin haze is part of the sky model already.
            let air = if environment.fog.is_dense() {
                environment.fog.through(sky, ray.origin, ray.direction, 2000.0)
            } else {
                sky
            };
            StillSample::sky(air + sun_disc(environment, ray.direction) + halos)
        }
    }
}

/// The sun itself, where a ray meets its disc.
fn sun_disc(environment: &Environment, direction: Vec3A) -> Vec3A {
    let Some(sun) = &environment.sun else { return Vec3A::ZERO };
    let cosine = direction.dot(sun.direction);
    // Disc, and an aureole that haze makes around it.
    let disc = if cosine > 0.999_975 { sun.illuminance * 200.0 } else { Vec3A::ZERO };
    let around = ((cosine - 0.97) / 0.03).max(0.0);
    disc + sun.illuminance * (0.06 * around * around * around)
}

/// Depth along the optical axis, never beyond the far plane.
pub(super) fn planar_depth(camera: &PinholeCamera, ray: &Ray, t: f32) -> f32 {
    let forward = Vec3A::from(camera.world_from_camera.z_axis);
    (t * ray.direction.dot(forward)).min(FAR_PLANE_M)
}
