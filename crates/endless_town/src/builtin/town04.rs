//! Town04: a small town inside a highway loop, at the foot of hills.

use super::layout::TownLayout;
use super::layout_geometry::{beside, hill, part, points, rect, rise, smooth, smooth_ring, turned};
use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use endless_road::RoadMap;
use endless_world::math::f64::sin;
use glam::DVec2;

/// From the middle of the median to the middle of a carriageway, metres.
const APART_M: f64 = 7.6;

/// How far ramps go along a carriageway while they come so far out of its middle, metres.
const TAPER_M: f64 = 45.0;
const TAPER_OUT_M: f64 = 14.5;

fn height(p: DVec2) -> f64 {
    let slope = 24.0 * rise(-60.0, 480.0, p.y);
    let waves = 2.2 * sin(p.x / 95.0 + 0.6) * rise(-40.0, 160.0, p.y);
    let hills = hill(p, (-160.0, 640.0), 420.0, 70.0) + hill(p, (420.0, 620.0), 380.0, 55.0);
    slope + waves + hills + hill(p, (-760.0, 180.0), 300.0, 45.0)
}

pub(super) fn make() -> (RoadMap, TownPreset) {
    let mut layout = TownLayout::of([42.0, -83.5]);
    highway(&mut layout);
    streets(&mut layout);
    land(&mut layout);
    let preset = TownPreset {
        summary: "A small town inside a highway loop with ramps and bridges, at the foot of wooded hills.".to_owned(),
        lamp_color: [0.96, 1.0, 0.94],
        conifers: 0.5,
        ..TownPreset::default()
    };
    layout.build(Some(&height), preset)
}

/// The loop: two carriageways, over the main street in the south, under the avenue in the west and a road in the north.
fn highway(layout: &mut TownLayout) {
    let middle = smooth_ring(&[
        (0.0, -262.0),
        (190.0, -252.0),
        (345.0, -170.0),
        (392.0, 0.0),
        (335.0, 170.0),
        (180.0, 252.0),
        (0.0, 268.0),
        (-190.0, 250.0),
        (-345.0, 165.0),
        (-395.0, 3.0),
        (-345.0, -165.0),
        (-190.0, -250.0),
    ]);
    let words = "motorway oneway=yes lanes=2 maxspeed=90";
    // Counter-clockwise outside, clockwise inside: both keep to the right.
    let outer = beside(&middle, -APART_M);
    let inner = turned(&beside(&middle, APART_M));
    for ring in [&outer, &inner] {
        let length: f64 = ring.windows(2).map(|w| w[0].distance(w[1])).sum();
        // Begun away from the bridge.
        let half = [part(ring, length / 2.0, length), part(ring, 0.0, length / 2.0)];
        let line: Vec<DVec2> = half[0].iter().chain(&half[1][1..]).copied().collect();
        let south = DVec2::new(0.0, -262.0);
        layout.road_with_bridges(words, &line, &[(south, 19.0)]);
    }
    let ramp = "motorway_link oneway=yes lanes=1 maxspeed=50";
    // Where a ramp leaves or joins a carriageway near a place, first out from it and then so far along in the direction of
    // travel: as slowly as cars that come at the motorway's speed can follow.
    let taper = |line: &[DVec2], near: (f64, f64), along_m: f64| {
        let p = DVec2::new(near.0, near.1);
        let nearest = (1..line.len() - 1).min_by(|&a, &b| line[a].distance(p).total_cmp(&line[b].distance(p)));
        let at = nearest.unwrap_or(1);
        let ahead = (line[at + 1] - line[at - 1]).normalize_or(DVec2::X);
        [line[at], line[at] + ahead * along_m - ahead.perp() * TAPER_OUT_M]
    };
    let off = |line: &[DVec2], near: (f64, f64), through: (f64, f64), to: (f64, f64)| {
        let [from, beside] = taper(line, near, TAPER_M);
        vec![from, beside, DVec2::new(through.0, through.1), DVec2::new(to.0, to.1)]
    };
    let on = |from: (f64, f64), through: (f64, f64), line: &[DVec2], near: (f64, f64)| {
        let [to, beside] = taper(line, near, -TAPER_M);
        vec![DVec2::new(from.0, from.1), DVec2::new(through.0, through.1), beside, to]
    };
    let ramps = [
        // South: a diamond on both sides of the main street.
        off(&outer, (-190.0, -262.0), (-60.0, -312.0), (0.0, -312.0)),
        on((0.0, -312.0), (60.0, -312.0), &outer, (190.0, -262.0)),
        off(&inner, (190.0, -246.0), (60.0, -208.0), (0.0, -212.0)),
        on((0.0, -212.0), (-60.0, -208.0), &inner, (-190.0, -246.0)),
        // West: the same about the avenue's bridge.
        off(&outer, (-372.0, 145.0), (-446.0, 40.0), (-446.0, 0.0)),
        on((-446.0, 0.0), (-446.0, -40.0), &outer, (-372.0, -145.0)),
        off(&inner, (-345.0, -135.0), (-334.0, -36.0), (-340.0, 0.0)),
        on((-340.0, 0.0), (-334.0, 36.0), &inner, (-345.0, 135.0)),
    ];
    for line in &ramps {
        layout.road(ramp, line);
    }
}

