//! What streets of random towns are like in some parts of the world: their roads, what is built along them.

use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use endless_world::Stream;

/// What is built in a part of a town.
pub(super) struct ZoneProfile {
    pub(super) kinds: &'static [(BuildingKind, f64)],
    pub(super) storeys: (u32, u32),
    /// Share of lots left open.
    pub(super) open: f64,
}

/// Streets of one part of the world.
#[derive(Clone, Copy)]
pub(super) struct RandomRegion {
    pub(super) name: &'static str,
    /// Degrees north and east: whose customs hold.
    pub(super) place: [f64; 2],
    pub(super) avenues: &'static [&'static str],
    pub(super) streets: &'static [&'static str],
    pub(super) middle: &'static [ZoneProfile],
    pub(super) outside: &'static [ZoneProfile],
    palms: f64,
    wires: bool,
    bright: bool,
    /// Ground between houses is paved.
    yards: bool,
}

const DOWNTOWN: ZoneProfile = ZoneProfile {
    kinds: &[
        (BuildingKind::Office, 3.0),
        (BuildingKind::Tower, 1.5),
        (BuildingKind::Flats, 1.5),
        (BuildingKind::Terrace, 1.0),
    ],
    storeys: (4, 9),
    open: 0.08,
};
const TERRACES: ZoneProfile = ZoneProfile {
    kinds: &[(BuildingKind::Terrace, 6.0), (BuildingKind::Office, 0.8), (BuildingKind::Shop, 0.6)],
    storeys: (2, 5),
    open: 0.03,
};
const LOW_FRONTS: ZoneProfile =
    ZoneProfile { kinds: &[(BuildingKind::Terrace, 7.0), (BuildingKind::Shop, 1.4)], storeys: (1, 3), open: 0.06 };
const SHOP_HOUSES: ZoneProfile = ZoneProfile {
    kinds: &[
        (BuildingKind::Terrace, 5.0),
        (BuildingKind::Shop, 2.0),
        (BuildingKind::Flats, 1.0),
        (BuildingKind::Tower, 0.3),
    ],
    storeys: (2, 6),
    open: 0.05,
};
const STRIP: ZoneProfile = ZoneProfile {
    kinds: &[
        (BuildingKind::Shop, 4.0),
        (BuildingKind::Office, 1.0),
        (BuildingKind::Hall, 1.0),
        (BuildingKind::House, 1.0),
    ],
    storeys: (1, 3),
    open: 0.25,
};
const HOUSES: ZoneProfile = ZoneProfile {
    kinds: &[(BuildingKind::House, 6.0), (BuildingKind::Flats, 0.7), (BuildingKind::Shop, 0.5)],
    storeys: (1, 3),
    open: 0.12,
};
const BLOCKS: ZoneProfile = ZoneProfile {
    kinds: &[(BuildingKind::Flats, 5.0), (BuildingKind::Shop, 1.0), (BuildingKind::Office, 0.6)],
    storeys: (3, 8),
    open: 0.2,
};
const WORKS: ZoneProfile = ZoneProfile {
    kinds: &[(BuildingKind::Hall, 4.0), (BuildingKind::Shop, 1.0), (BuildingKind::Office, 0.7)],
    storeys: (1, 3),
    open: 0.2,
};

const REGIONS: [RandomRegion; 4] = [
    RandomRegion {
        name: "European",
        place: [48.8, 9.2],
        avenues: &[
            "primary lanes=4 sidewalk=both maxspeed=50",
            "primary lanes=4 sidewalk=both parking:both=lane maxspeed=50",
            "secondary lanes=3 sidewalk=both maxspeed=50",
        ],
        streets: &[
            "residential sidewalk=both parking:both=lane maxspeed=30",
            "tertiary lanes=2 sidewalk=both maxspeed=50",
            "secondary lanes=2 sidewalk=both parking:right=lane maxspeed=50",
            "residential oneway=yes width=5.4 sidewalk=both parking:right=lane maxspeed=30",
        ],
        middle: &[TERRACES, TERRACES, DOWNTOWN],
        outside: &[BLOCKS, HOUSES, TERRACES, WORKS],
        palms: 0.0,
        wires: false,
        bright: false,
        yards: false,
    },
    RandomRegion {
        name: "North American",
        place: [39.1, -94.6],
        avenues: &[
            "primary lanes=6 sidewalk=both maxspeed=60",
            "primary lanes=4 sidewalk=both maxspeed=60",
            "secondary lanes=5 sidewalk=both maxspeed=50",
        ],
        streets: &[
            "secondary lanes=4 sidewalk=both maxspeed=50",
            "residential sidewalk=both parking:both=lane maxspeed=40",
            "secondary lanes=2 sidewalk=both parking:both=lane maxspeed=50",
            "tertiary lanes=3 oneway=yes sidewalk=both maxspeed=50",
        ],
        middle: &[DOWNTOWN, STRIP, DOWNTOWN],
        outside: &[HOUSES, STRIP, WORKS],
        palms: 0.1,
        wires: true,
        bright: false,
        yards: false,
    },
    RandomRegion {
        name: "Latin American",
        place: [-12.05, -77.0],
        avenues: &[
            "primary lanes=6 sidewalk=both maxspeed=60",
            "primary lanes=4 sidewalk=both maxspeed=50",
            "secondary lanes=4 sidewalk=both parking:right=lane maxspeed=50",
        ],
        streets: &[
            "residential width=7 sidewalk=both sidewalk:both:width=1.6 maxspeed=30",
            "residential oneway=yes width=6 sidewalk=both sidewalk:both:width=1.4 maxspeed=30",
            "tertiary lanes=2 width=8.4 sidewalk=both maxspeed=40",
            "secondary lanes=2 sidewalk=both parking:both=lane maxspeed=40",
        ],
        middle: &[LOW_FRONTS, SHOP_HOUSES, DOWNTOWN],
        outside: &[LOW_FRONTS, BLOCKS, WORKS],
        palms: 0.3,
        wires: true,
        bright: true,
        yards: true,
    },
    RandomRegion {
        name: "South-East Asian",
        place: [10.8, 106.7],
        avenues: &[
            "primary lanes=6 sidewalk=both maxspeed=60",
            "primary lanes=4 sidewalk=both maxspeed=50",
            "primary lanes=8 sidewalk=both maxspeed=60",
        ],
        streets: &[
            "secondary lanes=2 width=9 sidewalk=both parking:right=lane maxspeed=40",
            "residential width=6 sidewalk=both sidewalk:both:width=1.5 maxspeed=30",
            "tertiary lanes=2 width=8 sidewalk=both maxspeed=40",
            "tertiary lanes=3 oneway=yes sidewalk=both maxspeed=50",
        ],
        middle: &[SHOP_HOUSES, SHOP_HOUSES, DOWNTOWN],
        outside: &[SHOP_HOUSES, BLOCKS, LOW_FRONTS],
        palms: 0.4,
        wires: true,
        bright: false,
        yards: true,
    },
];

impl RandomRegion {
    pub(super) fn draw(random: &mut Stream) -> Self {
        *random.pick(&REGIONS)
    }

    /// How its towns are dressed.
    pub(super) fn preset(&self) -> TownPreset {
        TownPreset {
            palms: self.palms,
            wires: self.wires,
            bright: self.bright,
            yards: self.yards,
            ..TownPreset::default()
        }
    }
}
