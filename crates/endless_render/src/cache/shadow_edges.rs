//! The pixels around which some lie in the light of the sun and some do not.

use super::centre_band::{Centres, SunBits};
use super::sparse_centre::Centre;
use rayon::prelude::*;

/// How far from the edge of a shadow all of the disc is asked, at most: pixels.
const PENUMBRA: usize = 4;
/// Half the width of the shadow's edge of something five metres away.
const PENUMBRA_M: f32 = 0.023;
/// Edges of which half is narrower than this are sharp, pixels.
const SHARP: f32 = 0.7;

/// How many pixels before and after itself a pixel looks for the edge of a shadow.
#[derive(Clone, Copy)]
struct Reach {
    before: usize,
    after: usize,
}

impl Reach {
    fn of(centre: &Centre, pixel_angle: f32) -> Self {
        // An edge is told by the pixel to the left of it, or above.
        if is_sharp(centre, pixel_angle) {
            return Self { before: 1, after: 0 };
        }
        let reach = (penumbra(centre, pixel_angle) as usize).clamp(1, PENUMBRA);
        Self { before: reach, after: reach }
    }

    /// These pixels from here on, in the order of a byte's bits.
    fn window(self) -> u32 {
        (1 << (self.before + 1 + self.after)) - 1
    }
}

/// Half the width of a shadow's edge, pixels.
fn penumbra(centre: &Centre, pixel_angle: f32) -> f32 {
    PENUMBRA_M / (centre.distance * pixel_angle)
}

/// Whether the edges of shadows lie between two pixels here: each sample sees all of the sun's disc, or nothing.
pub(super) fn is_sharp(centre: &Centre, pixel_angle: f32) -> bool {
    penumbra(centre, pixel_angle) < SHARP
}

/// The pixels near the edge of a shadow.
pub(super) struct ShadowEdges {
    near: Bits,
}

/// Of eight pixels that follow each other in a row a bit each, row by row.
struct Bits {
    bytes: Vec<u8>,
    /// Bytes of a row.
    stride: usize,
}

impl Bits {
    /// `byte` tells them by row and place in the row.
    fn new(centres: &Centres, byte: impl Fn(usize, usize) -> u8 + Sync) -> Self {
        let stride = centres.width.div_ceil(8);
        let mut bytes = vec![0; stride * centres.height];
        bytes.par_chunks_mut(stride).enumerate().for_each(|(y, row)| {
            for (place, own) in row.iter_mut().enumerate() {
                *own = byte(y, place);
            }
        });
        Self { bytes, stride }
    }

    fn row(&self, y: usize) -> &[u8] {
        &self.bytes[y * self.stride..][..self.stride]
    }
}

impl ShadowEdges {
    pub(super) fn new(centres: &Centres, pixel_angle: f32) -> Self {
        let edges = Bits::new(centres, |y, place| edges_of(centres, y, place));
        let reach = |centre: &Centre| Reach::of(centre, pixel_angle);
        let across = Bits::new(centres, |y, place| {
            let row = edges.row(y);
            let byte = |place: usize| u32::from(row.get(place).copied().unwrap_or(0));
            // Bit 8 is the first pixel's.
            let around = place.checked_sub(1).map_or(0, byte) | byte(place) << 8 | byte(place + 1) << 16;
            if around == 0 {
                return 0;
            }
            let own = &centres.row(y)[8 * place..];
            own.iter().take(8).enumerate().fold(0, |bits, (lane, centre)| {
                let reach = reach(centre);
                bits | u8::from(around >> (8 + lane - reach.before) & reach.window() != 0) << lane
            })
        });
        let near = Bits::new(centres, |y, place| {
            let rows = y.saturating_sub(PENUMBRA)..(y + PENUMBRA + 1).min(centres.height);
            let SunBits { lit, shaded } = centres.sun_of_row(y)[place];
            let asking = (lit | shaded) & rows.fold(0, |bits, y| bits | across.row(y)[place]);
            if asking == 0 {
                return 0;
            }
            let own = &centres.row(y)[8 * place..];
            own.iter().take(8).enumerate().filter(|(lane, _)| asking >> lane & 1 == 1).fold(
                0,
                |bits, (lane, centre)| {
                    let Reach { before, after } = reach(centre);
                    let mut rows = y.saturating_sub(before)..(y + after + 1).min(centres.height);
                    bits | u8::from(rows.any(|y| across.row(y)[place] >> lane & 1 == 1)) << lane
                },
            )
        });
        Self { near }
    }

    /// Of eight pixels that follow each other, a bit each.
    pub(super) fn row(&self, y: usize) -> &[u8] {
        self.near.row(y)
    }
}

/// Which of eight pixels are lit while their neighbour to the right, or below, is shaded, or the other way round.
fn edges_of(centres: &Centres, y: usize, place: usize) -> u8 {
    let (row, next_row) = (centres.sun_of_row(y), centres.sun_of_row(y + 1));
    let of = |row: &[SunBits], place: usize| row.get(place).copied().unwrap_or_default();
    let (own, after, below) = (of(row, place), of(row, place + 1), of(next_row, place));
    let right = SunBits { lit: own.lit >> 1 | after.lit << 7, shaded: own.shaded >> 1 | after.shaded << 7 };
    own.lit & (right.shaded | below.shaded) | own.shaded & (right.lit | below.lit)
}
