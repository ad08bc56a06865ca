//! What the passes of a bake share.

use super::bake_stats::BakeStats;
use crate::accel::Ray;
use crate::camera_rays::{aims_through, lane_ray, sample_ray};
use crate::indirect::IndirectRays;
use crate::sampling::{SAMPLE_OFFSETS, SAMPLES};
use crate::settings::RenderSettings;
use crate::shade::Tracer;
use crate::vec3x8::Vec3x8;
use endless_world::PinholeCamera;
use wide::f32x8;

/// What the passes of a bake share.
pub(super) struct BakePass<'a> {
    pub(super) tracer: Tracer<'a>,
    pub(super) camera: &'a PinholeCamera,
    pub(super) pixel_angle: f32,
    pub(super) settings: &'a RenderSettings,
    pub(super) stats: &'a BakeStats,
    pub(super) indirect: IndirectRays<'a>,
}

impl BakePass<'_> {
    pub(super) fn width(&self) -> usize {
        self.camera.size.width as usize
    }

    pub(super) fn ray_of(&self, sample_index: usize) -> Ray {
        let pixel = sample_index / SAMPLES;
        sample_ray(self.camera, (pixel % self.width()) as u32, (pixel / self.width()) as u32, sample_index % SAMPLES)
    }

    /// One of eight rays.
    pub(super) fn ray_along(&self, directions: &Vec3x8, lane: usize) -> Ray {
        lane_ray(self.camera, directions, lane)
    }

    /// What tells the rays, their directions unless they are parallel, of eight pixels that follow each other in the
    /// picture, by sample; beyond `count`, of the last.
    pub(super) fn aims_of(&self, first: usize, count: usize) -> [Vec3x8; SAMPLES] {
        let pixel = |i: usize| first + i.min(count - 1);
        SAMPLE_OFFSETS.map(|offset| {
            let x = f32x8::new(std::array::from_fn(|i| (pixel(i) % self.width()) as f32 + 0.5 + offset.x));
            let y = f32x8::new(std::array::from_fn(|i| (pixel(i) / self.width()) as f32 + 0.5 + offset.y));
            aims_through(self.camera, x, y)
        })
    }
}
