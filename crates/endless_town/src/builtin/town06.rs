//! Town06: long roads of many lanes: a motorway with ramps, and a boulevard where left turns go past the junction and
//! back through the median (Michigan lefts).

use super::plan::Plan;
use super::shape::{points, rect, smooth};
use crate::character::Kind;
use crate::imported::Look;
use endless_road::RoadMap;
use glam::DVec2;

/// The boulevard's carriageways lie this far from its middle, the motorway's from its own, metres.
const BOULEVARD_M: f64 = 15.0;
const MOTORWAY_M: f64 = 10.5;
const MOTORWAY_Y: f64 = 190.0;
/// From a junction to the way back through the median, metres.
const BACK_M: f64 = 95.0;
const ENDS_M: f64 = 500.0;
const MOTORWAY_ENDS_M: f64 = 600.0;
/// From an arterial to where its ramps join and leave the motorway, metres.
const RAMP_M: f64 = 200.0;
const ARTERIALS: [f64; 3] = [-260.0, 30.0, 300.0];

pub(super) fn make() -> (RoadMap, Look) {
    let mut plan = Plan::of([42.5, -83.1]);
    motorway(&mut plan);
    boulevard(&mut plan);
    land(&mut plan);
    let look = Look {
        summary: "Long roads of many lanes: a motorway with ramps, a boulevard with turns through its median."
            .to_owned(),
        lamp_color: [0.96, 1.0, 0.94],
        lamp_cd: 7500.0,
        conifers: 0.12,
        ..Look::default()
    };
    plan.build(None, look)
}

/// Two carriageways of four lanes, with a fifth from every ramp that joins to the next that leaves.
fn motorway(plan: &mut Plan) {
    let carriageway = |lanes: u32| format!("motorway oneway=yes lanes={lanes} placement=right_of:2 maxspeed=100");
    let changes: [f64; 6] = {
        let [first, _, last] = ARTERIALS;
        [-MOTORWAY_ENDS_M, first - RAMP_M, first + RAMP_M, last - RAMP_M, last + RAMP_M, MOTORWAY_ENDS_M]
    };
    for (side, y) in [(1.0, MOTORWAY_Y - MOTORWAY_M), (-1.0, MOTORWAY_Y + MOTORWAY_M)] {
        for (k, part) in changes.windows(2).enumerate() {
            let over: Vec<(DVec2, f64)> = ARTERIALS
                .iter()
                .filter(|&&x| (part[0]..part[1]).contains(&x))
                .map(|&x| (DVec2::new(x, y), 20.0))
                .collect();
            let (from, to) = if side > 0.0 { (part[0], part[1]) } else { (part[1], part[0]) };
            let words = carriageway(if k % 2 == 0 { 5 } else { 4 });
            plan.road_with_bridges(&words, &points(&[(from, y), (to, y)]), &over);
        }
    }
    let ramp = "motorway_link oneway=yes lanes=1 maxspeed=60";
    for x in [ARTERIALS[0], ARTERIALS[2]] {
        // Seen in the direction of travel: off before the arterial, on behind it.
        for side in [1.0, -1.0] {
            let y = MOTORWAY_Y - side * MOTORWAY_M;
            let terminal = DVec2::new(x, MOTORWAY_Y - side * 62.0);
            let at = |along: f64, out: f64| (x + side * along, y - side * out);
            let end = (terminal.x, terminal.y);
            let far = |along: f64| (x + side * along, terminal.y + side * 4.0);
            plan.road(
                ramp,
                &points(&[at(-RAMP_M, 0.0), at(40.0 - RAMP_M, 13.9), at(90.0 - RAMP_M, 23.5), far(-50.0), end]),
            );
            plan.road(
                ramp,
                &points(&[end, far(50.0), at(RAMP_M - 90.0, 23.5), at(RAMP_M - 40.0, 13.9), at(RAMP_M, 0.0)]),
            );
            plan.lights(terminal);
        }
    }
}

