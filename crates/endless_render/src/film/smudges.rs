//! Dirt on the glass before the lens: soft spots that take light away, and scatter some of what is behind them.

use super::glare::{REDUCE, box_blur, reduce};
use endless_world::math::UnfusedVec3A;
use endless_world::{ImageSize, Stream, math};
use glam::{Vec2, Vec3A};

/// Share of light that dirt lets through, and the most that a spot covers.
const THROUGH: f32 = 0.62;
const MOST_COVER: f32 = 0.75;
/// Radius of what light is scattered over, in reduced pixels.
const SCATTER: usize = 6;

/// Spots on one camera's glass.
#[derive(Debug, Clone)]
pub(crate) struct Smudges {
    spots: Vec<Spot>,
}

#[derive(Debug, Clone)]
struct Spot {
    /// Pixels.
    centre: Vec2,
    radius: f32,
    cover: f32,
}

impl Smudges {
    /// So many spots, most of them small.
    pub(crate) fn new(count: u32, size: ImageSize, seed: u64) -> Self {
        let mut random = Stream::named(seed, "smudges", &[]);
        let (width, height) = (size.width as f32, size.height as f32);
        let spot = |_| {
            let share = random.f32();
            Spot {
                centre: Vec2::new(random.f32() * width, random.f32() * height),
                radius: height * (0.015 + 0.16 * share * share),
                cover: random.range_f32(0.25, MOST_COVER),
            }
        };
        Self { spots: (0..count).map(spot).collect() }
    }

    /// Lays the spots over a picture.
    pub(crate) fn draw(&self, size: ImageSize, picture: &mut [Vec3A]) {
        let (width, height) = (size.width as usize, size.height as usize);
        let (w, h) = (width.div_ceil(REDUCE), height.div_ceil(REDUCE));
        let soft = box_blur(&reduce(width, height, picture, w, h), w, h, SCATTER);
        for spot in &self.spots {
            let low = (spot.centre - spot.radius).floor().max(Vec2::ZERO).as_uvec2();
            let last = Vec2::new(width as f32 - 1.0, height as f32 - 1.0);
            let high = (spot.centre + spot.radius).ceil().min(last).as_uvec2();
            for y in low.y..=high.y {
                for x in low.x..=high.x {
                    let away = (Vec2::new(x as f32 + 0.5, y as f32 + 0.5) - spot.centre).length() / spot.radius;
                    let cover = spot.cover * math::smoothstep(1.0, 0.1, away);
                    let scattered = soft[(y as usize / REDUCE) * w + x as usize / REDUCE] * THROUGH;
                    let pixel = &mut picture[y as usize * width + x as usize];
                    *pixel = pixel.lerp_unfused(scattered, cover);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dirt_takes_light_away_and_leaves_the_rest_of_the_picture() {
        let size = ImageSize { width: 320, height: 180 };
        let picture = vec![Vec3A::ONE; size.pixels()];
        let mut dirty = picture.clone();
        Smudges::new(4, size, 3).draw(size, &mut dirty);
        let darker = dirty.iter().filter(|p| p.x < 0.99).count();
        assert!(darker > 100 && darker < size.pixels(), "{darker}");
        assert!(dirty.iter().all(|p| (0.6..=1.0).contains(&p.x)));
        let mut again = picture;
        Smudges::new(4, size, 3).draw(size, &mut again);
        assert_eq!(dirty, again);
    }
}
