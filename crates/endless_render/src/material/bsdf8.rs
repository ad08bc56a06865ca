//! Eight BSDFs side by side, each towards its own viewer: their light from one small light after another.

use super::Bsdf;
use crate::vec3x8::{Vec3x8, dot, normalize};
use glam::Vec3A;
use std::f32::consts::{FRAC_1_PI, PI};
use wide::f32x8;

/// What [`Bsdf::lit_by`] needs of eight BSDFs; what depends on the viewers alone is known beforehand.
pub(crate) struct Bsdf8 {
    albedo: Vec3x8,
    base: GgxLobe8,
    specular: f32x8,
    /// (1 − roughness)² of the base.
    smooth: f32x8,
    /// Share of the diffuse light that the specular lobe leaves on its way to the viewer.
    left: f32x8,
    /// Share of light that the coat lets through, a channel each.
    below: Vec3x8,
    translucency: f32x8,
    coat: f32x8,
    coat_f0: Vec3x8,
    coat_lobe: GgxLobe8,
    /// To the viewer.
    view: Vec3x8,
}

impl Bsdf8 {
    /// Of these BSDFs, each with the direction to its viewer; the rest stay dark.
    pub(crate) fn new(bsdfs: &[Option<(&Bsdf, Vec3A)>; 8]) -> Self {
        let number = |of: fn(&Bsdf) -> f32| f32x8::new(bsdfs.map(|l| l.map_or(0.0, |(bsdf, _)| of(bsdf))));
        let vectors = |of: fn(&Bsdf, Vec3A) -> Vec3A| {
            let v = bsdfs.map(|l| l.map_or(Vec3A::ZERO, |(bsdf, view)| of(bsdf, view)));
            [f32x8::new(v.map(|v| v.x)), f32x8::new(v.map(|v| v.y)), f32x8::new(v.map(|v| v.z))]
        };
        let view = vectors(|_, view| view);
        let (coat, roughness, specular) = (number(|l| l.coat), number(|l| l.roughness), number(|l| l.specular));
        let coat_f0 = vectors(|l, _| l.coat_f0);
        let base = GgxLobe8::new(vectors(|l, _| l.normal), roughness, &view);
        let coat_lobe = GgxLobe8::new(vectors(|l, _| l.coat_normal), number(|l| l.coat_roughness), &view);
        let smooth = (f32x8::ONE - roughness).fast_max(f32x8::ZERO);
        let smooth = smooth * smooth;
        let left = f32x8::ONE - grazing(specular, smooth, dot(&base.normal, &view));
        let towards = dot(&coat_lobe.normal, &view).abs();
        let below = fresnel(&coat_f0, towards).map(|f| f32x8::ONE - f * coat);
        let (albedo, translucency) = (vectors(|l, _| l.albedo), number(|l| l.translucency));
        Self { albedo, base, specular, smooth, left, below, translucency, coat, coat_f0, coat_lobe, view }
    }

    /// Radiance towards the viewers, over the illuminance of a surface facing the light; `light` points to the light.
    pub(crate) fn lit_by(&self, light: &Vec3x8) -> Vec3x8 {
        let cosine = dot(&self.base.normal, light);
        let facing = cosine.fast_max(f32x8::ZERO);
        let half = normalize([0, 1, 2].map(|k| self.view[k] + light[k]));
        let half_view = dot(&half, &self.view);
        let left = (f32x8::ONE - grazing(self.specular, self.smooth, cosine)) * self.left;
        let matte = facing * left * f32x8::splat(FRAC_1_PI);
        let shine = self.base.value(light, &half) * grazing(self.specular, self.smooth, half_view) * facing;
        let mut out: Vec3x8 = std::array::from_fn(|k| self.albedo[k] * matte);
        if self.translucency.simd_gt(f32x8::ZERO).any() {
            // Leaves: part of the light comes through, greener and brighter against the sun.
            let behind = (-cosine).fast_max(f32x8::ZERO) * f32x8::splat(FRAC_1_PI);
            for (k, tint) in [1.0, 1.15, 0.5].into_iter().enumerate() {
                let through = self.albedo[k] * behind * f32x8::splat(tint * 1.3);
                out[k] = out[k] * (f32x8::ONE - self.translucency) + through * self.translucency;
            }
        }
        out = std::array::from_fn(|k| self.below[k] * (out[k] + shine));
        if self.coat.simd_gt(f32x8::ZERO).any() {
            let facing = dot(&self.coat_lobe.normal, light).fast_max(f32x8::ZERO);
            let lobe = self.coat * self.coat_lobe.value(light, &half) * facing;
            let mirrored = fresnel(&self.coat_f0, half_view.abs());
            out = std::array::from_fn(|k| out[k] + mirrored[k] * lobe);
        }
        out
    }
}

