//! The air between surface and camera: extinction and in-scattered light.

use crate::math8;
use crate::vec3x8::{Vec3x8, dot, splat};
use endless_world::math;
use glam::Vec3A;
use std::f32::consts::PI;
use wide::f32x8;

/// Air that thins out exponentially with height (Beer–Lambert), with light scattered towards the viewer mostly from the
/// sun's side.
#[derive(Debug, Clone)]
pub(crate) struct Fog {
    /// At the ground, 1/m.
    pub(crate) extinction: f32,
    /// Height of that ground, metres.
    pub(crate) ground: f32,
    /// How much higher the air is thinner by the factor e, metres.
    pub(crate) scale_height_m: f32,
    /// How much of a lamp's light the air spreads as a halo: all of it would be 1; rain less than fog, for its drops are few and
    /// large.
    pub(crate) glow: f32,
    /// Radiance of infinitely deep air, kcd/m².
    pub(crate) airlight: Vec3A,
    /// Extra radiance towards the sun.
    pub(crate) sunward: Vec3A,
    /// Towards the sun.
    pub(crate) sun_direction: Vec3A,
}

impl Fog {
    /// Extinction at which contrast falls to 2 % over this distance (Koschmieder 1924).
    pub(crate) fn extinction_for_visibility(visibility_m: f32) -> f32 {
        3.912 / visibility_m
    }

    /// Whether it is more than the haze of a fair day.
    pub(crate) fn is_dense(&self) -> bool {
        self.extinction > 0.0015
    }

    /// Share of light left after a distance along a ray: the integral of the exponential profile in closed form.
    #[inline]
    pub(crate) fn transmittance(&self, origin: Vec3A, direction: Vec3A, distance_m: f32) -> f32 {
        let climb = direction.z * distance_m / self.scale_height_m;
        // (1 - e^-x) / x, by its series where the difference would lose its digits.
        let mean =
            if climb.abs() < 0.01 { 1.0 - climb * (0.5 - climb / 6.0) } else { (1.0 - math::exp(-climb)) / climb };
        math::exp(-self.extinction_at(origin.z) * mean * distance_m)
    }

    /// At a height, 1/m.
    #[inline]
    fn extinction_at(&self, z: f32) -> f32 {
        self.extinction * math::exp((self.ground - z) / self.scale_height_m)
    }

    /// Light scattered into a view ray along a distance.
    #[inline]
    pub(crate) fn in_scatter(&self, direction: Vec3A, transmittance: f32) -> Vec3A {
        let cosine = direction.dot(self.sun_direction).max(0.0);
        let lobe = cosine * cosine;
        (self.airlight + self.sunward * (lobe * lobe * lobe)) * (1.0 - transmittance)
    }

    /// Radiance seen along a ray through the air in front of something.
    #[inline]
    pub(crate) fn through(&self, radiance: Vec3A, origin: Vec3A, direction: Vec3A, distance_m: f32) -> Vec3A {
        let t = self.transmittance(origin, direction, distance_m);
        radiance * t + self.in_scatter(direction, t)
    }

    /// Light of a lamp scattered into eight view rays from one origin, over the lamp's intensity: single scattering in
    /// the closed form of the airlight integral without extinction (Sun, Ramamoorthi, Narasimhan, Nayar 2005), weighted
    /// by how much droplets send on towards the viewer.
    pub(crate) fn halo8(&self, origin: Vec3A, directions: &Vec3x8, distances_m: f32x8, lamp: Vec3A) -> f32x8 {
        let to_lamp = lamp - origin;
        let along = dot(&splat(to_lamp), directions);
        let aside = (f32x8::splat(to_lamp.length_squared()) - along * along).fast_max(f32x8::splat(0.04)).sqrt();
        let swept = math8::atan2_approx(distances_m - along, aside) + math8::atan2_approx(along, aside);
        let reach = along.fast_max(f32x8::ZERO).fast_min(distances_m);
        let forward = droplet_phase(along / f32x8::splat(to_lamp.length().max(0.2)));
        // The nearest part of the ray scatters most: the light has come that far, and has as far to go.
        let extinction = self.extinction_at(lamp.z);
        let faded = math8::exp(f32x8::splat(-extinction) * (reach + f32x8::splat(0.7) * aside));
        f32x8::splat(self.glow * extinction / (4.0 * PI)) * forward * faded * swept / aside
    }
}

/// Light that fog droplets scatter by an angle of this cosine, 1 on average: most goes nearly straight on (Henyey and
/// Greenstein 1941, g = 0.6, which makes up for scattering more than once).
fn droplet_phase(cosine: f32x8) -> f32x8 {
    const G: f32 = 0.6;
    let d = f32x8::splat(1.0 + G * G) - f32x8::splat(2.0 * G) * cosine;
    f32x8::splat(1.0 - G * G) / (d * d.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn droplets_lose_no_light() {
        let n = 20_000;
        let phase = |cosine: f32| droplet_phase(f32x8::splat(cosine)).to_array()[0];
        let mean = (0..n).map(|i| phase(2.0 * (i as f32 + 0.5) / n as f32 - 1.0)).sum::<f32>() / n as f32;
        assert!((mean - 1.0).abs() < 1e-3);
        assert!(phase(1.0) > 20.0 * phase(-1.0));
    }

    fn fog(scale_height_m: f32) -> Fog {
        Fog {
            extinction: Fog::extinction_for_visibility(100.0),
            ground: 5.0,
            scale_height_m,
            glow: 1.0,
            airlight: Vec3A::splat(2.0),
            sunward: Vec3A::ZERO,
            sun_direction: Vec3A::Z,
        }
    }

    #[test]
    fn far_things_take_the_colour_of_the_air() {
        let (fog, ground) = (fog(40.0), Vec3A::Z * 5.0);
        assert!((fog.transmittance(ground, Vec3A::X, 100.0) - 0.02).abs() < 1e-3);
        assert!((fog.through(Vec3A::ZERO, ground, Vec3A::X, 1000.0) - fog.airlight).length() < 1e-3);
        assert_eq!(fog.through(Vec3A::ONE, ground, Vec3A::X, 0.0), Vec3A::ONE);
    }

    #[test]
    fn air_thins_out_with_height() {
        let fog = fog(40.0);
        for (from, direction) in
            [(12.0, Vec3A::new(0.8, 0.0, -0.6)), (12.0, Vec3A::Z), (5.0, Vec3A::new(1.0, 0.0, 1e-4))]
        {
            let origin = Vec3A::Z * from;
            let steps = 10_000;
            let depth: f64 = (0..steps)
                .map(|i| {
                    let z = from + direction.z * 11.0 * (i as f32 + 0.5) / steps as f32;
                    f64::from(fog.extinction_at(z)) * 11.0 / f64::from(steps)
                })
                .sum();
            let t = fog.transmittance(origin, direction, 11.0);
            assert!((f64::from(t) - endless_world::math::f64::exp(-depth)).abs() < 1e-5, "{direction}");
        }
        assert!(fog.transmittance(Vec3A::Z * 5.0, Vec3A::Z, 1e5) > 0.2, "one sees the sky through a shallow fog");
    }
}
