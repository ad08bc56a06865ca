//! One sub-pixel sample of the still picture, its light taken apart by what can change it.

use crate::accel::{Hit, Ray};
use crate::light::{Environment, SUN_SAMPLES};
use crate::material::{Look, look};
use crate::octahedron;
use crate::scene::{Facet, FrameScene, SurfacePoint};
use crate::shade::{MIRROR_THRESHOLD, Tracer, footprint_m, mirror_light, mirror_ray};
use endless_scene::Surface;
use glam::Vec3A;

/// No instance: the sky.
pub(super) const SKY: u32 = u32::MAX;

/// What a sample saw and the parts of its radiance, fog applied, kcd/m².
#[derive(Debug, Clone, Copy)]
pub(super) struct StillSample {
    pub(super) hit: Hit,
    /// Emitted by the surface and scattered in by the air.
    pub(super) rest: [f32; 3],
    /// Reflected sky and bounced light; moving objects nearby darken it.
    pub(super) ambient: [f32; 3],
    /// By day the sun's light if nothing were in its way; at night that of all lamps, shadowed by the still town.
    pub(super) direct: [f32; 3],
    /// What the coat mirrors.
    pub(super) mirror: [f32; 3],
    /// Where the coat's mirror ray goes.
    pub(super) mirror_direction: [f32; 3],
    /// How far that ray gets in the still town.
    pub(super) mirror_t: f32,
    /// Share of the mirrored light that arrives, fog applied, a channel each, and the coat's roughness; 65,535 is 1.
    mirror_weight: [u16; 4],
    /// Geometric normal, packed.
    pub(super) normal: u32,
    /// Which directions to the sun's disc the still town leaves free, a bit each.
    pub(super) sun_free: u8,
    /// Which lamps near it light it past the still town, a bit each.
    pub(super) lamps_free: u32,
    /// [`Self::MIRRORS`], [`Self::LENS`].
    pub(super) flags: u8,
}

impl StillSample {
    /// Its mirror is strong enough to show moving things.
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

    /// Whether it saw the sky.
    pub(super) fn is_sky(&self) -> bool {
        self.hit.instance == SKY
    }

    /// Whether its mirror is strong enough to show moving things.
    pub(super) fn mirrors(&self) -> bool {
        self.flags & Self::MIRRORS != 0
    }

    /// Its surface; `ray` is the one that met it.
    pub(super) fn facet(&self, ray: &Ray) -> Facet {
        Facet::along(ray, self.hit.t, octahedron::unpack(self.normal))
    }

