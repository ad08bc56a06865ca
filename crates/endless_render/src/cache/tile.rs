//! Bounds of what the samples of a tile of pixels lie on and look at.

use super::ray_bounds::RayBounds;
use glam::Vec3A;

/// Pixels along a tile's edge.
pub(super) const TILE: u32 = 8;

/// An axis-aligned box that may be empty.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds3 {
    pub(super) low: Vec3A,
    pub(super) high: Vec3A,
}

impl Bounds3 {
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
    pub(super) points: Bounds3,
    /// Points that the sun reaches.
    pub(super) sunlit: Bounds3,
    /// Points that mirror.
    pub(super) mirrors: Bounds3,
    /// Directions of their mirror rays.
    pub(super) mirror_directions: Bounds3,
    /// How far the longest of them gets in the static scene.
    pub(super) mirror_reach: f32,
    /// Some sample is a traffic light's lens.
    pub(super) lens: bool,
}

impl TileBounds {
    pub(super) const EMPTY: Self = Self {
        points: Bounds3::EMPTY,
        sunlit: Bounds3::EMPTY,
        mirrors: Bounds3::EMPTY,
        mirror_directions: Bounds3::EMPTY,
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
    pub(super) fn ray_bounds(&self, sun: Option<Vec3A>) -> TileRayBounds {
        let mirror = (!self.mirrors.is_empty())
            .then(|| bounds_of(&self.mirrors, self.mirror_directions.low, self.mirror_directions.high));
        let sun = sun.filter(|_| !self.sunlit.is_empty()).map(|sun| bounds_of(&self.sunlit, sun - 0.011, sun + 0.011));
        TileRayBounds { mirror, sun }
    }

    /// The rays to a lamp: t from 0 to 1.
    pub(super) fn lamp_rays(&self, lamp: Vec3A) -> RayBounds {
        bounds_of(&self.points, lamp - self.points.high - SLACK, lamp - self.points.low + SLACK)
    }
}

/// The rays that leave a tile in every frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct TileRayBounds {
    /// Into its mirrors, if it has any.
    pub(super) mirror: Option<RayBounds>,
    /// To the sun's disc, if the sun reaches it.
    pub(super) sun: Option<RayBounds>,
}

/// Rays start a little off their surface.
const SLACK: f32 = 0.06;

fn bounds_of(origins: &Bounds3, direction_low: Vec3A, direction_high: Vec3A) -> RayBounds {
    RayBounds::new((origins.low - SLACK, origins.high + SLACK), (direction_low, direction_high))
}
