//! Reflection: Lambert and GGX (Walter et al. 2007) under a Fresnel coat (Schlick 1994).

use glam::Vec3A;
use std::f32::consts::{FRAC_1_PI, PI};

/// A diffuse and rough specular base under an optional smooth coat (lacquer, glass, water).
#[derive(Debug, Clone)]
pub(crate) struct Bsdf {
    /// Diffuse albedo of the base, linear.
    pub(crate) albedo: Vec3A,
    /// Shading normal of the base.
    pub(crate) normal: Vec3A,
    /// GGX roughness (perceptual; α = roughness²) of the base.
    pub(crate) roughness: f32,
    /// Reflectance at normal incidence of the base's specular lobe.
    pub(crate) specular: f32,
    /// Share of the surface that the coat covers.
    pub(crate) coat: f32,
    /// The coat's reflectance at normal incidence; coloured for metals.
    pub(crate) coat_f0: Vec3A,
    /// The coat's normal.
    pub(crate) coat_normal: Vec3A,
    /// GGX roughness of the coat for highlights of small lights; its reflections are mirror-like.
    pub(crate) coat_roughness: f32,
    /// Share of light that passes through (leaves).
    pub(crate) translucency: f32,
    /// Emitted radiance, kcd/m².
    pub(crate) emission: Vec3A,
}

impl Bsdf {
    /// A plain rough surface.
    pub(crate) fn matte(albedo: Vec3A, normal: Vec3A) -> Self {
        Self {
            albedo,
            normal,
            roughness: 0.85,
            specular: 0.03,
            coat: 0.0,
            coat_f0: Vec3A::splat(0.04),
            coat_normal: normal,
            coat_roughness: 0.1,
            translucency: 0.0,
            emission: Vec3A::ZERO,
        }
    }

    /// The same with a smooth coat.
    pub(crate) fn coated(mut self, share: f32, f0: f32, roughness: f32) -> Self {
        self.coat = share;
        self.coat_f0 = Vec3A::splat(f0);
        self.coat_roughness = roughness;
        self
    }
}

impl Bsdf {
    /// Share of light that the coat reflects towards the viewer; `view` points to the viewer.
    pub(crate) fn coat_reflectance(&self, view: Vec3A) -> Vec3A {
        if self.coat <= 0.0 {
            return Vec3A::ZERO;
        }
        fresnel(self.coat_f0, self.coat_normal.dot(view).abs()) * self.coat
    }

    /// Radiance towards `view` from a small light that gives `illuminance` (klx) to a surface facing it; `light` points
    /// to the light. kcd/m².
    pub(crate) fn lit_by(&self, illuminance: Vec3A, light: Vec3A, view: Vec3A) -> Vec3A {
        let cosine = self.normal.dot(light);
        let coat = self.coat_reflectance(view);
        let below = Vec3A::ONE - coat;
        // What the specular lobe takes on the way in and out, the diffuse base does not get.
        let left = (1.0 - grazing(self.specular, self.roughness, cosine))
            * (1.0 - grazing(self.specular, self.roughness, self.normal.dot(view)));
        let mut reflected = self.albedo * (FRAC_1_PI * cosine.max(0.0) * left);
        if self.translucency > 0.0 {
            // Leaves: part of the light comes through, greener and brighter against the sun.
            let through = self.albedo * Vec3A::new(1.0, 1.15, 0.5) * (FRAC_1_PI * (-cosine).max(0.0));
            reflected = reflected * (1.0 - self.translucency) + through * self.translucency * 1.3;
        }
        let mut out = below * reflected;
        if cosine > 0.0 {
            let lobe = ggx(self.normal, view, light, self.roughness);
            out += below * (lobe * schlick(self.specular, self.roughness, view, light) * cosine);
        }
        if self.coat > 0.0 {
            let coat_cosine = self.coat_normal.dot(light);
            if coat_cosine > 0.0 {
                let half = (view + light).normalize_or_zero();
                let lobe = ggx(self.coat_normal, view, light, self.coat_roughness);
                out += fresnel(self.coat_f0, half.dot(view).abs()) * (self.coat * lobe * coat_cosine);
            }
        }
        out * illuminance
    }

    /// Radiance towards `view` under ambient illuminance (klx) on the surface.
    pub(crate) fn lit_by_ambient(&self, illuminance: Vec3A, view: Vec3A) -> Vec3A {
        let coat = self.coat_reflectance(view);
        (Vec3A::ONE - coat) * (self.albedo + Vec3A::splat(self.specular * 0.35)) * (illuminance * FRAC_1_PI)
    }

    /// Direction of the coat's mirror reflection; `direction` points at the surface.
    pub(crate) fn mirror_direction(&self, direction: Vec3A, geometric_normal: Vec3A) -> Vec3A {
        let reflected = direction - self.coat_normal * (2.0 * direction.dot(self.coat_normal));
        // A bent normal may send it below the surface: lift it out.
        let below = reflected.dot(geometric_normal);
        if below < 0.02 { (reflected + geometric_normal * (0.02 - below)).normalize() } else { reflected }
    }
}

#[inline]
fn fresnel(f0: Vec3A, cosine: f32) -> Vec3A {
    let m = (1.0 - cosine).clamp(0.0, 1.0);
    let m2 = m * m;
    f0 + (Vec3A::ONE - f0) * (m2 * m2 * m)
}

