//! Colours and materials of buildings; linear albedo.

use endless_scene::{Material, Surface};
use endless_world::{ClassTag, Stream};

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
const BRIGHT: &[[f32; 3]] = &[
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

/// The materials from which the styles choose for one building.
#[derive(Debug, Clone, Copy)]
pub(super) struct Palette {
    pub(super) plaster: Material,
    pub(super) brick: Material,
    pub(super) stone: Material,
    pub(super) panel: Material,
    pub(super) sheet: Material,
    pub(super) boards: Material,
    pub(super) light_boards: Material,
    pub(super) roof: Material,
    pub(super) frame: Material,
    pub(super) door: Material,
    pub(super) sign: Material,
    pub(super) awning: Material,
    pub(super) grey: Material,
    pub(super) bright: Material,
    /// Another bright colour.
    pub(super) second: Material,
    pub(super) shutter: Material,
    pub(super) timber: Material,
    pub(super) white: Material,
    pub(super) white_paint: Material,
    pub(super) white_cladding: Material,
    pub(super) steel: Material,
    pub(super) warning: Material,
    pub(super) pale_wood: Material,
    pub(super) white_frame: Material,
    pub(super) metal_frame: Material,
}

impl Palette {
    pub(super) fn draw(stream: &mut Stream) -> Self {
        let mut any = |surface: Surface, colors: &[[f32; 3]]| {
            let shade = stream.range_f32(0.88, 1.08);
            of(surface, stream.pick(colors).map(|c| c * shade))
        };
        // Fields are drawn in the order in which they are written.
        Self {
            plaster: any(Surface::Plaster, PLASTERS),
            brick: any(Surface::Brick, BRICKS),
            stone: any(Surface::Stone, STONES),
            panel: any(Surface::Cladding, PANELS),
            sheet: any(Surface::Cladding, SHEETS),
            boards: any(Surface::Wood, BOARDS),
            roof: any(Surface::RoofTile, TILES),
            frame: any(Surface::Painted, FRAMES),
            door: any(Surface::Painted, DOORS),
            sign: any(Surface::LitSign, SIGNS),
            awning: any(Surface::Cloth, AWNINGS),
            grey: any(Surface::Concrete, &[[0.45, 0.44, 0.42], [0.56, 0.54, 0.50]]),
            bright: any(Surface::Plaster, BRIGHT),
            second: any(Surface::Plaster, BRIGHT),
            shutter: any(Surface::Painted, SHUTTERS),
            light_boards: any(Surface::Wood, &[[0.60, 0.58, 0.53], [0.42, 0.47, 0.48], [0.55, 0.50, 0.36]]),
            timber: of(Surface::Wood, [0.10, 0.065, 0.045]),
            white: of(Surface::Plaster, [0.70, 0.68, 0.63]),
            white_paint: of(Surface::Painted, [0.70, 0.70, 0.67]),
            white_cladding: of(Surface::Cladding, [0.62, 0.62, 0.60]),
            steel: of(Surface::Metal, [0.30, 0.31, 0.32]),
            warning: of(Surface::Painted, [0.62, 0.40, 0.03]),
            pale_wood: of(Surface::Wood, [0.60, 0.58, 0.53]),
            white_frame: of(Surface::Painted, [0.68, 0.68, 0.66]),
            metal_frame: of(Surface::Metal, [0.22, 0.23, 0.24]),
        }
    }
}
