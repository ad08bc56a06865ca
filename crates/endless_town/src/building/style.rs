//! Colours and materials of buildings; linear albedo.

use super::opening::Joinery;
use crate::character::Kind;
use endless_asset::{Material, Surface};
use endless_world::{ClassTag, Stream};

/// What a building is made of.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Style {
    pub(crate) wall: Material,
    /// Ground floor, where it differs.
    pub(crate) base: Material,
    pub(crate) trim: Material,
    pub(crate) roof: Material,
    pub(crate) joinery: Joinery,
    pub(crate) sign: Material,
    pub(crate) awning: Material,
}

const fn of(surface: Surface, color: [f32; 3]) -> Material {
    Material::new(surface, color, ClassTag::Buildings)
}

const PLASTERS: &[[f32; 3]] = &[
    [0.72, 0.68, 0.60],
    [0.66, 0.60, 0.48],
    [0.62, 0.48, 0.30],
    [0.60, 0.40, 0.32],
    [0.50, 0.49, 0.46],
    [0.70, 0.70, 0.68],
    [0.45, 0.48, 0.42],
    [0.42, 0.47, 0.53],
    [0.68, 0.56, 0.36],
    [0.55, 0.30, 0.22],
    [0.78, 0.75, 0.68],
];
const BRICKS: &[[f32; 3]] =
    &[[0.33, 0.13, 0.08], [0.42, 0.22, 0.14], [0.28, 0.16, 0.11], [0.48, 0.36, 0.24], [0.38, 0.17, 0.12]];
const STONES: &[[f32; 3]] = &[[0.50, 0.46, 0.38], [0.42, 0.41, 0.39], [0.58, 0.53, 0.44], [0.34, 0.32, 0.30]];
const PANELS: &[[f32; 3]] =
    &[[0.48, 0.50, 0.51], [0.25, 0.29, 0.33], [0.60, 0.60, 0.58], [0.16, 0.17, 0.19], [0.38, 0.27, 0.19]];
const SHEETS: &[[f32; 3]] =
    &[[0.52, 0.54, 0.55], [0.16, 0.25, 0.36], [0.38, 0.42, 0.36], [0.58, 0.54, 0.46], [0.36, 0.11, 0.08]];
const BOARDS: &[[f32; 3]] = &[[0.30, 0.07, 0.05], [0.22, 0.15, 0.10], [0.32, 0.27, 0.21], [0.12, 0.10, 0.085]];
const TILES: &[[f32; 3]] =
    &[[0.36, 0.13, 0.07], [0.27, 0.10, 0.065], [0.13, 0.12, 0.12], [0.22, 0.13, 0.09], [0.40, 0.19, 0.11]];
const FRAMES: &[[f32; 3]] =
    &[[0.72, 0.72, 0.70], [0.72, 0.72, 0.70], [0.10, 0.10, 0.10], [0.26, 0.16, 0.09], [0.16, 0.22, 0.20]];
const DOORS: &[[f32; 3]] =
    &[[0.20, 0.11, 0.06], [0.05, 0.13, 0.09], [0.06, 0.09, 0.20], [0.30, 0.04, 0.035], [0.12, 0.12, 0.12]];
const SIGNS: &[[f32; 3]] = &[
    [0.70, 0.06, 0.05],
    [0.05, 0.22, 0.55],
    [0.04, 0.38, 0.14],
    [0.85, 0.55, 0.05],
    [0.75, 0.75, 0.72],
    [0.50, 0.08, 0.35],
    [0.08, 0.45, 0.50],
];
const AWNINGS: &[[f32; 3]] =
    &[[0.42, 0.05, 0.05], [0.05, 0.20, 0.12], [0.62, 0.56, 0.42], [0.08, 0.12, 0.28], [0.55, 0.30, 0.06]];

impl Style {
    /// Draws the materials of a building of this kind.
    pub(crate) fn draw(kind: Kind, stream: &mut Stream) -> Self {
        let mut any = |surface: Surface, colors: &[[f32; 3]]| {
            let shade = stream.range_f32(0.88, 1.08);
            of(surface, stream.pick(colors).map(|c| c * shade))
        };
        let plaster = any(Surface::Plaster, PLASTERS);
        let brick = any(Surface::Brick, BRICKS);
        let stone = any(Surface::Stone, STONES);
        let panel = any(Surface::Cladding, PANELS);
        let sheet = any(Surface::Cladding, SHEETS);
        let boards = any(Surface::Wood, BOARDS);
        let roof = any(Surface::RoofTile, TILES);
        let frame = any(Surface::Painted, FRAMES);
        let door = any(Surface::Painted, DOORS);
        let sign = any(Surface::LitSign, SIGNS);
        let awning = any(Surface::Cloth, AWNINGS);
        let grey = any(Surface::Concrete, &[[0.45, 0.44, 0.42], [0.56, 0.54, 0.50]]);
        let choice = stream.f64();
        let (wall, base) = match kind {
            Kind::House if choice < 0.6 => (plaster, plaster),
            Kind::House if choice < 0.85 => (brick, brick),
            Kind::House => (of(Surface::Wood, [0.55, 0.53, 0.49]), brick),
            Kind::Terrace if choice < 0.55 => (plaster, stone),
            Kind::Terrace if choice < 0.9 => (brick, stone),
            Kind::Terrace => (stone, stone),
            Kind::Flats if choice < 0.6 => (plaster, plaster),
            Kind::Flats if choice < 0.8 => (brick, grey),
            Kind::Flats => (grey, grey),
            Kind::Shop if choice < 0.5 => (plaster, plaster),
            Kind::Shop => (panel, panel),
            Kind::Office if choice < 0.45 => (stone, stone),
            Kind::Office if choice < 0.8 => (panel, stone),
            Kind::Office => (brick, stone),
            Kind::Tower => (panel, stone),
            Kind::Hall => (sheet, grey),
            Kind::Barn => (boards, grey),
        };
        let recess = match kind {
            Kind::Tower => 0.09,
            Kind::Barn | Kind::Hall => 0.1,
            _ => stream.range_f32(0.11, 0.2),
        };
        let frame = if kind == Kind::Tower { of(Surface::Metal, [0.22, 0.23, 0.24]) } else { frame };
        let joinery = Joinery { wall, frame, sill: grey, door, recess };
        Self { wall, base, trim: grey, roof, joinery, sign, awning }
    }
}
