//! The first pass of a bake: what each sample sees, what it sees of the sun, and which pixels are uniform.

use super::bake_pass::BakePass;
use super::packed_hit::PackedHit;
use super::primary_hits::{PackedNormals, PrimaryHits};
use super::sun_rays::{sun_can_light, sun_origin};
use crate::accel::{Ray, RayStream, first_lanes, lanes};
use crate::camera_rays::{aims8, set_row};
use crate::light::{SUN_SAMPLES, Sun};
use crate::sampling::SAMPLES;
use crate::scene::SurfaceInteraction;
use crate::work_share;
use rayon::prelude::*;
use wide::f32x8;

/// Up to eight neighbouring pixels of a row.
struct EightPixels<'a> {
    distances: &'a mut [[f32; SAMPLES]],
    hits: &'a mut [[PackedHit; SAMPLES]],
    normals: &'a mut [[PackedNormals; SAMPLES]],
    sun_free: &'a mut [[u8; SAMPLES]],
    uniform: &'a mut [bool],
}

impl BakePass<'_> {
    /// Visibility of every sample, and of the sun's disc from there, in bundles of eight neighbours.
    pub(super) fn trace(&self) -> PrimaryHits {
        let width = self.width();
        let mut found = PrimaryHits::new(width, self.camera.size.height as usize);
        let PrimaryHits { distances, sun_free, uniform, surfaces, .. } = &mut found;
        let rows = distances.par_chunks_mut(width).zip(sun_free.par_chunks_mut(width));
        let rows = rows.zip(uniform.par_chunks_mut(width)).zip(surfaces.par_iter_mut());
        rows.enumerate().with_max_len(work_share::ROWS).for_each(
            |(y, (((distances, sun_free), uniform), surfaces))| {
                let eights = distances.chunks_mut(8).zip(sun_free.chunks_mut(8)).zip(uniform.chunks_mut(8));
                let eights = eights.zip(surfaces.hits.chunks_mut(8).zip(surfaces.normals.chunks_mut(8)));
                for (eight, (((distances, sun_free), uniform), (hits, normals))) in eights.enumerate() {
                    let pixels = EightPixels { distances, hits, normals, sun_free, uniform };
                    self.trace_eight(y as u32, 8 * eight as u32, pixels);
                }
            },
        );
        self.stats.add((found.uniform.len() * SAMPLES) as u64 * 2);
        found
    }

    /// All samples of up to eight pixels.
    fn trace_eight(&self, y: u32, first: u32, eight: EightPixels<'_>) {
        let EightPixels { distances, hits, normals, sun_free, uniform } = eight;
        let count = uniform.len() as u32;
        let mut rays = RayStream::<SAMPLES>::NONE;
        rays.tmax = [f32x8::splat(f32::MAX); SAMPLES];
        for sample in 0..SAMPLES {
            set_row(self.camera, &mut rays, sample, aims8(self.camera, first, first + count, y, sample));
        }
        let active = first_lanes(uniform.len());
        let found = self.tracer.still.accel.closest32(&rays, active);
        let mut points: [Option<SurfaceInteraction<'_>>; 8 * SAMPLES] = [const { None }; 8 * SAMPLES];
        for lane in lanes(active) {
            let Some(hit) = found.get(lane) else { continue };
            distances[lane % 8][lane / 8] = hit.t;
            hits[lane % 8][lane / 8] = PackedHit::new(&hit);
            let point = SurfaceInteraction::new(&self.tracer.still.instances, &rays.ray(lane), &hit);
            normals[lane % 8][lane / 8] = PackedNormals::new(&point);
            points[lane] = Some(point);
        }
        for (pixel, uniform) in uniform.iter_mut().enumerate() {
            *uniform = is_uniform(std::array::from_fn(|sample| points[8 * sample + pixel].as_ref()));
        }
        let Some(sun) = &self.tracer.environment.sun else { return };
        let mut to_sun = rays.clone();
        let mut asked = 0u32;
        for lane in lanes(active) {
            let Some(point) = points[lane].as_ref().filter(|point| sun_can_light(point, sun.direction)) else {
                continue;
            };
            asked |= 1 << lane;
            to_sun.set(lane, &Ray { origin: sun_origin(&point.facet(), sun.direction), ..rays.ray(lane) });
        }
        let blocked = self.sun_blocked(sun, &mut to_sun, asked);
        for lane in lanes(asked) {
            let bits = (0..SUN_SAMPLES).map(|part| u8::from(blocked[part] >> lane & 1 == 0) << part);
            sun_free[lane % 8][lane / 8] = bits.sum();
        }
    }

    /// Which of a bundle's rays what stands still keeps from each part of the sun's disc. All parts are asked only near
    /// where the first, of which each sample has another, says different things.
    fn sun_blocked(&self, sun: &Sun, rays: &mut RayStream<SAMPLES>, asked: u32) -> [u32; SUN_SAMPLES] {
        /// Half-way between the middle of the disc and its rim.
        const FIRST: usize = 1;
        let mut part_blocked = |part: usize, asked: u32| {
            for (sample, disc) in sun.disc.iter().enumerate() {
                for (axis, along) in rays.direction.iter_mut().zip(disc[part].to_array()) {
                    axis[sample] = f32x8::splat(along);
                }
            }
            if asked == 0 { 0 } else { self.tracer.still.accel.occluded32(rays, asked) }
        };
        let first = part_blocked(FIRST, asked);
        let again = near_a_shadows_edge(first, asked & !first) & asked;
        if again == 0 {
            return [first; SUN_SAMPLES];
        }
        std::array::from_fn(|part| if part == FIRST { first } else { first & !again | part_blocked(part, again) })
    }
}

