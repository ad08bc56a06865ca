//! The land as roads shape it: level across them, and their banks into the land beside. What stands beside roads stands
//! on this.

use super::formation::Formation;
use super::plan::{Street, StreetPlan};
use crate::Terrain;
use glam::DVec2;

/// Between samples along roads, and of the formation, metres.
const SAMPLE_M: f64 = 2.0;
/// Beyond a road's edge the formation passes into the land over this width, metres.
const FADE_M: f64 = 9.0;
/// Side of bins, metres.
const BIN_M: f64 = 16.0;

/// A place on the middle of a road.
#[derive(Debug, Clone, Copy)]
struct ReliefSample {
    at: DVec2,
    z: f64,
    /// Half the road with its sidewalks, metres.
    half: f64,
}

/// The land as all roads of a plan shape it, on a natural height.
pub(super) fn formation(plan: &StreetPlan, natural: &dyn Fn(DVec2) -> f64) -> Formation {
    let samples: Vec<ReliefSample> = plan.streets.iter().flat_map(samples_of).collect();
    let widest = samples.iter().map(|s| s.half).fold(0.0, f64::max) + FADE_M;
    let (low, high) =
        samples.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), s| (l.min(s.at), h.max(s.at)));
    let (low, high) = if samples.is_empty() { (DVec2::ZERO, DVec2::ONE) } else { (low, high) };
    let (low, high) = (low - 2.0 * widest, high + 2.0 * widest);
    let columns = ((high.x - low.x) / BIN_M).ceil() as usize + 1;
    let rows = ((high.y - low.y) / BIN_M).ceil() as usize + 1;
    let mut bins: Vec<Vec<ReliefSample>> = vec![Vec::new(); columns * rows];
    for sample in &samples {
        let (from, to) = ((sample.at - widest - low) / BIN_M, (sample.at + widest - low) / BIN_M);
        for y in from.y.max(0.0) as usize..=(to.y as usize).min(rows - 1) {
            for x in from.x.max(0.0) as usize..=(to.x as usize).min(columns - 1) {
                bins[y * columns + x].push(*sample);
            }
        }
    }
    let near = |p: DVec2| {
        let cell = ((p - low) / BIN_M).max(DVec2::ZERO);
        &bins[(cell.y as usize).min(rows - 1) * columns + (cell.x as usize).min(columns - 1)]
    };
    Formation::new(Terrain::new(low, high, SAMPLE_M, |p| shaped(near(p), p, natural(p))))
}

/// Places along the middle of a street where it lies on the ground.
fn samples_of(street: &Street) -> Vec<ReliefSample> {
    let length = street.length();
    let n = (length / SAMPLE_M).ceil().max(1.0) as usize;
    let half = 0.5 * street.section.width_m() + street.section.sidewalks[0].max(street.section.sidewalks[1]);
    let on_ground = |s: f64| {
        let level = street.level(s);
        !level.bridge && !level.tunnel
    };
    let stations = (0..=n).map(|k| length * k as f64 / n as f64).filter(|&s| on_ground(s));
    stations
        .map(|s| {
            let at = street.point(s, 0.0);
            ReliefSample { at: at.truncate(), z: at.z, half }
        })
        .collect()
}

/// The natural height at a place, or that of the roads near it.
fn shaped(near: &[ReliefSample], p: DVec2, natural: f64) -> f64 {
    let (mut sum, mut weights, mut hold) = (0.0, 0.0, 0.0f64);
    for sample in near {
        let d = sample.at.distance(p);
        let t = ((d - sample.half - 1.0) / FADE_M).clamp(0.0, 1.0);
        let here = 1.0 - t * t * (3.0 - 2.0 * t);
        if here > 0.0 {
            let weight = here / (d * d + 1.0).powi(2);
            sum += weight * sample.z;
            weights += weight;
            hold = hold.max(here);
        }
    }
    if weights > 0.0 { natural + (sum / weights - natural) * hold } else { natural }
}
