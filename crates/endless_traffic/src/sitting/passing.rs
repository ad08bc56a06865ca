//! Where people pass benches: before those who sit there, not behind them.

use super::places::{BenchPlace, BenchPlaces, passing_range};
use crate::walk_strip::DirectedEdge;
use endless_road::WalkEdgeId;
use glam::DVec2;

/// Benches matter from so far before them to so far behind them, along the sidewalk, metres.
const NEAR_M: [f64; 2] = [-4.0, 0.8];
/// Who has been pushed behind a bench is so far behind a seat of it and no further away from it, metres.
const BEHIND_M: [f64; 2] = [0.0, 1.5];

impl BenchPlaces {
    /// Where those keep who would be so far to the left of the middle of a strip, of an edge, at a place along it: before the
    /// benches that are near, metres to the left. Who is behind one now does not come through those who sit there.
    pub(crate) fn kept_before(&self, edge: WalkEdgeId, strip: &DirectedEdge, now: DVec2, along: f64, left: f64) -> f64 {
        let near = |place: &&BenchPlace| {
            let past_m = along - strip.local(place.at.truncate()).0;
            (NEAR_M[0]..NEAR_M[1]).contains(&past_m) && !place.is_behind(now, BEHIND_M)
        };
        let range_at =
            |place: &BenchPlace| passing_range(strip.local(place.at.truncate()).1, strip.along.perp_dot(place.facing));
        let ranges = self.on(edge).iter().filter(near).map(range_at);
        let kept = ranges.fold(left, |left, [least, most]| left.max(least).min(most));
        kept.clamp(-strip.half_width, strip.half_width)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::{RoadNetwork, WalkEdge, WalkKind, WalkNetwork, WalkNodeId};
    use endless_world::BenchSeat;
    use glam::DVec3;
    use std::f32::consts::FRAC_PI_2;

    #[test]
    fn people_pass_before_a_bench_at_the_kerb_either_way() {
        // A sidewalk of 3 m along x, and a bench on it that looks to the left.
        let kind = WalkKind::Sidewalk;
        let edge = WalkEdge { nodes: [WalkNodeId(0), WalkNodeId(1)], width_m: 3.0, kind };
        let ends = [DVec3::ZERO, DVec3::new(40.0, 0.0, 0.0)];
        let walk = WalkNetwork { nodes: ends.to_vec(), edges: vec![edge] };
        let seat = BenchSeat { position: DVec3::new(10.0, -0.9, 0.1).as_vec3(), yaw_rad: FRAC_PI_2 };
        let places = BenchPlaces::new(&RoadNetwork { walk, ..RoadNetwork::default() }, &[seat], 0.25);
        for [from, to] in [ends, [ends[1], ends[0]]].map(|ends| ends.map(DVec3::truncate)) {
            let along = (to - from).normalize();
            let strip = DirectedEdge { from, along, length: 40.0, half_width: 1.25, kind, round_m: 0.3 };
            let (at, left) = strip.local(DVec2::new(10.0, -0.9));
            let kept = places.kept_before(WalkEdgeId(0), &strip, from, at, left);
            assert!(strip.point(at, kept).y.abs() < 1e-6, "{kept}");
            let (elsewhere, _) = strip.local(DVec2::new(35.0, 0.0));
            assert_eq!(places.kept_before(WalkEdgeId(0), &strip, from, elsewhere, left), left);
            let behind = DVec2::new(10.3, -1.25);
            assert_eq!(places.kept_before(WalkEdgeId(0), &strip, behind, at, left), left, "they walk out as they came");
        }
    }
}
