//! Town03: a larger town about a roundabout, with a boulevard of many lanes, an underpass, and streets up a hill.

use super::layout::TownLayout;
use super::layout_geometry::{arc, hill, points, rect, rise, smooth};
use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use crate::geometry::unit;
use endless_road::RoadMap;
use glam::DVec2;

/// Radius of the roundabout's middle lane line, metres.
const RING_M: f64 = 27.0;
/// The middle lines of the boulevard's carriageways.
const SOUTHBOUND: f64 = 201.5;
const NORTHBOUND: f64 = 218.5;

fn height(p: DVec2) -> f64 {
    19.0 * rise(45.0, 340.0, p.y)
        + 34.0 * rise(330.0, 700.0, p.y)
        + hill(p, (620.0, 120.0), 330.0, 30.0)
        + hill(p, (-640.0, 60.0), 300.0, 26.0)
        + 26.0 * rise(380.0, 760.0, -p.y)
}

pub(super) fn make() -> (RoadMap, TownPreset) {
    let mut layout = TownLayout::of([40.6, -80.1]);
    main_roads(&mut layout);
    quarters(&mut layout);
    land(&mut layout);
    let preset = TownPreset {
        summary: "A larger town: a roundabout of five arms, a boulevard of six lanes, an underpass, streets up a hill."
            .to_owned(),
        lamp_color: [1.0, 0.78, 0.52],
        lamp_cd: 5200.0,
        ..TownPreset::default()
    };
    layout.build(Some(&height), preset)
}

/// A place on the roundabout, by its direction in degrees.
fn on_ring(degrees: f64) -> (f64, f64) {
    let p = unit(degrees.to_radians()) * RING_M;
    (p.x, p.y)
}

fn main_roads(layout: &mut TownLayout) {
    let avenue = "primary lanes=4 sidewalk=both maxspeed=50";
    let boulevard = "primary oneway=yes lanes=3 sidewalk=right maxspeed=60";
    let end = boulevard.replace("lanes=3", "lanes=2");
    let diagonal = "secondary lanes=2 sidewalk=both parking:both=lane maxspeed=50";
    layout.roundabout("primary lanes=2 sidewalk=right maxspeed=30", DVec2::ZERO, RING_M);
    layout.road(avenue, &points(&[on_ring(0.0), (125.0, 0.0), (SOUTHBOUND, 0.0), (NORTHBOUND, 0.0), (335.0, 6.0)]));
    // West: under the parkway.
    layout.road(avenue, &points(&[(-340.0, 0.0), (-125.0, 0.0), on_ring(180.0)]));
    layout.road(
        "secondary lanes=2 sidewalk=both parking:right=lane maxspeed=50",
        &smooth(&[on_ring(90.0), (2.0, 62.0), (6.0, 125.0), (-4.0, 210.0), (14.0, 285.0)]),
    );
    layout.road(
        diagonal,
        &smooth(&[on_ring(240.0), (-34.0, -62.0), (-62.0, -108.0), (-106.0, -180.0), (-112.0, -260.0)]),
    );
    layout.road(diagonal, &smooth(&[on_ring(300.0), (34.0, -62.0), (62.0, -108.0), (100.0, -180.0), (104.0, -261.0)]));
    layout.road(avenue, &points(&[(0.0, -125.0), (-6.0, -262.0)]));
    // Two lanes alone reach the streets at its ends, where one turns right and one left.
    layout.road(boulevard, &points(&[(NORTHBOUND, -260.0), (NORTHBOUND, 150.0)]));
    layout.road(&end, &points(&[(NORTHBOUND, 150.0), (NORTHBOUND, 256.0)]));
    layout.road(boulevard, &points(&[(SOUTHBOUND, 256.0), (SOUTHBOUND, -118.0)]));
    layout.road(&end, &points(&[(SOUTHBOUND, -118.0), (SOUTHBOUND, -260.0)]));
    layout.road_with_bridges(
        "secondary lanes=4 sidewalk=both maxspeed=60",
        &points(&[(-230.0, -258.0), (-230.0, 150.0), (-222.0, 250.0)]),
        &[(DVec2::new(-230.0, 0.0), 20.0)],
    );
    for y in [0.0, -118.0, 150.0] {
        layout.lights(DVec2::new(SOUTHBOUND, y));
        layout.lights(DVec2::new(NORTHBOUND, y));
    }
    layout.lights(DVec2::new(-230.0, -140.0));
    layout.lights(DVec2::new(-230.0, 150.0));
}

