//! Colours and materials of buildings; linear albedo.

use super::manner::Manner;
use super::opening::Joinery;
use endless_scene::{Material, Surface};
use endless_world::{ClassTag, Stream};

/// What a building is made of.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Style {
    pub(crate) manner: Manner,
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
    /// Whether windows have shutters, if those of the manner may.
    pub(crate) shuttered: bool,
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

const SHUTTERS: &[[f32; 3]] =
    &[[0.05, 0.15, 0.09], [0.10, 0.17, 0.26], [0.24, 0.12, 0.06], [0.30, 0.05, 0.04], [0.42, 0.43, 0.40]];
/// Facades of low streets in Latin America.
pub(crate) const BRIGHT: &[[f32; 3]] = &[
    [0.72, 0.42, 0.10],
    [0.12, 0.38, 0.52],
    [0.62, 0.16, 0.14],
    [0.30, 0.50, 0.28],
    [0.76, 0.60, 0.22],
    [0.55, 0.24, 0.40],
    [0.75, 0.72, 0.64],
    [0.20, 0.48, 0.46],
];

/// The colour of a shop's sign.
pub(super) fn sign(stream: &mut Stream) -> Material {
    of(Surface::LitSign, *stream.pick(SIGNS))
}

/// The cloth of a shop's awning.
pub(super) fn awning(stream: &mut Stream) -> Material {
    of(Surface::Cloth, *stream.pick(AWNINGS))
}

impl Style {
    /// Draws the materials of a building.
    pub(crate) fn draw(manner: Manner, stream: &mut Stream) -> Self {
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
        let bright = any(Surface::Plaster, BRIGHT);
        let second = any(Surface::Plaster, BRIGHT);
        let shutter = any(Surface::Painted, SHUTTERS);
        let timber = of(Surface::Wood, [0.10, 0.065, 0.045]);
        let white = of(Surface::Plaster, [0.70, 0.68, 0.63]);
        let light_boards = any(Surface::Wood, &[[0.60, 0.58, 0.53], [0.42, 0.47, 0.48], [0.55, 0.50, 0.36]]);
        let choice = stream.f64();
        let (wall, base, accent) = match manner {
            Manner::Cottage if choice < 0.7 => (plaster, plaster, shutter),
            Manner::Cottage => (brick, brick, shutter),
            Manner::Villa => (plaster, stone, white),
            Manner::Weatherboard => (light_boards, brick, of(Surface::Painted, [0.70, 0.70, 0.67])),
            Manner::TimberFrame => (white, if choice < 0.5 { stone } else { white }, timber),
            Manner::TerracedBrick => (brick, brick, if choice < 0.6 { white } else { stone }),
            Manner::OldTown if choice < 0.8 => (plaster, stone, white),
            Manner::OldTown => (stone, stone, stone),
            Manner::Tenement => (brick, if choice < 0.4 { stone } else { brick }, grey),
            Manner::Latin => (bright, if choice < 0.35 { second } else { bright }, second),
            Manner::Balconies if choice < 0.8 => (plaster, plaster, shutter),
            Manner::Balconies => (brick, grey, shutter),
            Manner::Panels => (grey, grey, bright),
            Manner::BrickFlats => (brick, brick, grey),
            Manner::ShopRow if choice < 0.5 => (plaster, plaster, grey),
            Manner::ShopRow => (brick, brick, grey),
            Manner::Supermarket => (panel, panel, sign),
            Manner::Petrol => (of(Surface::Cladding, [0.62, 0.62, 0.60]), panel, sign),
            Manner::StoneOffice if choice < 0.75 => (stone, stone, stone),
            Manner::StoneOffice => (brick, stone, stone),
            Manner::RibbonOffice => (panel, if choice < 0.5 { stone } else { panel }, grey),
            Manner::School if choice < 0.5 => (brick, brick, bright),
            Manner::School => (plaster, grey, bright),
            Manner::ParkingDeck => (grey, grey, grey),
            Manner::GlassTower => (panel, stone, of(Surface::Metal, [0.30, 0.31, 0.32])),
            Manner::ConcreteTower => (grey, stone, grey),
            Manner::Warehouse => (sheet, grey, of(Surface::Painted, [0.62, 0.40, 0.03])),
            Manner::Works => (brick, brick, sheet),
            Manner::Barn => (boards, grey, of(Surface::Wood, [0.60, 0.58, 0.53])),
            Manner::Church if choice < 0.6 => (stone, stone, stone),
            Manner::Church => (white, stone, stone),
        };
        let recess = match manner {
            Manner::GlassTower => 0.07,
            Manner::Barn | Manner::Warehouse => 0.1,
            Manner::StoneOffice | Manner::ConcreteTower | Manner::Church | Manner::OldTown => {
                stream.range_f32(0.22, 0.34)
            }
            Manner::RibbonOffice => 0.12,
            _ => stream.range_f32(0.14, 0.24),
        };
        let frame = match manner {
            Manner::GlassTower | Manner::RibbonOffice => of(Surface::Metal, [0.22, 0.23, 0.24]),
            Manner::Panels | Manner::School => of(Surface::Painted, [0.68, 0.68, 0.66]),
            _ => frame,
        };
        let joinery = Joinery { wall, frame, sill: grey, door, recess };
        let shuttered = stream.chance(0.45);
        Self { manner, wall, base, trim: grey, accent, roof, joinery, sign, awning, shuttered }
    }
}
