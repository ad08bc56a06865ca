//! What the first pass of a bake for one instant knows of single rays: [`super::sparse_primary`].

use super::packed_hit::PackedHit;
use super::primary_hits::PackedNormals;
use crate::light::SUN_SAMPLES;

/// Rows of pixels whose centres are traced together, eight columns at a time.
pub(super) const ROWS: usize = 4;
/// The part of the sun's disc that is asked everywhere: half-way between its middle and its rim.
pub(super) const FIRST: usize = 1;
/// The other part that samples ask near the edge of a shadow, on its rim.
pub(super) const RIM: usize = 3;
/// For which of its parts, a bit each, the answers of these two stand there.
pub(super) const BY_FIRST: u8 = 0b0011;
pub(super) const BY_RIM: u8 = 0b1100;
/// All parts of it.
pub(super) const WHOLE: u8 = (1 << SUN_SAMPLES) - 1;

/// What the ray through a pixel's centre met.
#[derive(Clone, Copy)]
pub(super) struct Centre {
    pub(super) distance: f32,
    pub(super) hit: PackedHit,
    pub(super) normals: PackedNormals,
    /// The triangle's, as its mesh numbers it.
    pub(super) material: u16,
    /// On a lens of a traffic light.
    pub(super) is_lens: bool,
    pub(super) is_leaf: bool,
    /// Its light depends on nothing but what falls on it.
    pub(super) is_plain: bool,
    pub(super) sun: SunSeen,
}

/// What a sample's ray to the first part of the sun's disc says.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum SunSeen {
    /// The sun cannot light it, or there is none.
    Never,
    Lit,
    Shaded,
}

impl Centre {
    pub(super) const SKY: Self = Self {
        distance: f32::MAX,
        hit: PackedHit::NONE,
        normals: PackedNormals::NONE,
        material: 0,
        is_lens: false,
        is_leaf: false,
        is_plain: false,
        sun: SunSeen::Never,
    };

    pub(super) fn is_sky(&self) -> bool {
        self.distance == f32::MAX
    }

    /// Whether a neighbour's centre lies on the same surface, or sees the sky, too; where that takes no look at places and
    /// normals.
    pub(super) fn evidently_continues(&self, other: &Self) -> Option<bool> {
        if self.is_sky() || other.is_sky() {
            return Some(self.is_sky() && other.is_sky());
        }
        let flat = self.hit.is_on_triangle_of(&other.hit) && self.normals.shading == other.normals.shading;
        if flat || self.is_lens {
            return Some(!self.is_lens);
        }
        (!self.may_continue(&other.hit, other.material)).then_some(false)
    }

    /// Whether its surface may go on in a hit on such a material; places and normals tell whether it does.
    pub(super) fn may_continue(&self, hit: &PackedHit, material: u16) -> bool {
        self.hit.is_on_instance_of(hit) && self.material == material && !self.is_lens
    }
}
