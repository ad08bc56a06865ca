//! Paint: lines between lanes, stop lines, crossings.

use super::class::RoadClass;
use super::country::CountryRules;
use super::crossing::CROSSING_M;
use super::curve::line_through;
use super::graph::StreetSegmentEnd;
use super::lane::inside;
use super::movement::Movement;
use super::plan::{FootwayCrossing, Street, StreetPlan};
use super::section::LaneUse;
use crate::{Lane, MarkingColor, RoadMap, RoadMarking, TrafficControl, Turn};

const LINE_M: f64 = 0.12;
const STOP_LINE_M: f64 = 0.4;
/// A bar and the gap after it, metres.
const BAR_M: f64 = 0.5;
const DASH: [f64; 2] = [3.0, 5.0];
/// Lines between lanes are unbroken this far before a stop line, metres.
const SOLID_M: f64 = 18.0;

/// Paints all streets.
pub(super) fn streets(plan: &StreetPlan, country: &CountryRules, map: &mut RoadMap) {
    let hidden = inside(plan);
    for (street, _) in plan.streets.iter().zip(hidden).filter(|(_, hidden)| !hidden) {
        if !street.section.unpaved {
            lines(street, country, map);
            stop_lines(street, map);
        }
        for crossing in street.crossings.iter().filter(|c| c.painted) {
            bars(street, crossing, country, map);
        }
    }
}

/// A line along a street.
fn along(street: &Street, t: f64, from: f64, to: f64, dash: Option<[f64; 2]>, color: MarkingColor, map: &mut RoadMap) {
    if to - from < 1.0 {
        return;
    }
    let points: Vec<_> = street.stations(from, to, 4.0).into_iter().map(|s| street.point(s, t)).collect();
    map.markings.push(RoadMarking { line: line_through(points), width_m: LINE_M, dash, color });
}

/// The free pieces of a street between crossings.
fn pieces(street: &Street) -> Vec<(f64, f64)> {
    let (mut from, to) = (street.stops[0], street.length() - street.stops[1]);
    let mut pieces = Vec::new();
    for crossing in street.crossings.iter().filter(|c| c.end.is_none()) {
        pieces.push((from, crossing.s - 0.5 * CROSSING_M - 0.8));
        from = crossing.s + 0.5 * CROSSING_M + 0.8;
    }
    pieces.push((from, to));
    pieces
}

fn lines(street: &Street, country: &CountryRules, map: &mut RoadMap) {
    let quiet = street.class <= RoadClass::Residential || street.class == RoadClass::Service;
    let bands = &street.section.bands;
    let yellow = if country.yellow_centre { MarkingColor::Yellow } else { MarkingColor::White };
    let many = bands.iter().filter(|b| matches!(b.what, LaneUse::Lane { .. })).count() > 2;
    for (from, to) in pieces(street) {
        for (i, pair) in bands.windows(2).enumerate() {
            let t = street.section.edges(i)[1];
            match (pair[0].what, pair[1].what) {
                (LaneUse::Lane { forward: a, .. }, LaneUse::Lane { forward: b, .. }) if a != b => {
                    if quiet && !many {
                        continue;
                    }
                    if many {
                        for side in [-0.12, 0.12] {
                            along(street, t + side, from, to, None, yellow, map);
                        }
                    } else {
                        along(street, t, from, to, Some(DASH), yellow, map);
                    }
                }
                (LaneUse::Lane { forward, .. }, LaneUse::Lane { .. }) => {
                    // Unbroken before the stop line.
                    let end = usize::from(forward);
                    let solid = if matches!(street.control[end], TrafficControl::Free) {
                        0.0
                    } else {
                        SOLID_M.min(0.4 * (to - from))
                    };
                    let (a, b) = if forward { (from, to - solid) } else { (from + solid, to) };
                    along(street, t, a, b, Some(DASH), MarkingColor::White, map);
                    if solid > 1.0 {
                        let (a, b) = if forward { (to - solid, to) } else { (from, from + solid) };
                        along(street, t, a, b, None, MarkingColor::White, map);
                    }
                }
                (LaneUse::Bike, _) | (_, LaneUse::Bike) => {
                    along(street, t, from, to, Some([1.0, 1.0]), MarkingColor::White, map);
                }
                (LaneUse::Shoulder, LaneUse::Lane { .. }) | (LaneUse::Lane { .. }, LaneUse::Shoulder) => {
                    along(street, t, from, to, None, MarkingColor::White, map);
                }
                _ => {}
            }
        }
        let rural = street.section.sidewalks == [0.0; 2] && street.class >= RoadClass::Tertiary && !street.link;
        if rural && !matches!(bands.first().map(|b| b.what), Some(LaneUse::Shoulder)) {
            for (t, inwards) in [(street.section.kerbs[0], -0.2), (street.section.kerbs[1], 0.2)] {
                along(street, t + inwards, from, to, None, MarkingColor::White, map);
            }
        }
    }
}

