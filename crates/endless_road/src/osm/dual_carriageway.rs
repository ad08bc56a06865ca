//! Dual carriageways: the median between the two carriageways of one road, along which there are no sidewalks.

use super::class::RoadClass;
use super::plan::{Street, StreetPlan};
use glam::DVec2;

/// Distance between samples, metres.
const SAMPLE_M: f64 = 8.0;
/// Widest median of any road, metres.
const WIDEST_M: f64 = 26.0;

/// Widest median that is usual for a class, metres: quiet streets on two sides of a square are no twins.
pub(super) fn widest_m(class: RoadClass) -> f64 {
    match class {
        RoadClass::Service | RoadClass::Living | RoadClass::Residential | RoadClass::Unclassified => 7.0,
        RoadClass::Tertiary => 14.0,
        _ => WIDEST_M,
    }
}

/// Finds the twins of all one-way roads, takes the sidewalks between them away and notes the median's half width.
pub(super) fn find(plan: &mut StreetPlan) {
    let boxes: Vec<[DVec2; 2]> = plan.streets.iter().map(bounds).collect();
    for i in 0..plan.streets.len() {
        let street = &plan.streets[i];
        if !street.oneway() || street.roundabout || street.link || street.class < RoadClass::Residential {
            continue;
        }
        let near: Vec<&Street> = (0..plan.streets.len())
            .filter(|&j| {
                let other = &plan.streets[j];
                j != i
                    && other.oneway()
                    && !other.roundabout
                    && other.class == street.class
                    && overlap(&boxes[i], &boxes[j])
            })
            .map(|j| &plan.streets[j])
            .collect();
        let n = (street.length() / SAMPLE_M).ceil().max(2.0) as usize;
        let gaps: Vec<(f64, Option<f64>)> = (0..=n)
            .map(|k| {
                let s = street.length() * k as f64 / n as f64;
                (s, near.iter().filter_map(|other| gap(street, s, other)).reduce(f64::min))
            })
            .collect();
        let hits = gaps.iter().filter(|(_, gap)| gap.is_some()).count();
        if hits * 10 < gaps.len() * 6 {
            continue;
        }
        let street = &mut plan.streets[i];
        street.section.sidewalks[0] = 0.0;
        street.median = gaps.into_iter().map(|(s, gap)| (s, gap.map_or(0.0, |g| 0.5 * g))).collect();
    }
}

fn bounds(street: &Street) -> [DVec2; 2] {
    let points = street.line.points().iter().map(|p| p.truncate());
    let (low, high) = points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
    [low - WIDEST_M, high + WIDEST_M]
}

fn overlap(a: &[DVec2; 2], b: &[DVec2; 2]) -> bool {
    a[0].cmple(b[1]).all() && b[0].cmple(a[1]).all()
}

/// Kerb to kerb from a place on a street to another that runs the other way on its left.
fn gap(street: &Street, s: f64, other: &Street) -> Option<f64> {
    let here = street.point(s, 0.0);
    let (at, t) = other.line.project(here.truncate());
    let there = other.line.at(at).position;
    let ahead = street.direction(s);
    let across = (there - here).truncate();
    let opposite = other.direction(at).dot(ahead) < -0.85;
    // At its left, and beside it rather than ahead.
    let beside = ahead.perp_dot(across) > 0.9 * across.length();
    let gap = t.abs() - street.section.kerbs[0] - other.section.kerbs[0];
    (opposite && beside && (there.z - here.z).abs() < 2.0 && (-1.0..widest_m(street.class)).contains(&gap))
        .then_some(gap.max(0.0))
}

impl Street {
    /// Half the width of the median on the left at a place, metres.
    pub(super) fn half_median(&self, s: f64) -> f64 {
        let i = self.median.partition_point(|(at, _)| *at <= s).clamp(1, self.median.len().max(1)) - 1;
        match (self.median.get(i), self.median.get(i + 1)) {
            (Some(a), Some(b)) if a.1 > 0.0 && b.1 > 0.0 => a.1 + (b.1 - a.1) * ((s - a.0) / (b.0 - a.0).max(1e-9)),
            _ => 0.0,
        }
    }
}
