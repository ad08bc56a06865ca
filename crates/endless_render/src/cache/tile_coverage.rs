//! Moving objects in front of the pixels of a tile, and their light.

use super::bake::CameraBake;
use super::coverage::Coverage;
use super::moving_hits::MovingHits;
use super::tile::TILE;
use crate::accel::Ray;
use crate::sampling::SAMPLES;
use crate::scene::{FrameScene, SurfaceInteraction};
use crate::shade::MovingSample;
use endless_scene::Surface;
use glam::Vec3A;

/// Pixels of a tile.
const PIXELS: usize = (TILE * TILE) as usize;

/// Lights that lie no further apart than this share are told by their mean.
const ALIKE: f32 = 0.06;

/// A pixel of a tile towards which rays found something.
pub(super) struct CoveredPixel<'f> {
    /// Its place in the tile, row by row.
    pub(super) place: usize,
    pub(super) rays: [Ray; SAMPLES],
    pub(super) found: &'f MovingHits,
}

/// What covers each pixel of a tile. `shade` gives the light of samples; `halo` that of lamps in the air before one, at
/// a place of the tile.
///
/// Of a smooth piece every fourth pixel is shaded, across and down, then every second, then all: but one that lies between
/// pixels of the same piece that look alike has their mean.
pub(super) fn coverages<'a, 'f>(
    bake: &CameraBake,
    frame: &'a FrameScene,
    pixels: impl Iterator<Item = CoveredPixel<'f>>,
    mut shade: impl FnMut(&[&MovingSample<'a>]) -> Vec<Vec3A>,
    halo: impl Fn(usize, &MovingSample<'a>) -> Vec3A,
) -> [Coverage; PIXELS] {
    let mut seen = Vec::new();
    let mut coverages = [const { Coverage::NONE }; PIXELS];
    for CoveredPixel { place, rays, found } in pixels {
        coverages[place] = Coverage::new(bake, frame, &rays, found, &mut seen);
    }
    if seen.is_empty() {
        return coverages;
    }
    let between = InterpolationStep::ALL.map(|step| between(&coverages, &seen, step));
    let mut lights = vec![Vec3A::ZERO; seen.len()];
    let mut shade_all = |wanted: &[usize], lights: &mut [Vec3A]| {
        let samples: Vec<&MovingSample<'_>> = wanted.iter().map(|&i| &seen[i]).collect();
        for (&i, light) in wanted.iter().zip(shade(&samples)) {
            lights[i] = light;
        }
    };
    let mut first = vec![true; seen.len()];
    for InterpolatedPixel { own, .. } in between.iter().flatten() {
        first[*own] = false;
    }
    let first: Vec<usize> = (0..seen.len()).filter(|&i| first[i]).collect();
    shade_all(&first, &mut lights);
    for between in between {
        let mut unlike = Vec::new();
        for InterpolatedPixel { own, around } in between {
            match mean_of_alike(around.map(|i| lights[i])) {
                Some(mean) => lights[own] = mean,
                None => unlike.push(own),
            }
        }
        shade_all(&unlike, &mut lights);
    }
    for (place, cover) in coverages.iter_mut().enumerate() {
        for i in cover.shaded.clone() {
            cover.light += (lights[i] + halo(place, &seen[i])) * f32::from(seen[i].stands_for);
        }
    }
    coverages
}

/// A sample that tells its whole pixel, and those of pixels around it that may stand for it.
struct InterpolatedPixel {
    own: usize,
    around: [usize; 4],
}

/// How far apart the pixels lie between which a pixel has its place.
#[derive(Clone, Copy)]
enum InterpolationStep {
    /// Four.
    Wide,
    /// Two.
    Narrow,
}

impl InterpolationStep {
    /// Wide ones first: the narrow ones build on them.
    const ALL: [Self; 2] = [Self::Wide, Self::Narrow];

    /// The places before and after a place along a line of the tile, or twice its own if it has its own light. The last
    /// place of a line has none after it.
    fn around(self, at: usize) -> [usize; 2] {
        match (self, at) {
            (Self::Wide, 2) => [0, 4],
            (Self::Wide, 6) => [4, 7],
            (Self::Narrow, 1 | 3 | 5) => [at - 1, at + 1],
            _ => [at; 2],
        }
    }

    /// Whether a place lies too closely between others for this step.
    fn passes(self, at: usize) -> bool {
        matches!((self, at), (Self::Wide, 1 | 3 | 5))
    }
}

/// The pixels that may be told by those around them, in the order of their samples.
fn between(
    coverages: &[Coverage; PIXELS],
    seen: &[MovingSample<'_>],
    step: InterpolationStep,
) -> Vec<InterpolatedPixel> {
    let side = TILE as usize;
    let of_place = |place: usize| {
        let (x, y) = (place % side, place / side);
        let ([left, right], [above, below]) = (step.around(x), step.around(y));
        if step.passes(x) || step.passes(y) || (left == right && above == below) {
            return None;
        }
        let own = coverages[place].told_by(seen)?;
        let corner = |x: usize, y: usize| {
            coverages[y * side + x].told_by(seen).filter(|&i| same_piece(&seen[i].point, &seen[own].point))
        };
        let around = [corner(left, above)?, corner(right, above)?, corner(left, below)?, corner(right, below)?];
        Some(InterpolatedPixel { own, around })
    };
    (0..PIXELS).filter_map(of_place).collect()
}

/// Whether two points lie on the same smooth piece of something that moves, and look the same but for the light.
fn same_piece(a: &SurfaceInteraction<'_>, b: &SurfaceInteraction<'_>) -> bool {
    std::ptr::eq(a.material, b.material)
        && a.instance.id == b.instance.id
        && a.normal.dot(b.normal) > 0.98
        // What panes show has edges of its own.
        && a.material.surface != Surface::CarGlass
}

fn mean_of_alike(lights: [Vec3A; 4]) -> Option<Vec3A> {
    let [a, b, c, d] = lights;
    let (least, most) = (a.min(b).min(c.min(d)), a.max(b).max(c.max(d)));
    (most - least).cmple(most * ALIKE).all().then(|| (a + b + c + d) * 0.25)
}
