//! Points of the picture where light is gathered, and what the samples between them take from it.

use crate::indirect::{DenoiseGuide, surface_weight};
use glam::Vec3A;
use rayon::prelude::*;

/// Points along a row of a picture, at least: light varies over angles, however many pixels tell it.
const POINTS_ACROSS: usize = 640;

/// Pixels between the points of a picture of some width, along and down.
pub(super) fn spacing(width: usize) -> usize {
    (width / POINTS_ACROSS).max(2)
}

/// Samples take light from points around them that lie on their own surface by as much as this, together.
const LEAST_WEIGHT: f32 = 0.15;
/// Others take a share from points around them that are as near as this, together.
const LEAST_SHARE: f32 = 0.3;

/// Points are clean if those around lie on their surface by as much as this, in the mean.
const LEAST_SUPPORT: f32 = 0.3;

/// Points, row by row, and the light gathered there.
pub(super) struct PointGrid {
    pub(super) width: usize,
    /// Pixels between them.
    pub(super) spacing: usize,
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
    pub(super) fn new(
        width: usize,
        spacing: usize,
        guides: Vec<DenoiseGuide>,
        light: Vec<Vec3A>,
        share: Vec<Vec3A>,
    ) -> Self {
        let clean = (0..guides.len()).into_par_iter().map(|place| is_clean(width, &guides, place)).collect();
        Self { width, spacing, guides, light, share, clean }
    }

    /// The points around a pixel, at most `reach` to each side.
    fn around(&self, x: usize, y: usize, reach: usize) -> impl Iterator<Item = usize> {
        let places = [x, y].map(|at| at / self.spacing..at.div_ceil(self.spacing));
        around(self.width, self.guides.len() / self.width, places, reach)
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

/// The points of a grid around a place: its column and row, or those between which it lies; at most `reach` to each side.
fn around(
    width: usize,
    height: usize,
    [x, y]: [std::ops::Range<usize>; 2],
    reach: usize,
) -> impl Iterator<Item = usize> {
    let range = |at: std::ops::Range<usize>, end: usize| {
        let first = (at.start + 1).saturating_sub(reach).min(end - 1);
        first..(at.end + reach).min(end)
    };
    let columns = range(x, width);
    range(y, height).flat_map(move |row| columns.clone().map(move |column| row * width + column))
}

/// Whether enough of the points around one lie on its surface.
fn is_clean(width: usize, guides: &[DenoiseGuide], place: usize) -> bool {
    let own = [place % width, place / width].map(|at| at..at);
    let (mut sum, mut count) = (0.0, 0.0);
    for other in around(width, guides.len() / width, own, 2).filter(|other| *other != place) {
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
        PointGrid::new(9, 2, guides, light, vec![Vec3A::splat(0.5); 45])
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
        let grid = PointGrid::new(grid.width, 2, grid.guides, grid.light, grid.share);
        let here = DenoiseGuide { position: Vec3A::new(3.0, 0.0, 2.0), normal: Vec3A::X, reach_m: 1.0 };
        assert!(grid.on_surface(&here, 6, 4).is_none());
    }

    #[test]
    fn points_lie_as_densely_in_angle_on_large_pictures() {
        assert_eq!([320, 960, 1280, 1920, 3840].map(spacing), [2, 2, 2, 3, 6]);
    }

    #[test]
    fn corners_of_the_picture_have_points() {
        for (x, y) in [(0, 0), (17, 0), (0, 9), (17, 9)] {
            assert!(wall().around(x, y, 1).count() > 0 && wall().around(x, y, 2).all(|place| place < 45));
        }
    }
}
