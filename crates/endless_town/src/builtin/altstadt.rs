//! Altstadt: a European old town: irregular cobbled streets, closed fronts, squares, zebra crossings, a ring road where
//! its walls stood.

use super::layout::TownLayout;
use super::layout_geometry::{points, rect, rise, smooth, smooth_ring};
use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use crate::palette::COBBLES;
use endless_road::RoadMap;
use glam::DVec2;

fn height(p: DVec2) -> f64 {
    // The castle's hill in the north-west; the ground falls a little to the south.
    4.0 * rise(-160.0, 160.0, p.y - 0.4 * p.x) + 40.0 * rise(250.0, 640.0, p.length())
}

pub(super) fn make() -> (RoadMap, TownPreset) {
    let mut layout = TownLayout::of([49.3, 10.6]);
    streets(&mut layout);
    land(&mut layout);
    let preset = TownPreset {
        summary: "A European old town: irregular cobbled streets, squares, zebra crossings, a ring road.".to_owned(),
        lamp_color: [1.0, 0.74, 0.42],
        lamp_cd: 3000.0,
        conifers: 0.05,
        paving: COBBLES,
        yards: true,
        ..TownPreset::default()
    };
    layout.build(Some(&height), preset)
}

fn streets(layout: &mut TownLayout) {
    let ring = "secondary lanes=2 width=9 sidewalk=both maxspeed=50";
    let street = "tertiary width=6.4 sidewalk=both sidewalk:both:width=2.4 maxspeed=30";
    let lane = "residential width=5.4 sidewalk=both sidewalk:both:width=1.6 maxspeed=30";
    let narrow = "residential oneway=yes width=4.4 parking:right=no sidewalk=both sidewalk:both:width=1.5 maxspeed=20";
    layout.road(
        ring,
        &smooth_ring(&[
            (0.0, -206.0),
            (128.0, -176.0),
            (208.0, -76.0),
            (214.0, 46.0),
            (138.0, 158.0),
            (10.0, 202.0),
            (-122.0, 172.0),
            (-206.0, 70.0),
            (-204.0, -62.0),
            (-120.0, -168.0),
        ]),
    );
    // Through the gates to the market.
    layout.road(street, &smooth(&[(0.0, -206.0), (14.0, -140.0), (-6.0, -84.0), (-34.0, -34.0)]));
    layout.road(street, &smooth(&[(214.0, 46.0), (150.0, 30.0), (92.0, 44.0), (40.0, 30.0)]));
    layout.road(street, &smooth(&[(-206.0, 70.0), (-150.0, 52.0), (-96.0, 60.0), (-38.0, 36.0)]));
    layout.road(street, &smooth(&[(10.0, 202.0), (-2.0, 140.0), (11.0, 114.0), (22.0, 88.0), (40.0, 30.0)]));
    // Around the market square.
    layout.road(lane, &points(&[(-34.0, -34.0), (36.0, -30.0), (40.0, 30.0), (-38.0, 36.0), (-34.0, -34.0)]));
    // Between.
    layout.road(narrow, &smooth(&[(36.0, -30.0), (86.0, -52.0), (140.0, -44.0), (208.0, -76.0)]));
    layout.road(lane, &smooth(&[(-34.0, -34.0), (-84.0, -58.0), (-140.0, -44.0), (-204.0, -62.0)]));
    layout.road(narrow, &smooth(&[(3.0, -110.0), (60.0, -112.0), (98.0, -130.0), (128.0, -176.0)]));
    layout.road(lane, &smooth(&[(5.0, -116.0), (-60.0, -112.0), (-96.0, -126.0), (-120.0, -168.0)]));
    layout.road(narrow, &smooth(&[(138.0, 158.0), (112.0, 110.0), (118.0, 70.0), (112.0, 39.0)]));
    layout.road(lane, &smooth(&[(-122.0, 172.0), (-104.0, 120.0), (-112.0, 90.0), (-104.0, 58.0)]));
    layout.road(narrow, &smooth(&[(11.0, 114.0), (-50.0, 110.0), (-104.0, 120.0)]));
    layout.road(lane, &smooth(&[(11.0, 114.0), (64.0, 106.0), (112.0, 110.0)]));
    layout.road(narrow, &smooth(&[(98.0, -130.0), (112.0, -90.0), (112.0, -47.0)]));
    layout.road(narrow, &smooth(&[(-112.0, -51.0), (-104.0, -90.0), (-96.0, -126.0)]));
    layout.road(lane, &smooth(&[(150.0, -47.0), (160.0, -8.0), (150.0, 30.0)]));
    layout.road(narrow, &smooth(&[(-150.0, 52.0), (-158.0, 4.0), (-150.0, -46.0)]));
    for (x, y) in [
        (0.0, -206.0),
        (214.0, 46.0),
        (-206.0, 70.0),
        (10.0, 202.0),
        (208.0, -76.0),
        (-204.0, -62.0),
        (-34.0, -34.0),
        (40.0, 30.0),
        (36.0, -30.0),
        (-38.0, 36.0),
    ] {
        layout.zebra(DVec2::new(x, y));
    }
    layout.lights(DVec2::new(128.0, -176.0));
}

fn land(layout: &mut TownLayout) {
    layout.land("place=square", &points(&[(-26.0, -25.0), (28.0, -22.0), (31.0, 22.0), (-29.0, 27.0)]));
    layout.building("townhall building:levels=3", &rect((8.0, 10.0), (22.0, 12.0), 0.0));
    layout.building("church building:levels=4", &rect((-66.0, 86.0), (15.0, 28.0), 0.0));
    layout.land("place=square", &rect((62.0, -84.0), (30.0, 26.0), -8.0));
    for (x, y) in [(-14.0, -14.0), (0.0, -14.0), (16.0, -12.0), (-18.0, 14.0)] {
        layout.feature("bench", DVec2::new(x, y));
    }
    for (x, y) in [(56.0, -80.0), (68.0, -88.0), (-20.0, 20.0), (22.0, -16.0)] {
        layout.feature("natural=tree", DVec2::new(x, y));
    }
    let inner = smooth_ring(&[
        (0.0, -190.0),
        (118.0, -162.0),
        (192.0, -70.0),
        (198.0, 42.0),
        (128.0, 146.0),
        (8.0, 186.0),
        (-114.0, 158.0),
        (-190.0, 64.0),
        (-188.0, -58.0),
        (-112.0, -154.0),
    ]);
    layout.zone(inner, &[(BuildingKind::Terrace, 1.0)], (3, 4), 0.0);
    layout.zone(
        rect((0.0, 0.0), (3000.0, 3000.0), 0.0),
        &[(BuildingKind::Flats, 2.0), (BuildingKind::House, 2.0), (BuildingKind::Terrace, 1.0)],
        (2, 4),
        0.1,
    );
}