    /// The ray into its mirror, as far as the still town.
    pub(super) fn mirror_ray(&self, facet: &Facet) -> Ray {
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
pub(super) fn still_light(pixel: &[StillSample], environment: &Environment) -> (Vec3A, Vec3A) {
    let mean = |sum: Vec3A| sum / pixel.len() as f32;
    let radiance = pixel.iter().map(|s| s.still_radiance(environment)).sum();
    (mean(radiance), mean(pixel.iter().map(|s| Vec3A::from(s.ambient)).sum()))
}

/// Share of the direct light that arrives through these free directions.
pub(super) fn sun_share(environment: &Environment, free: u8) -> f32 {
    if environment.night { 1.0 } else { free.count_ones() as f32 / SUN_SAMPLES as f32 }
}

/// The look of a still sample; the same wherever it is asked for.
pub(super) fn still_look(point: &SurfacePoint<'_>, environment: &Environment, sample: usize, pixel_angle: f32) -> Look {
    look(point, environment, footprint_m(point, pixel_angle), sample as f32 / 4.0 + 0.1)
}

fn pack_weight(weight: Vec3A, roughness: f32) -> [u16; 4] {
    [weight.x, weight.y, weight.z, roughness].map(|c| (c.clamp(0.0, 1.0) * 65_535.0).round() as u16)
}

/// Shades a sample of the still town; `tracer` must hold nothing that moves. `irradiance` is what the bake gathered
/// there, klx.
pub(super) fn shade_still(
    tracer: &Tracer<'_>,
    ray: &Ray,
    hit: &Hit,
    sun_free: u8,
    irradiance: Vec3A,
    sample: usize,
    pixel_angle: f32,
) -> StillSample {
    let environment = tracer.environment;
    let point = SurfacePoint::new(&tracer.still.instances, ray, hit);
    let look = still_look(&point, environment, sample, pixel_angle);
    let view = -ray.direction;
    let transmittance = environment.fog.transmittance(ray.origin, ray.direction, hit.t);
    let (mirror, mirror_t) = mirror_light(tracer, &point, &look, pixel_angle);
    let mirrors = look.coat_reflectance(view).max_element() >= MIRROR_THRESHOLD;
    let lens = matches!(point.material.surface, Surface::SignalLens(_)) && point.instance.signal.is_some();
    let facet = point.facet();
    let lamps_free = if environment.night { lamps_free(tracer, &facet) } else { 0 };
    let direct = if environment.night {
        lamp_sum(tracer, &facet, &look, lamps_free)
    } else {
        environment.sun.as_ref().map_or(Vec3A::ZERO, |sun| look.lit_by(sun.illuminance, sun.direction, view))
    };
    let rest = look.emission * transmittance
        + environment.fog.in_scatter(ray.direction, transmittance)
        + halos(tracer, ray, hit.t);
    StillSample {
        hit: *hit,
        rest: rest.to_array(),
        ambient: (look.lit_by_ambient(irradiance, view) * transmittance).to_array(),
        direct: (direct * transmittance).to_array(),
        mirror: (mirror * transmittance).to_array(),
        mirror_direction: mirror_ray(&point, &look).direction.to_array(),
        mirror_t,
        mirror_weight: pack_weight(look.coat_reflectance(view) * transmittance, look.coat_roughness),
        normal: octahedron::pack(point.geometric_normal),
        sun_free,
        lamps_free,
        flags: u8::from(mirrors) * StillSample::MIRRORS + u8::from(lens) * StillSample::LENS,
    }
}

/// Gives all samples of a uniform pixel the lamp light of its centre.
pub(super) fn share_lamp_light(pixel: &mut [StillSample]) {
    if let [centre, others @ ..] = pixel {
        for other in others {
            other.direct = centre.direct;
        }
    }
}

/// The lamps near a point that light it past the still town, a bit each.
fn lamps_free(tracer: &Tracer<'_>, facet: &Facet) -> u32 {
    let origin = facet.ray_origin();
    let mut free = 0;
    for (bit, lamp) in tracer.still.lamps.near(facet.position).enumerate() {
        let (illuminance, direction) = lamp.illuminance_at(facet.position);
        let lit = facet.geometric_normal.dot(direction) > 0.0 && illuminance.max_element() > 0.0;
        let ray = Ray { origin, direction: lamp.position - origin, tmax: 0.999 };
        free |= u32::from(lit && !tracer.still.accel.occluded(&ray)) << bit;
    }
    free
}

/// Those of the free lamps that something that moves hides; only `lamps` (indices) are asked.
pub(super) fn lamps_blocked(tracer: &Tracer<'_>, frame: &FrameScene, lamps: &[u16], facet: &Facet, free: u32) -> u32 {
    if lamps.is_empty() || free == 0 {
        return 0;
    }
    let near = tracer.still.lamps.indices_near(facet.position);
    let origin = facet.ray_origin();
    let mut blocked = 0;
    for lamp in lamps {
        let Ok(bit) = near.binary_search(lamp) else { continue };
        let position = tracer.still.lamps.all()[usize::from(*lamp)].position;
        let hidden =
            free >> bit & 1 == 1 && frame.accel.occluded(&Ray { origin, direction: position - origin, tmax: 0.999 });
        blocked |= u32::from(hidden) << bit;
    }
    blocked
}

/// Light of these lamps near a point, without fog.
pub(super) fn lamp_sum(tracer: &Tracer<'_>, facet: &Facet, look: &Look, free: u32) -> Vec3A {
    let mut sum = Vec3A::ZERO;
    for (bit, lamp) in tracer.still.lamps.near(facet.position).enumerate() {
        if free >> bit & 1 == 1 {
            let (illuminance, direction) = lamp.illuminance_at(facet.position);
            sum += look.lit_by(illuminance, direction, -facet.direction);
        }
    }
    sum
}

/// Glow of lamps in misty night air along a view ray.
pub(super) fn halos(tracer: &Tracer<'_>, ray: &Ray, distance: f32) -> Vec3A {
    let environment = tracer.environment;
    if !environment.halos() {
        return Vec3A::ZERO;
    }
    let reach = distance.min(150.0);
    tracer
        .still
        .lamps
        .all()
        .iter()
        .filter(|lamp| lamp.position.distance_squared(ray.origin) < 140.0 * 140.0)
        .map(|lamp| environment.fog.halo(ray.origin, ray.direction, reach, lamp.position, lamp.intensity))
        .sum()
}
