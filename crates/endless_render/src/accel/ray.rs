//! Rays, hits, and a ray prepared for box and triangle tests in one frame of reference.

use glam::{Mat3A, Vec3A};

/// A ray; `direction` need not be of unit length. Valid hits have `0 < t <= tmax`, `t` in units of `direction`.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Start of the ray, world space, metres.
    pub origin: Vec3A,
    /// Direction in world space, any length but zero.
    pub direction: Vec3A,
    /// Largest valid `t`; may be infinite.
    pub tmax: f32,
}

/// Rays whose direction is the way to a light end here, a little before it.
pub(super) const TO_LIGHT: f32 = 0.999;

impl Ray {
    /// A ray that meets nothing.
    pub(crate) const NONE: Self = Self { origin: Vec3A::ZERO, direction: Vec3A::Z, tmax: 0.0 };

    /// The ray that must be free for the light at a place to arrive.
    pub(crate) fn to_light(origin: Vec3A, light: Vec3A) -> Self {
        Self { origin, direction: light - origin, tmax: TO_LIGHT }
    }
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The hit lies at `origin + t * direction`.
    pub t: f32,
    /// Index of the instance in the list the structure was built from.
    pub instance: u32,
    /// Index of the triangle in its mesh.
    pub triangle: u32,
    /// Barycentric weight of the triangle's second vertex.
    pub u: f32,
    /// Barycentric weight of the triangle's third vertex.
    pub v: f32,
}

impl Hit {
    /// Stands for "nothing yet": every hit at `t <= tmax` comes before it.
    pub(super) const fn none(tmax: f32) -> Self {
        Hit { t: tmax, instance: u32::MAX, triangle: u32::MAX, u: 0.0, v: 0.0 }
    }

    /// `None` if it still stands for nothing.
    pub(super) fn found(self) -> Option<Self> {
        (self.instance != u32::MAX).then_some(self)
    }

    /// The order of hits: nearest first, then lowest instance, then lowest triangle. It does not depend on the
    /// order in which a traversal meets them.
    #[inline]
    pub(super) fn precedes(&self, other: &Hit) -> bool {
        self.t < other.t || (self.t == other.t && (self.instance, self.triangle) < (other.instance, other.triangle))
    }
}

/// Far slab distances grow by this factor, so that rounding never makes a ray miss the box of a triangle which it
/// hits (Ize 2013 asks for `1 + 2 gamma(3)`; the rest covers the rounding of the triangle test).
pub(super) const FAR_PAD: f32 = 1.0 + 16.0 / 16_777_216.0;

/// The inverse of a direction component is limited to this, so that `0 * inverse` stays a number.
pub(super) const MAX_INVERSE: f32 = 1e20;

/// Finite inverse of a direction component; keeps the sign, that of zero included.
#[inline]
pub(super) fn inverse(d: f32) -> f32 {
    if d.abs() < 1.0 / MAX_INVERSE { MAX_INVERSE.copysign(d) } else { 1.0 / d }
}

/// Axes permuted so that the ray runs mostly along the last, and the shear that makes it run along it alone
/// (Woop, Benthin, Wald: Watertight ray/triangle intersection, JCGT 2013).
#[derive(Clone, Copy, Debug)]
pub(super) struct Shear {
    pub(super) axes: [usize; 3],
    pub(super) x: f32,
    pub(super) y: f32,
    pub(super) z: f32,
}

/// The axis along which a direction is longest.
#[inline]
pub(super) fn main_axis(d: Vec3A) -> usize {
    let a = d.abs();
    if a.x >= a.y && a.x >= a.z {
        0
    } else if a.y >= a.z {
        1
    } else {
        2
    }
}

/// Main axis `z` and the two after it in cyclic order, as `[x, y, z]`.
#[inline]
pub(super) fn permutation(z: usize) -> [usize; 3] {
    const CYCLE: [[usize; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];
    CYCLE[z]
}

/// A ray in the frame of one instance, with all that box and triangle tests need.
#[derive(Clone, Copy, Debug)]
pub(super) struct LocalRay {
    pub(super) origin: [f32; 3],
    /// Inverse direction, always finite.
    pub(super) inverse: [f32; 3],
    /// Per axis 1 if the ray runs towards lower coordinates: indexes the near planes of a node.
    pub(super) negative: [usize; 3],
    pub(super) shear: Shear,
}

impl LocalRay {
    #[inline]
    pub(super) fn new(origin: Vec3A, direction: Vec3A) -> Self {
        let inverse = direction.to_array().map(inverse);
        let axes = permutation(main_axis(direction));
        let d = direction.to_array();
        let z = inverse[axes[2]];
        LocalRay {
            origin: origin.to_array(),
            inverse,
            negative: inverse.map(|i| usize::from(i.is_sign_negative())),
            shear: Shear { axes, x: d[axes[0]] * z, y: d[axes[1]] * z, z },
        }
    }

    /// Where the ray enters a box (not before its own start), or `None` if it passes by.
    ///
    /// Rounded subtraction and multiplication are monotone: a ray that enters a box also enters every box around
    /// it, and not later. So a tree of boxes can lose no triangle whose own box is entered.
    #[inline]
    pub(super) fn enter(&self, min: [f32; 3], max: [f32; 3]) -> Option<f32> {
        let (mut near, mut far) = (0.0f32, f32::INFINITY);
        for k in 0..3 {
            let (first, last) = if self.negative[k] == 0 { (min[k], max[k]) } else { (max[k], min[k]) };
            near = near.max((first - self.origin[k]) * self.inverse[k]);
            far = far.min((last - self.origin[k]) * (self.inverse[k] * FAR_PAD));
        }
        (near <= far).then_some(near)
    }
}

/// `object_from_world`, applied with a fixed order of roundings that packets repeat lane by lane.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayTransform {
    pub(super) linear: Mat3A,
    pub(super) translation: Vec3A,
}

impl RayTransform {
    #[inline]
    pub(super) fn vector(&self, v: Vec3A) -> Vec3A {
        let m = &self.linear;
        (m.x_axis * v.x + m.y_axis * v.y) + m.z_axis * v.z
    }

    #[inline]
    pub(super) fn point(&self, p: Vec3A) -> Vec3A {
        self.vector(p) + self.translation
    }
}
