//! The light that eight surfaces side by side reflect, each towards its own viewer: the bits of [`Bsdf`]'s functions.

use super::Bsdf;
use crate::vec3x8::{Vec3x8, dot, normalize_or, splat};
use glam::Vec3A;
use std::f32::consts::{FRAC_1_PI, PI};
use wide::f32x8;

/// Stands in for surfaces that are not there.
static NOTHING: Bsdf = Bsdf {
    albedo: Vec3A::ZERO,
    normal: Vec3A::Z,
    roughness: 1.0,
    specular: 0.0,
    coat: 0.0,
    coat_f0: Vec3A::ZERO,
    coat_normal: Vec3A::Z,
    coat_roughness: 1.0,
    translucency: 0.0,
    emission: Vec3A::ZERO,
};

/// Eight BSDFs towards their viewers.
pub(crate) struct Reflection8 {
    albedo: Vec3x8,
    normal: Vec3x8,
    roughness: f32x8,
    specular: f32x8,
    translucency: f32x8,
    emission: Vec3x8,
    /// None if no surface has one.
    coat: Option<Coat8>,
    coat_reflectance: Vec3x8,
    /// To the viewers.
    views: Vec3x8,
}

/// Coats, of surfaces of which not all need to have one.
struct Coat8 {
    /// Share of the surface, and whether there is any.
    share: f32x8,
    there: f32x8,
    f0: Vec3x8,
    normal: Vec3x8,
    roughness: f32x8,
}

impl Reflection8 {
    /// Of surfaces seen from where `views` point; what is found where there is none means nothing.
    #[inline]
    pub(crate) fn new(bsdfs: &[Option<&Bsdf>; 8], views: &Vec3x8) -> Self {
        let bsdfs = bsdfs.map(|bsdf| bsdf.unwrap_or(&NOTHING));
        let [ax, ay, az, roughness, nx, ny, nz, specular] =
            columns(bsdfs, |l| (l.albedo, l.roughness, l.normal, l.specular));
        let [ex, ey, ez, translucency, ..] = columns(bsdfs, |l| (l.emission, l.translucency, Vec3A::ZERO, 0.0));
        let share = f32x8::new(bsdfs.map(|l| l.coat));
        let there = share.simd_gt(f32x8::ZERO);
        let coat = there.any().then(|| Coat8::new(bsdfs, share, there));
        let coat_reflectance = coat.as_ref().map_or([f32x8::ZERO; 3], |coat| coat.reflectance(views));
        Self {
            albedo: [ax, ay, az],
            normal: [nx, ny, nz],
            roughness,
            specular,
            translucency,
            emission: [ex, ey, ez],
            coat,
            coat_reflectance,
            views: *views,
        }
    }

    /// [`Bsdf::coat_reflectance`] towards the viewers.
    #[inline]
    pub(crate) fn coat_reflectance(&self) -> Vec3x8 {
        self.coat_reflectance
    }

    /// Emitted radiance, kcd/m².
    #[inline]
    pub(crate) fn emission(&self) -> Vec3x8 {
        self.emission
    }

