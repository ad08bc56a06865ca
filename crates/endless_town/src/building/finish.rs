//! The materials and ornaments of one building.

use super::opening::Joinery;
use super::palette::Palette;
use super::style::{BuildingStyle, WindowFrames, WindowRecess};
use endless_scene::Material;
use endless_world::Stream;

/// The materials of a building of a style.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BuildingFinish {
    pub(crate) style: &'static BuildingStyle,
    pub(crate) wall: Material,
    /// Ground floor, where it differs.
    pub(crate) base: Material,
    pub(crate) trim: Material,
    /// Surrounds, shutters, bands: what stands out.
    pub(crate) accent: Material,
    pub(crate) roof: Material,
    pub(crate) joinery: Joinery,
    pub(crate) sign: Material,
    pub(crate) awning: Material,
    /// Whether windows have shutters, if those of the style may.
    pub(crate) shuttered: bool,
}

impl BuildingFinish {
    /// Draws the materials of a building.
    pub(crate) fn draw(style: &'static BuildingStyle, stream: &mut Stream) -> Self {
        let palette = Palette::draw(stream);
        let [wall, base, accent] = (style.materials)(&palette, stream.f64());
        let recess = match style.recess {
            WindowRecess::Fixed(depth) => depth,
            WindowRecess::Between(least, most) => stream.range_f32(least, most),
        };
        let frame = match style.frames {
            WindowFrames::Painted => palette.frame,
            WindowFrames::White => palette.white_frame,
            WindowFrames::Metal => palette.metal_frame,
        };
        let Palette { grey, door, roof, sign, awning, .. } = palette;
        let joinery = Joinery { wall, frame, sill: grey, door, recess };
        let shuttered = stream.chance(0.45);
        Self { style, wall, base, trim: grey, accent, roof, joinery, sign, awning, shuttered }
    }
}
