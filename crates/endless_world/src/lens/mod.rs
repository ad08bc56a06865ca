//! Lenses: how the directions of the world become places of a picture.
//!
//! All have in common that a place is `focal · p + principal` in pixels, and that `p` follows from a point of the camera's
//! frame (x right, y down, z forward) alone:
//!
//! | Lens | `p` of (x, y, z) | `focal` | Depth |
//! |---|---|---|---|
//! | perspective | (x, y) / z, distorted | pixels | z |
//! | fisheye | θ (1 + k1 θ² + k2 θ⁴ + k3 θ⁶ + k4 θ⁸) (x, y) / r, with r = √(x² + y²), θ = atan2(r, z) | pixels a radian | distance |
//! | equirectangular | (atan2(x, z), atan2(y, √(x² + z²))) | pixels a radian | distance |
//! | orthographic | (x, y) | pixels a metre | z |
//!
//! The fisheye is that of OpenCV's `fisheye` module (Kannala and Brandt 2006); with all k = 0 it is equidistant.

mod fisheye;
mod model;

pub use fisheye::Fisheye;
pub use model::LensModel;

use crate::{Distortion, math};
use glam::{Vec2, Vec3};
use std::f32::consts::{FRAC_PI_2, PI};

/// How a camera's lens makes its picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lens {
    /// Straight lines stay straight, but for the distortion.
    Perspective(Distortion),
    /// The angle from the optical axis decides the distance from the middle.
    Fisheye(Fisheye),
    /// Longitude across, latitude down.
    Equirectangular,
    /// All rays are parallel.
    Orthographic,
}

/// How the depth of a picture is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DepthMeasure {
    /// Along the optical axis.
    #[default]
    Planar,
    /// Along the ray, from the lens.
    Distance,
}

/// What is nearer has no place in a picture, metres.
const NEAR_M: f32 = 1e-4;

impl Lens {
    /// A true pinhole.
    pub const PINHOLE: Self = Self::Perspective(Distortion::NONE);

    /// How its depth is measured: behind a lens that looks to all sides nothing is at a positive planar depth.
    pub fn depth_measure(&self) -> DepthMeasure {
        match self {
            Self::Perspective(_) | Self::Orthographic => DepthMeasure::Planar,
            Self::Fisheye(_) | Self::Equirectangular => DepthMeasure::Distance,
        }
    }

    /// Whether all rays leave one point.
    #[inline]
    pub fn is_central(&self) -> bool {
        !matches!(self, Self::Orthographic)
    }

    /// `p` and the depth of a point of the camera's frame; `None` for what it does not show, wherever the picture ends.
    pub fn project(&self, point: Vec3) -> Option<(Vec2, f32)> {
        let ahead = point.z > NEAR_M;
        match self {
            Self::Perspective(distortion) => ahead.then(|| (distortion.distort(point.truncate() / point.z), point.z)),
            Self::Orthographic => ahead.then(|| (point.truncate(), point.z)),
            Self::Fisheye(fisheye) => {
                let distance = point.length();
                let place = (distance > NEAR_M).then(|| fisheye.project(point)).flatten()?;
                Some((place, distance))
            }
            Self::Equirectangular => {
                let distance = point.length();
                let across = Vec2::new(point.x, point.z).length();
                (distance > NEAR_M)
                    .then(|| (Vec2::new(math::atan2(point.x, point.z), math::atan2(point.y, across)), distance))
            }
        }
    }

    /// Whether it shows anything at `p`.
    #[inline]
    pub fn shows(&self, p: Vec2) -> bool {
        match self {
            Self::Perspective(_) | Self::Orthographic => true,
            Self::Fisheye(fisheye) => fisheye.shows(p),
            Self::Equirectangular => p.x.abs() <= PI && p.y.abs() <= FRAC_PI_2,
        }
    }

    /// Direction of the ray at `p` in the camera's frame, of a length that is not 0; where it shows nothing, that of the
    /// nearest ray.
    #[inline]
    pub fn direction(&self, p: Vec2) -> Vec3 {
        match self {
            Self::Perspective(distortion) => distortion.undistort(p).extend(1.0),
            Self::Orthographic => Vec3::Z,
            Self::Fisheye(fisheye) => fisheye.direction(p),
            Self::Equirectangular => {
                let (sin_x, cos_x) = math::sin_cos(p.x.clamp(-PI, PI));
                let (sin_y, cos_y) = math::sin_cos(p.y.clamp(-FRAC_PI_2, FRAC_PI_2));
                Vec3::new(sin_x * cos_y, sin_y, cos_x * cos_y)
            }
        }
    }
}

#[cfg(test)]
mod tests;
