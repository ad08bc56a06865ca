//! Crosswalks.

use super::outline::{corners, rectangle};
use super::sampled::SampledDocument;
use crate::{Crossing, ImportNote, Lane};
use glam::{DVec2, DVec3};

/// More crossings than this are no map of a town.
const MOST: usize = 5000;
/// Narrower and shorter ones are noise, metres.
const LEAST_M: f64 = 0.8;

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

/// The direction of the lane that passes nearest to a place.
fn nearest_lane(lanes: &[Lane], place: DVec3) -> Option<DVec2> {
    let mut best = (30.0 * 30.0, None);
    for lane in lanes {
        for pair in lane.centerline.points().windows(2) {
            let (a, along) = (pair[0], pair[1] - pair[0]);
            let t = ((place - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
            let distance = (place - (a + along * t)).length_squared();
            if distance < best.0 {
                best = (distance, Some(along.truncate().normalize_or_zero()));
            }
        }
    }
    best.1
}
