//! What samples near the edges of shadows see of the sun's disc.

use super::sparse_centre::{PARTS, ROWS};
use crate::accel::{Ray, RayStream, Tlas};
use crate::light::Sun;
use glam::Vec3A;

/// Samples whose rays go together.
const SAMPLES_OF_BUNDLE: usize = 8 * ROWS / PARTS.len();

/// Rays to all of the sun's disc from a few samples.
pub(super) struct DiscRays {
    rays: RayStream<ROWS>,
    /// Pixel of the row, and sample.
    places: [(usize, usize); SAMPLES_OF_BUNDLE],
    count: usize,
}

impl DiscRays {
    pub(super) fn none() -> Self {
        Self { rays: RayStream::NONE, places: [(0, 0); SAMPLES_OF_BUNDLE], count: 0 }
    }

    pub(super) fn is_full(&self) -> bool {
        self.count == SAMPLES_OF_BUNDLE
    }

    /// Adds those of a sample.
    pub(super) fn push(&mut self, sun: &Sun, (x, sample): (usize, usize), origin: Vec3A) {
        for (lane, part) in (self.count * PARTS.len()..).zip(PARTS) {
            self.rays.set(lane, &Ray { origin, direction: sun.disc[sample][part], tmax: f32::MAX });
        }
        self.places[self.count] = (x, sample);
        self.count += 1;
    }

    /// Traces them all and tells which parts of the disc each sample sees.
    pub(super) fn trace(&mut self, accel: &Tlas, mut tell: impl FnMut(usize, usize, u8)) {
        let count = std::mem::take(&mut self.count);
        if count == 0 {
            return;
        }
        let shaded = accel.occluded32(&self.rays, ((1u64 << (count * PARTS.len())) - 1) as u32);
        for (k, &(x, sample)) in self.places[..count].iter().enumerate() {
            let free = |ray: usize| u8::from(shaded >> (PARTS.len() * k + ray) & 1 == 0);
            // Each ray stands for half of what the sample asks elsewhere.
            tell(x, sample, (free(0) * 0b0011) | (free(1) * 0b1100));
        }
    }
}
