//! One sub-pixel sample of the static picture; its light is kept in parts, by what can change them.

use crate::accel::{Hit, Ray};
use crate::light::{Environment, SUN_SAMPLES};
use crate::octahedron;
use crate::scene::ShadingPoint;
use glam::Vec3A;

/// No instance: the sky.
pub(super) const SKY: u32 = u32::MAX;

/// What a sample saw and the parts of its radiance, fog applied, kcd/m².
#[derive(Debug, Clone, Copy)]
pub(super) struct GBufferSample {
    pub(super) hit: Hit,
    /// Emitted by the surface and scattered in by the air.
    pub(super) rest: [f32; 3],
    /// Reflected sky and bounced light; moving objects nearby darken it.
    pub(super) ambient: [f32; 3],
    /// By day the sun's light if nothing were in its way; at night that of all lamps, shadowed by the static scene.
    pub(super) direct: [f32; 3],
    /// What the coat mirrors.
    pub(super) mirror: [f32; 3],
    /// Where the coat's mirror ray goes.
    pub(super) mirror_direction: [f32; 3],
    /// How far that ray gets in the static scene.
    pub(super) mirror_t: f32,
    /// Share of the mirrored light that arrives, fog applied, a channel each, and the coat's roughness; 65,535 is 1.
    pub(super) mirror_weight: [u16; 4],
    /// Geometric normal, packed.
    pub(super) normal: u32,
    /// Which directions to the sun's disc the static scene leaves free, a bit each.
    pub(super) sun_free: u8,
    /// Which lamps near it light it past the static scene, a bit each.
    pub(super) lamps_free: u32,
    /// [`Self::MIRRORS`], [`Self::LENS`].
    pub(super) flags: u8,
}

impl GBufferSample {
    /// Its mirror reflection is strong enough to show moving objects.
    pub(super) const MIRRORS: u8 = 1;
    /// A traffic light's lens.
    pub(super) const LENS: u8 = 2;

    /// The open sky.
    pub(super) fn sky(radiance: Vec3A) -> Self {
        Self {
            hit: Hit { t: f32::MAX, instance: SKY, triangle: 0, u: 0.0, v: 0.0 },
            rest: radiance.to_array(),
            ambient: [0.0; 3],
            direct: [0.0; 3],
            mirror: [0.0; 3],
            mirror_direction: [0.0; 3],
            mirror_t: 0.0,
            mirror_weight: [0; 4],
            normal: 0,
            sun_free: 0,
            lamps_free: 0,
            flags: 0,
        }
    }

    /// Its light on another place of the same piece.
    pub(super) fn seen_by(&self, sun_free: u8, hit: &Hit) -> Self {
        Self { hit: *hit, sun_free, lamps_free: 0, ..*self }
    }

    /// Whether it saw the sky.
    pub(super) fn is_sky(&self) -> bool {
        self.hit.instance == SKY
    }

    /// Whether its mirror reflection is strong enough to show moving objects.
    pub(super) fn mirrors(&self) -> bool {
        self.flags & Self::MIRRORS != 0
    }

    /// Its surface; `ray` is the one that met it.
    pub(super) fn facet(&self, ray: &Ray) -> ShadingPoint {
        ShadingPoint::along(ray, self.hit.t, octahedron::unpack(self.normal))
    }

    /// The ray into its mirror, as far as the static scene.
    pub(super) fn mirror_ray(&self, facet: &ShadingPoint) -> Ray {
        Ray { origin: facet.ray_origin(), direction: Vec3A::from(self.mirror_direction), tmax: self.mirror_t }
    }

    /// Share of the mirrored light that arrives, and the roughness of the mirror.
    pub(super) fn mirror_weight(&self) -> (Vec3A, f32) {
        let [r, g, b, roughness] = self.mirror_weight.map(|c| f32::from(c) / 65_535.0);
        (Vec3A::new(r, g, b), roughness)
    }

    /// Its radiance when nothing moves: the parts put together.
    pub(super) fn still_radiance(&self, environment: &Environment) -> Vec3A {
        let share = sun_share(environment, self.sun_free);
        Vec3A::from(self.rest) + Vec3A::from(self.ambient) + Vec3A::from(self.direct) * share + Vec3A::from(self.mirror)
    }
}

/// Mean radiance of a pixel when nothing moves, and the ambient part of it.
pub(super) fn still_light(pixel: &[GBufferSample], environment: &Environment) -> (Vec3A, Vec3A) {
    let mean = |sum: Vec3A| sum / pixel.len() as f32;
    let radiance = pixel.iter().map(|s| s.still_radiance(environment)).sum();
    (mean(radiance), mean(pixel.iter().map(|s| Vec3A::from(s.ambient)).sum()))
}

/// Share of the direct light that arrives through these free directions.
pub(super) fn sun_share(environment: &Environment, free: u8) -> f32 {
    if environment.night { 1.0 } else { free.count_ones() as f32 / SUN_SAMPLES as f32 }
}

pub(super) fn pack_weight(weight: Vec3A, roughness: f32) -> [u16; 4] {
    [weight.x, weight.y, weight.z, roughness].map(|c| (c.clamp(0.0, 1.0) * 65_535.0).round() as u16)
}