/// The lanes of pixels of which some samples lie in shadow and others in light, or pixels near them in the row do.
fn near_a_shadows_edge(shaded: u32, lit: u32) -> u32 {
    /// Pixels to each side.
    const REACH: u32 = 3;
    let pixels = |lanes: u32| lanes.to_ne_bytes().into_iter().fold(0, |all, row| all | u32::from(row));
    let near = |pixels: u32| (1..=REACH).fold(pixels, |all, step| all | pixels << step | pixels >> step);
    (near(pixels(shaded)) & near(pixels(lit)) & 0xff) * 0x0101_0101
}

/// Whether a pixel's samples lie on one flat piece of one surface.
fn is_uniform(points: [Option<&SurfaceInteraction<'_>>; SAMPLES]) -> bool {
    let [Some(centre), others @ ..] = points else { return false };
    let same_piece = |p: &SurfaceInteraction<'_>| {
        std::ptr::eq(p.instance, centre.instance)
            && p.material == centre.material
            && p.normal.dot(centre.normal) > 0.995
            && (p.position - centre.position).dot(centre.geometric_normal).abs() < 0.02
    };
    !centre.is_signal_lens() && others.into_iter().all(|p| p.is_some_and(same_piece))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cache::bake_stats::BakeStats;
    use crate::cache::sparse_primary::KeptRow;
    use crate::indirect::IndirectRays;
    use crate::lighting::{Lighting, ViewedArea};
    use crate::scene::{Geometry, Instance, StaticScene};
    use crate::settings::RenderSettings;
    use endless_scene::{Material, MeshBuilder, Surface};
    use endless_world::{CameraSite, ClassTag, ImageSize, LensModel, Mount, TimeOfDay, Weather};
    use glam::{Affine3A, Vec3};

    fn cuboid(low: Vec3, high: Vec3) -> Instance {
        let mut builder = MeshBuilder::new();
        builder.cuboid(low, high, Material::new(Surface::Concrete, [0.4; 3], ClassTag::Static));
        Instance::new(&Geometry::new(builder.finish()), Affine3A::IDENTITY)
    }

    /// A floor, a wall, and a fence of posts as thin as three centimetres.
    fn street() -> StaticScene {
        let floor = cuboid(Vec3::new(-60.0, -60.0, -1.0), Vec3::new(60.0, 60.0, 0.0));
        let wall = cuboid(Vec3::new(14.0, -12.0, 0.0), Vec3::new(15.0, -2.0, 9.0));
        let posts = (0..30).map(|k| {
            let foot = Vec3::new(9.0 + 0.1 * k as f32, -3.0 + 0.4 * k as f32, 0.0);
            cuboid(foot, foot + Vec3::new(0.03, 0.03, 1.6))
        });
        StaticScene::new([floor, wall].into_iter().chain(posts).collect(), &[])
    }

    /// Asking all of the disc only where a bundle is not of one mind errs on few samples.
    #[test]
    fn the_sun_is_seen_as_if_each_part_of_its_disc_were_asked() {
        let still = street();
        let size = ImageSize { width: 161, height: 91 };
        for time in [TimeOfDay::Morning, TimeOfDay::Afternoon] {
            let settings = RenderSettings::new(Weather::ClearSky, time, 3, size);
            let site = CameraSite {
                name: "pole".to_owned(),
                position: [0.0, 0.0, 6.0],
                yaw_rad: 0.0,
                down_tilt_rad: 0.35,
                horizontal_fov_rad: 1.1,
                lens: LensModel::Pinhole,
                mount: Mount::Pole,
                roll_rad: 0.0,
            };
            let camera = settings.camera(&site);
            let lighting = Lighting::direct(&still, &settings, &ViewedArea::of(&still, &camera));
            let (tracer, stats) = (lighting.tracer(&still, None), BakeStats::default());
            let (settings, indirect) = (&settings, IndirectRays::Trace);
            let pass = BakePass { tracer, camera: &camera, pixel_angle: 0.01, settings, stats: &stats, indirect };
            let primary = pass.trace();
            let sun = lighting.environment.sun.as_ref().expect("a clear sky");
            let (mut lit, mut partly, mut wrong) = (0, 0, 0);
            for index in 0..size.pixels() * SAMPLES {
                let ray = pass.ray_of(index);
                let hit = still.accel.closest(&ray).and_then(|hit| PackedHit::new(&hit).at(hit.t));
                assert_eq!(primary.pixel(index / SAMPLES).hit(index % SAMPLES), hit);
                let Some(hit) = hit else { continue };
                let point = SurfaceInteraction::new(&still.instances, &ray, &hit);
                let origin = sun_origin(&point.facet(), sun.direction);
                let sees = |&direction| !still.accel.occluded(&Ray { origin, direction, tmax: f32::MAX });
                let parts = sun.disc[index % SAMPLES].iter().map(|direction| u32::from(sees(direction)));
                let asked = if sun_can_light(&point, sun.direction) { parts.sum::<u32>() } else { 0 };
                lit += asked;
                partly += u32::from(asked % SUN_SAMPLES as u32 != 0);
                wrong += asked.abs_diff(primary.sun_free[index / SAMPLES][index % SAMPLES].count_ones());
            }
            assert!(lit > 20_000 && partly > 100, "{lit} parts reach a sample, {partly} samples see part of the disc");
            assert!(wrong * 500 < lit, "{wrong} of {lit} parts are taken for others in the {time}");
            // For one instant pixels are asked, not samples.
            let (sparse, width) = (pass.trace_sparse(), size.width as usize);
            let mut apart = 0;
            for (y, full) in primary.sun_free.chunks(width).enumerate() {
                let mut distances = vec![[f32::MAX; SAMPLES]; width];
                let (mut sun_free, mut uniform) = (vec![[0; SAMPLES]; width], vec![false; width]);
                let kept = KeptRow { distances: &mut distances, sun_free: &mut sun_free, uniform: &mut uniform };
                sparse.trace_row(y, kept);
                let parts = |pixel: &[u8; SAMPLES]| pixel.iter().map(|free| free.count_ones()).sum::<u32>();
                apart += full.iter().zip(&sun_free).map(|(a, b)| parts(a).abs_diff(parts(b))).sum::<u32>();
            }
            assert!(apart * 40 < lit, "{apart} of {lit} parts differ by few rays in the {time}");
        }
    }
}
