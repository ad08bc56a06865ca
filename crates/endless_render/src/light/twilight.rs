//! Colours of the clear sky while the sun rises or sets.
//!
//! Light scattered once, at three wavelengths, tells how bright the twilight sky is, not what colour it has: the blue of the zenith comes
//! from ozone high up (Hulburt 1953), and what reaches the low air has been scattered many times. So its brightness stays, but for the dark
//! rim that single scattering leaves at the horizon, and its colours are set by eye: blue, warm above the sun, a rosy belt opposite.

use endless_world::math::{self, UnfusedVec3A, smoothstep};
use glam::Vec3A;

/// Sines of the sun's elevation between which the colours of the day go over into these: 4° and −1°.
const BEGINS: f32 = 0.07;
const REIGNS: f32 = -0.0175;
/// Below this the rim is filled with the light above it: the sine of 12°.
const RIM: f32 = 0.208;

const BLUE: Vec3A = Vec3A::new(0.62, 0.98, 1.75);
const WARM: Vec3A = Vec3A::new(2.10, 0.85, 0.28);
const ROSE: Vec3A = Vec3A::new(1.45, 0.86, 0.98);

/// How far twilight has come, 0 by day to 1.
pub(super) fn share(sun: Vec3A) -> f32 {
    1.0 - smoothstep(REIGNS, BEGINS, sun.z)
}

/// The direction whose light a direction near the horizon gets.
pub(super) fn above_rim(direction: Vec3A) -> Vec3A {
    let level = Vec3A::new(direction.x, direction.y, 0.0).normalize_or(Vec3A::X);
    if direction.z >= RIM { direction } else { level * (1.0 - RIM * RIM).sqrt() + Vec3A::Z * RIM }
}

/// The colour of the light from a direction.
pub(super) fn hue(direction: Vec3A, sun: Vec3A) -> Vec3A {
    let level = |v: Vec3A| Vec3A::new(v.x, v.y, 0.0).normalize_or(Vec3A::X);
    let towards = 0.5 + 0.5 * level(direction).dot(level(sun));
    let height = direction.z.max(0.0);
    // The later it is, the lower and the nearer to the sun the glow.
    let late = smoothstep(0.0, -0.10, sun.z);
    let near = towards * towards;
    let glow = math::exp(-height * (4.0 + 6.0 * late)) * near * (1.0 - late + late * near);
    let from_belt = (height - 0.2) / 0.1;
    let belt = 0.45 * (1.0 - late) * math::exp(-from_belt * from_belt) * (1.0 - towards);
    BLUE.lerp_unfused(ROSE, belt).lerp_unfused(WARM, glow.min(0.9))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn towards(azimuth_deg: f32, elevation_deg: f32) -> Vec3A {
        let (sin, cos) = math::sin_cos(elevation_deg.to_radians());
        let (s, c) = math::sin_cos(azimuth_deg.to_radians());
        Vec3A::new(c * cos, s * cos, sin)
    }

    #[test]
    fn days_and_nights_keep_their_colours() {
        assert_eq!(share(towards(0.0, 6.0)), 0.0);
        assert_eq!(share(towards(0.0, -2.0)), 1.0);
    }

    #[test]
    fn it_is_warm_above_the_sun_and_blue_overhead() {
        for elevation in [-1.0, -3.0, -5.0] {
            let colour = |azimuth, height| hue(towards(azimuth, height), towards(200.0, elevation));
            let [low, overhead, opposite] = [colour(200.0, 2.0), colour(200.0, 80.0), colour(20.0, 3.0)];
            assert!(low.x > 2.0 * low.z, "{low}");
            assert!(overhead.z > 1.5 * overhead.x && opposite.z > opposite.x);
        }
    }

    #[test]
    fn nothing_is_taken_from_the_rim() {
        for height in [0.0, 5.0, 11.9, 12.1, 60.0] {
            let raised = above_rim(towards(70.0, height));
            assert!((raised.length() - 1.0).abs() < 1e-5 && raised.z > RIM - 1e-4);
        }
    }
}
