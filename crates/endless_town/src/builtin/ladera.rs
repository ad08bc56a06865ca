//! Ladera: a Latin American town on a hillside: steep narrow streets, low houses wall to wall in bright colours, wires
//! overhead, speed bumps.

use super::layout::TownLayout;
use super::layout_geometry::{hill, points, rect, rise, smooth};
use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use endless_road::RoadMap;
use endless_world::math::f64::sin;
use glam::DVec2;

fn height(p: DVec2) -> f64 {
    // Up towards the north, in two steps, with a spur in the east.
    let slope = 16.0 * rise(-150.0, 40.0, p.y) + 20.0 * rise(30.0, 230.0, p.y);
    slope
        + hill(p, (250.0, 60.0), 200.0, 11.0)
        + 60.0 * rise(210.0, 620.0, p.y)
        + 4.0 * sin(p.x / 90.0) * rise(-120.0, 60.0, p.y)
        + 30.0 * rise(300.0, 700.0, p.x.abs())
}

pub(super) fn make() -> (RoadMap, TownPreset) {
    let mut layout = TownLayout::of([-7.2, -78.5]);
    streets(&mut layout);
    land(&mut layout);
    let preset = TownPreset {
        summary: "A Latin American hillside town: steep narrow streets, low bright houses, wires, speed bumps."
            .to_owned(),
        lamp_color: [1.0, 0.66, 0.30],
        lamp_cd: 3600.0,
        conifers: 0.04,
        palms: 0.35,
        wires: true,
        bright: true,
        ..TownPreset::default()
    };
    layout.build(Some(&height), preset)
}

fn streets(layout: &mut TownLayout) {
    let main = "tertiary lanes=2 width=8.4 sidewalk=both maxspeed=40";
    let calle = "residential width=6.4 sidewalk=both sidewalk:both:width=1.4 maxspeed=30";
    let narrow = "residential oneway=yes width=5.2 sidewalk=both sidewalk:both:width=1.3 maxspeed=30";
    // The road in the valley, and one that winds up.
    layout.road(main, &smooth(&[(-270.0, -160.0), (-140.0, -152.0), (0.0, -158.0), (140.0, -150.0), (262.0, -160.0)]));
    layout.road(
        main,
        &smooth(&[
            (0.0, -158.0),
            (6.0, -96.0),
            (0.0, -20.0),
            (10.0, 60.0),
            (60.0, 118.0),
            (52.0, 190.0),
            (-20.0, 216.0),
            (-140.0, 206.0),
        ]),
    );
    // Along the slope.
    layout.road(calle, &points(&[(-262.0, -84.0), (-120.0, -92.0), (5.0, -90.0), (130.0, -86.0), (256.0, -92.0)]));
    layout.road(calle, &points(&[(-258.0, -18.0), (-124.0, -24.0), (0.0, -20.0), (126.0, -18.0), (250.0, -26.0)]));
    layout.road(calle, &points(&[(-250.0, 50.0), (-118.0, 44.0), (8.0, 48.0), (128.0, 52.0), (244.0, 44.0)]));
    layout.road(calle, &points(&[(-238.0, 118.0), (-112.0, 116.0), (58.0, 118.0), (150.0, 122.0), (232.0, 112.0)]));
    // Straight up.
    let up = |x: f64, lean: f64| [-156.0, -90.0, -21.0, 48.0, 118.0].map(|y| (x + lean * (y + 160.0), y));
    layout.road(calle, &points(&up(-262.0, 0.09)));
    layout.road(narrow, &points(&up(-190.0, 0.02)));
    layout.road(narrow, &points(&up(-122.0, 0.03).into_iter().rev().collect::<Vec<_>>()));
    layout.road(narrow, &points(&up(-62.0, 0.02)));
    layout.road(narrow, &points(&up(70.0, -0.01).into_iter().rev().collect::<Vec<_>>()));
    layout.road(narrow, &points(&up(132.0, 0.0)));
    layout.road(narrow, &points(&up(196.0, 0.0).into_iter().rev().collect::<Vec<_>>()));
    layout.road(calle, &points(&up(258.0, -0.09)));
    layout.road(calle, &smooth(&[(-140.0, 206.0), (-190.0, 176.0), (-236.0, 118.0)]));
    layout.lights(DVec2::new(0.0, -158.0));
    for (x, y) in [
        (3.0, -60.0),
        (3.0, 20.0),
        (-160.0, -91.0),
        (64.0, -88.0),
        (-60.0, -22.0),
        (66.0, 50.0),
        (-180.0, 46.0),
        (190.0, -20.0),
        (-90.0, -155.0),
        (90.0, -153.0),
    ] {
        layout.bump(DVec2::new(x, y));
    }
    for (x, y) in [(0.0, -20.0), (5.0, -90.0), (-122.0, -24.0)] {
        layout.zebra(DVec2::new(x, y));
    }
}

fn land(layout: &mut TownLayout) {
    layout.land("place=square", &rect((36.0, -54.0), (46.0, 48.0), 0.0));
    layout.building("church building:levels=3", &rect((36.0, 20.0), (16.0, 30.0), 0.0));
    for (x, y) in [(22.0, -40.0), (50.0, -40.0), (22.0, -68.0), (50.0, -68.0)] {
        layout.feature("natural=tree", DVec2::new(x, y));
    }
    for (x, y) in [(30.0, -50.0), (42.0, -50.0), (36.0, -62.0)] {
        layout.feature("bench", DVec2::new(x, y));
    }
    layout.zone(
        rect((0.0, -150.0), (560.0, 90.0), 0.0),
        &[(BuildingKind::Terrace, 5.0), (BuildingKind::Shop, 1.5)],
        (2, 3),
        0.03,
    );
    layout.zone(
        rect((0.0, 0.0), (3000.0, 3000.0), 0.0),
        &[(BuildingKind::Terrace, 8.0), (BuildingKind::Shop, 0.4)],
        (1, 3),
        0.05,
    );
}
