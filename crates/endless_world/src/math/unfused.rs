//! Operations of `glam` that fuse a multiplication with an addition where the processor can, and so give other bits on
//! other processors: the same without fusing. `clippy.toml` bans the originals, all but `Quat * Vec3`, which cannot be
//! banned; `scripts/compare_cpu_levels.sh` notices one.

use super::{acos, sin};
use glam::{Affine3A, Mat3, Mat3A, Quat, Vec3, Vec3A, Vec3Swizzles};

/// Of SIMD vectors.
pub trait UnfusedVec3A {
    /// `self × other`.
    #[must_use]
    fn cross_unfused(self, other: Self) -> Self;

    /// `self` at 0, `to` at 1.
    #[must_use]
    fn lerp_unfused(self, to: Self, share: f32) -> Self;
}

impl UnfusedVec3A for Vec3A {
    #[inline]
    fn cross_unfused(self, other: Self) -> Self {
        (self.zxy() * other - self * other.zxy()).zxy()
    }

    #[inline]
    fn lerp_unfused(self, to: Self, share: f32) -> Self {
        self + (to - self) * share
    }
}

/// Of unit quaternions.
pub trait UnfusedQuat {
    /// The rotated vector.
    #[must_use]
    fn rotate_unfused(self, vector: Vec3) -> Vec3;

    /// Spherical interpolation along the shorter arc (Shoemake 1985): `self` at 0, `to` at 1.
    #[must_use]
    fn slerp_unfused(self, to: Self, share: f32) -> Self;
}

impl UnfusedQuat for Quat {
    #[inline]
    fn rotate_unfused(self, vector: Vec3) -> Vec3 {
        let (axis, w) = (Vec3::new(self.x, self.y, self.z), self.w);
        vector * (w * w - axis.dot(axis)) + axis * (2.0 * vector.dot(axis)) + axis.cross(vector) * (2.0 * w)
    }

    fn slerp_unfused(self, to: Self, share: f32) -> Self {
        let cosine = self.dot(to);
        let to = if cosine < 0.0 { -to } else { to };
        let cosine = cosine.abs();
        // Nearly the same: the sines below would be of nothing.
        if cosine > 0.9995 {
            return (self * (1.0 - share) + to * share).normalize();
        }
        let angle_rad = acos(cosine);
        (self * sin((1.0 - share) * angle_rad) + to * sin(share * angle_rad)) * (1.0 / sin(angle_rad))
    }
}

/// Of SIMD matrices.
pub trait UnfusedMatrix {
    /// The inverse; not finite if there is none.
    #[must_use]
    fn inverse_unfused(&self) -> Self;

    /// The determinant: negative if it mirrors.
    #[must_use]
    fn determinant_unfused(&self) -> f32;
}

impl UnfusedMatrix for Mat3A {
    #[inline]
    fn inverse_unfused(&self) -> Self {
        Mat3::from(*self).inverse().into()
    }

    #[inline]
    fn determinant_unfused(&self) -> f32 {
        Mat3::from(*self).determinant()
    }
}

impl UnfusedMatrix for Affine3A {
    #[inline]
    fn inverse_unfused(&self) -> Self {
        let matrix3 = self.matrix3.inverse_unfused();
        Self { matrix3, translation: -(matrix3 * self.translation) }
    }

    #[inline]
    fn determinant_unfused(&self) -> f32 {
        self.matrix3.determinant_unfused()
    }
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "the originals are what these are compared with")]
mod tests {
    use super::*;
    use glam::EulerRot;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3A> {
        (-9.0f32..9.0, -9.0f32..9.0, -9.0f32..9.0).prop_map(Vec3A::from)
    }

    fn turn() -> impl Strategy<Value = Quat> {
        (-3.0f32..3.0, -3.0f32..3.0, -3.0f32..3.0).prop_map(|(a, b, c)| Quat::from_euler(EulerRot::XYZ, a, b, c))
    }

    proptest! {
        #[test]
        fn they_are_the_originals_but_for_rounding(
            a in vector(), b in vector(), p in turn(), q in turn(), share in 0.0f32..1.0,
        ) {
            prop_assert!(a.cross_unfused(b).abs_diff_eq(a.cross(b), 1e-4));
            prop_assert!(a.lerp_unfused(b, share).abs_diff_eq(a.lerp(b, share), 1e-5));
            prop_assert!(q.rotate_unfused(a.into()).abs_diff_eq((q * a).into(), 1e-4));
            let (ours, theirs) = (p.slerp_unfused(q, share), p.slerp(q, share));
            prop_assert!(ours.is_normalized() && ours.dot(theirs).abs() > 1.0 - 1e-3, "{ours} {theirs}");
            let place = Affine3A::from_scale_rotation_translation(Vec3::new(1.0, 2.0, 0.5), q, b.into());
            prop_assert!(place.inverse_unfused().abs_diff_eq(place.inverse(), 1e-4));
            prop_assert!((place.determinant_unfused() - 1.0).abs() < 1e-3);
        }
    }
}
