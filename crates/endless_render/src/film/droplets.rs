//! Drops of rain that sit on the lens: each shows the whole scene upside down, out of focus.

use super::glare::{REDUCE, box_blur, reduce};
use endless_world::math::UnfusedVec3A;
use endless_world::{ImageSize, Stream, math};
use glam::{Vec2, Vec3A};

/// Drops on one camera's lens.
#[derive(Debug, Clone)]
pub(crate) struct Droplets {
    drops: Vec<Droplet>,
}

#[derive(Debug, Clone)]
struct Droplet {
    /// Pixels.
    centre: Vec2,
    radius: f32,
    /// How much higher than wide: gravity draws them down.
    tall: f32,
}

impl Droplets {
    /// So many drops, most of them small.
    pub(crate) fn new(count: u32, size: ImageSize, seed: u64) -> Self {
        let mut random = Stream::named(seed, "droplets", &[]);
        let (width, height) = (size.width as f32, size.height as f32);
        let drops = (0..count)
            .map(|_| {
                let share = random.f32();
                Droplet {
                    centre: Vec2::new(random.f32() * width, random.f32() * height),
                    radius: height * (0.006 + 0.030 * share * share * share),
                    tall: 1.0 + 0.5 * share * random.f32(),
                }
            })
            .collect();
        Self { drops }
    }

    /// Lays the drops over a picture.
    pub(crate) fn draw(&self, size: ImageSize, picture: &mut [Vec3A]) {
        let (width, height) = (size.width as usize, size.height as usize);
        let (w, h) = (width.div_ceil(REDUCE), height.div_ceil(REDUCE));
        let soft = box_blur(&reduce(width, height, picture, w, h), w, h, 3);
        for drop in &self.drops {
            let reach = Vec2::new(drop.radius, drop.radius * drop.tall);
            let low = (drop.centre - reach).floor().max(Vec2::ZERO).as_uvec2();
            let high = (drop.centre + reach).ceil().min(Vec2::new(width as f32 - 1.0, height as f32 - 1.0)).as_uvec2();
            for y in low.y..=high.y {
                for x in low.x..=high.x {
                    let away = (Vec2::new(x as f32 + 0.5, y as f32 + 0.5) - drop.centre) / reach;
                    let r2 = away.length_squared();
                    if r2 >= 1.0 {
                        continue;
                    }
                    // Upside down and wide, wider still towards the rim.
                    let from = drop.centre - away * (0.30 + 0.25 * r2) * height as f32;
                    let at = (from / REDUCE as f32)
                        .max(Vec2::ZERO)
                        .as_uvec2()
                        .min(glam::UVec2::new(w as u32 - 1, h as u32 - 1));
                    let shown = soft[at.y as usize * w + at.x as usize] * (1.0 - 0.55 * r2 * r2);
                    let cover = 0.9 * math::smoothstep(1.0, 0.55, r2);
                    let pixel = &mut picture[y as usize * width + x as usize];
                    *pixel = pixel.lerp_unfused(shown, cover);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drops_turn_the_picture_over_and_add_no_light() {
        let size = ImageSize { width: 320, height: 180 };
        // Bright above, dark below.
        let picture: Vec<Vec3A> =
            (0..size.pixels()).map(|i| Vec3A::splat(if i / 320 < 90 { 1.0 } else { 0.1 })).collect();
        let mut wet = picture.clone();
        Droplets::new(40, size, 3).draw(size, &mut wet);
        let mean = |from: usize, to: usize, p: &[Vec3A]| p[from..to].iter().map(|v| v.x).sum::<f32>();
        let half = size.pixels() / 2;
        assert!(mean(0, half, &wet) < mean(0, half, &picture));
        assert!(mean(half, size.pixels(), &wet) > mean(half, size.pixels(), &picture));
        assert!(wet.iter().all(|v| v.x > 0.0 && v.x <= 1.0));
    }
}