fn quarters(layout: &mut TownLayout) {
    let street = "tertiary sidewalk=both parking:both=lane maxspeed=40";
    let quiet = "residential sidewalk=both parking:right=lane maxspeed=40";
    // Half way round the middle.
    layout.road(
        street,
        &smooth(&[
            (125.0, 0.0),
            (96.0, 78.0),
            (6.0, 125.0),
            (-84.0, 92.0),
            (-125.0, 0.0),
            (-108.0, -62.0),
            (-62.0, -108.0),
            (0.0, -125.0),
            (62.0, -108.0),
            (108.0, -62.0),
            (125.0, 0.0),
        ]),
    );
    layout.road(
        street,
        &smooth(&[(108.0, -62.0), (154.0, -96.0), (SOUTHBOUND, -118.0), (NORTHBOUND, -118.0), (335.0, -122.0)]),
    );
    layout.road(street, &smooth(&[(-108.0, -62.0), (-160.0, -106.0), (-230.0, -140.0), (-340.0, -132.0)]));
    layout.road(quiet, &smooth(&[(-84.0, 92.0), (-122.0, 122.0), (-166.0, 142.0), (-230.0, 150.0), (-340.0, 138.0)]));
    layout.road(
        quiet,
        &smooth(&[
            (96.0, 78.0),
            (130.0, 108.0),
            (162.0, 136.0),
            (SOUTHBOUND, 150.0),
            (NORTHBOUND, 150.0),
            (335.0, 146.0),
        ]),
    );
    // Round the outside.
    layout.road(
        street,
        &points(&[
            (-340.0, -258.0),
            (-230.0, -258.0),
            (-112.0, -260.0),
            (-6.0, -262.0),
            (104.0, -261.0),
            (SOUTHBOUND, -260.0),
            (NORTHBOUND, -260.0),
            (335.0, -258.0),
        ]),
    );
    layout.road(
        street,
        &points(&[
            (335.0, -258.0),
            (335.0, 6.0),
            (335.0, 146.0),
            (326.0, 244.0),
            (NORTHBOUND, 256.0),
            (SOUTHBOUND, 256.0),
        ]),
    );
    layout.road(street, &points(&[(-340.0, -258.0), (-340.0, 0.0), (-340.0, 138.0), (-320.0, 236.0), (-222.0, 250.0)]));
    layout
        .road(quiet, &smooth(&[(-222.0, 250.0), (-110.0, 240.0), (14.0, 285.0), (110.0, 250.0), (SOUTHBOUND, 256.0)]));
    layout.road(quiet, &smooth(&[(-122.0, 122.0), (-116.0, 180.0), (-110.0, 240.0)]));
    layout.road(quiet, &smooth(&[(130.0, 108.0), (110.0, 180.0), (110.0, 250.0)]));
    for p in [(125.0, 0.0), (-125.0, 0.0), (0.0, -125.0), (6.0, 125.0)] {
        layout.zebra(DVec2::new(p.0, p.1));
    }
}

fn land(layout: &mut TownLayout) {
    layout.land("leisure=park", &arc(DVec2::ZERO, 17.0, 0.0, 353.0));
    for k in 0..6 {
        layout.feature("natural=tree", unit(f64::from(k) * std::f64::consts::FRAC_PI_3) * 10.0);
    }
    // A square between the avenue and the diagonal.
    layout.square(&points(&[(44.0, -7.5), (106.0, -7.5), (96.0, -46.0), (52.0, -46.0)]));
    layout.park(&points(&[(9.0, -240.0), (88.0, -240.0), (86.0, -182.0), (10.0, -150.0)]));
    layout.land("amenity=parking", &rect((276.0, -60.0), (78.0, 62.0), 0.0));
    layout.building("supermarket building:levels=1", &rect((276.0, 52.0), (64.0, 34.0), 0.0));
    let middle = arc(DVec2::ZERO, 150.0, 0.0, 353.0);
    layout.zone(
        middle,
        &[
            (BuildingKind::Terrace, 5.0),
            (BuildingKind::Office, 1.6),
            (BuildingKind::Flats, 1.0),
            (BuildingKind::Shop, 0.5),
        ],
        (3, 5),
        0.02,
    );
    layout.zone(
        rect((270.0, -40.0), (160.0, 500.0), 0.0),
        &[
            (BuildingKind::Office, 2.0),
            (BuildingKind::Flats, 2.5),
            (BuildingKind::Shop, 1.0),
            (BuildingKind::Tower, 0.4),
        ],
        (4, 7),
        0.04,
    );
    layout.zone(
        rect((-60.0, -200.0), (620.0, 180.0), 0.0),
        &[(BuildingKind::Terrace, 4.0), (BuildingKind::Flats, 2.5), (BuildingKind::Shop, 0.8)],
        (2, 4),
        0.04,
    );
    layout.zone(
        rect((0.0, 0.0), (3000.0, 3000.0), 0.0),
        &[(BuildingKind::House, 5.0), (BuildingKind::Terrace, 1.2), (BuildingKind::Flats, 0.6)],
        (2, 3),
        0.06,
    );
}
