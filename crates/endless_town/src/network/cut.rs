//! Where junction areas end and stop lines lie.

use super::plan::Plan;
use endless_world::math::f64::{cos, sin, tan};
use std::f64::consts::TAU;

/// Along the street, metres.
pub(crate) const CROSSING_M: f64 = 3.2;
/// From the junction's area to the crossing.
pub(crate) const BEFORE_CROSSING_M: f64 = 0.8;
/// From the crossing to the stop line's far edge.
const AFTER_CROSSING_M: f64 = 1.2;

/// Fills `cuts` of every street: far enough out that kerbs of the given radius fit between neighbouring arms.
/// Stop lines are set for arms with a crossing; [`without_crossing`] moves the others.
pub(crate) fn cut_streets(plan: &mut Plan, radius_m: f64) {
    for n in 0..plan.nodes.len() {
        let arms = plan.nodes[n].arms.clone();
        let mut cuts = vec![7.0f64; arms.len()];
        for i in 0..arms.len() {
            let j = (i + 1) % arms.len();
            let (u, v) = (plan.arm_direction(arms[i], 15.0), plan.arm_direction(arms[j], 15.0));
            let between = super::plan::angle(v) - super::plan::angle(u);
            let theta = between.rem_euclid(TAU);
            // Nearly opposite arms have no corner between them.
            if theta > 2.7 {
                continue;
            }
            let (left, right) = (plan.arm_profile(arms[i]).kerb(), plan.arm_profile(arms[j]).kerb());
            let tangent = radius_m / tan(theta / 2.0);
            cuts[i] = cuts[i].max((right + left * cos(theta)) / sin(theta) + tangent);
            cuts[j] = cuts[j].max((left + right * cos(theta)) / sin(theta) + tangent);
        }
        for (arm, cut) in arms.iter().zip(cuts) {
            let street = &mut plan.streets[arm.street];
            street.cuts[arm.end] = cut;
            street.stops[arm.end] = cut + BEFORE_CROSSING_M + CROSSING_M + AFTER_CROSSING_M;
        }
    }
}

/// Distance of the stop line where there is no crossing.
pub(crate) fn without_crossing(cut: f64) -> f64 {
    cut + 0.6
}
