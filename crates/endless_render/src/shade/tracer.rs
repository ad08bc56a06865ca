//! Rays against the static and the moving part of a scene together.

use crate::accel::{Hit, Ray, RayStream};
use crate::indirect::ProbeGrid;
use crate::light::{Environment, LampMaps, Lamps};
use crate::scene::{FrameScene, StaticScene, SurfaceInteraction};
use glam::Vec3A;

/// All that light depends on at one instant.
#[derive(Clone, Copy)]
pub(crate) struct Tracer<'a> {
    pub(crate) still: &'a StaticScene,
    /// `None` while baking.
    pub(crate) moving: Option<&'a FrameScene>,
    pub(crate) environment: &'a Environment,
    /// With the power that they have in this light; the same as those of `still` otherwise.
    pub(crate) lamps: &'a Lamps,
    pub(crate) lamp_maps: &'a LampMaps,
    /// `None` while the probes themselves are made.
    pub(crate) probes: Option<&'a ProbeGrid>,
}

/// What a ray met.
#[derive(Clone, Copy)]
pub(crate) struct SceneHit {
    pub(crate) hit: Hit,
    pub(crate) moving: bool,
}

impl SceneHit {
    /// On what stands still.
    pub(crate) fn still(hit: Hit) -> Self {
        Self { hit, moving: false }
    }
}

impl<'a> Tracer<'a> {
    /// The nearest surface; what stands still wins a tie.
    pub(crate) fn closest(&self, ray: &Ray) -> Option<SceneHit> {
        let still = self.still.accel.closest(ray);
        let shortened = Ray { tmax: still.map_or(ray.tmax, |h| h.t), ..*ray };
        let moving = self.moving.and_then(|m| m.accel.closest(&shortened));
        nearer(still, moving)
    }

    /// [`Self::occluded`] for those of eight rays whose bit is set in `active`, a bit each.
    pub(crate) fn occluded8(&self, rays: &[Ray; 8], active: u8) -> u8 {
        let by_moving = self.moving.filter(|_| active != 0).map_or(0, |m| m.accel.occluded8(rays, active));
        let open = active & !by_moving;
        if open == 0 { by_moving } else { by_moving | self.still.accel.occluded8(rays, open) }
    }

    /// [`Self::closest`] for those of a bundle's rays whose bit is set in `active`.
    pub(crate) fn closest32(&self, rays: &RayStream<4>, active: u32) -> [[Option<SceneHit>; 8]; 4] {
        let still = self.still.accel.closest32(rays, active);
        let moving = self.moving.map(|moving| moving.accel.closest32(&still.shortened(rays), active));
        let of = |lane: usize| nearer(still.get(lane), moving.as_ref().and_then(|moving| moving.get(lane)));
        std::array::from_fn(|row| std::array::from_fn(|i| of(8 * row + i)))
    }

    /// [`Self::occluded`] for those of a bundle's rays whose bit is set in `active`, a bit each.
    pub(crate) fn occluded32(&self, rays: &RayStream<4>, active: u32) -> u32 {
        let by_moving = self.moving.map_or(0, |m| m.accel.occluded32(rays, active));
        let open = active & !by_moving;
        if open == 0 { by_moving } else { by_moving | self.still.accel.occluded32(rays, open) }
    }

    /// Whether anything is in the way.
    pub(crate) fn occluded(&self, ray: &Ray) -> bool {
        self.moving.is_some_and(|m| m.accel.occluded(ray)) || self.still.accel.occluded(ray)
    }

    /// The surface that a ray met.
    pub(crate) fn point(&self, ray: &Ray, struck: &SceneHit) -> SurfaceInteraction<'a> {
        match self.moving {
            Some(moving) if struck.moving => SurfaceInteraction::new(&moving.instances, ray, &struck.hit),
            _ => SurfaceInteraction::new(&self.still.instances, ray, &struck.hit),
        }
    }

    /// Ambient illuminance (sky and bounced light) of a surface in the open, klx.
    pub(crate) fn ambient(&self, position: Vec3A, normal: Vec3A) -> Vec3A {
        match self.probes {
            Some(probes) => probes.irradiance(position, normal),
            None => self.environment.sky.mean * (std::f32::consts::PI * (0.35 + 0.25 * normal.z)),
        }
    }
}

/// What stands still wins a tie.
fn nearer(still: Option<Hit>, moving: Option<Hit>) -> Option<SceneHit> {
    match (still, moving) {
        (Some(s), Some(m)) if m.t >= s.t => Some(SceneHit::still(s)),
        (_, Some(hit)) => Some(SceneHit { hit, moving: true }),
        (Some(hit), None) => Some(SceneHit::still(hit)),
        (None, None) => None,
    }
}
