//! Town07: a village on rolling land: narrow roads without paint, barns, fields of maize.

use super::layout::TownLayout;
use super::layout_geometry::{points, rect, rise, smooth};
use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use endless_road::RoadMap;
use endless_world::math::f64::sin;
use glam::DVec2;

fn height(p: DVec2) -> f64 {
    let rolling = 3.4 * sin(p.x / 88.0 + 0.4) * sin(p.y / 76.0 - 0.3) + 2.0 * sin((p.x + p.y) / 130.0);
    rolling + 26.0 * rise(330.0, 720.0, p.length())
}

pub(super) fn make() -> (RoadMap, TownPreset) {
    let mut layout = TownLayout::of([43.1, -89.6]);
    roads(&mut layout);
    land(&mut layout);
    let preset = TownPreset {
        summary: "A village on rolling land: narrow roads without paint, barns, fields of maize.".to_owned(),
        lamp_color: [1.0, 0.62, 0.25],
        lamp_cd: 2800.0,
        conifers: 0.35,
        maize: true,
        ..TownPreset::default()
    };
    layout.build(Some(&height), preset)
}

fn roads(layout: &mut TownLayout) {
    let lane = "residential width=6 sidewalk=no maxspeed=60";
    let village = "residential width=6.2 sidewalk=both sidewalk:both:width=1.8 maxspeed=40";
    let track = "residential width=5.4 surface=gravel sidewalk=no maxspeed=30";
    layout.road(village, &smooth(&[(-120.0, 14.0), (-60.0, -4.0), (0.0, 0.0), (70.0, 12.0), (130.0, 0.0)]));
    let bays = format!("{village} parking:right=lane");
    layout.road(&bays, &smooth(&[(0.0, 0.0), (10.0, 60.0), (-6.0, 118.0)]));
    layout.road(lane, &smooth(&[(-120.0, 14.0), (-190.0, 40.0), (-262.0, 20.0), (-318.0, 60.0)]));
    layout.road(lane, &smooth(&[(130.0, 0.0), (200.0, -24.0), (262.0, 8.0), (316.0, 0.0)]));
    layout.road(lane, &smooth(&[(-6.0, 118.0), (-20.0, 180.0), (24.0, 232.0), (20.0, 268.0)]));
    layout.road(lane, &smooth(&[(0.0, 0.0), (-14.0, -70.0), (20.0, -140.0), (4.0, -200.0), (20.0, -262.0)]));
    // All around, through the fields.
    layout.road(lane, &smooth(&[(-318.0, 60.0), (-306.0, 150.0), (-220.0, 214.0), (-110.0, 240.0), (20.0, 268.0)]));
    layout.road(lane, &smooth(&[(20.0, 268.0), (140.0, 244.0), (240.0, 190.0), (300.0, 100.0), (316.0, 0.0)]));
    layout.road(lane, &smooth(&[(316.0, 0.0), (290.0, -110.0), (210.0, -210.0), (110.0, -238.0), (20.0, -262.0)]));
    layout.road(lane, &smooth(&[(20.0, -262.0), (-110.0, -250.0), (-220.0, -190.0), (-290.0, -80.0), (-318.0, 60.0)]));
    layout.road(track, &smooth(&[(-190.0, 40.0), (-170.0, 120.0), (-110.0, 160.0), (-13.0, 150.0)]));
    layout.road(track, &smooth(&[(200.0, -24.0), (190.0, -110.0), (120.0, -150.0), (20.0, -140.0)]));
    layout.road(track, &smooth(&[(70.0, 12.0), (96.0, 90.0), (90.0, 160.0), (140.0, 244.0)]));
}

fn land(layout: &mut TownLayout) {
    let field = "landuse=farmland crop=maize";
    for (middle, size, turn) in [
        ((-235.0, 118.0), (86.0, 100.0), 8.0),
        ((-232.0, -56.0), (96.0, 118.0), -6.0),
        ((-110.0, -110.0), (110.0, 130.0), 4.0),
        ((-60.0, 205.0), (120.0, 52.0), 8.0),
        ((200.0, 118.0), (110.0, 120.0), -12.0),
        ((262.0, -86.0), (56.0, 100.0), 20.0),
        ((110.0, -82.0), (110.0, 80.0), -6.0),
        ((100.0, -196.0), (120.0, 46.0), 8.0),
        ((-100.0, 90.0), (70.0, 70.0), 4.0),
    ] {
        layout.land(field, &rect(middle, size, turn));
    }
    layout.land(
        "landuse=forest",
        &smooth(&[(300.0, 200.0), (420.0, 90.0), (430.0, 260.0), (250.0, 330.0), (220.0, 280.0)]),
    );
    layout.land("landuse=forest", &smooth(&[(-340.0, -120.0), (-260.0, -230.0), (-180.0, -330.0), (-420.0, -330.0)]));
    layout.building("church building:levels=2", &rect((30.0, 34.0), (9.0, 17.0), 0.0));
    layout.building("barn", &rect((-160.0, 8.0), (13.0, 24.0), 24.0));
    layout.building("barn", &rect((160.0, 30.0), (24.0, 13.0), -20.0));
    layout.building("barn", &rect((44.0, -116.0), (13.0, 22.0), 30.0));
    // Beside the church, and the farms' yards.
    for (middle, size, turn) in
        [((56.0, 27.0), (28.0, 17.0), 8.0), ((-140.0, 0.0), (18.0, 16.0), 24.0), ((146.0, 14.0), (18.0, 16.0), -20.0)]
    {
        layout.land("amenity=parking", &rect(middle, size, turn));
    }
    layout.zone(
        points(&[(-140.0, -50.0), (140.0, -50.0), (140.0, 70.0), (40.0, 130.0), (-50.0, 130.0), (-140.0, 60.0)]),
        &[(BuildingKind::House, 5.0), (BuildingKind::Barn, 1.0)],
        (1, 2),
        0.12,
    );
    layout.zone(
        rect((0.0, 0.0), (3000.0, 3000.0), 0.0),
        &[(BuildingKind::House, 1.0), (BuildingKind::Barn, 2.0)],
        (1, 2),
        0.86,
    );
}
