//! Rays against the still and the moving part of a scene together.

use crate::accel::{Hit, Ray};
use crate::indirect::ProbeGrid;
use crate::light::{Environment, LampMaps};
use crate::scene::{FrameScene, StaticScene, SurfacePoint};
use glam::Vec3A;

/// All that light depends on at one instant.
#[derive(Clone, Copy)]
pub(crate) struct Tracer<'a> {
    pub(crate) still: &'a StaticScene,
    /// `None` while baking.
    pub(crate) moving: Option<&'a FrameScene>,
    pub(crate) environment: &'a Environment,
    pub(crate) lamp_maps: &'a LampMaps,
    /// `None` while the probes themselves are made.
    pub(crate) probes: Option<&'a ProbeGrid>,
}

/// What a ray met.
#[derive(Clone, Copy)]
pub(crate) struct Struck {
    pub(crate) hit: Hit,
    pub(crate) moving: bool,
}

impl<'a> Tracer<'a> {
    /// The nearest surface; what stands still wins a tie.
    pub(crate) fn closest(&self, ray: &Ray) -> Option<Struck> {
        let still = self.still.accel.closest(ray);
        let shortened = Ray { tmax: still.map_or(ray.tmax, |h| h.t), ..*ray };
        let moving = self.moving.and_then(|m| m.accel.closest(&shortened));
        match (still, moving) {
            (Some(s), Some(m)) if m.t >= s.t => Some(Struck { hit: s, moving: false }),
            (_, Some(hit)) => Some(Struck { hit, moving: true }),
            (Some(hit), None) => Some(Struck { hit, moving: false }),
            (None, None) => None,
        }
    }

    /// Whether anything is in the way.
    pub(crate) fn occluded(&self, ray: &Ray) -> bool {
        self.moving.is_some_and(|m| m.accel.occluded(ray)) || self.still.accel.occluded(ray)
    }

    /// The surface that a ray met.
    pub(crate) fn point(&self, ray: &Ray, struck: &Struck) -> SurfacePoint<'a> {
        match self.moving {
            Some(moving) if struck.moving => SurfacePoint::new(&moving.instances, ray, &struck.hit),
            _ => SurfacePoint::new(&self.still.instances, ray, &struck.hit),
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