fn streets(layout: &mut TownLayout) {
    let avenue = "secondary lanes=4 sidewalk=both maxspeed=50";
    let main = "tertiary sidewalk=both parking:both=lane maxspeed=50";
    let quiet = "residential sidewalk=both maxspeed=40";
    let home = "residential sidewalk=both parking:right=lane maxspeed=40";
    let road = "unclassified sidewalk=no maxspeed=60";
    // Nobody walks across ramps.
    layout.road_with_bridges(
        "secondary lanes=4 sidewalk=no maxspeed=60",
        &points(&[(-520.0, 0.0), (-446.0, 0.0), (-340.0, 0.0), (-210.0, 0.0)]),
        &[(DVec2::new(-395.0, 0.0), 20.0)],
    );
    layout.road(avenue, &points(&[(-210.0, 0.0), (0.0, 0.0), (235.0, 8.0)]));
    layout.road(
        "tertiary sidewalk=no maxspeed=60",
        &points(&[(0.0, -392.0), (0.0, -312.0), (0.0, -212.0), (0.0, -190.0)]),
    );
    layout.road(main, &points(&[(0.0, -190.0), (0.0, 0.0), (6.0, 120.0)]));
    // Over the highway, round its outside through the hills and back to the avenue.
    layout.road_with_bridges(
        road,
        &smooth(&[
            (6.0, 120.0),
            (8.0, 190.0),
            (2.0, 268.0),
            (-12.0, 332.0),
            (-52.0, 378.0),
            (-120.0, 386.0),
            (-210.0, 340.0),
            (-320.0, 330.0),
            (-420.0, 270.0),
            (-486.0, 160.0),
            (-516.0, 60.0),
            (-520.0, 0.0),
        ]),
        &[(DVec2::new(2.0, 268.0), 20.0)],
    );
    layout.road(
        road,
        &smooth(&[
            (0.0, -392.0),
            (-130.0, -384.0),
            (-280.0, -350.0),
            (-420.0, -260.0),
            (-500.0, -130.0),
            (-520.0, 0.0),
        ]),
    );
    layout.road(quiet, &points(&[(-205.0, -128.0), (0.0, -120.0), (150.0, -124.0), (240.0, -104.0), (235.0, 8.0)]));
    layout.road(home, &points(&[(-205.0, -128.0), (-210.0, 0.0), (-196.0, 108.0), (-96.0, 118.0), (6.0, 120.0)]));
    layout.road(home, &points(&[(6.0, 120.0), (128.0, 112.0), (226.0, 96.0), (235.0, 8.0)]));
    layout.road(quiet, &points(&[(118.0, -123.0), (114.0, 0.0), (128.0, 112.0)]));
    layout.road(home, &points(&[(-104.0, -124.0), (-100.0, 0.0), (-96.0, 118.0)]));
    layout.road(quiet, &points(&[(-210.0, -60.0), (-104.0, -64.0)]));
    layout.lights(DVec2::new(0.0, 0.0));
    layout.lights(DVec2::new(-210.0, 0.0));
    layout.zebra(DVec2::new(0.0, -120.0));
    layout.zebra(DVec2::new(114.0, 0.0));
}

fn land(layout: &mut TownLayout) {
    layout.land("leisure=park", &rect((58.0, -62.0), (86.0, 92.0), 0.0));
    layout.land("place=square", &rect((-27.0, -26.0), (30.0, 26.0), 0.0));
    layout.land("amenity=parking", &rect((-50.0, -176.0), (56.0, 42.0), 0.0));
    layout.building("supermarket building:levels=1", &rect((-52.0, -212.0), (46.0, 20.0), 0.0));
    layout.land(
        "landuse=forest",
        &smooth(&[(60.0, 300.0), (330.0, 250.0), (430.0, 330.0), (180.0, 430.0), (60.0, 380.0)]),
    );
    layout.land("landuse=forest", &smooth(&[(-330.0, 380.0), (-120.0, 430.0), (-150.0, 500.0), (-420.0, 460.0)]));
    layout.land("landuse=meadow", &rect((290.0, 0.0), (90.0, 240.0), 0.0));
    let centre = rect((0.0, -8.0), (190.0, 120.0), 0.0);
    layout.zone(
        centre,
        &[
            (BuildingKind::Terrace, 4.0),
            (BuildingKind::Shop, 1.6),
            (BuildingKind::Flats, 1.0),
            (BuildingKind::Office, 0.6),
        ],
        (2, 3),
        0.03,
    );
    layout.zone(
        rect((0.0, -320.0), (420.0, 130.0), 0.0),
        &[(BuildingKind::Hall, 2.0), (BuildingKind::Shop, 2.0)],
        (1, 2),
        0.2,
    );
    layout.zone(
        rect((10.0, 0.0), (520.0, 300.0), 0.0),
        &[(BuildingKind::House, 6.0), (BuildingKind::Flats, 0.7), (BuildingKind::Shop, 0.5)],
        (1, 3),
        0.07,
    );
    layout.zone(
        rect((0.0, 0.0), (3000.0, 3000.0), 0.0),
        &[(BuildingKind::House, 1.0), (BuildingKind::Barn, 1.0)],
        (1, 2),
        0.75,
    );
}
