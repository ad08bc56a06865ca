//! A town on a grid of streets: what sets it apart.

use crate::network::{MAIN, Profile, RESIDENTIAL};

/// Which way a line of the street grid runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Along {
    /// North to south: a line of `xs`.
    Column,
    /// West to east: a line of `ys`.
    Row,
}

/// The street plan: a bent grid with gaps, closed by a ring road.
#[derive(Debug, Clone)]
pub(crate) struct Layout {
    /// Where the columns cross the x axis, metres; the first and last belong to the ring.
    pub(crate) xs: &'static [f64],
    /// Where the rows cross the y axis.
    pub(crate) ys: &'static [f64],
    /// Profile of each column, ring included.
    pub(crate) columns: &'static [Profile],
    /// Profile of each row.
    pub(crate) rows: &'static [Profile],
    /// Pieces left out: (direction, line, piece along it).
    pub(crate) gaps: &'static [(Along, usize, usize)],
    /// How far junctions stray from the grid, metres.
    pub(crate) bend_m: f64,
    /// Radius of kerbs at corners, metres.
    pub(crate) corner_m: f64,
    /// Junctions are signalised where the minor road has at least this priority.
    pub(crate) signals_from: u8,
    /// Whether unsignalised junctions have zebra crossings on every arm, or just on minor ones.
    pub(crate) zebra_everywhere: bool,
    /// Streets at least this long have a zebra crossing in the middle, metres.
    pub(crate) mid_block_from_m: f64,
}

/// How lots are built on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Detached house with a pitched roof and a garden.
    House,
    /// Party-wall town house, shops below where the street is busy.
    Terrace,
    /// Free-standing block of flats.
    Flats,
    /// Low shop or supermarket with a flat roof.
    Shop,
    /// Office block with a stone or panel front.
    Office,
    /// Glass tower.
    Tower,
    /// Warehouse or workshop.
    Hall,
    /// Barn.
    Barn,
}

/// One town.
#[derive(Debug, Clone)]
pub(crate) struct Character {
    pub(crate) name: &'static str,
    pub(crate) summary: &'static str,
    pub(crate) seed: u64,
    pub(crate) layout: Layout,
    /// Kinds of buildings with their shares.
    pub(crate) kinds: &'static [(Kind, f64)],
    /// Fewest and most storeys of terraces and flats.
    pub(crate) storeys: (u32, u32),
    /// Metres of street front between street trees, 0 for none.
    pub(crate) street_trees_m: f64,
    /// Trees per 1000 m² of open lot ground.
    pub(crate) garden_trees: f64,
    /// Share of conifers and palms among trees.
    pub(crate) conifers: f64,
    pub(crate) palms: f64,
    /// Street lamps: linear colour and candela.
    pub(crate) lamp_color: [f32; 3],
    pub(crate) lamp_cd: f32,
    pub(crate) lamp_spacing_m: f64,
    /// Whether wires hang on wooden poles along quiet streets.
    pub(crate) wires: bool,
    /// Share of parking places taken.
    pub(crate) parked: f64,
    /// Share of lots left as parks, yards or fields.
    pub(crate) open_lots: f64,
    /// Colour of lane lines in the middle: yellow in some towns.
    pub(crate) yellow_centre: bool,
}

use Along::{Column, Row};
use Kind::{Flats, House, Shop, Terrace};

/// The town on a bent grid.
pub(crate) const TOWN02: Character = Character {
    name: "Town02",
    summary: "Small blocks of shops and flats with cars parked along every street.",
    seed: 202,
    layout: Layout {
        xs: &[-165.0, -85.0, -8.0, 72.0, 165.0],
        ys: &[-140.0, -48.0, 42.0, 140.0],
        columns: &[RESIDENTIAL, RESIDENTIAL, MAIN, RESIDENTIAL, RESIDENTIAL],
        rows: &[RESIDENTIAL, MAIN, RESIDENTIAL, RESIDENTIAL],
        gaps: &[(Column, 1, 2), (Column, 3, 0), (Row, 2, 3)],
        bend_m: 3.0,
        corner_m: 5.0,
        signals_from: 3,
        zebra_everywhere: true,
        mid_block_from_m: 85.0,
    },
    kinds: &[(Terrace, 6.0), (Shop, 1.5), (Flats, 2.0), (House, 0.8)],
    storeys: (2, 4),
    street_trees_m: 22.0,
    garden_trees: 1.6,
    conifers: 0.1,
    palms: 0.15,
    lamp_color: [1.0, 0.78, 0.52],
    lamp_cd: 3600.0,
    lamp_spacing_m: 27.0,
    wires: true,
    parked: 0.62,
    open_lots: 0.06,
    yellow_centre: false,
};
