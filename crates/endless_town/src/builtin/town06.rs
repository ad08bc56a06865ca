//! Town06: long roads of many lanes: a motorway with ramps, and a boulevard where left turns go past the junction and
//! back through the median (Michigan lefts). At both ends of the town the one becomes the other.

use super::layout::TownLayout;
use super::layout_geometry::{arc, points, rect};
use crate::building::BuildingKind;
use crate::dressing::TownPreset;
use endless_road::RoadMap;
use glam::DVec2;

/// The boulevard's carriageways lie this far from its middle, the motorway's from its own, metres.
const BOULEVARD_M: f64 = 15.0;
const MOTORWAY_M: f64 = 10.5;
const MOTORWAY_Y: f64 = 190.0;
/// From a junction to the way back through the median, metres.
const BACK_M: f64 = 95.0;
/// Here both roads bend towards one another.
const ENDS_M: f64 = 515.0;
/// From an arterial to where its ramps join and leave the motorway, metres.
const RAMP_M: f64 = 200.0;
/// From the motorway's middle to where its ramps end on an arterial, metres.
const TERMINAL_M: f64 = 62.0;
const ARTERIALS: [f64; 3] = [-260.0, 30.0, 300.0];
/// The street south of the boulevard; beyond it, and beyond the northern ramps, the outer arterials have two lanes.
const SOUTH_Y: f64 = -100.0;
/// The street between the boulevard and the southern ramps: a truck has room before the lights on both its sides.
const NORTH_Y: f64 = 68.0;

pub(super) fn make() -> (RoadMap, TownPreset) {
    let mut layout = TownLayout::of([42.5, -83.1]);
    motorway(&mut layout);
    boulevard(&mut layout);
    streets(&mut layout);
    land(&mut layout);
    let preset = TownPreset {
        summary: "Long roads of many lanes: a motorway with ramps, a boulevard with turns through its median."
            .to_owned(),
        lamp_color: [0.96, 1.0, 0.94],
        lamp_cd: 7500.0,
        conifers: 0.12,
        ..TownPreset::default()
    };
    layout.build(None, preset)
}

/// Two carriageways of four lanes, with a fifth from every ramp that joins to where it leaves again: at the next ramp, or
/// as the boulevard's lane for right turns.
fn motorway(layout: &mut TownLayout) {
    let [first, _, last] = ARTERIALS;
    for side in [1.0, -1.0] {
        let y = MOTORWAY_Y - side * MOTORWAY_M;
        // In the direction of travel: from where the boulevard ends, by the ramps, to where it begins.
        let mut ramps = [first - RAMP_M, first + RAMP_M, last - RAMP_M, last + RAMP_M];
        if side < 0.0 {
            ramps.reverse();
        }
        let [off, on, off_again, on_again] = ramps.map(|x| DVec2::new(x, y));
        let mut begin = bend(-side, y);
        begin.push(off);
        let mut end = vec![on_again];
        end.extend(bend(side, y));
        for (lanes, line) in
            [(4, begin), (4, vec![off, on]), (5, vec![on, off_again]), (4, vec![off_again, on_again]), (5, end)]
        {
            let words = format!("motorway oneway=yes lanes={lanes} placement=right_of:2 maxspeed=100");
            let inside = |x: f64| line.iter().any(|p| p.x < x) && line.iter().any(|p| p.x > x);
            let over: Vec<(DVec2, f64)> =
                ARTERIALS.iter().filter(|&&x| inside(x)).map(|&x| (DVec2::new(x, y), 20.0)).collect();
            layout.road_with_bridges(&words, &line, &over);
        }
    }
    let ramp = "motorway_link oneway=yes lanes=1 maxspeed=60";
    for x in [ARTERIALS[0], ARTERIALS[2]] {
        // Seen in the direction of travel: off before the arterial, on behind it.
        for side in [1.0, -1.0] {
            let y = MOTORWAY_Y - side * MOTORWAY_M;
            let terminal = DVec2::new(x, MOTORWAY_Y - side * TERMINAL_M);
            let at = |along: f64, out: f64| (x + side * along, y - side * out);
            let end = (terminal.x, terminal.y);
            let far = |along: f64| (x + side * along, terminal.y + side * 4.0);
            layout.road(
                ramp,
                &points(&[at(-RAMP_M, 0.0), at(40.0 - RAMP_M, 13.9), at(90.0 - RAMP_M, 23.5), far(-50.0), end]),
            );
            layout.road(
                ramp,
                &points(&[end, far(50.0), at(RAMP_M - 90.0, 23.5), at(RAMP_M - 40.0, 13.9), at(RAMP_M, 0.0)]),
            );
            layout.lights(terminal);
        }
    }
}

