//! Town02: a small, compact grid of two-lane streets that meet in T-junctions, with shops, flats and a park.

use super::layout::TownLayout;
use super::shape::{arc, points, rect};
use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use endless_road::RoadMap;
use glam::DVec2;

/// Half the size of the ring that closes the town off, and the radius of its corners, metres.
const RING_X: f64 = 104.0;
const RING_Y: f64 = 100.0;
const CORNER_M: f64 = 18.0;
/// The streets inside the ring: columns by their x, rows by their y, metres.
const WEST: f64 = -36.0;
const MIDDLE: f64 = 28.0;
const MAIN: f64 = -8.0;
const SOUTH: f64 = -56.0;
const NORTH: f64 = 52.0;
const PARK: f64 = 24.0;

pub(super) fn make() -> (RoadMap, TownPreset) {
    let mut layout = TownLayout::of([39.5, -0.4]);
    streets(&mut layout);
    land(&mut layout);
    let preset = TownPreset {
        summary: "Small blocks of shops and flats with cars parked along every street.".to_owned(),
        lamp_color: [1.0, 0.78, 0.52],
        lamp_cd: 3600.0,
        conifers: 0.1,
        palms: 0.15,
        wires: true,
        ..TownPreset::default()
    };
    layout.build(None, preset)
}

/// The ring from the south end of the western column all the way round to it again, counter-clockwise.
fn ring() -> Vec<DVec2> {
    let corner = |x: f64, y: f64, from_deg: f64| {
        let middle = DVec2::new(x * (RING_X - CORNER_M), y * (RING_Y - CORNER_M));
        arc(middle, CORNER_M, from_deg, from_deg + 90.0)
    };
    let start = DVec2::new(WEST, -RING_Y);
    let corners = [corner(1.0, -1.0, -90.0), corner(1.0, 1.0, 0.0), corner(-1.0, 1.0, 90.0), corner(-1.0, -1.0, 180.0)];
    std::iter::once(start).chain(corners.into_iter().flatten()).chain([start]).collect()
}

fn streets(layout: &mut TownLayout) {
    let main = "tertiary sidewalk=both parking:both=lane maxspeed=50";
    let street = "residential sidewalk=both parking:both=lane maxspeed=30";
    layout.road(street, &ring());
    layout.road(main, &points(&[(-RING_X, MAIN), (RING_X, MAIN)]));
    layout.road(street, &points(&[(WEST, -RING_Y), (WEST, MAIN)]));
    layout.road(street, &points(&[(MIDDLE, MAIN), (MIDDLE, RING_Y)]));
    layout.road(street, &points(&[(WEST, SOUTH), (RING_X, SOUTH)]));
    layout.road(street, &points(&[(-RING_X, NORTH), (MIDDLE, NORTH)]));
    layout.road(street, &points(&[(MIDDLE, PARK), (RING_X, PARK)]));
    for x in [-RING_X, WEST, MIDDLE, RING_X] {
        layout.lights(DVec2::new(x, MAIN));
    }
    for (x, y) in [(WEST, SOUTH), (MIDDLE, NORTH), (MIDDLE, PARK), (RING_X, SOUTH), (-RING_X, NORTH)] {
        layout.zebra(DVec2::new(x, y));
    }
}

fn land(layout: &mut TownLayout) {
    layout.park(&points(&[
        (MIDDLE + 9.5, PARK + 9.5),
        (RING_X - 9.5, PARK + 9.5),
        (RING_X - 9.5, RING_Y - 9.5),
        (MIDDLE + 9.5, RING_Y - 9.5),
    ]));
    // A supermarket and its car park in the south-west.
    layout.building("supermarket building:levels=1", &rect((-66.0, -66.0), (26.0, 20.0), 0.0));
    layout.land("amenity=parking", &rect((-70.0, -38.0), (32.0, 30.0), 0.0));
    // Courts behind the shops of the main street, lawns elsewhere.
    for (low, high) in [
        ((-RING_X, MAIN), (MIDDLE, NORTH)),
        ((MIDDLE, MAIN), (RING_X, PARK)),
        ((WEST, SOUTH), (RING_X, MAIN)),
        ((-RING_X, -RING_Y), (WEST, MAIN)),
    ] {
        let middle = (f64::midpoint(low.0, high.0), f64::midpoint(low.1, high.1));
        layout.land("landuse=commercial", &rect(middle, (high.0 - low.0 - 4.0, high.1 - low.1 - 4.0), 0.0));
    }
    let inside = rect((0.0, 0.0), (2.0 * RING_X, 2.0 * RING_Y), 0.0);
    layout.zone(
        inside,
        &[
            (BuildingKind::Terrace, 6.0),
            (BuildingKind::Shop, 1.5),
            (BuildingKind::Flats, 2.0),
            (BuildingKind::House, 0.8),
        ],
        (2, 4),
        0.05,
    );
    layout.zone(
        rect((0.0, 0.0), (3000.0, 3000.0), 0.0),
        &[
            (BuildingKind::Terrace, 3.0),
            (BuildingKind::Flats, 1.5),
            (BuildingKind::House, 3.0),
            (BuildingKind::Shop, 0.4),
        ],
        (2, 3),
        0.06,
    );
}
