//! Bounds of what the samples of a tile of pixels lie on and look at.

use super::beam_box::Bundle;
use glam::Vec3A;

/// Pixels along a tile's edge.
pub(super) const TILE: u32 = 8;
/// Tiles along the edge of a block of tiles: tests run on blocks first.
pub(super) const BLOCK: u32 = 8;

/// An axis-aligned box that may be empty.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span {
    pub(super) low: Vec3A,
    pub(super) high: Vec3A,
}

impl Span {
    pub(super) const EMPTY: Self = Self { low: Vec3A::INFINITY, high: Vec3A::NEG_INFINITY };

    pub(super) fn add(&mut self, p: Vec3A) {
        self.low = self.low.min(p);
        self.high = self.high.max(p);
    }

    pub(super) fn join(&mut self, other: &Self) {
        self.low = self.low.min(other.low);
        self.high = self.high.max(other.high);
    }

    pub(super) fn is_empty(&self) -> bool {
        self.low.x > self.high.x
    }

    /// Whether it overlaps a box.
    pub(super) fn meets(&self, low: Vec3A, high: Vec3A) -> bool {
        self.low.cmple(high).all() && self.high.cmpge(low).all()
    }
}

/// What a tile's still samples lie on.
#[derive(Debug, Clone, Copy)]
pub(super) struct TileBounds {
    /// All surface points.
    pub(super) points: Span,
    /// Points that the sun reaches.
    pub(super) sunlit: Span,
    /// Points that mirror.
    pub(super) mirrors: Span,
    /// Directions of their mirror rays.
    pub(super) mirror_directions: Span,
    /// Some sample is a traffic light's lens.
    pub(super) lens: bool,
}

impl TileBounds {
    pub(super) const EMPTY: Self = Self {
        points: Span::EMPTY,
        sunlit: Span::EMPTY,
        mirrors: Span::EMPTY,
        mirror_directions: Span::EMPTY,
        lens: false,
    };

    pub(super) fn join(&mut self, other: &Self) {
        self.points.join(&other.points);
        self.sunlit.join(&other.sunlit);
        self.mirrors.join(&other.mirrors);
        self.mirror_directions.join(&other.mirror_directions);
        self.lens |= other.lens;
    }

    /// The mirror rays, if there are any.
    pub(super) fn mirror_bundle(&self) -> Option<Bundle> {
        (!self.mirrors.is_empty())
            .then(|| bundle(&self.mirrors, self.mirror_directions.low, self.mirror_directions.high))
    }

    /// The rays to the sun's disc, if the sun reaches the tile.
    pub(super) fn sun_bundle(&self, sun: Vec3A) -> Option<Bundle> {
        (!self.sunlit.is_empty()).then(|| bundle(&self.sunlit, sun - 0.011, sun + 0.011))
    }

    /// The rays to a lamp: t from 0 to 1.
    pub(super) fn lamp_bundle(&self, lamp: Vec3A) -> Bundle {
        bundle(&self.points, lamp - self.points.high - SLACK, lamp - self.points.low + SLACK)
    }
}

/// Rays start a little off their surface.
const SLACK: f32 = 0.06;

fn bundle(origins: &Span, direction_low: Vec3A, direction_high: Vec3A) -> Bundle {
    Bundle { origin_low: origins.low - SLACK, origin_high: origins.high + SLACK, direction_low, direction_high }
}