/// Half a circle at the eastern (1) or western (-1) end, in the direction of travel: from the boulevard's carriageway to
/// the motorway's at `y`, or from that to the boulevard's.
fn bend(out: f64, y: f64) -> Vec<DVec2> {
    // Each carriageway leads to the one of the other road on which one drives the other way.
    let eastbound = y < MOTORWAY_Y;
    let boulevard_y = if eastbound { BOULEVARD_M } else { -BOULEVARD_M };
    let (middle, radius) = (DVec2::new(out * ENDS_M, 0.5 * (y + boulevard_y)), 0.5 * (y - boulevard_y));
    let mut half = arc(middle, radius, 90.0, 90.0 - 180.0 * out);
    if eastbound != (out > 0.0) {
        half.reverse();
    }
    half
}

fn boulevard(layout: &mut TownLayout) {
    let words =
        |lanes: u32| format!("primary oneway=yes lanes={lanes} placement=right_of:2 sidewalk=right maxspeed=75");
    let (arterial, outer) = ("secondary lanes=4 sidewalk=both maxspeed=60", "tertiary sidewalk=both maxspeed=50");
    // From both ends to the first arterial a fifth lane turns right.
    let [first, _, last] = ARTERIALS;
    let carriageway = |layout: &mut TownLayout, side: f64, right_turn: f64, far: f64| {
        let at = |x: f64| DVec2::new(x, -side * BOULEVARD_M);
        let arrival = layout.road(&words(5), &[at(-side * ENDS_M), at(right_turn)]);
        let rest = layout.road(&words(4), &[at(right_turn), at(far)]);
        [arrival, rest]
    };
    let east = carriageway(layout, 1.0, first, ENDS_M);
    let west = carriageway(layout, -1.0, last, -ENDS_M);
    for x in ARTERIALS {
        let (south, north) = (DVec2::new(x, -BOULEVARD_M), DVec2::new(x, BOULEVARD_M));
        let north_end = MOTORWAY_Y + TERMINAL_M;
        let beyond = if x == ARTERIALS[1] { arterial } else { outer };
        layout.road(beyond, &points(&[(x, -190.0), (x, SOUTH_Y)]));
        layout.road(arterial, &[DVec2::new(x, SOUTH_Y), south]);
        let across = layout.road(arterial, &[south, north]);
        layout.road(arterial, &[north, DVec2::new(x, north_end)]);
        layout.road(beyond, &points(&[(x, north_end), (x, 300.0)]));
        layout.lights(south);
        layout.lights(north);
        // Lefts begin or end on the piece through the median; rights do not touch it.
        for (carriageway, at) in [(east, south), (west, north)] {
            for road in carriageway {
                layout.no_left(road, at, across);
                layout.no_left(across, at, road);
            }
        }
        // Past the junction, and back through the median.
        for (side, at) in [(1.0, x + BACK_M), (-1.0, x - BACK_M)] {
            let y = side * BOULEVARD_M;
            layout.road("tertiary_link oneway=yes lanes=1 maxspeed=20", &points(&[(at, -y), (at, y)]));
        }
    }
}

fn streets(layout: &mut TownLayout) {
    let street = "tertiary sidewalk=both maxspeed=50";
    let [first, second, third] = ARTERIALS;
    for y in [-190.0, NORTH_Y, 300.0] {
        layout.road(street, &points(&[(first, y), (second, y), (third, y)]));
    }
    layout.road(
        street,
        &points(&[
            (first, SOUTH_Y),
            (-115.0, SOUTH_Y - 4.0),
            (second, SOUTH_Y),
            (165.0, SOUTH_Y + 4.0),
            (third, SOUTH_Y),
        ]),
    );
}

fn land(layout: &mut TownLayout) {
    for (x, y) in [(-180.0, -56.0), (-60.0, -58.0), (110.0, -56.0), (230.0, -56.0), (-330.0, -60.0), (380.0, -60.0)] {
        layout.land("amenity=parking", &rect((x, y), (64.0, 40.0), 0.0));
    }
    layout.tree_row(&points(&[(-480.0, 0.0), (-380.0, 0.0)]));
    for x in [-220.0, -110.0, 70.0, 180.0, 260.0, 340.0] {
        layout.tree_row(&points(&[(x - 15.0, 0.0), (x + 17.0, 0.0)]));
    }
    layout.zone(
        rect((0.0, 60.0), (1100.0, 90.0), 0.0),
        &[(BuildingKind::Shop, 3.0), (BuildingKind::Office, 1.5), (BuildingKind::Flats, 1.0)],
        (2, 4),
        0.06,
    );
    layout.zone(
        rect((0.0, -140.0), (1100.0, 200.0), 0.0),
        &[(BuildingKind::Hall, 2.0), (BuildingKind::Shop, 2.0), (BuildingKind::Flats, 1.2)],
        (2, 4),
        0.08,
    );
    layout.zone(
        rect((0.0, 0.0), (3000.0, 3000.0), 0.0),
        &[(BuildingKind::Hall, 2.0), (BuildingKind::Shop, 1.0)],
        (1, 2),
        0.2,
    );
}
