//! A BSDF in 28 bytes, for those that are kept for every pixel.

use super::Bsdf;
use crate::octahedron;
use crate::rgb9e5::Rgb9e5;
use glam::Vec3A;

/// What [`Bsdf::lit_by`] needs of a BSDF.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PackedBsdf {
    albedo: Rgb9e5,
    coat_f0: Rgb9e5,
    normal: u32,
    coat_normal: u32,
    /// Roughness, specular reflectance, coat, its roughness, translucency; 65,535 is 1.
    shares: [u16; 5],
}

impl PackedBsdf {
    /// Of one that gives no light of its own.
    pub(crate) fn new(bsdf: &Bsdf) -> Self {
        let shares = [bsdf.roughness, bsdf.specular, bsdf.coat, bsdf.coat_roughness, bsdf.translucency];
        Self {
            albedo: Rgb9e5::new(bsdf.albedo),
            coat_f0: Rgb9e5::new(bsdf.coat_f0),
            normal: octahedron::pack(bsdf.normal),
            coat_normal: octahedron::pack(bsdf.coat_normal),
            shares: shares.map(|share| (share.clamp(0.0, 1.0) * 65_535.0).round() as u16),
        }
    }

    /// The BSDF.
    pub(crate) fn get(&self) -> Bsdf {
        let [roughness, specular, coat, coat_roughness, translucency] =
            self.shares.map(|share| f32::from(share) / 65_535.0);
        Bsdf {
            albedo: self.albedo.get(),
            normal: octahedron::unpack(self.normal),
            roughness,
            specular,
            coat,
            coat_f0: self.coat_f0.get(),
            coat_normal: octahedron::unpack(self.coat_normal),
            coat_roughness,
            translucency,
            emission: Vec3A::ZERO,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_on_a_packed_one_is_the_same_to_the_eye() {
        let normal = Vec3A::new(0.1, -0.2, 1.0).normalize();
        let mut bsdf = Bsdf::matte(Vec3A::new(0.12, 0.1, 0.07), normal).coated(0.8, 0.02, 0.12);
        bsdf.coat_normal = Vec3A::Z;
        let packed = PackedBsdf::new(&bsdf).get();
        let view = Vec3A::new(0.5, 0.3, 0.4).normalize();
        for light in [Vec3A::Z, Vec3A::new(-0.5, -0.3, 0.42).normalize(), Vec3A::new(0.9, 0.0, 0.2).normalize()] {
            let [a, b] = [&bsdf, &packed].map(|bsdf| bsdf.lit_by(Vec3A::ONE, light, view));
            assert!((a - b).abs().max_element() < 0.01 * a.max_element(), "{a} became {b}");
        }
    }
}
