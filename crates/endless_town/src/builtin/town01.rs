//! Town01: a small town on both banks of a river; its streets meet in T-junctions.

use super::layout::TownLayout;
use super::layout_geometry::{band, beside, distance, hill, points, rect, rise, smooth};
use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use endless_road::RoadMap;
use glam::DVec2;

/// Half the river from bank to bank and at the water's edge, metres; and its depth below the banks.
const BANKS_M: f64 = 15.0;
const WATER_M: f64 = 10.6;
const BED_M: f64 = 3.6;

fn river() -> Vec<DVec2> {
    smooth(&[
        (-760.0, -60.0),
        (-560.0, 20.0),
        (-400.0, 10.0),
        (-290.0, -14.0),
        (-205.0, 0.0),
        (-110.0, 12.0),
        (-15.0, 0.0),
        (95.0, -12.0),
        (205.0, 0.0),
        (300.0, 18.0),
        (420.0, -6.0),
        (580.0, 30.0),
        (760.0, -40.0),
    ])
}

fn height(p: DVec2, river: &[DVec2]) -> f64 {
    let away = distance(river, p);
    let banks = -BED_M * rise(BANKS_M, BANKS_M - 8.0, away);
    let valley = 5.0 * rise(70.0, 260.0, away) + 40.0 * rise(300.0, 760.0, away);
    banks + valley + hill(p, (-90.0, 300.0), 220.0, 9.0)
}

pub(super) fn make() -> (RoadMap, TownPreset) {
    let mut layout = TownLayout::of([41.2, -84.0]);
    let river = river();
    streets(&mut layout);
    land(&mut layout, &river);
    let preset = TownPreset {
        summary: "A small town on both banks of a river: bridges, quiet streets, T-junctions.".to_owned(),
        lamp_color: [1.0, 0.62, 0.25],
        lamp_cd: 3400.0,
        conifers: 0.2,
        ..TownPreset::default()
    };
    layout.build(Some(&|p| height(p, &river)), preset)
}

fn streets(layout: &mut TownLayout) {
    let ring = "tertiary sidewalk=both maxspeed=50";
    let main = "tertiary sidewalk=both parking:both=lane maxspeed=40";
    let quiet = "residential sidewalk=both maxspeed=40";
    let home = "residential sidewalk=both parking:right=lane maxspeed=40";
    let over = |x: f64| (DVec2::new(x, 0.0), 19.0);
    // Around the town, over the river in the west and in the east.
    let west = points(&[(-205.0, -66.0), (-205.0, 60.0)]);
    let east = points(&[(205.0, -62.0), (205.0, 64.0)]);
    layout.road_with_bridges(ring, &west, &[over(-205.0)]);
    layout.road_with_bridges(ring, &east, &[over(205.0)]);
    layout.road(
        ring,
        &points(&[(-205.0, 60.0), (-203.0, 172.0), (-60.0, 180.0), (80.0, 172.0), (205.0, 166.0), (205.0, 64.0)]),
    );
    layout.road(
        ring,
        &points(&[
            (-205.0, -66.0),
            (-205.0, -164.0),
            (-40.0, -172.0),
            (110.0, -166.0),
            (205.0, -170.0),
            (205.0, -62.0),
        ]),
    );
    // Along the banks, and the bridge between them.
    layout.road(main, &points(&[(-205.0, 60.0), (-110.0, 66.0), (-15.0, 56.0), (95.0, 44.0), (205.0, 64.0)]));
    layout.road(main, &points(&[(-205.0, -66.0), (-110.0, -50.0), (-15.0, -62.0), (95.0, -72.0), (205.0, -62.0)]));
    layout.road_with_bridges(main, &points(&[(-15.0, -62.0), (-15.0, 56.0)]), &[(DVec2::new(-15.0, 0.0), 19.0)]);
    // Side streets, none opposite another.
    layout.road(home, &points(&[(-112.0, 66.0), (-118.0, 120.0), (-112.0, 177.0)]));
    layout.road(quiet, &points(&[(62.0, 48.0), (66.0, 110.0), (58.0, 174.0)]));
    layout.road(home, &points(&[(-118.0, 120.0), (-40.0, 124.0), (62.5, 136.0)]));
    layout.road(quiet, &points(&[(64.5, 88.0), (130.0, 100.0), (205.0, 108.0)]));
    layout.road(home, &points(&[(-82.0, -54.0), (-84.0, -112.0), (-78.0, -170.0)]));
    layout.road(quiet, &points(&[(102.0, -72.0), (106.0, -120.0), (100.0, -166.0)]));
    layout.road(quiet, &points(&[(-84.0, -118.0), (-140.0, -112.0), (-205.0, -118.0)]));
    layout.road(home, &points(&[(-83.0, -106.0), (10.0, -118.0), (105.0, -114.0)]));
    layout.lights(DVec2::new(-15.0, 56.0));
    layout.zebra(DVec2::new(-15.0, -62.0));
    layout.zebra(DVec2::new(62.0, 48.0));
    layout.zebra(DVec2::new(-82.0, -54.0));
}

fn land(layout: &mut TownLayout, river: &[DVec2]) {
    layout.land("natural=water", &band(river, WATER_M));
    layout.tree_row(&part_of(&beside(river, 21.0), -180.0, 180.0));
    layout.land("leisure=park", &points(&[(-14.0 + 12.0, -54.0), (80.0, -60.0), (86.0, -34.0), (0.0, -22.0)]));
    layout.land("place=square", &rect((-46.0, 86.0), (40.0, 30.0), -3.0));
    layout.building("church building:levels=3", &rect((-52.0, 104.0), (16.0, 9.0), 0.0));
    layout.land("landuse=farmland", &rect((0.0, 300.0), (420.0, 160.0), 0.0));
    layout.land("landuse=farmland", &rect((40.0, -290.0), (460.0, 150.0), 0.0));
    let centre = rect((-20.0, 0.0), (190.0, 150.0), 0.0);
    layout.zone(
        centre,
        &[(BuildingKind::Terrace, 5.0), (BuildingKind::Shop, 1.0), (BuildingKind::Flats, 0.5)],
        (2, 3),
        0.03,
    );
    layout.zone(
        rect((0.0, 0.0), (3000.0, 3000.0), 0.0),
        &[(BuildingKind::House, 6.0), (BuildingKind::Terrace, 1.0), (BuildingKind::Shop, 0.4)],
        (1, 2),
        0.08,
    );
}

/// The points of a line between two places from west to east.
fn part_of(line: &[DVec2], west: f64, east: f64) -> Vec<DVec2> {
    line.iter().copied().filter(|p| (west..east).contains(&p.x)).collect()
}
