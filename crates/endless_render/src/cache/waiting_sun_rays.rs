//! Rays to the sun from samples anywhere in a row, which wait until enough of them can go together.

use super::sparse_centre::ROWS;
use crate::accel::{Ray, RayStream, Tlas};
use glam::Vec3A;

/// How many go together.
const LANES: usize = 8 * ROWS;

/// Those that wait.
pub(super) struct WaitingSunRays {
    rays: RayStream<ROWS>,
    asked_by: [SunQuestion; LANES],
    count: usize,
}

/// Who asks, and for how much.
#[derive(Clone, Copy)]
pub(super) struct SunQuestion {
    /// Of the row.
    pub(super) pixel: usize,
    pub(super) sample: usize,
    /// The parts of the sun's disc that the ray stands for, a bit each.
    pub(super) parts: u8,
}

impl WaitingSunRays {
    pub(super) fn none() -> Self {
        let nobody = SunQuestion { pixel: 0, sample: 0, parts: 0 };
        Self { rays: RayStream::NONE, asked_by: [nobody; LANES], count: 0 }
    }

    pub(super) fn is_full(&self) -> bool {
        self.count == LANES
    }

    /// Adds one.
    pub(super) fn push(&mut self, question: SunQuestion, origin: Vec3A, direction: Vec3A) {
        self.rays.set(self.count, &Ray { origin, direction, tmax: f32::MAX });
        self.asked_by[self.count] = question;
        self.count += 1;
    }

    /// Traces them all and tells who sees what they asked for.
    pub(super) fn trace(&mut self, accel: &Tlas, mut sees: impl FnMut(SunQuestion)) {
        let count = std::mem::take(&mut self.count);
        if count == 0 {
            return;
        }
        let shaded = accel.occluded32(&self.rays, ((1u64 << count) - 1) as u32);
        for (ray, &question) in self.asked_by[..count].iter().enumerate() {
            if shaded >> ray & 1 == 0 {
                sees(question);
            }
        }
    }
}
