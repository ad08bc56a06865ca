//! How large a building is, and the rhythm of its facades.

use super::finish::BuildingFinish;
use super::kind::BuildingKind;
use super::style::{BuildingStyle, RhythmStyle};
use endless_world::Stream;

/// The dimensions of a building, metres. Its frame: x along the front, y into the lot, the front wall at y = 0.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BuildingDimensions {
    pub(crate) kind: BuildingKind,
    /// How it is built, where that is known; drawn otherwise.
    pub(crate) style: Option<&'static BuildingStyle>,
    pub(crate) width: f32,
    pub(crate) depth: f32,
    pub(crate) storeys: u32,
    /// Shops on the ground floor.
    pub(crate) shops: bool,
    /// Whether a neighbour stands right beside its right and its left wall.
    pub(crate) party_walls: [bool; 2],
}

impl BuildingDimensions {
    /// The style and the materials.
    pub(super) fn finish(&self, stream: &mut Stream) -> BuildingFinish {
        let drawn = BuildingStyle::draw(self.kind, self.storeys, self.shops, stream);
        BuildingFinish::draw(self.style.unwrap_or(drawn), stream)
    }
}

/// The rhythm of a facade, metres.
#[derive(Debug, Clone, Copy)]
pub(super) struct FacadeRhythm {
    pub(super) bay: f32,
    /// Width and height.
    pub(super) window: [f32; 2],
    pub(super) sill: f32,
    pub(super) storey: f32,
    pub(super) ground: f32,
}

impl FacadeRhythm {
    pub(super) fn of(style: &BuildingStyle, shops: bool, stream: &mut Stream) -> Self {
        let RhythmStyle { bay, window, sill, storey, ground } = style.rhythm;
        let stretch = stream.range_f32(0.94, 1.1);
        let ground = if shops { 4.0 } else { ground.unwrap_or(storey) };
        Self { bay: bay * stretch, window, sill, storey, ground }
    }

    /// With storeys of such heights that the eaves are where they are known to be.
    pub(super) fn stretched(self, height: f32, storeys: u32) -> Self {
        let factor = (height / self.height(storeys)).clamp(0.8, 1.5);
        let [w, h] = self.window;
        Self { storey: self.storey * factor, ground: self.ground * factor, window: [w, h * factor.min(1.1)], ..self }
    }

    /// From the ground to the eaves.
    pub(super) fn height(&self, storeys: u32) -> f32 {
        self.ground + self.storey * (storeys.max(1) - 1) as f32
    }
}

/// A building as it is to be made: its dimensions, its materials, its rhythm.
#[derive(Debug, Clone, Copy)]
pub(super) struct BuildingDesign<'a> {
    pub(super) dimensions: &'a BuildingDimensions,
    pub(super) finish: &'a BuildingFinish,
    pub(super) rhythm: &'a FacadeRhythm,
}
