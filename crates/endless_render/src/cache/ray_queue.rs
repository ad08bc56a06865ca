//! Rays towards moving objects that wait until enough of them can be traced together.

use crate::accel::{Hit, Ray, RayStream, lanes};
use crate::scene::FrameScene;

/// Who asks for a ray: a pixel, a sample, and the parts of the sun's disc that it stands for.
pub(super) type RayOwner = (usize, usize, u8);

/// Rays of a row that are traced together: one for each sample of eight pixels.
pub(super) struct RayQueue {
    owners: [RayOwner; 32],
    pub(super) rays: RayStream<4>,
    count: usize,
    /// Rays traced so far.
    pub(super) traced: u64,
}

impl RayQueue {
    pub(super) fn new() -> Self {
        Self { owners: [(0, 0, 0); 32], rays: RayStream::NONE, count: 0, traced: 0 }
    }

    /// Adds a ray; there must be room.
    pub(super) fn push(&mut self, owner: RayOwner, ray: Ray) {
        self.owners[self.count] = owner;
        self.rays.set(self.count, &ray);
        self.count += 1;
    }

    pub(super) fn is_full(&self) -> bool {
        self.count == self.owners.len()
    }

    /// Takes all rays off the list: those there were, a bit each.
    fn take(&mut self) -> u32 {
        let active = ((1u64 << self.count) - 1) as u32;
        self.traced += self.count as u64;
        self.count = 0;
        active
    }

    /// Tells who met something nearer than its ray's end.
    pub(super) fn closest(&mut self, frame: &FrameScene, mut tell: impl FnMut(RayOwner, Hit)) {
        let active = self.take();
        if active == 0 {
            return;
        }
        let hits = frame.accel.closest32(&self.rays, active);
        for lane in lanes(active) {
            if let Some(hit) = hits.get(lane).filter(|hit| hit.t < self.rays.ray(lane).tmax) {
                tell(self.owners[lane], hit);
            }
        }
    }

    /// Tells whose ray is not free.
    pub(super) fn occluded(&mut self, frame: &FrameScene, mut tell: impl FnMut(RayOwner)) {
        let active = self.take();
        if active == 0 {
            return;
        }
        for lane in lanes(frame.accel.occluded32(&self.rays, active)) {
            tell(self.owners[lane]);
        }
    }
}
