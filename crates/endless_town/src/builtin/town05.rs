//! Town05: a square grid of streets of many lanes with an expressway on a viaduct right through it.

use super::layout::TownLayout;
use super::layout_geometry::{points, rect};
use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use endless_road::RoadMap;
use glam::DVec2;

/// The grid's lines, both ways; and the avenues beyond it, where the expressway comes down.
const LINES: [f64; 4] = [-195.0, -65.0, 65.0, 195.0];
const OUTER: f64 = 345.0;
/// From the middle of the expressway to the middle of a carriageway, metres.
const APART_M: f64 = 8.2;
/// The viaduct reaches this far from the middle, metres.
const VIADUCT_M: f64 = 222.0;

pub(super) fn make() -> (RoadMap, TownPreset) {
    let mut layout = TownLayout::of([34.0, -118.2]);
    streets(&mut layout);
    land(&mut layout);
    let preset = TownPreset {
        summary: "A square grid of multi-lane streets, with an expressway on a viaduct over its cross streets."
            .to_owned(),
        lamp_color: [0.96, 1.0, 0.94],
        lamp_cd: 6500.0,
        conifers: 0.05,
        palms: 0.35,
        ..TownPreset::default()
    };
    layout.build(None, preset)
}

fn streets(layout: &mut TownLayout) {
    let urban = "secondary lanes=4 sidewalk=both maxspeed=50";
    let wide = "primary lanes=6 sidewalk=both maxspeed=60";
    let parked = "secondary lanes=2 sidewalk=both parking:both=lane maxspeed=50";
    let expressway = "trunk oneway=yes lanes=3 sidewalk=no maxspeed=80";
    for (k, x) in LINES.into_iter().enumerate() {
        let words = [urban, wide, parked, urban][k];
        layout.road(words, &points(&[(x, LINES[0]), (x, LINES[3])]));
    }
    for (k, y) in LINES.into_iter().enumerate() {
        let words = [urban, parked, wide, urban][k];
        layout.road(words, &points(&[(-OUTER, y), (OUTER, y)]));
    }
    for x in [-OUTER, OUTER] {
        layout.road(urban, &points(&[(x, LINES[0]), (x, LINES[3])]));
    }
    for (side, y) in [(1.0, -APART_M), (-1.0, APART_M)] {
        let line = points(&[(-side * OUTER, y), (side * OUTER, y)]);
        layout.road_with_bridges(expressway, &line, &[(DVec2::new(0.0, y), VIADUCT_M)]);
    }
    for x in LINES {
        LINES.iter().for_each(|&y| layout.lights(DVec2::new(x, y)));
    }
    for x in [-OUTER, OUTER] {
        for y in [LINES[1], -APART_M, APART_M, LINES[2]] {
            layout.lights(DVec2::new(x, y));
        }
    }
}

fn land(layout: &mut TownLayout) {
    layout.park(&points(&[(-50.0, 80.0), (52.0, 84.0), (52.0, 182.0), (-50.0, 182.0)]));
    layout.square(&points(&[(75.0, -182.0), (120.0, -182.0), (120.0, -140.0), (75.0, -140.0)]));
    layout.land("amenity=parking", &rect((-130.0, -130.0), (70.0, 52.0), 0.0));
    layout.land("amenity=parking", &rect((-268.0, 130.0), (70.0, 62.0), 0.0));
    for x in [-130.0, 0.0, 130.0] {
        // Under the viaduct.
        layout.land("amenity=parking", &rect((x, 0.0), (84.0, 22.0), 0.0));
    }
    layout.zone(
        rect((0.0, 0.0), (3000.0, 3000.0), 0.0),
        &[
            (BuildingKind::Office, 3.0),
            (BuildingKind::Flats, 3.0),
            (BuildingKind::Terrace, 2.0),
            (BuildingKind::Shop, 1.4),
            (BuildingKind::Tower, 0.5),
        ],
        (4, 7),
        0.08,
    );
}
