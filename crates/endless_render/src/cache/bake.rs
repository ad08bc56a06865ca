//! All that is precomputed for one camera in one scene without moving objects.

use super::bake_pass::BakePass;
use super::bake_stats::{BakeStats, timed};
use super::camera_film::{CameraFilm, FilmResponse};
use super::gbuffer::GBuffer;
use super::picture_memory::PictureMemory;
use super::tile_hierarchy::TileHierarchy;
use crate::accel::Ray;
use crate::camera_rays::sample_ray;
use crate::film::{Exposure, LONGEST_PX};
use crate::indirect::{IndirectHits, IndirectRays, TapeStack};
use crate::light::HaloGrid;
use crate::lighting::{Lighting, ViewedArea};
use crate::scene::{RigidVelocity, StaticScene};
use crate::settings::RenderSettings;
use endless_world::{CameraSite, PinholeCamera, SensorLayers};
use glam::{Vec2, Vec3A};
use std::sync::Arc;

/// The fixed-camera cache of one camera in one scene.
pub struct CameraBake {
    pub(super) camera: PinholeCamera,
    /// Angle of a pixel, radians.
    pub(super) pixel_angle: f32,
    pub(super) lighting: Arc<Lighting>,
    /// Where lamps glow in the air.
    pub(super) halos: Option<HaloGrid>,
    pub(super) gbuffer: GBuffer,
    pub(super) tiles: TileHierarchy,
    pub(super) film: CameraFilm,
    pub(super) stats: BakeStats,
    /// What frames have besides RGB, depth and instances.
    pub(super) wanted: SensorLayers,
}

impl CameraBake {
    /// Traces and shades what stands still as this camera sees it.
    pub fn bake(still: &StaticScene, settings: &RenderSettings, site: &CameraSite) -> Self {
        Self::bake_with(still, settings, site, IndirectRays::Trace).0
    }

    /// The same; gives also what another bake of this camera needs not trace again, in whatever condition.
    pub fn bake_keeping(still: &StaticScene, settings: &RenderSettings, site: &CameraSite) -> (Self, IndirectHits) {
        Self::bake_with(still, settings, site, IndirectRays::Record)
    }

    /// The same with what an earlier bake of this camera kept: of the same scene, site, lens, size and gathering.
    pub fn bake_reusing(
        still: &StaticScene,
        settings: &RenderSettings,
        site: &CameraSite,
        hits: &IndirectHits,
    ) -> Self {
        Self::bake_with(still, settings, site, IndirectRays::Replay(hits)).0
    }

    fn bake_with(
        still: &StaticScene,
        settings: &RenderSettings,
        site: &CameraSite,
        indirect: IndirectRays<'_>,
    ) -> (Self, IndirectHits) {
        let camera = settings.camera(site);
        let area = ViewedArea::of(still, &camera);
        let lighting = timed("lights", || Lighting::direct(still, settings, &area));
        let (lighting, probes) = timed("probes", || lighting.with_probes(still, settings, &area, indirect));
        let memory = PictureMemory::default();
        let (bake, [points, edges]) = Self::lit(still, settings, camera, Arc::new(lighting), None, indirect, memory);
        (bake, IndirectHits { probes, points, edges })
    }

    /// What a camera that moves sees from one place: in light that is known, and on a film that was exposed before; on one
    /// that is exposed for this picture if there is none.
    pub(crate) fn from_here(
        still: &StaticScene,
        settings: &RenderSettings,
        camera: &PinholeCamera,
        lighting: &Arc<Lighting>,
        response: Option<&Arc<FilmResponse>>,
        memory: PictureMemory,
    ) -> Self {
        Self::lit(still, settings, camera.clone(), Arc::clone(lighting), response, IndirectRays::Trace, memory).0
    }

    /// Its memory, for another picture.
    pub(crate) fn into_memory(self) -> PictureMemory {
        self.gbuffer.into_memory(self.film.radiance)
    }

    /// How this camera's film is exposed.
    pub(crate) fn exposure(&self) -> Exposure {
        self.film.response.exposure()
    }

    /// How it would be exposed if it were for this picture alone; looks at fewer pixels than a film that is exposed for it.
    pub(crate) fn wanted_exposure(&self) -> Exposure {
        self.film.wanted_exposure(&self.camera, &self.lighting.environment, &self.gbuffer)
    }

    /// All but the light.
    fn lit(
        still: &StaticScene,
        settings: &RenderSettings,
        camera: PinholeCamera,
        lighting: Arc<Lighting>,
        response: Option<&Arc<FilmResponse>>,
        indirect: IndirectRays<'_>,
        memory: PictureMemory,
    ) -> (Self, [TapeStack; 2]) {
        let pixel_angle = camera.pixel_angle_rad();
        let environment = &lighting.environment;
        let stats = BakeStats::default();
        let tracer = lighting.tracer(still, None);
        let pass = BakePass { tracer, camera: &camera, pixel_angle, settings, stats: &stats, indirect };
        let (gbuffer, radiance, tapes) = GBuffer::bake(&pass, memory);
        let sun = environment.sun.as_ref().map(|sun| sun.direction);
        let tiles = timed("tiles", || TileHierarchy::new(&camera, &gbuffer, sun));
        let film = timed("film", || CameraFilm::new(settings, &camera, environment, &gbuffer, radiance, response));
        let halos = timed("halos", || lighting.halos(still, &camera));
        let wanted = settings.layers;
        (Self { camera, pixel_angle, lighting, halos, gbuffer, tiles, film, stats, wanted }, tapes)
    }

    /// The camera.
    pub fn camera(&self) -> &PinholeCamera {
        &self.camera
    }

    /// Counters.
    pub fn stats(&self) -> &BakeStats {
        &self.stats
    }

    /// Way in the image of a point that moves, while the shutter is open, pixels.
    pub(super) fn way_in_image(&self, point: Vec3A, velocity: RigidVelocity) -> Vec2 {
        let shutter_s = self.film.response.shutter_s;
        if shutter_s == 0.0 || velocity == RigidVelocity::ZERO {
            return Vec2::ZERO;
        }
        let half = velocity.at(point) * (0.5 * shutter_s);
        let at = |p: Vec3A| self.camera.project(p.into()).map(|(at, _)| at);
        match (at(point - half), at(point + half)) {
            (Some(from), Some(to)) => self.camera.way_in_image(from, to).clamp_length_max(LONGEST_PX),
            _ => Vec2::ZERO,
        }
    }

    /// The ray of a pixel's sample.
    pub(super) fn ray(&self, x: u32, y: u32, sample: usize) -> Ray {
        sample_ray(&self.camera, x, y, sample)
    }
}
