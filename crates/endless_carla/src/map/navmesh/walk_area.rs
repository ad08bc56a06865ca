//! Kinds of polygons.

use super::super::surface::SurfaceKind;

/// What a polygon is to those who walk.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum WalkArea {
    Sidewalk,
    Crosswalk,
    Road,
}

impl WalkArea {
    /// CARLA's number of it.
    pub(super) const fn number(self) -> u8 {
        match self {
            Self::Sidewalk => 1,
            Self::Crosswalk => 2,
            Self::Road => 3,
        }
    }

    /// CARLA's flag of it.
    pub(super) const fn flag(self) -> u16 {
        1 << self.number()
    }
}

impl From<SurfaceKind> for WalkArea {
    fn from(kind: SurfaceKind) -> Self {
        match kind {
            SurfaceKind::Sidewalk | SurfaceKind::Way => Self::Sidewalk,
            SurfaceKind::Crosswalk => Self::Crosswalk,
            SurfaceKind::Road => Self::Road,
        }
    }
}