    /// [`Bsdf::lit_by`] one light that is the same for all eight.
    pub(crate) fn lit_by(&self, illuminance: Vec3A, light: Vec3A) -> Vec3x8 {
        let light = splat(light);
        let cosine = dot(&self.normal, &light);
        let half = normalize_or(std::array::from_fn(|k| self.views[k] + light[k]), &[f32x8::ZERO; 3]);
        let half_view = dot(&half, &self.views);
        let below = self.coat_reflectance.map(|coat| f32x8::ONE - coat);
        let specular = Specular8::new(self.specular, self.roughness);
        let left =
            (f32x8::ONE - specular.grazing(cosine)) * (f32x8::ONE - specular.grazing(dot(&self.normal, &self.views)));
        let matte = f32x8::splat(FRAC_1_PI) * cosine.fast_max(f32x8::ZERO) * left;
        let mut out = self.albedo.map(|albedo| albedo * matte);
        let translucent = self.translucency.simd_gt(f32x8::ZERO);
        if translucent.any() {
            let behind = f32x8::splat(FRAC_1_PI) * (-cosine).fast_max(f32x8::ZERO);
            for (k, tint) in [1.0, 1.15, 0.5].map(f32x8::splat).into_iter().enumerate() {
                let through = self.albedo[k] * tint * behind * self.translucency * f32x8::splat(1.3);
                let mixed = out[k] * (f32x8::ONE - self.translucency) + through;
                out[k] = translucent.select(mixed, out[k]);
            }
        }
        out = std::array::from_fn(|k| below[k] * out[k]);
        let facing = cosine.simd_gt(f32x8::ZERO);
        if facing.any() {
            let lobe = ggx(&self.normal, &self.views, cosine, &half, self.roughness);
            let shine = lobe * specular.grazing(half_view) * cosine;
            out = std::array::from_fn(|k| facing.select(out[k] + below[k] * shine, out[k]));
        }
        if let Some(coat) = &self.coat {
            let cosine = dot(&coat.normal, &light);
            let facing = coat.there & cosine.simd_gt(f32x8::ZERO);
            if facing.any() {
                let lobe = coat.share * ggx(&coat.normal, &self.views, cosine, &half, coat.roughness) * cosine;
                let mirrored = fresnel(&coat.f0, half_view.abs());
                out = std::array::from_fn(|k| facing.select(out[k] + mirrored[k] * lobe, out[k]));
            }
        }
        std::array::from_fn(|k| out[k] * f32x8::splat(illuminance[k]))
    }

    /// [`Bsdf::lit_by_ambient`], each under its own illuminance.
    #[inline]
    pub(crate) fn lit_by_ambient(&self, illuminance: &Vec3x8) -> Vec3x8 {
        let shine = self.specular * f32x8::splat(0.35);
        std::array::from_fn(|k| {
            let below = f32x8::ONE - self.coat_reflectance[k];
            below * (self.albedo[k] + shine) * (illuminance[k] * f32x8::splat(FRAC_1_PI))
        })
    }
}

impl Coat8 {
    #[inline]
    fn new(bsdfs: [&Bsdf; 8], share: f32x8, there: f32x8) -> Self {
        let [r, g, b, roughness, x, y, z, _] = columns(bsdfs, |l| (l.coat_f0, l.coat_roughness, l.coat_normal, 0.0));
        Self { share, there, f0: [r, g, b], normal: [x, y, z], roughness }
    }

    /// Share of light that coats reflect towards the viewers.
    #[inline]
    fn reflectance(&self, views: &Vec3x8) -> Vec3x8 {
        fresnel(&self.f0, dot(&self.normal, views).abs()).map(|f| (f * self.share) & self.there)
    }
}

/// A base's specular reflectance, but for the angle.
struct Specular8 {
    f0: f32x8,
    /// How much more there is at a grazing angle.
    more: f32x8,
}

impl Specular8 {
    #[inline]
    fn new(f0: f32x8, roughness: f32x8) -> Self {
        let smooth = (f32x8::ONE - roughness).fast_max(f32x8::ZERO);
        let more = ((f0 * f32x8::splat(50.0)).fast_min(f32x8::ONE) - f0) * (smooth * smooth);
        Self { f0, more }
    }

    #[inline]
    fn grazing(&self, cosine: f32x8) -> f32x8 {
        self.f0 + self.more * schlick(cosine)
    }
}

/// Two vectors and two numbers of each of eight BSDFs side by side. Rows that are turned at once cost less than columns
/// that are gathered one number after another.
#[inline]
fn columns(bsdfs: [&Bsdf; 8], row: impl Fn(&Bsdf) -> (Vec3A, f32, Vec3A, f32)) -> [f32x8; 8] {
    f32x8::transpose(bsdfs.map(|bsdf| {
        let (v, a, w, b) = row(bsdf);
        f32x8::new([v.x, v.y, v.z, a, w.x, w.y, w.z, b])
    }))
}

/// Schlick's fifth power.
#[inline]
fn schlick(cosine: f32x8) -> f32x8 {
    let m = (f32x8::ONE - cosine).fast_clamp(f32x8::ZERO, f32x8::ONE);
    let m2 = m * m;
    m2 * m2 * m
}

#[inline]
fn fresnel(f0: &Vec3x8, cosine: f32x8) -> Vec3x8 {
    let m5 = schlick(cosine);
    f0.map(|f| f + (f32x8::ONE - f) * m5)
}

