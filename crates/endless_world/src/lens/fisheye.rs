//! Kannala and Brandt's lens, as in OpenCV's `fisheye` module.

use crate::math;
use glam::{Vec2, Vec3};

/// A lens that shows a point at the angle θ from the optical axis at θ (1 + k1 θ² + k2 θ⁴ + k3 θ⁶ + k4 θ⁸) focal lengths
/// from the middle, up to a largest angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fisheye {
    k: [f32; 4],
    max_angle_rad: f32,
    /// Where that is shown: the radius of the image circle, focal lengths.
    max_radius: f32,
}

/// Steps of Newton's method from a place to its angle: as good as single precision.
const NEWTON_STEPS: u32 = 10;

impl Fisheye {
    /// Up to an angle; less, where the lens would fold back before.
    pub fn new(k: [f32; 4], max_angle_rad: f32) -> Self {
        /// Places that are looked at.
        const STEPS: u16 = 1024;
        let angle = |step: u16| max_angle_rad * f32::from(step) / f32::from(STEPS);
        let last = (1..=STEPS).find(|&step| slope(k, angle(step)) < LEAST_SLOPE).map_or(STEPS, |step| step - 1);
        let max_angle_rad = angle(last);
        Self { k, max_angle_rad, max_radius: radius(k, max_angle_rad) }
    }

    /// k1 to k4.
    pub fn k(&self) -> [f32; 4] {
        self.k
    }

    /// Largest angle from the optical axis that is shown, radians.
    pub fn max_angle_rad(&self) -> f32 {
        self.max_angle_rad
    }

    /// Radius of the image circle, focal lengths.
    pub fn max_radius(&self) -> f32 {
        self.max_radius
    }

    /// How far from the middle an angle is shown, focal lengths; angles that are not shown at the image circle.
    pub fn radius_of(&self, angle_rad: f32) -> f32 {
        radius(self.k, angle_rad.min(self.max_angle_rad))
    }

    pub(super) fn project(&self, point: Vec3) -> Option<Vec2> {
        let across = point.truncate().length();
        let angle = math::atan2(across, point.z);
        (angle <= self.max_angle_rad).then(|| {
            // On the axis the ratio has a limit, which is none of 0 / 0.
            if across > 0.0 { point.truncate() * (radius(self.k, angle) / across) } else { Vec2::ZERO }
        })
    }

    pub(super) fn shows(&self, p: Vec2) -> bool {
        p.length() <= self.max_radius
    }

    pub(super) fn direction(&self, p: Vec2) -> Vec3 {
        let from_middle = p.length();
        let (sin, cos) = math::sin_cos(self.angle(from_middle.min(self.max_radius)));
        if from_middle > 0.0 { (p * (sin / from_middle)).extend(cos) } else { Vec3::Z }
    }

    /// The angle that is shown so far from the middle.
    fn angle(&self, from_middle: f32) -> f32 {
        if self.k == [0.0; 4] {
            return from_middle;
        }
        let mut angle = from_middle.min(self.max_angle_rad);
        for _ in 0..NEWTON_STEPS {
            let step = (radius(self.k, angle) - from_middle) / slope(self.k, angle).max(LEAST_SLOPE);
            angle = (angle - step).clamp(0.0, self.max_angle_rad);
        }
        angle
    }
}

/// Where the picture grows less with the angle, the lens has ended.
const LEAST_SLOPE: f32 = 0.05;

fn radius([k1, k2, k3, k4]: [f32; 4], angle: f32) -> f32 {
    let a2 = angle * angle;
    angle * (1.0 + a2 * (k1 + a2 * (k2 + a2 * (k3 + a2 * k4))))
}

/// Its derivative.
fn slope([k1, k2, k3, k4]: [f32; 4], angle: f32) -> f32 {
    let a2 = angle * angle;
    1.0 + a2 * (3.0 * k1 + a2 * (5.0 * k2 + a2 * (7.0 * k3 + a2 * (9.0 * k4))))
}