/// A GGX lobe towards a viewer.
struct GgxLobe8 {
    normal: Vec3x8,
    /// α².
    a2: f32x8,
    /// Cosine to the viewer.
    n_v: f32x8,
    /// √(n_v² (1 − α²) + α²).
    masked: f32x8,
}

impl GgxLobe8 {
    fn new(normal: Vec3x8, roughness: f32x8, view: &Vec3x8) -> Self {
        let alpha = (roughness * roughness).fast_max(f32x8::splat(0.0016));
        let a2 = alpha * alpha;
        let n_v = dot(&normal, view).fast_max(f32x8::splat(0.02));
        let masked = (n_v * n_v * (f32x8::ONE - a2) + a2).sqrt();
        Self { normal, a2, n_v, masked }
    }

    /// Distribution and height-correlated shadowing-masking (Heitz 2014) over 4 cos cos.
    fn value(&self, light: &Vec3x8, half: &Vec3x8) -> f32x8 {
        let n_h = dot(&self.normal, half).fast_max(f32x8::ZERO);
        let n_l = dot(&self.normal, light).fast_max(f32x8::ZERO);
        let d = n_h * n_h * (self.a2 - f32x8::ONE) + f32x8::ONE;
        let shadowed = (n_l * n_l * (f32x8::ONE - self.a2) + self.a2).sqrt();
        let visibility = (n_l * self.masked + self.n_v * shadowed).fast_max(f32x8::splat(1e-4));
        self.a2 * f32x8::splat(0.5) / (f32x8::splat(PI) * d * d * visibility)
    }
}

/// Schlick's fifth power.
fn schlick(cosine: f32x8) -> f32x8 {
    let m = (f32x8::ONE - cosine).fast_max(f32x8::ZERO).fast_min(f32x8::ONE);
    let m2 = m * m;
    m2 * m2 * m
}

fn fresnel(f0: &Vec3x8, cosine: f32x8) -> Vec3x8 {
    let m5 = schlick(cosine);
    f0.map(|f| f + (f32x8::ONE - f) * m5)
}

fn grazing(f0: f32x8, smooth: f32x8, cosine: f32x8) -> f32x8 {
    f0 + ((f0 * f32x8::splat(50.0)).fast_min(f32x8::ONE) - f0) * smooth * schlick(cosine)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn direction() -> impl Strategy<Value = Vec3A> {
        (-1.0f32..1.0, -1.0f32..1.0, 0.05f32..1.0).prop_map(|(x, y, z)| Vec3A::new(x, y, z).normalize())
    }

    fn evaluate_bsdf() -> impl Strategy<Value = Bsdf> {
        (direction(), direction(), 0.1f32..1.0, 0.0f32..0.08, 0.0f32..1.0, 0.05f32..0.5, 0.0f32..0.5).prop_map(
            |(normal, coat_normal, roughness, specular, coat, coat_roughness, translucency)| {
                let mut bsdf = Bsdf::matte(Vec3A::new(0.2, 0.4, 0.6), normal).coated(
                    if coat < 0.4 { 0.0 } else { coat },
                    0.04,
                    coat_roughness,
                );
                (bsdf.roughness, bsdf.specular, bsdf.coat_normal) = (roughness, specular, coat_normal);
                bsdf.translucency = if translucency < 0.25 { 0.0 } else { translucency };
                bsdf
            },
        )
    }

    proptest! {
        #[test]
        fn eight_are_lit_as_one_after_another(
            bsdfs in prop::collection::vec((evaluate_bsdf(), direction(), direction()), 8), there in any::<u8>(),
        ) {
            let eight = std::array::from_fn(|i| (there >> i & 1 == 1).then_some((&bsdfs[i].0, bsdfs[i].1)));
            let light = [0, 1, 2].map(|k| f32x8::new(std::array::from_fn(|i| bsdfs[i].2[k])));
            let lit = Bsdf8::new(&eight).lit_by(&light).map(f32x8::to_array);
            for i in (0..8).filter(|i| there >> i & 1 == 1) {
                let (bsdf, view, light) = &bsdfs[i];
                let one = bsdf.lit_by(Vec3A::ONE, *light, *view);
                let found = Vec3A::new(lit[0][i], lit[1][i], lit[2][i]);
                prop_assert!(found.abs_diff_eq(one, 2e-4 * one.max_element().max(0.01)), "{found} {one}");
            }
        }
    }
}
