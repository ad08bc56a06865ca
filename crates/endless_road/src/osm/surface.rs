//! What lies on the ground: bands of streets, sidewalks, the asphalt of junctions and the corners around them.

use super::curve::{line_through, unfolded};
use super::import_context::ImportContext;
use super::lane::inside;
use super::plan::{Street, StreetPlan};
use super::section::{KERB_M, LaneUse};
use super::segment_index::SegmentIndex;
use super::street_segment::StreetSegment;
use crate::{LaneSurface, LaneType, RoadMap};
use glam::{DVec2, DVec3};

/// Height of sidewalks above the road, metres.
pub(super) const KERB_HEIGHT_M: f64 = 0.13;
const STEP_M: f64 = 4.0;
/// Width of the path around a corner where no sidewalk arrives, metres.
pub(super) const STUB_M: f64 = 1.6;

/// Adds the strips of all streets.
pub(super) fn streets(plan: &StreetPlan, map: &mut RoadMap) {
    let hidden = inside(plan);
    for (street, hidden) in plan.streets.iter().zip(hidden) {
        if !hidden {
            street_strips(street, map);
        }
    }
}

fn street_strips(street: &Street, map: &mut RoadMap) {
    let (from, to) = (street.cuts[0], street.length() - street.cuts[1]);
    let stations = street.stations(from, to, STEP_M);
    let section = &street.section;
    median(street, &stations, map);
    let mut add = lane_surfaces(street, &stations, map);
    for (i, band) in section.bands.iter().enumerate() {
        let (kind, reversed) = match band.what {
            LaneUse::Lane { forward, .. } => (LaneType::Driving, !forward),
            LaneUse::Bike => (LaneType::Biking, false),
            LaneUse::Parking => (LaneType::Parking, false),
            LaneUse::Shoulder => (LaneType::Shoulder, false),
        };
        add(kind, section.edges(i), 0.0, reversed);
    }
    for side in 0..2 {
        if section.sidewalks[side] <= 0.0 {
            continue;
        }
        let kerb = section.kerbs[side];
        let sign = if side == 0 { 1.0 } else { -1.0 };
        let (stone, back) = (kerb + sign * KERB_M, section.back(side));
        let pair = |a: f64, b: f64| if side == 0 { [b, a] } else { [a, b] };
        add(LaneType::Curb, pair(kerb, stone), KERB_HEIGHT_M, side == 0);
        add(LaneType::Sidewalk, pair(stone, back), KERB_HEIGHT_M, side == 0);
    }
}

/// What adds strips along a street: kind, left and right edge, height above the road, and whether they run against it.
pub(super) fn lane_surfaces<'a>(
    street: &'a Street,
    stations: &'a [f64],
    map: &'a mut RoadMap,
) -> impl FnMut(LaneType, [f64; 2], f64, bool) + 'a {
    move |kind, edges, height, reversed| {
        // One strip a level, so that bridges are told from the ground.
        let mut start = 0;
        while start + 1 < stations.len() {
            let bridge = street.level(0.5 * (stations[start] + stations[start + 1])).bridge;
            let mut end = start + 1;
            while end + 1 < stations.len() && street.level(0.5 * (stations[end] + stations[end + 1])).bridge == bridge {
                end += 1;
            }
            let along: Vec<DVec3> = stations[start..=end].iter().map(|&s| street.point(s, 0.0)).collect();
            let line = |t: f64| -> Vec<DVec3> {
                let raw: Vec<DVec3> =
                    stations[start..=end].iter().map(|&s| street.point(s, t) + DVec3::Z * height).collect();
                unfolded(&raw, &along)
            };
            let (mut left, mut right) = (line(edges[0]), line(edges[1]));
            if reversed {
                left.reverse();
                right.reverse();
                std::mem::swap(&mut left, &mut right);
            }
            map.lane_surfaces.push(LaneSurface {
                kind,
                left,
                right,
                in_junction: false,
                unpaved: street.section.unpaved,
                bridge,
            });
            start = end;
        }
    }
}