/// Dashes between lanes that lead side by side through a place where nothing crosses: merges, rings, changes of width.
pub(super) fn through(plan: &StreetPlan, intersection: usize, ways: &[(Movement, &Lane)], map: &mut RoadMap) {
    let k = &plan.intersections[intersection];
    let crossed = k.arms.len() > 2 && !k.arms.iter().all(|&arm| plan.street(arm).oneway());
    for &(m, lane) in ways {
        let ring = plan.street(m.from).roundabout && plan.street(m.to).roundabout;
        if k.signals || m.turn != Turn::Straight || (crossed && !ring) {
            continue;
        }
        let next = |arm: StreetSegmentEnd, band: usize, lanes: &[usize]| {
            let place = lanes.iter().position(|&l| l == band)?;
            Some((arm, *lanes.get(place + 1)?))
        };
        let (ins, outs) = (plan.lanes_in(m.from), plan.lanes_out(m.to));
        let beside = next(m.from, m.lane_in, &ins).zip(next(m.to, m.lane_out, &outs));
        let Some(((from, lane_in), (to, lane_out))) = beside else { continue };
        let is_beside =
            |o: &&(Movement, &Lane)| (o.0.from, o.0.lane_in, o.0.to, o.0.lane_out) == (from, lane_in, to, lane_out);
        let Some((_, right)) = ways.iter().find(is_beside) else { continue };
        let (a, b) = (&lane.centerline, &right.centerline);
        let n = (a.length() / 4.0).ceil().max(2.0) as usize;
        let points = (0..=n).map(|i| {
            let share = i as f64 / n as f64;
            a.position(a.length() * share).midpoint(b.position(b.length() * share))
        });
        map.markings.push(RoadMarking {
            line: line_through(points.collect()),
            width_m: LINE_M,
            dash: Some(DASH),
            color: MarkingColor::White,
        });
    }
}

fn stop_lines(street: &Street, map: &mut RoadMap) {
    for end in 0..2 {
        let forward = end == 1;
        let lanes = street.section.lanes(forward);
        let dash = match street.control[end] {
            TrafficControl::Free => continue,
            TrafficControl::Yield => Some([0.5, 0.35]),
            TrafficControl::Stop | TrafficControl::Signal(_) => None,
        };
        let (Some(&first), Some(&last)) = (lanes.first(), lanes.last()) else { continue };
        let s = if forward { street.length() - street.stops[1] - 0.25 } else { street.stops[0] + 0.25 };
        let (a, b) = (street.section.edges(first), street.section.edges(last));
        let (left, right) = (a[0].max(b[0]) - 0.15, a[1].min(b[1]) + 0.15);
        if left - right < 0.5 {
            continue;
        }
        let line = line_through(vec![street.point(s, left), street.point(s, right)]);
        map.markings.push(RoadMarking { line, width_m: STOP_LINE_M, dash, color: MarkingColor::White });
    }
}

fn bars(street: &Street, crossing: &FootwayCrossing, country: &CountryRules, map: &mut RoadMap) {
    let [left, right] = street.section.kerbs;
    let (from, to) = (crossing.s - 0.5 * CROSSING_M, crossing.s + 0.5 * CROSSING_M);
    let mut paint = |a, b, width_m| {
        map.markings.push(RoadMarking {
            line: line_through(vec![a, b]),
            width_m,
            dash: None,
            color: MarkingColor::White,
        });
    };
    if crossing.signal.is_some() && !country.bars_at_signals {
        for s in [from, to] {
            paint(street.point(s, left - 0.2), street.point(s, right + 0.2), LINE_M);
        }
        return;
    }
    let count = ((left - right - 0.4) / (2.0 * BAR_M)).floor().max(1.0) as usize;
    let used = (2 * count - 1) as f64 * BAR_M;
    let first = 0.5 * (left + right) + 0.5 * used - 0.5 * BAR_M;
    for k in 0..count {
        let t = first - 2.0 * BAR_M * k as f64;
        paint(street.point(from, t), street.point(to, t), BAR_M);
    }
}
