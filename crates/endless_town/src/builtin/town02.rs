//! Town02: a small, compact grid of two-lane streets that meet in T-junctions, with shops, flats and a park.

use super::layout::TownLayout;
use super::layout_geometry::{arc, points, rect};
use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use endless_road::RoadMap;
use glam::DVec2;

/// Half the size of the ring that closes the town off, and the radius of its corners, metres.
const RING_X: f64 = 150.0;
const RING_Y: f64 = 140.0;
const CORNER_M: f64 = 20.0;
/// Straight road at each end of a corner on which nobody parks, metres.
const CLEAR_M: f64 = 12.0;
/// The streets inside the ring: columns by their x, rows by their y, metres.
const WEST: f64 = -50.0;
const MIDDLE: f64 = 44.0;
const EAST: f64 = 76.0;
const FAR_WEST: f64 = -98.0;
const MAIN: f64 = -8.0;
const SOUTH: f64 = -76.0;
const NORTH: f64 = 70.0;
const PARK: f64 = 34.0;

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

/// The ring that closes the town off, counter-clockwise from the south-east: its corners, each with some metres of
/// straight road before and after, and the straight sides between them.
fn ring() -> ([Vec<DVec2>; 4], [Vec<DVec2>; 4]) {
    let corners =
        [(1.0, -1.0, -90.0), (1.0, 1.0, 0.0), (-1.0, 1.0, 90.0), (-1.0, -1.0, 180.0)].map(|(x, y, from_deg)| {
            let middle = DVec2::new(x * (RING_X - CORNER_M), y * (RING_Y - CORNER_M));
            let bend = arc(middle, CORNER_M, from_deg, from_deg + 90.0);
            let (first, last) = (bend[0], bend[bend.len() - 1]);
            // Along the sides, which are parallel to the axes.
            let (in_from, out_to) = if x * y < 0.0 {
                (DVec2::new(first.x - x * CLEAR_M, first.y), DVec2::new(last.x, last.y - y * CLEAR_M))
            } else {
                (DVec2::new(first.x, first.y - y * CLEAR_M), DVec2::new(last.x - x * CLEAR_M, last.y))
            };
            std::iter::once(in_from).chain(bend).chain([out_to]).collect::<Vec<DVec2>>()
        });
    let sides = std::array::from_fn(|i| {
        let next = &corners[(i + 1) % 4];
        vec![corners[i][corners[i].len() - 1], next[0]]
    });
    (corners, sides)
}

fn streets(layout: &mut TownLayout) {
    let main = "tertiary sidewalk=both parking:both=lane maxspeed=50";
    let street = "residential sidewalk=both parking:both=lane maxspeed=30";
    // Nobody parks where lorries cut corners.
    let (corners, sides) = ring();
    for corner in &corners {
        layout.road("residential sidewalk=both maxspeed=30", corner);
    }
    for side in &sides {
        layout.road(street, side);
    }
    layout.road(main, &points(&[(-RING_X, MAIN), (RING_X, MAIN)]));
    layout.road(street, &points(&[(WEST, -RING_Y), (WEST, MAIN)]));
    layout.road(street, &points(&[(MIDDLE, MAIN), (MIDDLE, RING_Y)]));
    layout.road(street, &points(&[(WEST, SOUTH), (RING_X, SOUTH)]));
    layout.road(street, &points(&[(-RING_X, NORTH), (MIDDLE, NORTH)]));
    layout.road(street, &points(&[(MIDDLE, PARK), (RING_X, PARK)]));
    layout.road(street, &points(&[(EAST, -RING_Y), (EAST, SOUTH)]));
    layout.road(street, &points(&[(FAR_WEST, MAIN), (FAR_WEST, NORTH)]));
    for x in [-RING_X, WEST, MIDDLE, RING_X] {
        layout.lights(DVec2::new(x, MAIN));
    }
    // Where the small streets meet the busy ring, they would wait for ever.
    for (x, y) in [(RING_X, SOUTH), (-RING_X, NORTH)] {
        layout.lights(DVec2::new(x, y));
    }
    for (x, y) in [(WEST, SOUTH), (MIDDLE, NORTH), (MIDDLE, PARK)] {
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
    layout.building("supermarket building:levels=1", &rect((-86.0, -92.0), (30.0, 22.0), 0.0));
    layout.land("amenity=parking", &rect((-92.0, -56.0), (40.0, 34.0), 0.0));
    // Courts behind the shops of the main street, clear of carriageways and pavements; lawns elsewhere.
    for (low, high) in [
        ((-RING_X, MAIN), (MIDDLE, NORTH)),
        ((MIDDLE, MAIN), (RING_X, PARK)),
        ((WEST, SOUTH), (RING_X, MAIN)),
        ((-RING_X, -RING_Y), (WEST, MAIN)),
    ] {
        let middle = (f64::midpoint(low.0, high.0), f64::midpoint(low.1, high.1));
        layout.land("landuse=commercial", &rect(middle, (high.0 - low.0 - 18.0, high.1 - low.1 - 18.0), 0.0));
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
