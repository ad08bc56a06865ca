//! Town10HD: a dense downtown with towers, a plaza in its middle and a promenade on the river.

use super::layout::TownLayout;
use super::layout_geometry::{points, rect, rise};
use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use endless_road::RoadMap;
use glam::DVec2;

const COLUMNS: [f64; 5] = [-184.0, -92.0, -4.0, 88.0, 180.0];
const ROWS: [f64; 5] = [-150.0, -72.0, 6.0, 86.0, 164.0];
/// The edge of the quay, and the water below it.
const QUAY_Y: f64 = -190.0;
const QUAY_M: f64 = 2.6;

/// The river lies lower than the quay.
fn height(p: DVec2) -> f64 {
    -QUAY_M * rise(QUAY_Y - 4.5, QUAY_Y - 8.5, p.y) * rise(-262.0, -254.0, p.y) + 20.0 * rise(-270.0, -420.0, p.y)
}

pub(super) fn make() -> (RoadMap, TownPreset) {
    let mut layout = TownLayout::of([41.88, -87.63]);
    streets(&mut layout);
    land(&mut layout);
    let preset = TownPreset {
        summary:
            "Dense downtown: towers, busy sidewalks, signals at every corner, a plaza and a promenade on the river."
                .to_owned(),
        lamp_color: [0.96, 1.0, 0.94],
        lamp_cd: 5500.0,
        conifers: 0.0,
        ..TownPreset::default()
    };
    layout.build(Some(&height), preset)
}

fn streets(layout: &mut TownLayout) {
    let downtown = "secondary lanes=4 sidewalk=both maxspeed=50";
    let avenue = "primary lanes=4 sidewalk=both parking:both=lane maxspeed=50";
    let parked = "secondary lanes=4 sidewalk=both parking:both=lane maxspeed=40";
    for (k, x) in COLUMNS.into_iter().enumerate() {
        let words = [downtown, parked, avenue, parked, downtown][k];
        layout.road(words, &points(&[(x, ROWS[0]), (x, ROWS[4])]));
    }
    for (k, y) in ROWS.into_iter().enumerate() {
        let words = [avenue, parked, downtown, parked, downtown][k];
        layout.road(words, &points(&[(COLUMNS[0], y), (COLUMNS[4], y)]));
    }
    for x in COLUMNS {
        ROWS.iter().for_each(|&y| layout.lights(DVec2::new(x, y)));
    }
}

fn land(layout: &mut TownLayout) {
    // The plaza: a block without houses, but for the theatre on it.
    layout.square(&points(&[(8.5, 17.0), (79.0, 17.0), (79.0, 76.5), (8.5, 76.5)]));
    layout.building("theatre building:levels=4", &rect((54.0, 58.0), (30.0, 24.0), 0.0));
    // The promenade between the drive and the river.
    layout.square(&points(&[(-196.0, QUAY_Y + 1.0), (192.0, QUAY_Y + 1.0), (192.0, -164.5), (-196.0, -164.5)]));
    let (west, east) = (-270.0, 266.0);
    layout
        .land("natural=water", &points(&[(west, -252.0), (east, -252.0), (east, QUAY_Y - 7.0), (west, QUAY_Y - 7.0)]));
    // Courts behind the houses.
    for x in COLUMNS.windows(2) {
        for y in ROWS.windows(2) {
            let middle = (x[0].midpoint(x[1]), y[0].midpoint(y[1]));
            layout.land("landuse=commercial", &rect(middle, (x[1] - x[0] - 4.0, y[1] - y[0] - 4.0), 0.0));
        }
    }
    layout.park(&points(&[(-81.0, 97.0), (-17.5, 97.0), (-17.5, 152.0), (-81.0, 152.0)]));
    layout.zone(
        rect((0.0, 20.0), (250.0, 240.0), 0.0),
        &[(BuildingKind::Tower, 3.0), (BuildingKind::Office, 4.0), (BuildingKind::Terrace, 2.0)],
        (6, 10),
        0.0,
    );
    layout.zone(
        rect((0.0, 0.0), (3000.0, 3000.0), 0.0),
        &[
            (BuildingKind::Terrace, 3.0),
            (BuildingKind::Office, 4.0),
            (BuildingKind::Tower, 1.4),
            (BuildingKind::Flats, 1.0),
        ],
        (4, 8),
        0.02,
    );
}
