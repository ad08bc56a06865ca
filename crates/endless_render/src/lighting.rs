//! Lighting baked once for what cameras view, which stays the same while objects move.

use crate::accel::Ray;
use crate::indirect::{IndirectRays, PROBE_BOUNCES, ProbeGrid, ProbeRegion, TapeStack};
use crate::light::{Environment, HaloGrid, LampMaps, Lamps, lamp_power};
use crate::scene::{FrameScene, StaticScene};
use crate::settings::RenderSettings;
use crate::shade::{Tracer, halos8};
use endless_world::{CameraRay, PinholeCamera};
use glam::{Vec2, Vec3A};
use std::sync::Arc;
use wide::f32x8;

/// Rectangle of ground that cameras see within the reach of probes, and the height of that ground.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ViewedArea {
    low: Vec2,
    high: Vec2,
    ground: f32,
}

impl ViewedArea {
    /// Around nothing.
    pub(crate) const EMPTY: Self = Self { low: Vec2::ZERO, high: Vec2::ZERO, ground: 0.0 };

    /// Of one camera.
    pub(crate) fn of(still: &StaticScene, camera: &PinholeCamera) -> Self {
        let eye = Vec2::new(camera.position.x, camera.position.y);
        let (mut low, mut high, mut ground) = (eye - 6.0, eye + 6.0, camera.position.z - 3.0);
        let size = camera.size;
        for row in 0..12 {
            for column in 0..16 {
                let (x, y) =
                    (size.width as f32 * (column as f32 + 0.5) / 16.0, size.height as f32 * (row as f32 + 0.5) / 12.0);
                let Some(CameraRay { origin, direction }) = camera.ray(x, y) else { continue };
                let ray = Ray { origin: origin.into(), direction: direction.into(), tmax: 110.0 };
                if let Some(hit) = still.accel.closest(&ray) {
                    let p = ray.origin + ray.direction * hit.t;
                    low = low.min(Vec2::new(p.x, p.y) - 4.0);
                    high = high.max(Vec2::new(p.x, p.y) + 4.0);
                    ground = ground.min(p.z);
                }
            }
        }
        Self { low, high, ground }
    }

    /// What is seen of either.
    pub(crate) fn joined(self, other: &Self) -> Self {
        let (low, high) = (self.low.min(other.low), self.high.max(other.high));
        Self { low, high, ground: self.ground.min(other.ground) }
    }
}

/// Sun, sky and air, what hides lamps, and light that bounced.
pub(crate) struct Lighting {
    pub(crate) environment: Arc<Environment>,
    /// Where not all of them are lit.
    pub(crate) dimmed_lamps: Option<Arc<Lamps>>,
    pub(crate) lamp_maps: LampMaps,
    /// Light that bounced; without them it is that of the open sky.
    pub(crate) probes: Option<ProbeGrid>,
}

impl Lighting {
    /// Around what cameras see, without light that bounced.
    pub(crate) fn direct(still: &StaticScene, settings: &RenderSettings, area: &ViewedArea) -> Self {
        let ViewedArea { low, high, ground } = *area;
        let dark = Self::dark(still, settings, ground);
        let lamps = if dark.environment.night { still.lamps.all() } else { &[] };
        Self { lamp_maps: LampMaps::bake(&still.accel, lamps, low, high, Lamps::range_m()), ..dark }
    }

    /// Without what hides lamps, and without light that bounced; the air lies on ground of this height, metres.
    pub(crate) fn dark(still: &StaticScene, settings: &RenderSettings, ground: f32) -> Self {
        let environment = Arc::new(Environment::new(settings, ground));
        let share = environment.lamps_lit;
        let dimmed_lamps = (environment.night && share < 1.0)
            .then(|| Arc::new(still.lamps.scaled(|_, hung| Vec3A::splat(lamp_power(hung, share)))));
        Self { environment, dimmed_lamps, lamp_maps: LampMaps::default(), probes: None }
    }

    /// The same sun, sky, air and lamps, without light that bounced.
    pub(crate) fn without_probes(&self) -> Self {
        let Self { environment, dimmed_lamps, lamp_maps, .. } = self;
        let (environment, dimmed_lamps) = (Arc::clone(environment), dimmed_lamps.clone());
        Self { environment, dimmed_lamps, lamp_maps: lamp_maps.clone(), probes: None }
    }

    /// With light that bounced; and the ends of the rays that gathered it, if these are to be kept.
    pub(crate) fn with_probes(
        self,
        still: &StaticScene,
        settings: &RenderSettings,
        area: &ViewedArea,
        indirect: IndirectRays<'_>,
    ) -> (Self, [TapeStack; PROBE_BOUNCES]) {
        let ViewedArea { low, high, ground } = *area;
        let region = ProbeRegion { low, high, ground, pattern: settings.pattern };
        let (probes, hits) = ProbeGrid::bake(&self.tracer(still, None), &region, indirect);
        (Self { probes: Some(probes), ..self }, hits)
    }

    /// The glow of lamps in the air before a camera, if there is any.
    pub(crate) fn halos(&self, still: &StaticScene, camera: &PinholeCamera) -> Option<HaloGrid> {
        let tracer = self.tracer(still, None);
        self.environment.halos().then(|| {
            HaloGrid::bake(camera.size.width, camera.size.height, |x, y, distances| {
                let direction = camera.ray_through(x, y).to_array().map(f32x8::splat);
                halos8(&tracer, Vec3A::from(camera.ray_origin(x, y)), &direction, distances)
            })
        })
    }

    /// All that light depends on at an instant, or when nothing moves.
    pub(crate) fn tracer<'a>(&'a self, still: &'a StaticScene, moving: Option<&'a FrameScene>) -> Tracer<'a> {
        let Self { environment, dimmed_lamps, lamp_maps, probes, .. } = self;
        let lamps = dimmed_lamps.as_deref().unwrap_or(&still.lamps);
        Tracer { still, moving, environment, lamps, lamp_maps, probes: probes.as_ref() }
    }
}