#[inline]
fn schlick(f0: f32, roughness: f32, view: Vec3A, light: Vec3A) -> f32 {
    grazing(f0, roughness, (view + light).normalize_or_zero().dot(view))
}

/// Schlick's reflectance; surfaces that reflect almost nothing head-on do not shine at grazing angles either, nor do
/// rough ones: their bumps hide each other's glancing sides.
#[inline]
fn grazing(f0: f32, roughness: f32, cosine: f32) -> f32 {
    let m = (1.0 - cosine).clamp(0.0, 1.0);
    let m2 = m * m;
    let smooth = (1.0 - roughness).max(0.0);
    f0 + ((f0 * 50.0).min(1.0) - f0) * (smooth * smooth) * (m2 * m2 * m)
}

/// Distribution and shadowing-masking of GGX over 4 cos cos.
#[inline]
fn ggx(normal: Vec3A, view: Vec3A, light: Vec3A, roughness: f32) -> f32 {
    let half = (view + light).normalize_or_zero();
    let (n_h, n_v, n_l) = (normal.dot(half).max(0.0), normal.dot(view).max(0.02), normal.dot(light).max(0.0));
    let alpha = (roughness * roughness).max(0.0016);
    let a2 = alpha * alpha;
    let d = n_h * n_h * (a2 - 1.0) + 1.0;
    let distribution = a2 / (PI * d * d);
    // Height-correlated Smith (Heitz 2014).
    let visibility =
        0.5 / (n_l * (n_v * n_v * (1.0 - a2) + a2).sqrt() + n_v * (n_l * n_l * (1.0 - a2) + a2).sqrt()).max(1e-4);
    distribution * visibility
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::{hammersley, sphere_direction};
    use proptest::prelude::*;

    /// Reflected share of a unit light from all directions, by quadrature.
    fn albedo(bsdf: &Bsdf, view: Vec3A) -> f32 {
        let n = 20_000;
        let mut sum = 0.0;
        for i in 0..n {
            let light = sphere_direction(hammersley(i, n));
            if light.z > 0.0 {
                sum += bsdf.lit_by(Vec3A::ONE, light, view).y;
            }
        }
        sum * 4.0 * PI / n as f32
    }

    #[test]
    fn a_white_matte_surface_returns_what_it_gets() {
        let mut bsdf = Bsdf::matte(Vec3A::ONE, Vec3A::Z);
        bsdf.specular = 0.0;
        let view = Vec3A::new(0.3, 0.0, 0.95).normalize();
        assert!((albedo(&bsdf, view) - 1.0).abs() < 0.01);
    }

    #[test]
    fn rough_ground_does_not_shine_under_a_low_sun() {
        let mut asphalt = Bsdf::matte(Vec3A::splat(0.08), Vec3A::Z);
        asphalt.roughness = 0.84;
        asphalt.specular = 0.022;
        // Towards a sun 8 degrees high, seen at 8 degrees: where a smooth road would blind.
        let (sin, cos) = endless_world::math::sin_cos(8f32.to_radians());
        let (light, view) = (Vec3A::new(cos, 0.0, sin), Vec3A::new(-cos, 0.0, sin));
        let matte = 0.08 * FRAC_1_PI * sin;
        let shine = |bsdf: &Bsdf| bsdf.lit_by(Vec3A::ONE, light, view).y / matte;
        let rough = shine(&asphalt);
        assert!((1.0..4.0).contains(&rough), "{rough}");
        asphalt.roughness = 0.4;
        assert!(shine(&asphalt) > 4.0 * rough);
    }

    proptest! {
        #[test]
        fn light_and_viewer_may_change_places(
            roughness in 0.1f32..1.0, specular in 0.0f32..0.08, a in 0.1f32..1.5, b in 0.1f32..1.5, turn in 0.0f32..6.0,
        ) {
            let mut bsdf = Bsdf::matte(Vec3A::splat(0.3), Vec3A::Z);
            bsdf.roughness = roughness;
            bsdf.specular = specular;
            let (sin_turn, cos_turn) = endless_world::math::sin_cos(turn);
            let ((sin_a, cos_a), (sin_b, cos_b)) = (endless_world::math::sin_cos(a), endless_world::math::sin_cos(b));
            let (light, view) = (Vec3A::new(cos_a, 0.0, sin_a), Vec3A::new(cos_b * cos_turn, cos_b * sin_turn, sin_b));
            let forth = bsdf.lit_by(Vec3A::ONE, light, view).y / sin_a;
            let back = bsdf.lit_by(Vec3A::ONE, view, light).y / sin_b;
            prop_assert!((forth - back).abs() < 1e-3 * forth.max(back).max(1.0));
        }

        #[test]
        fn no_surface_gives_more_than_it_gets(
            roughness in 0.3f32..1.0, specular in 0.0f32..0.08, coat in 0.0f32..1.0, elevation in 0.15f32..1.5, grey in 0.0f32..0.85,
        ) {
            let mut bsdf = Bsdf::matte(Vec3A::splat(grey), Vec3A::Z).coated(coat, 0.04, 0.4);
            bsdf.roughness = roughness;
            bsdf.specular = specular;
            let view = Vec3A::new(endless_world::math::cos(elevation), 0.0, endless_world::math::sin(elevation));
            prop_assert!(albedo(&bsdf, view) <= 1.02);
        }
    }
}
