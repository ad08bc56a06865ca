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
    /// How far the longest of them gets in the still town.
    pub(super) mirror_reach: f32,
    /// Some sample is a traffic light's lens.
    pub(super) lens: bool,
}

impl TileBounds {
    pub(super) const EMPTY: Self = Self {
        points: Span::EMPTY,
        sunlit: Span::EMPTY,
        mirrors: Span::EMPTY,
        mirror_directions: Span::EMPTY,
        mirror_reach: 0.0,
        lens: false,
    };

    pub(super) fn join(&mut self, other: &Self) {
        self.points.join(&other.points);
        self.sunlit.join(&other.sunlit);
        self.mirrors.join(&other.mirrors);
        self.mirror_directions.join(&other.mirror_directions);
        self.mirror_reach = self.mirror_reach.max(other.mirror_reach);
        self.lens |= other.lens;
    }

    /// The rays from a tile whose bounds are known.
    pub(super) fn bundles(&self, sun: Option<Vec3A>) -> TileBundles {
        let mirror = (!self.mirrors.is_empty())
            .then(|| bundle(&self.mirrors, self.mirror_directions.low, self.mirror_directions.high));
        let sun = sun.filter(|_| !self.sunlit.is_empty()).map(|sun| bundle(&self.sunlit, sun - 0.011, sun + 0.011));
        TileBundles { mirror, sun }
    }

    /// The rays to a lamp: t from 0 to 1.
    pub(super) fn lamp_bundle(&self, lamp: Vec3A) -> Bundle {
        bundle(&self.points, lamp - self.points.high - SLACK, lamp - self.points.low + SLACK)
    }
}

/// The rays that leave a tile in every frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct TileBundles {
    /// Into its mirrors, if it has any.
    pub(super) mirror: Option<Bundle>,
    /// To the sun's disc, if the sun reaches it.
    pub(super) sun: Option<Bundle>,
}

/// Rays start a little off their surface.
const SLACK: f32 = 0.06;

fn bundle(origins: &Span, direction_low: Vec3A, direction_high: Vec3A) -> Bundle {
    Bundle::new((origins.low - SLACK, origins.high + SLACK), (direction_low, direction_high))
}
