//! Crosswalks.

use super::outline::{corners, rectangle};
use super::sampled::SampledDocument;
use crate::{Crossing, ImportNote, Lane};
use endless_world::math::segment::share_along;
use glam::{DVec2, DVec3};

/// More crossings than this are no map of a town.
const MOST: usize = 5000;
/// Narrower and shorter ones are noise, metres.
const LEAST_M: f64 = 0.8;
/// Where a crosswalk is drawn shorter than the road is wide, people would wait on the road: it reaches so far beside the lane on
/// which it ends, metres, if that is no further away than this. People wait so far from its sides.
const BESIDE_LANE_M: f64 = 0.2;
const FROM_SIDES_M: f64 = 0.45;
const SHORT_BY_M: f64 = 3.0;
/// Lanes so much higher or lower are on another level, metres.
const STOREY_M: f64 = 2.0;

/// The crossings that cut lanes.
pub(super) fn crossings(sampled: &SampledDocument<'_>, lanes: &[Lane], notes: &mut Vec<ImportNote>) -> Vec<Crossing> {
    let mut crossings = Vec::new();
    for shape in &sampled.roads {
        for object in shape.road.objects.iter().filter(|object| object.kind == "crosswalk") {
            let corners = corners(shape, object);
            let found = rectangle(&corners).and_then(|rectangle| {
                let mut crossing = Crossing { ends: [DVec3::ZERO; 2], width_m: 0.0, signal: None, cuts: Vec::new() };
                let height = corners.iter().map(|p| p.z).sum::<f64>() / corners.len() as f64;
                let middle = rectangle.middle.extend(height);
                let lane = nearest_lane(lanes, middle)?;
                // People walk across the lanes, which is mostly along the longer side.
                let across = |side: DVec2| side.normalize_or_zero().perp_dot(lane).abs();
                let long_way = across(rectangle.long) > 0.5 || across(rectangle.short) < 0.5;
                let (way, wide) =
                    if long_way { (rectangle.long, rectangle.short) } else { (rectangle.short, rectangle.long) };
                crossing.ends = [middle - way.extend(0.0), middle + way.extend(0.0)];
                crossing.width_m = 2.0 * wide.length();
                crossing.ends = reach_kerbs(&crossing, lanes);
                (crossing.width_m > LEAST_M && 2.0 * way.length() > LEAST_M).then_some(crossing)
            });
            let place = || format!("line {}: crosswalk {}", object.line, object.id);
            match found {
                Some(crossing) if lanes.iter().any(|lane| crate::cut::cut_range(&crossing, lane).is_some()) => {
                    if crossings.len() < MOST {
                        crossings.push(crossing);
                    }
                }
                _ => notes.push(ImportNote { place: place(), text: "crosses no lane and was left out".to_owned() }),
            }
        }
    }
    crossings
}

/// The ends of a crosswalk, those that lie on a lane moved outwards to its edge.
fn reach_kerbs(crossing: &Crossing, lanes: &[Lane]) -> [DVec3; 2] {
    const STEP_M: f64 = 0.1;
    let [from, to] = crossing.ends;
    let ahead = (to - from).truncate().normalize_or_zero();
    let aside = ahead.perp() * (0.5 * crossing.width_m - FROM_SIDES_M).max(0.0);
    let reach = |end: DVec3, outwards: DVec2| {
        let near = |lane: &&Lane| {
            let away = lane.centerline.points()[0].distance(end);
            away < lane.centerline.length() + lane.width_m + crossing.width_m + SHORT_BY_M
        };
        let near: Vec<&Lane> = lanes.iter().filter(near).collect();
        let is_on = |lane: &Lane, place: DVec2, beside_m: f64| {
            let (s, t) = lane.centerline.project(place);
            t.abs() < 0.5 * lane.width_m + beside_m && (lane.centerline.position(s).z - end.z).abs() < STOREY_M
        };
        let is_on_lane = |place: DVec2, beside_m: f64| {
            [place - aside, place, place + aside].iter().any(|&at| near.iter().any(|lane| is_on(lane, at, beside_m)))
        };
        if !is_on_lane(end.truncate(), 0.0) {
            return end;
        }
        let steps = (SHORT_BY_M / STEP_M) as u32;
        let moves = (1..=steps).map(|step| outwards * (STEP_M * f64::from(step)));
        let free = moves.into_iter().find(|&move_m| !is_on_lane(end.truncate() + move_m, BESIDE_LANE_M));
        end + free.unwrap_or_default().extend(0.0)
    };
    [reach(from, -ahead), reach(to, ahead)]
}

/// The direction of the lane that passes nearest to a place.
fn nearest_lane(lanes: &[Lane], place: DVec3) -> Option<DVec2> {
    let mut best = (30.0 * 30.0, None);
    for lane in lanes {
        for pair in lane.centerline.points().windows(2) {
            let (a, along) = (pair[0], pair[1] - pair[0]);
            let t = share_along(place, a, pair[1]);
            let distance = (place - (a + along * t)).length_squared();
            if distance < best.0 {
                best = (distance, Some(along.truncate().normalize_or_zero()));
            }
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{LaneId, Polyline};

    #[test]
    fn crosswalks_that_end_on_a_lane_reach_its_edge() {
        let lane = |k: u32, y: f64, z: f64| {
            Lane::new(LaneId(k), Polyline::new([-50.0, 50.0].map(|x| DVec3::new(x, y, z))), 3.5, 13.9)
        };
        let lanes = [lane(0, -1.75, 0.0), lane(1, 1.75, 0.0), lane(2, 5.25, 8.0)];
        let reached = |from: f64, to: f64| {
            let ends = [from, to].map(|y| DVec3::new(0.0, y, 0.0));
            let crossing = Crossing { ends, width_m: 3.0, signal: None, cuts: Vec::new() };
            reach_kerbs(&crossing, &lanes).map(|end| (end.y * 10.0).round() / 10.0)
        };
        assert_eq!(reached(-2.7, 3.0), [-3.7, 3.7], "both are drawn too short, and the bridge above is another road");
        assert_eq!(reached(-3.5, 4.2), [-3.5, 4.2]);
        // Where the next lane follows, the edge is too far away: it is drawn in pieces.
        assert_eq!(reached(-3.5, -1.0), [-3.5, -1.0]);
    }
}
