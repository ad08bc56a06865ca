//! The ranges of lanes that crossings cut.

use crate::{Crossing, CrossingId, Lane, LaneCut, NetworkError, RoadNetwork};

/// A lane this much above or below a crossing passes over or under it, metres.
const OTHER_LEVEL_M: f64 = 2.0;

pub(crate) fn derive(network: &mut RoadNetwork) -> Result<(), NetworkError> {
    for place in 0..network.crossings.len() {
        let crossing = &network.crossings[place];
        let cuts: Vec<LaneCut> = network
            .lanes
            .iter()
            .filter_map(|lane| cut_range(crossing, lane).map(|range| LaneCut { lane: lane.id, range }))
            .collect();
        if cuts.is_empty() {
            return Err(NetworkError::CutsNothing { crossing: CrossingId(place as u16) });
        }
        network.crossings[place].cuts = cuts;
    }
    Ok(())
}

/// The range of `s` of the lane's centre line inside the crossing's rectangle.
pub(crate) fn cut_range(crossing: &Crossing, lane: &Lane) -> Option<(f64, f64)> {
    let [from, to] = crossing.ends;
    let length = from.truncate().distance(to.truncate());
    let u_axis = (to - from).truncate().normalize_or_zero();
    let half = 0.5 * crossing.width_m;
    // Most lanes of a map are far away.
    let reach = lane.centerline.length() + length + crossing.width_m;
    if lane.centerline.points()[0].truncate().distance_squared(from.truncate()) > reach * reach {
        return None;
    }
    let mut range: Option<(f64, f64)> = None;
    let mut s = 0.0;
    for pair in lane.centerline.points().windows(2) {
        let span = pair[0].distance(pair[1]);
        let [a, b] = [pair[0], pair[1]].map(|p| {
            let d = (p - from).truncate();
            (d.dot(u_axis), u_axis.perp_dot(d))
        });
        // Clip the segment to 0 ≤ u ≤ length, −half ≤ v ≤ half (Liang–Barsky).
        let (mut t0, mut t1) = (0.0f64, 1.0f64);
        for (start, step, low, high) in [(a.0, b.0 - a.0, 0.0, length), (a.1, b.1 - a.1, -half, half)] {
            if step.abs() < 1e-12 {
                if start < low || start > high {
                    t1 = -1.0;
                }
            } else {
                let (x, y) = ((low - start) / step, (high - start) / step);
                t0 = t0.max(x.min(y));
                t1 = t1.min(x.max(y));
            }
        }
        if t0 < t1 {
            let at = pair[0].lerp(pair[1], 0.5 * (t0 + t1));
            let u = ((at - from).truncate().dot(u_axis) / length.max(1e-9)).clamp(0.0, 1.0);
            if (from.z + (to.z - from.z) * u - at.z).abs() < OTHER_LEVEL_M {
                let (low, high) = (s + t0 * span, s + t1 * span);
                range = Some(range.map_or((low, high), |(l, h)| (l.min(low), h.max(high))));
            }
        }
        s += span;
    }
    range
}
