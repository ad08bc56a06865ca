//! Which strips across junctions show traces of wheels: those of the road that goes straight on.

use endless_road::{LaneSurface, LaneType};
use endless_world::math::segment::share_along;
use glam::{DVec2, DVec3};

/// Shorter strips have no traces of their own, metres.
const LEAST_M: f64 = 5.0;
/// A strip goes straight on if its ends differ by less (cosine), and its middle is not aside.
const STRAIGHT: f64 = 0.96;
/// Strips overlap where a middle line comes this near to another's, metres.
const OVERLAP_M: f64 = 2.2;
const LEVEL_M: f64 = 1.5;

/// By strip, whether it has traces. Of strips that cross the shorter has them, which leads over the narrower road: no two
/// that overlap, since the upper one would cut off those of the lower.
pub(crate) fn travelled(lane_surfaces: &[LaneSurface]) -> Vec<bool> {
    let mut travelled = vec![false; lane_surfaces.len()];
    let mut straight: Vec<(usize, MiddleLine)> =
        lane_surfaces.iter().enumerate().filter_map(|(i, strip)| Some((i, MiddleLine::straight(strip)?))).collect();
    straight.sort_by(|a, b| a.1.length().total_cmp(&b.1.length()).then(a.0.cmp(&b.0)));
    let mut chosen: Vec<MiddleLine> = Vec::new();
    for (i, line) in straight {
        travelled[i] = chosen.iter().all(|other| !line.overlaps(other));
        if travelled[i] {
            chosen.push(line);
        }
    }
    travelled
}

/// Ends of the middle of a straight strip.
struct MiddleLine([DVec3; 2]);

impl MiddleLine {
    /// Of a driving lane that goes straight across a junction.
    fn straight(strip: &LaneSurface) -> Option<Self> {
        if strip.kind != LaneType::Driving || !strip.in_junction || strip.unpaved {
            return None;
        }
        let middle: Vec<DVec3> = strip.left.iter().zip(&strip.right).map(|(l, r)| l.midpoint(*r)).collect();
        let [first, second, .., before, last] = middle[..] else {
            return (middle.len() > 1 && middle[0].distance(*middle.last()?) > LEAST_M)
                .then(|| Self([middle[0], middle[middle.len() - 1]]));
        };
        let way = |a: DVec3, b: DVec3| (b - a).truncate().normalize_or_zero();
        let straight =
            way(first, second).dot(way(before, last)) > STRAIGHT && way(first, second).dot(way(first, last)) > STRAIGHT;
        (straight && first.distance(last) > LEAST_M).then_some(Self([first, last]))
    }

    fn length(&self) -> f64 {
        self.0[0].distance(self.0[1])
    }

    fn overlaps(&self, other: &Self) -> bool {
        let ([a, b], [c, d]) = (self.0, other.0);
        let flat = |p: DVec3| p.truncate();
        let reach = (self.length() + other.length()) / 2.0 + OVERLAP_M;
        if flat(a.midpoint(b)).distance_squared(flat(c.midpoint(d))) > reach * reach {
            return false;
        }
        let level = ((a.z + b.z) - (c.z + d.z)).abs() / 2.0 < LEVEL_M;
        level && segments_distance([flat(a), flat(b)], [flat(c), flat(d)]) < OVERLAP_M
    }
}

/// Least distance of two line segments.
fn segments_distance([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> f64 {
    let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    let cross = side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
    let to = |p: DVec2, q: DVec2, r: DVec2| {
        let along = share_along(r, p, q);
        p.lerp(q, along).distance(r)
    };
    let ends = [to(a, b, c), to(a, b, d), to(c, d, a), to(c, d, b)];
    if cross { 0.0 } else { ends.into_iter().fold(f64::INFINITY, f64::min) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(middle: &[[f64; 2]]) -> LaneSurface {
        let points: Vec<DVec2> = middle.iter().map(|&p| DVec2::from_array(p)).collect();
        let mut across: Vec<DVec2> = points.windows(2).map(|p| (p[1] - p[0]).normalize().perp()).collect();
        across.extend(across.last().copied());
        let border = |side: f64| points.iter().zip(&across).map(|(p, n)| (*p + *n * side).extend(0.0)).collect();
        let (left, right) = (border(1.75), border(-1.75));
        LaneSurface { kind: LaneType::Driving, left, right, in_junction: true, unpaved: false, bridge: false }
    }

    fn line(from: [f64; 2], to: [f64; 2]) -> LaneSurface {
        let at = |t: f64| [0, 1].map(|k| from[k] + (to[k] - from[k]) * t);
        strip(&[0.0, 0.25, 0.5, 0.75, 1.0].map(at))
    }

    #[test]
    fn of_two_roads_that_cross_one_has_traces_in_all_its_lanes() {
        let wide = [-5.25, -1.75, 1.75, 5.25].map(|y| line([-6.0, y], [6.0, y]));
        let narrow = [-1.75, 1.75].map(|x| line([x, -10.0], [x, 10.0]));
        let turn = strip(&[[-6.0, -5.25], [-3.0, -5.5], [-1.9, -7.0], [-1.75, -10.0]]);
        let all: Vec<LaneSurface> = narrow.into_iter().chain(wide).chain([turn]).collect();
        assert_eq!(travelled(&all), [false, false, true, true, true, true, false]);
    }

    #[test]
    fn lanes_that_part_have_one_trace() {
        let all = [line([0.0, 0.0], [20.0, 0.0]), line([0.0, 0.0], [20.0, 3.5])];
        assert_eq!(travelled(&all).iter().filter(|t| **t).count(), 1);
    }

    #[test]
    fn segments_that_cross_touch() {
        let at = |a: [f64; 2], b: [f64; 2]| [DVec2::from_array(a), DVec2::from_array(b)];
        assert_eq!(segments_distance(at([0.0, 0.0], [2.0, 2.0]), at([0.0, 2.0], [2.0, 0.0])), 0.0);
        assert_eq!(segments_distance(at([0.0, 0.0], [2.0, 0.0]), at([3.0, 0.0], [5.0, 0.0])), 1.0);
    }
}
