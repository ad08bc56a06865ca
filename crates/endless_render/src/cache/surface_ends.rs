//! Where surfaces end between the centres of neighbouring pixels.

use super::centre_band::Centres;
use super::faint_ends::DayLight;
use super::pieces8::Pieces8;
use super::sparse_centre::Centre;
use crate::accel::lanes;
use crate::camera_rays::{aims8, places8};
use crate::octahedron::unpack8;
use crate::sampling::SAMPLES;
use endless_world::PinholeCamera;
use rayon::prelude::*;
use wide::f32x8;

/// Whether pixels' neighbours to the right and below go on on their surfaces. The picture's edges end nothing.
pub(super) struct SurfaceEnds {
    /// Of eight pixels that follow each other in a row, a bit each.
    goes_on: Vec<GoesOn>,
    row_blocks: usize,
}

/// Of eight pixels: which neighbours to the right, and below, are alike.
#[derive(Clone, Copy, Default)]
struct GoesOn {
    right: u8,
    below: u8,
}

impl SurfaceEnds {
    /// By day, ends that are hardly seen are none.
    pub(super) fn new(camera: &PinholeCamera, centres: &Centres, light: Option<&DayLight>) -> Self {
        let row_blocks = centres.width.div_ceil(8);
        let mut goes_on = vec![GoesOn::default(); row_blocks * centres.height];
        goes_on.par_chunks_mut(row_blocks).enumerate().for_each(|(y, row)| {
            for (block, goes_on) in row.iter_mut().enumerate() {
                *goes_on = compare_block(camera, centres, light, 8 * block, y);
            }
        });
        Self { goes_on, row_blocks }
    }

    /// Which samples of a pixel lie between its centre and those of neighbours on the same surface.
    pub(super) fn known(&self, x: usize, y: usize) -> [bool; SAMPLES] {
        let block = |x: usize, y: usize| self.goes_on[y * self.row_blocks + x / 8];
        let has = |bits: u8, x: usize| bits >> (x % 8) & 1 == 1;
        let own = block(x, y);
        let left = x == 0 || has(block(x - 1, y).right, x - 1);
        let above = y == 0 || has(block(x, y - 1).below, x);
        [true, has(own.right, x), left && has(own.below, x), above]
    }
}

/// Whether the surfaces of up to eight pixels from `x` on go on.
fn compare_block(camera: &PinholeCamera, centres: &Centres, light: Option<&DayLight>, x: usize, y: usize) -> GoesOn {
    let row = centres.row(y);
    let own = &row[x..row.len().min(x + 8)];
    let right = compare(own, &row[x + 1..row.len().min(x + 9)]);
    let below = match y + 1 < centres.height {
        true => compare(own, &centres.row(y + 1)[x..][..own.len()]),
        false => Comparison { alike: u8::MAX, unsure: 0 },
    };
    // The last pixel of a row has no neighbour that it could differ from.
    let at_the_end = u8::from(x + own.len() == row.len()) << (own.len() - 1);
    let mut goes_on = GoesOn { right: right.alike | at_the_end, below: below.alike };
    if right.unsure | below.unsure != 0 {
        let pieces = Pieces8::of_centres(camera, row, x, y);
        let faint = |ends: u8, others: &[Centre]| {
            let is_faint = |lane: usize| light.is_some_and(|light| light.is_faint(&own[lane], &others[lane]));
            lanes(ends.into()).filter(|&lane| is_faint(lane)).fold(0, |bits, lane| bits | 1 << lane)
        };
        if right.unsure != 0 {
            goes_on.right |= right.unsure & pieces.go_on_in(&Pieces8::of_centres(camera, row, x + 1, y));
            goes_on.right |= faint(right.unsure & !goes_on.right, &row[x + 1..]);
        }
        if below.unsure != 0 {
            goes_on.below |= below.unsure & pieces.go_on_in(&Pieces8::of_centres(camera, centres.row(y + 1), x, y + 1));
            goes_on.below |= faint(below.unsure & !goes_on.below, &centres.row(y + 1)[x..]);
        }
    }
    goes_on
}

/// What is evident of eight pixels and neighbours of theirs, a bit each.
#[derive(Default)]
struct Comparison {
    alike: u8,
    /// Where that takes a look at places and normals.
    unsure: u8,
}

fn compare(own: &[Centre], others: &[Centre]) -> Comparison {
    let mut comparison = Comparison::default();
    for (lane, (own, other)) in own.iter().zip(others).enumerate() {
        let evident = own.evidently_continues(other);
        comparison.alike |= u8::from(evident == Some(true)) << lane;
        comparison.unsure |= u8::from(evident.is_none()) << lane;
    }
    comparison
}

impl Pieces8 {
    /// Of the pixels from `x` on of a row; beyond its end, of the last.
    fn of_centres(camera: &PinholeCamera, row: &[Centre], x: usize, y: usize) -> Self {
        let centres: [&Centre; 8] = std::array::from_fn(|i| &row[(x + i).min(row.len() - 1)]);
        let aims = aims8(camera, x as u32, row.len() as u32, y as u32, 0);
        let distances = f32x8::new(centres.map(|centre| centre.distance));
        Self {
            positions: places8(camera, &aims, distances),
            geometric: unpack8(&centres.map(|centre| centre.normals.geometric)),
            shading: unpack8(&centres.map(|centre| centre.normals.shading)),
        }
    }
}