fn boulevard(plan: &mut Plan) {
    let words = "primary oneway=yes lanes=4 sidewalk=right maxspeed=75";
    let arterial = "secondary lanes=4 sidewalk=both maxspeed=60";
    let street = "tertiary sidewalk=both maxspeed=50";
    let east = plan.road(words, &points(&[(-ENDS_M, -BOULEVARD_M), (ENDS_M, -BOULEVARD_M)]));
    let west = plan.road(words, &points(&[(ENDS_M, BOULEVARD_M), (-ENDS_M, BOULEVARD_M)]));
    for x in ARTERIALS {
        let (south, north) = (DVec2::new(x, -BOULEVARD_M), DVec2::new(x, BOULEVARD_M));
        plan.road(arterial, &[DVec2::new(x, -190.0), south]);
        let across = plan.road(arterial, &[south, north]);
        plan.road(arterial, &[north, DVec2::new(x, 300.0)]);
        plan.lights(south);
        plan.lights(north);
        // Lefts begin or end on the piece through the median; rights do not touch it.
        plan.no_left(east, south, across);
        plan.no_left(west, north, across);
        plan.no_left(across, south, east);
        plan.no_left(across, north, west);
        // Past the junction, and back through the median.
        for (side, at) in [(1.0, x + BACK_M), (-1.0, x - BACK_M)] {
            let y = side * BOULEVARD_M;
            plan.road(
                "primary_link oneway=yes lanes=1 maxspeed=20",
                &smooth(&[
                    (at - side * 22.0, -y),
                    (at - side * 8.0, -y + side * 3.5),
                    (at, -side * 5.0),
                    (at, side * 5.0),
                    (at - side * 8.0, y - side * 3.5),
                    (at - side * 22.0, y),
                ]),
            );
        }
    }
    plan.road(street, &points(&[(ARTERIALS[0], -190.0), (ARTERIALS[1], -190.0), (ARTERIALS[2], -190.0)]));
    plan.road(street, &points(&[(ARTERIALS[0], 300.0), (ARTERIALS[1], 300.0), (ARTERIALS[2], 300.0)]));
    plan.road(
        street,
        &points(&[
            (ARTERIALS[0], -100.0),
            (-115.0, -104.0),
            (ARTERIALS[1], -100.0),
            (165.0, -96.0),
            (ARTERIALS[2], -100.0),
        ]),
    );
    plan.road(street, &points(&[(ARTERIALS[0], 92.0), (ARTERIALS[1], 92.0), (ARTERIALS[2], 92.0)]));
}

fn land(plan: &mut Plan) {
    for (x, y) in [(-180.0, -56.0), (-60.0, -58.0), (110.0, -56.0), (230.0, -56.0), (-330.0, -60.0), (380.0, -60.0)] {
        plan.land("amenity=parking", &rect((x, y), (64.0, 40.0), 0.0));
    }
    plan.tree_row(&points(&[(-480.0, 0.0), (-380.0, 0.0)]));
    for x in [-220.0, -110.0, 70.0, 180.0, 260.0, 340.0] {
        plan.tree_row(&points(&[(x - 15.0, 0.0), (x + 17.0, 0.0)]));
    }
    plan.zone(
        rect((0.0, 60.0), (1100.0, 90.0), 0.0),
        &[(Kind::Shop, 3.0), (Kind::Office, 1.5), (Kind::Flats, 1.0)],
        (2, 4),
        0.06,
    );
    plan.zone(
        rect((0.0, -140.0), (1100.0, 200.0), 0.0),
        &[(Kind::Hall, 2.0), (Kind::Shop, 2.0), (Kind::Flats, 1.2)],
        (2, 4),
        0.08,
    );
    plan.zone(rect((0.0, 0.0), (3000.0, 3000.0), 0.0), &[(Kind::Hall, 2.0), (Kind::Shop, 1.0)], (1, 2), 0.2);
}
