//! Points of the picture where light is gathered, and what the samples between them take from it.

use crate::indirect::{DenoiseGuide, surface_weight};
use glam::Vec3A;
use rayon::prelude::*;

/// Pixels between points, along and down.
pub(super) const SPACING: usize = 2;
/// Samples take light from points around them that lie on their own surface by as much as this, together.
const LEAST_WEIGHT: f32 = 0.15;
/// Others take a share from points around them that are as near as this, together.
const LEAST_SHARE: f32 = 0.3;

/// Points are clean if those around lie on their surface by as much as this, in the mean.
const LEAST_SUPPORT: f32 = 0.3;

/// Points, row by row, and the light gathered there.
pub(super) struct PointGrid {
    pub(super) width: usize,
    pub(super) guides: Vec<DenoiseGuide>,
    /// Irradiance, klx.
    pub(super) light: Vec<Vec3A>,
    /// That as a share of the irradiance in the open.
    pub(super) share: Vec<Vec3A>,
    /// Whether enough points around lie on the same surface: elsewhere, denoising left noise.
    clean: Vec<bool>,
}

impl PointGrid {
    /// Of points whose light is denoised.
    pub(super) fn new(width: usize, guides: Vec<DenoiseGuide>, light: Vec<Vec3A>, share: Vec<Vec3A>) -> Self {
        let clean = (0..guides.len()).into_par_iter().map(|place| is_clean(width, &guides, place)).collect();
        Self { width, guides, light, share, clean }
    }

    /// The points around a pixel, at most `reach` to each side.
    fn around(&self, x: usize, y: usize, reach: usize) -> impl Iterator<Item = usize> {
        around(self.width, self.guides.len() / self.width, [x, y], reach)
    }

    /// Light of a sample of the pixel at (x, y), from the points around it that lie on its surface.
    pub(super) fn on_surface(&self, here: &DenoiseGuide, x: usize, y: usize) -> Option<Vec3A> {
        let (mut sum, mut total) = (Vec3A::ZERO, 0.0);
        for place in self.around(x, y, 1).filter(|place| self.clean[*place]) {
            let weight = surface_weight(here, &self.guides[place], 1.0);
            sum += self.light[place] * weight;
            total += weight;
        }
        (total > LEAST_WEIGHT).then(|| sum / total)
    }

    /// Share of the light in the open that reaches the things near a sample of the pixel at (x, y), however they are
    /// turned.
    pub(super) fn share_nearby(&self, here: &DenoiseGuide, x: usize, y: usize) -> Option<Vec3A> {
        let (mut sum, mut total) = (Vec3A::ZERO, 0.0);
        for place in self.around(x, y, 2) {
            let there = &self.guides[place];
            if there.normal == Vec3A::ZERO {
                continue;
            }
            let apart = (there.position - here.position).length_squared() / (here.reach_m * here.reach_m);
            let near = 1.0 / (1.0 + 0.1 * apart);
            let facing = 0.2 + here.normal.dot(there.normal).max(0.0);
            let weight = near * near * facing;
            sum += self.share[place] * weight;
            total += weight;
        }
        (total > LEAST_SHARE).then(|| sum / total)
    }
}

/// The points around a pixel in a grid of points, at most `reach` to each side.
fn around(width: usize, height: usize, [x, y]: [usize; 2], reach: usize) -> impl Iterator<Item = usize> {
    let range = |at: usize, end: usize| {
        let first = (at / SPACING + 1).saturating_sub(reach).min(end - 1);
        first..(at.div_ceil(SPACING) + reach).min(end)
    };
    let columns = range(x, width);
    range(y, height).flat_map(move |row| columns.clone().map(move |column| row * width + column))
}

/// Whether enough of the points around one lie on its surface.
fn is_clean(width: usize, guides: &[DenoiseGuide], place: usize) -> bool {
    let pixel = [place % width, place / width].map(|at| SPACING * at);
    let (mut sum, mut count) = (0.0, 0.0);
    for other in around(width, guides.len() / width, pixel, 2).filter(|other| *other != place) {
        sum += surface_weight(&guides[place], &guides[other], 1.0);
        count += 1.0;
    }
    sum > LEAST_SUPPORT * count
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wall of nine by five points a metre apart; light grows along it.
    fn wall() -> PointGrid {
        let place = |i: usize| Vec3A::new((i % 9) as f32, 0.0, (i / 9) as f32);
        let guides = (0..45).map(|i| DenoiseGuide { position: place(i), normal: Vec3A::Y, reach_m: 1.0 }).collect();
        let light = (0..45).map(|i| Vec3A::splat((i % 9) as f32)).collect();
        PointGrid::new(9, guides, light, vec![Vec3A::splat(0.5); 45])
    }

    #[test]
    fn what_lies_between_points_takes_from_all_of_them() {
        let here = DenoiseGuide { position: Vec3A::new(3.5, 0.0, 2.5), normal: Vec3A::Y, reach_m: 1.0 };
        let light = wall().on_surface(&here, 7, 5).expect("on the wall");
        assert!((light.x - 3.5).abs() < 1e-4, "{light}");
    }

    #[test]
    fn what_lies_elsewhere_takes_nothing_and_what_is_turned_away_a_share() {
        let turned = DenoiseGuide { position: Vec3A::new(3.0, 0.0, 2.0), normal: Vec3A::X, reach_m: 1.0 };
        assert!(wall().on_surface(&turned, 6, 4).is_none());
        assert_eq!(wall().share_nearby(&turned, 6, 4), Some(Vec3A::splat(0.5)));
        let far = DenoiseGuide { position: Vec3A::new(3.0, 40.0, 2.0), normal: Vec3A::Y, reach_m: 1.0 };
        assert!(wall().on_surface(&far, 6, 4).is_none() && wall().share_nearby(&far, 6, 4).is_none());
    }

    #[test]
    fn what_lies_by_a_point_alone_on_its_surface_takes_nothing() {
        let mut grid = wall();
        grid.guides[21].normal = Vec3A::X;
        let grid = PointGrid::new(grid.width, grid.guides, grid.light, grid.share);
        let here = DenoiseGuide { position: Vec3A::new(3.0, 0.0, 2.0), normal: Vec3A::X, reach_m: 1.0 };
        assert!(grid.on_surface(&here, 6, 4).is_none());
    }

    #[test]
    fn corners_of_the_picture_have_points() {
        for (x, y) in [(0, 0), (17, 0), (0, 9), (17, 9)] {
            assert!(wall().around(x, y, 1).count() > 0 && wall().around(x, y, 2).all(|place| place < 45));
        }
    }
}
