//! What the rays through the centres of all pixels met, in bands of a few rows.

use super::sparse_centre::{Centre, ROWS};

/// Some rows of pixels.
pub(super) struct CentreBand {
    /// Row by row.
    pub(super) centres: Vec<Centre>,
    /// What the sun lights of eight pixels that follow each other in a row, and what lies in its shadow, a bit each.
    pub(super) sun: Vec<SunBits>,
}

/// Of eight pixels.
#[derive(Clone, Copy, Default)]
pub(super) struct SunBits {
    pub(super) lit: u8,
    pub(super) shaded: u8,
}

impl CentreBand {
    /// Rows of nothing but sky.
    pub(super) fn of_sky(width: usize, rows: usize) -> Self {
        Self { centres: vec![Centre::SKY; width * rows], sun: vec![SunBits::default(); width.div_ceil(8) * rows] }
    }
}

/// All pixels.
pub(super) struct Centres {
    pub(super) width: usize,
    pub(super) height: usize,
    /// Of [`ROWS`] rows each, but for the last.
    pub(super) bands: Vec<CentreBand>,
}

impl Centres {
    pub(super) fn row(&self, y: usize) -> &[Centre] {
        &self.bands[y / ROWS].centres[y % ROWS * self.width..][..self.width]
    }

    /// Eight pixels each; none outside the picture.
    pub(super) fn sun_of_row(&self, y: usize) -> &[SunBits] {
        let blocks = self.width.div_ceil(8);
        if y < self.height { &self.bands[y / ROWS].sun[y % ROWS * blocks..][..blocks] } else { &[] }
    }
}