/// The half of the median that lies beside this carriageway.
fn median(street: &Street, stations: &[f64], map: &mut RoadMap) {
    let kerb = street.section.kerbs[0];
    let wide = |s: f64| street.half_median(s) > 0.3;
    let mut start = 0;
    while start < stations.len() {
        let end = (start..stations.len()).find(|&k| !wide(stations[k])).unwrap_or(stations.len());
        if end - start >= 2 {
            let part = &stations[start..end];
            let along: Vec<DVec3> = part.iter().map(|&s| street.point(s, 0.0)).collect();
            let line = |width: &dyn Fn(f64) -> f64| -> Vec<DVec3> {
                let raw: Vec<DVec3> =
                    part.iter().map(|&s| street.point(s, kerb + width(s)) + DVec3::Z * KERB_HEIGHT_M).collect();
                unfolded(&raw, &along)
            };
            let (face, stone, middle) = (line(&|_| 0.0), line(&|_| KERB_M), line(&|s| street.half_median(s)));
            let bridge = street.level(part[0]).bridge;
            let mut add = |kind, left: &[DVec3], right: &[DVec3]| {
                let (left, right) = (left.to_vec(), right.to_vec());
                map.lane_surfaces.push(LaneSurface { kind, left, right, in_junction: false, unpaved: false, bridge });
            };
            add(LaneType::Curb, &stone, &face);
            add(LaneType::Median, &middle, &stone);
        }
        start = end + 1;
    }
}

/// Strips of driveways and aisles, from behind the sidewalk on.
pub(super) fn yards(plan: &StreetPlan, context: &ImportContext<'_>, yards: &[StreetSegment], map: &mut RoadMap) {
    let hidden = inside(plan);
    let near =
        SegmentIndex::new(plan.streets.iter().enumerate().filter(|(i, _)| !hidden[*i]).map(|(i, s)| (i, &s.line)));
    let on_street = |p: DVec2| {
        near.at(p).iter().any(|&i| {
            let street = &plan.streets[i];
            let (_, t) = street.line.project(p);
            t.abs() < street.section.back(usize::from(t < 0.0)).abs() - 0.1
        })
    };
    for yard in yards {
        let bridge = yard.levels.iter().any(|l| l.bridge);
        let mut runs: Vec<Vec<DVec3>> = vec![Vec::new()];
        for pair in yard.vertices.windows(2) {
            let n = (pair[0].at.distance(pair[1].at) / 0.7).ceil().clamp(1.0, 5000.0) as usize;
            for k in 0..=n {
                let p = pair[0].at.lerp(pair[1].at, k as f64 / n as f64);
                if !on_street(p) {
                    runs.last_mut().expect("never empty").push(p.extend(context.ground(p)));
                } else if runs[runs.len() - 1].len() > 1 {
                    runs.push(Vec::new());
                } else {
                    runs.last_mut().expect("never empty").clear();
                }
            }
        }
        for points in runs.into_iter().filter(|r| r.len() > 1 && r[0].distance(r[r.len() - 1]) > 0.5) {
            let (left, right) = ribbon(&points, yard.section.kerbs[0], yard.section.kerbs[1], 4.0);
            let unpaved = yard.section.unpaved;
            map.lane_surfaces.push(LaneSurface {
                kind: LaneType::Driving,
                left,
                right,
                in_junction: true,
                unpaved,
                bridge,
            });
        }
    }
}

/// The borders of a ribbon along a chain of points with rounded bends.
pub(super) fn ribbon(points: &[DVec3], left: f64, right: f64, radius_m: f64) -> (Vec<DVec3>, Vec<DVec3>) {
    let line = line_through(super::curve::rounded(&super::curve::simplified(points, 0.1), radius_m));
    let along = line.points();
    let border = |t: f64| {
        let n = along.len();
        let raw: Vec<DVec3> = (0..n)
            .map(|i| {
                let before = (along[i] - along[i.saturating_sub(1)]).truncate().normalize_or_zero();
                let after = (along[(i + 1).min(n - 1)] - along[i]).truncate().normalize_or_zero();
                let normal = (before + after).perp().normalize_or_zero();
                along[i] + (normal * t).extend(0.0)
            })
            .collect();
        unfolded(&raw, along)
    };
    (border(left), border(right))
}
