//! What moves in front of the pixels of a tile, and its light.

use super::bake::CameraBake;
use super::cover::Cover;
use super::row::Found;
use super::tile::TILE;
use crate::accel::Ray;
use crate::sampling::SAMPLES;
use crate::scene::{FrameScene, SurfacePoint};
use crate::shade::Seen;
use endless_scene::Surface;
use glam::Vec3A;

/// Pixels of a tile.
const PIXELS: usize = (TILE * TILE) as usize;

/// Lights that lie no further apart than this share are told by their mean.
const ALIKE: f32 = 0.06;

/// A pixel of a tile towards which rays found something.
pub(super) struct Touched<'f> {
    /// Its place in the tile, row by row.
    pub(super) place: usize,
    pub(super) rays: [Ray; SAMPLES],
    pub(super) found: &'f Found,
}

/// What covers each pixel of a tile. `shade` gives the light of samples; `halo` that of lamps in the air before one, at
/// a place of the tile.
///
/// Of a smooth piece every fourth pixel is shaded, across and down, then every second, then all: but one that lies between
/// pixels of the same piece that look alike has their mean.
pub(super) fn covers<'a, 'f>(
    bake: &CameraBake,
    frame: &'a FrameScene,
    pixels: impl Iterator<Item = Touched<'f>>,
    mut shade: impl FnMut(&[&Seen<'a>]) -> Vec<Vec3A>,
    halo: impl Fn(usize, &Seen<'a>) -> Vec3A,
) -> [Cover; PIXELS] {
    let mut seen = Vec::new();
    let mut covers = [const { Cover::NONE }; PIXELS];
    for Touched { place, rays, found } in pixels {
        covers[place] = Cover::new(bake, frame, &rays, found, &mut seen);
    }
    if seen.is_empty() {
        return covers;
    }
    let between = Step::ALL.map(|step| between(&covers, &seen, step));
    let mut lights = vec![Vec3A::ZERO; seen.len()];
    let mut shade_all = |wanted: &[usize], lights: &mut [Vec3A]| {
        let samples: Vec<&Seen<'_>> = wanted.iter().map(|&i| &seen[i]).collect();
        for (&i, light) in wanted.iter().zip(shade(&samples)) {
            lights[i] = light;
        }
    };
    let mut first = vec![true; seen.len()];
    for Between { own, .. } in between.iter().flatten() {
        first[*own] = false;
    }
    let first: Vec<usize> = (0..seen.len()).filter(|&i| first[i]).collect();
    shade_all(&first, &mut lights);
    for between in between {
        let mut unlike = Vec::new();
        for Between { own, around } in between {
            match mean_of_alike(around.map(|i| lights[i])) {
                Some(mean) => lights[own] = mean,
                None => unlike.push(own),
            }
        }
        shade_all(&unlike, &mut lights);
    }
    for (place, cover) in covers.iter_mut().enumerate() {
        for i in cover.shaded.clone() {
            cover.light += (lights[i] + halo(place, &seen[i])) * f32::from(seen[i].stands_for);
        }
    }
    covers
}

/// A sample that tells its whole pixel, and those of pixels around it that may stand for it.
struct Between {
    own: usize,
    around: [usize; 4],
}

/// How far apart the pixels lie between which a pixel has its place.
#[derive(Clone, Copy)]
enum Step {
    /// Four.
    Wide,
    /// Two.
    Narrow,
}

impl Step {
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
fn between(covers: &[Cover; PIXELS], seen: &[Seen<'_>], step: Step) -> Vec<Between> {
    let side = TILE as usize;
    let of_place = |place: usize| {
        let (x, y) = (place % side, place / side);
        let ([left, right], [above, below]) = (step.around(x), step.around(y));
        if step.passes(x) || step.passes(y) || (left == right && above == below) {
            return None;
        }
        let own = covers[place].told_by(seen)?;
        let corner = |x: usize, y: usize| {
            covers[y * side + x].told_by(seen).filter(|&i| same_piece(&seen[i].point, &seen[own].point))
        };
        let around = [corner(left, above)?, corner(right, above)?, corner(left, below)?, corner(right, below)?];
        Some(Between { own, around })
    };
    (0..PIXELS).filter_map(of_place).collect()
}

/// Whether two points lie on the same smooth piece of something that moves, and look the same but for the light.
fn same_piece(a: &SurfacePoint<'_>, b: &SurfacePoint<'_>) -> bool {
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