/// Distribution and shadowing-masking of GGX over 4 cos cos; `cosine` is that of the light.
#[inline]
fn ggx(normal: &Vec3x8, views: &Vec3x8, cosine: f32x8, half: &Vec3x8, roughness: f32x8) -> f32x8 {
    let n_h = dot(normal, half).fast_max(f32x8::ZERO);
    let n_v = dot(normal, views).fast_max(f32x8::splat(0.02));
    let n_l = cosine.fast_max(f32x8::ZERO);
    let alpha = (roughness * roughness).fast_max(f32x8::splat(0.0016));
    let a2 = alpha * alpha;
    let d = n_h * n_h * (a2 - f32x8::ONE) + f32x8::ONE;
    let distribution = a2 / (f32x8::splat(PI) * d * d);
    let rest = f32x8::ONE - a2;
    let masked = n_l * (n_v * n_v * rest + a2).sqrt() + n_v * (n_l * n_l * rest + a2).sqrt();
    distribution * (f32x8::splat(0.5) / masked.fast_max(f32x8::splat(1e-4)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vec3x8::side_by_side;
    use proptest::prelude::*;

    fn direction() -> impl Strategy<Value = Vec3A> {
        prop_oneof![
            8 => (-1.0f32..1.0, -1.0f32..1.0, -1.0f32..1.0)
                .prop_filter_map("no direction", |(x, y, z)| Vec3A::new(x, y, z).try_normalize()),
            1 => prop::sample::select(vec![Vec3A::X, Vec3A::Y, Vec3A::Z, -Vec3A::X, -Vec3A::Y, -Vec3A::Z]),
        ]
    }

    /// A number from 0 to `most`, often an end.
    fn share(most: f32) -> impl Strategy<Value = f32> {
        prop_oneof![2 => Just(0.0), 1 => Just(most), 5 => 0.0..most]
    }

    fn color(most: f32) -> impl Strategy<Value = Vec3A> {
        (share(most), share(most), share(most)).prop_map(|(r, g, b)| Vec3A::new(r, g, b))
    }

    fn bsdf() -> impl Strategy<Value = Bsdf> {
        let base = (color(1.0), direction(), share(1.0), share(0.08), share(1.0), color(5.0));
        let coat = (share(1.0), color(1.0), direction(), share(0.5));
        (base, coat).prop_map(|(base, coat)| {
            let (albedo, normal, roughness, specular, translucency, emission) = base;
            let (coat, coat_f0, coat_normal, coat_roughness) = coat;
            Bsdf {
                albedo,
                normal,
                roughness,
                specular,
                coat,
                coat_f0,
                coat_normal,
                coat_roughness,
                translucency,
                emission,
            }
        })
    }

    fn bits(v: Vec3A) -> [u32; 3] {
        v.to_array().map(f32::to_bits)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4096))]

        #[test]
        fn eight_reflect_what_one_after_another_does(
            mut bsdfs in prop::collection::vec((bsdf(), direction(), color(2.0)), 8), there in any::<u8>(),
            light in direction(), illuminance in color(100.0), plain: bool, against: bool,
        ) {
            for (bsdf, view, _) in &mut bsdfs {
                if plain {
                    (bsdf.coat, bsdf.translucency) = (0.0, 0.0);
                }
                if against {
                    *view = -light;
                }
            }
            let eight = std::array::from_fn(|i| (there >> i & 1 == 1).then_some(&bsdfs[i].0));
            let reflection = Reflection8::new(&eight, &side_by_side(std::array::from_fn(|i| bsdfs[i].1)));
            let found = [
                reflection.coat_reflectance(),
                reflection.emission(),
                reflection.lit_by(illuminance, light),
                reflection.lit_by_ambient(&side_by_side(std::array::from_fn(|i| bsdfs[i].2))),
            ];
            for i in (0..8).filter(|i| there >> i & 1 == 1) {
                let (bsdf, view, ambient) = &bsdfs[i];
                let expected = [
                    bsdf.coat_reflectance(*view),
                    bsdf.emission,
                    bsdf.lit_by(illuminance, light, *view),
                    bsdf.lit_by_ambient(*ambient, *view),
                ];
                prop_assert_eq!(found.map(|v| v.map(|axis| axis.to_array()[i].to_bits())), expected.map(bits));
            }
        }
    }
}
