//! Falling rain between the lens and the scene: short streaks, each at its own depth, behind nothing nearer.
//!
//! A drop is a tiny wide-angle lens: it shows the mean of what lies around (Garg and Nayar 2007), so streaks are
//! brighter than a dark street and vanish before the sky.

use endless_world::{ImageSize, Lens, PinholeCamera, Stream};
use glam::{Vec2, Vec3, Vec3A};

/// The rain of one scene.
#[derive(Debug, Clone)]
pub(crate) struct Rain {
    /// Streaks a frame.
    pub(crate) drops: u32,
    /// Radiance of a drop, kcd/m².
    pub(crate) radiance: Vec3A,
    /// Horizontal drift over fall, from wind.
    pub(crate) slant: f32,
    pub(crate) seed: u64,
}

/// Large drops fall at 9 m/s, small ones at 3 (Gunn and Kinzer 1949); the shutter is open for a thirtieth of a second under
/// dark clouds.
const STREAK_M: [f32; 2] = [0.09, 0.30];
/// What a large near drop covers of a pixel on its way, from light rain to a downpour. A drop alone is before a pixel for a
/// hundredth of that time; what is seen as a streak are the few that catch the light, and those that follow each other.
const OPACITY: [f32; 2] = [0.08, 0.34];
const NEAREST_M: f32 = 1.2;
const FARTHEST_M: f32 = 22.0;
/// Spray is not seen from farther.
const SPRAY_SEEN_M: f32 = 45.0;

impl Rain {
    /// Drops that burst on the ground at this instant: specks of spray where `ground` gives the distance of a pixel of
    /// level ground; gives pixels as [`Self::draw`] does.
    pub(crate) fn splash(
        &self,
        frame: u32,
        camera: &PinholeCamera,
        ground: impl Fn(usize) -> Option<f32>,
        mut blend: impl FnMut(usize, f32),
    ) {
        let mut random = Stream::named(self.seed, "splashes", &[u64::from(frame)]);
        let (width, height) = (camera.size.width as i32, camera.size.height as i32);
        for _ in 0..self.drops {
            let (x, y) = ((random.f32() * width as f32) as i32, (random.f32() * height as f32) as i32);
            let (size_m, strength) = (random.range_f32(0.012, 0.035), random.range_f32(0.15, 0.5));
            let Some(distance) = ground((y * width + x) as usize).filter(|d| *d < SPRAY_SEEN_M) else { continue };
            // A crown of spray: a small arc, open above, wider than high.
            let away = if camera.lens.is_central() { distance } else { 1.0 };
            let half = size_m * camera.intrinsics.fx / away;
            let fade = strength * (half / 0.7).min(1.0) * (1.0 - distance / SPRAY_SEEN_M);
            let reach = half.ceil() as i32;
            for dx in -reach..=reach {
                let t = dx as f32 / half.max(0.5);
                let (x, y) = (x + dx, y - (t * t * half * 0.8) as i32);
                if t.abs() <= 1.0 && (0..width).contains(&x) && (0..height).contains(&y) {
                    blend((y * width + x) as usize, fade * (0.5 + 0.5 * t * t));
                }
            }
        }
    }

    /// A frame's streaks over a picture of this `depth`, metres: gives `blend` pixels and the share of each that
    /// becomes rain.
    pub(crate) fn draw(&self, frame: u32, camera: &PinholeCamera, depth: &[f32], mut blend: impl FnMut(usize, f32)) {
        let mut random = Stream::named(self.seed, "rain", &[u64::from(frame)]);
        let (width, height) = (camera.size.width as f32, camera.size.height as f32);
        let k = &camera.intrinsics;
        let perspective = matches!(camera.lens, Lens::Perspective(_));
        let heavy = Stream::named(self.seed, "weight of rain", &[]).range_f32(OPACITY[0], OPACITY[1]);
        for _ in 0..self.drops {
            // Uniform in the volume of the view cone: z³ uniform.
            let cube = random.range_f32(NEAREST_M.powi(3), FARTHEST_M.powi(3));
            let z = endless_world::math::pow(cube, 1.0 / 3.0);
            let at = Vec2::new(random.f32() * width, random.f32() * height * 1.1);
            // Small drops are many.
            let size = random.f32() * random.f32();
            let fall_m = STREAK_M[0] + (STREAK_M[1] - STREAK_M[0]) * size;
            let length = (fall_m * k.fy / z).clamp(2.0, height * 0.12);
            let lean = self.slant * 1.5 + 0.07f32.copysign(self.slant) + random.range_f32(-0.03, 0.03);
            let away = if camera.lens.is_central() { z } else { 1.0 };
            let thickness = ((0.0012 + 0.0022 * size) * k.fx / away).clamp(0.3, 2.0);
            let opacity = heavy * thickness.min(1.0) * random.range_f32(0.4, 1.0);
            let along = if perspective {
                Vec2::new(lean, -1.0).normalize() * length
            } else {
                // Upwards in the world is not upwards in the picture.
                let Some(ray) = camera.ray(at.x, at.y) else { continue };
                let below = ray.origin + ray.direction * z;
                let right = camera.world_from_camera.x_axis;
                let above = below + (Vec3::Z + right * lean).normalize() * fall_m;
                let Some((to, _)) = camera.project(above) else { continue };
                camera.way_in_image(at, to).clamp_length_max(height * 0.12)
            };
            streak(camera.size, at, along, thickness, |i, share| {
                if depth[i] >= z {
                    blend(i, opacity * share);
                }
            });
        }
    }
}

/// The pixels of a streak, and how strong it is there: it fades towards its ends and sides.
fn streak(size: ImageSize, from: Vec2, along: Vec2, thickness: f32, mut each: impl FnMut(usize, f32)) {
    let (width, height) = (size.width as i32, size.height as i32);
    let steps = along.length().ceil().max(1.0) as i32;
    let half = (thickness * 0.5).max(0.5);
    for step in 0..=steps {
        let t = step as f32 / steps as f32;
        let p = from + along * t;
        let along_fade = 1.0 - (2.0 * t - 1.0) * (2.0 * t - 1.0);
        let y = p.y.floor() as i32;
        let (x0, x1) = ((p.x - half).floor() as i32, (p.x + half).floor() as i32);
        if y < 0 || y >= height {
            continue;
        }
        for x in x0.max(0)..=x1.min(width - 1) {
            let across = 1.0 - ((x as f32 + 0.5 - p.x).abs() / (half + 0.5)).min(1.0);
            each((y * width + x) as usize, along_fade * across);
        }
    }
}
