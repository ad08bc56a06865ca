//! What the passes of a bake share.

use super::bake_stats::BakeStats;
use crate::accel::Ray;
use crate::camera_rays::sample_ray;
use crate::sampling::SAMPLES;
use crate::settings::RenderSettings;
use crate::shade::Tracer;
use endless_world::PinholeCamera;

/// What the passes of a bake share.
pub(super) struct BakePass<'a> {
    pub(super) tracer: Tracer<'a>,
    pub(super) camera: &'a PinholeCamera,
    pub(super) pixel_angle: f32,
    pub(super) settings: &'a RenderSettings,
    pub(super) stats: &'a BakeStats,
}

impl BakePass<'_> {
    pub(super) fn width(&self) -> usize {
        self.camera.size.width as usize
    }

    pub(super) fn ray_of(&self, sample_index: usize) -> Ray {
        let pixel = sample_index / SAMPLES;
        sample_ray(self.camera, (pixel % self.width()) as u32, (pixel / self.width()) as u32, sample_index % SAMPLES)
    }
}
