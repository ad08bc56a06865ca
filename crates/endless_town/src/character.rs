//! The eight towns: what sets each apart.

use crate::network::{
    AVENUE, BOULEVARD, COUNTRY, DOWNTOWN, MAIN, Profile, QUIET, RESIDENTIAL, THROUGH, URBAN, VILLAGE,
};

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

const SODIUM: [f32; 3] = [1.0, 0.62, 0.25];
const WARM: [f32; 3] = [1.0, 0.78, 0.52];
const WHITE: [f32; 3] = [0.96, 1.0, 0.94];

use Along::{Column, Row};
use Kind::{Barn, Flats, Hall, House, Office, Shop, Terrace, Tower};

/// All towns, in the paper's order.
pub(crate) const CHARACTERS: &[Character] = &[
    Character {
        name: "Town01",
        summary: "A small town of quiet streets that meet in T-junctions.",
        seed: 101,
        layout: Layout {
            xs: &[-175.0, -70.0, 45.0, 175.0],
            ys: &[-150.0, -50.0, 48.0, 150.0],
            columns: &[THROUGH, QUIET, MAIN, THROUGH],
            rows: &[THROUGH, MAIN, RESIDENTIAL, THROUGH],
            gaps: &[(Column, 1, 1), (Row, 2, 2)],
            bend_m: 5.0,
            corner_m: 5.0,
            signals_from: 3,
            zebra_everywhere: false,
            mid_block_from_m: 95.0,
        },
        kinds: &[(House, 5.0), (Terrace, 3.0), (Shop, 1.2), (Flats, 0.8)],
        storeys: (2, 3),
        street_trees_m: 17.0,
        garden_trees: 3.0,
        conifers: 0.25,
        palms: 0.0,
        lamp_color: SODIUM,
        lamp_cd: 3200.0,
        lamp_spacing_m: 28.0,
        wires: true,
        parked: 0.5,
        open_lots: 0.08,
        yellow_centre: true,
    },
    Character {
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
        lamp_color: WARM,
        lamp_cd: 3600.0,
        lamp_spacing_m: 27.0,
        wires: true,
        parked: 0.62,
        open_lots: 0.06,
        yellow_centre: false,
    },
    Character {
        name: "Town03",
        summary: "A larger town: winding main roads of two lanes each way, residential quarters between them.",
        seed: 303,
        layout: Layout {
            xs: &[-215.0, -112.0, 4.0, 102.0, 215.0],
            ys: &[-205.0, -98.0, 6.0, 108.0, 205.0],
            columns: &[URBAN, RESIDENTIAL, URBAN, RESIDENTIAL, URBAN],
            rows: &[URBAN, RESIDENTIAL, URBAN, MAIN, URBAN],
            gaps: &[(Column, 1, 0), (Row, 1, 2), (Column, 3, 3), (Row, 3, 0), (Column, 3, 1)],
            bend_m: 12.0,
            corner_m: 7.0,
            signals_from: 3,
            zebra_everywhere: true,
            mid_block_from_m: 90.0,
        },
        kinds: &[(Terrace, 3.5), (Flats, 2.5), (House, 2.0), (Office, 1.5), (Shop, 1.2)],
        storeys: (2, 6),
        street_trees_m: 14.0,
        garden_trees: 2.6,
        conifers: 0.2,
        palms: 0.0,
        lamp_color: WARM,
        lamp_cd: 5200.0,
        lamp_spacing_m: 28.0,
        wires: false,
        parked: 0.5,
        open_lots: 0.08,
        yellow_centre: true,
    },
    Character {
        name: "Town04",
        summary: "A small town on both sides of a wide avenue with a planted island.",
        seed: 404,
        layout: Layout {
            xs: &[-205.0, -85.0, 50.0, 205.0],
            ys: &[-165.0, -8.0, 90.0, 165.0],
            columns: &[THROUGH, RESIDENTIAL, MAIN, THROUGH],
            rows: &[THROUGH, AVENUE, QUIET, THROUGH],
            gaps: &[(Column, 1, 2), (Row, 2, 2)],
            bend_m: 7.0,
            corner_m: 7.0,
            signals_from: 3,
            zebra_everywhere: false,
            mid_block_from_m: 100.0,
        },
        kinds: &[(House, 3.5), (Terrace, 2.0), (Flats, 1.5), (Shop, 2.0), (Hall, 1.0)],
        storeys: (2, 4),
        street_trees_m: 13.0,
        garden_trees: 3.0,
        conifers: 0.45,
        palms: 0.0,
        lamp_color: WHITE,
        lamp_cd: 5200.0,
        lamp_spacing_m: 30.0,
        wires: true,
        parked: 0.45,
        open_lots: 0.1,
        yellow_centre: true,
    },
    Character {
        name: "Town05",
        summary: "A square grid of multi-lane streets with large signalised cross junctions.",
        seed: 505,
        layout: Layout {
            xs: &[-195.0, -65.0, 65.0, 195.0],
            ys: &[-195.0, -65.0, 65.0, 195.0],
            columns: &[URBAN, AVENUE, DOWNTOWN, URBAN],
            rows: &[URBAN, DOWNTOWN, AVENUE, URBAN],
            gaps: &[],
            bend_m: 0.0,
            corner_m: 8.0,
            signals_from: 4,
            zebra_everywhere: true,
            mid_block_from_m: 95.0,
        },
        kinds: &[(Office, 3.0), (Flats, 3.0), (Terrace, 2.0), (Shop, 1.6), (Tower, 0.4)],
        storeys: (4, 8),
        street_trees_m: 16.0,
        garden_trees: 1.6,
        conifers: 0.05,
        palms: 0.3,
        lamp_color: WHITE,
        lamp_cd: 6500.0,
        lamp_spacing_m: 28.0,
        wires: false,
        parked: 0.5,
        open_lots: 0.07,
        yellow_centre: true,
    },
    Character {
        name: "Town06",
        summary: "Long roads of many lanes between halls, shops and low flats.",
        seed: 606,
        layout: Layout {
            xs: &[-225.0, -60.0, 85.0, 225.0],
            ys: &[-135.0, 0.0, 135.0],
            columns: &[URBAN, URBAN, URBAN, URBAN],
            rows: &[BOULEVARD, BOULEVARD, BOULEVARD],
            gaps: &[(Column, 1, 1)],
            bend_m: 6.0,
            corner_m: 9.0,
            signals_from: 4,
            zebra_everywhere: false,
            mid_block_from_m: 1.0e9,
        },
        kinds: &[(Hall, 3.0), (Shop, 3.0), (Flats, 1.6), (Office, 1.6)],
        storeys: (3, 5),
        street_trees_m: 20.0,
        garden_trees: 1.8,
        conifers: 0.15,
        palms: 0.35,
        lamp_color: WHITE,
        lamp_cd: 8000.0,
        lamp_spacing_m: 30.0,
        wires: false,
        parked: 0.5,
        open_lots: 0.14,
        yellow_centre: true,
    },
    Character {
        name: "Town07",
        summary: "A village: narrow bending roads between barns, fields and many trees.",
        seed: 707,
        layout: Layout {
            xs: &[-195.0, -62.0, 80.0, 195.0],
            ys: &[-180.0, -45.0, 62.0, 180.0],
            columns: &[COUNTRY, COUNTRY, VILLAGE, COUNTRY],
            rows: &[COUNTRY, VILLAGE, COUNTRY, COUNTRY],
            gaps: &[(Column, 1, 2), (Row, 2, 0), (Column, 1, 0)],
            bend_m: 18.0,
            corner_m: 5.0,
            signals_from: 2,
            zebra_everywhere: false,
            mid_block_from_m: 100.0,
        },
        kinds: &[(House, 5.0), (Barn, 3.0)],
        storeys: (1, 2),
        street_trees_m: 21.0,
        garden_trees: 5.0,
        conifers: 0.4,
        palms: 0.0,
        lamp_color: SODIUM,
        lamp_cd: 2600.0,
        lamp_spacing_m: 32.0,
        wires: true,
        parked: 0.5,
        open_lots: 0.35,
        yellow_centre: false,
    },
    Character {
        name: "Town10HD",
        summary: "Dense downtown: high buildings, busy sidewalks, signals at every corner.",
        seed: 1010,
        layout: Layout {
            xs: &[-172.0, -88.0, -4.0, 84.0, 172.0],
            ys: &[-158.0, -76.0, 4.0, 82.0, 158.0],
            columns: &[DOWNTOWN, DOWNTOWN, AVENUE, DOWNTOWN, DOWNTOWN],
            rows: &[DOWNTOWN, MAIN, DOWNTOWN, MAIN, DOWNTOWN],
            gaps: &[(Row, 3, 2)],
            bend_m: 2.0,
            corner_m: 6.0,
            signals_from: 3,
            zebra_everywhere: true,
            mid_block_from_m: 1.0e9,
        },
        kinds: &[(Terrace, 4.0), (Office, 4.0), (Tower, 2.2)],
        storeys: (5, 9),
        street_trees_m: 15.0,
        garden_trees: 1.2,
        conifers: 0.0,
        palms: 0.0,
        lamp_color: WHITE,
        lamp_cd: 5500.0,
        lamp_spacing_m: 25.0,
        wires: false,
        parked: 0.65,
        open_lots: 0.05,
        yellow_centre: false,
    },
];
