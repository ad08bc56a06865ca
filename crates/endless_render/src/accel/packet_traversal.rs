//! The state of a packet's traversal.

use super::ray::Hit;
use super::stream::{RayStream, StreamHits, lane_mask};
use wide::f32x8;

/// How far N times eight rays have come.
pub(super) struct PacketTraversal<const N: usize> {
    /// Lanes still to trace, one bit each.
    pub(super) live: u32,
    best: [[Hit; 8]; N],
    /// `t` of each `best`, side by side: boxes are tested against it.
    pub(super) ends: [f32x8; N],
    /// Largest of those of the live lanes.
    pub(super) reach: f32,
}

impl<const N: usize> PacketTraversal<N> {
    pub(super) fn new(rays: &RayStream<N>, active: u32) -> Self {
        let best = rays.tmax.map(|row| row.to_array().map(Hit::none));
        let mut trip = PacketTraversal { live: active, best, ends: rays.tmax, reach: 0.0 };
        trip.update_reach();
        trip
    }

    pub(super) fn update_reach(&mut self) {
        let mut most = f32x8::ZERO;
        for (row, ends) in self.ends.iter().enumerate() {
            most = most.fast_max(lane_mask(self.live >> (8 * row)) & *ends);
        }
        self.reach = most.to_array().into_iter().fold(0.0, f32::max);
    }

    /// The best hit of a lane so far.
    #[inline]
    pub(super) fn best(&self, lane: usize) -> &Hit {
        &self.best[lane / 8 % N][lane % 8]
    }

    /// A better one.
    #[inline]
    pub(super) fn improve(&mut self, lane: usize, hit: Hit) {
        self.best[lane / 8 % N][lane % 8] = hit;
        self.ends[lane / 8 % N].as_mut_array()[lane % 8] = hit.t;
    }

    /// One row alone.
    pub(super) fn row(&self, row: usize) -> PacketTraversal<1> {
        let live = self.live >> (8 * row) & 255;
        let mut part = PacketTraversal { live, best: [self.best[row]], ends: [self.ends[row]], reach: 0.0 };
        part.update_reach();
        part
    }

    pub(super) fn set_row(&mut self, row: usize, part: &PacketTraversal<1>) {
        let PacketTraversal { live, best: [best], ends: [ends], .. } = *part;
        self.live = self.live & !(255 << (8 * row)) | live << (8 * row);
        (self.best[row], self.ends[row]) = (best, ends);
    }

    pub(super) fn hits(self, asked: u32) -> StreamHits<N> {
        StreamHits { best: self.best, asked }
    }
}
