//! Streets and junctions as geometry, before lanes are laid: reference lines, where they are cut at junctions, and
//! the kerb lines around corners.

use super::Profile;
use endless_road::{CrossingId, LaneId, Polyline};
use endless_world::SignalId;
use endless_world::math::f64::{atan2, sin_cos};
use glam::{DVec2, DVec3};

/// A crossing on a street.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StreetCrossing {
    /// Its middle along the street's reference line.
    pub(crate) s: f64,
    /// Along the street, metres.
    pub(crate) width: f64,
    pub(crate) id: CrossingId,
    /// The walk signal, where there is one.
    pub(crate) signal: Option<SignalId>,
}

/// A street from one junction to the next.
#[derive(Debug, Clone)]
pub(crate) struct Street {
    /// Reference line from node `ends[0]` to node `ends[1]`.
    pub(crate) path: Polyline,
    pub(crate) profile: Profile,
    pub(crate) ends: [usize; 2],
    /// Distance along the path from each end at which the junction's area begins.
    pub(crate) cuts: [f64; 2],
    /// Distance from each end at which the lanes end: stop lines.
    pub(crate) stops: [f64; 2],
    pub(crate) crossings: Vec<StreetCrossing>,
    /// Lanes by direction: along the path, and against it; leftmost first.
    pub(crate) lanes: [Vec<LaneId>; 2],
}

impl Street {
    /// The point at `s` along and `t` to the left of the reference line, seen from above.
    pub(crate) fn point(&self, s: f64, t: f64) -> DVec2 {
        let place = self.path.at(s);
        let (sin, cos) = sin_cos(place.heading_rad);
        place.position.truncate() + DVec2::new(-sin, cos) * t
    }

    /// Heading of the reference line.
    pub(crate) fn heading(&self, s: f64) -> f64 {
        self.path.at(s).heading_rad
    }

    pub(crate) fn length(&self) -> f64 {
        self.path.length()
    }

    /// Range of `s` between the junctions' areas.
    pub(crate) fn body(&self) -> (f64, f64) {
        (self.cuts[0], self.length() - self.cuts[1])
    }

    /// Range of `s` in which lanes run.
    pub(crate) fn lane_range(&self) -> (f64, f64) {
        (self.stops[0], self.length() - self.stops[1])
    }

    /// Whether a crossing, widened by `margin` on both sides, covers `s`.
    pub(crate) fn near_crossing(&self, s: f64, margin: f64) -> bool {
        self.crossings.iter().any(|c| (s - c.s).abs() < c.width / 2.0 + margin)
    }
}

/// One end of a street, seen from its junction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Arm {
    pub(crate) street: usize,
    /// 0 if the street's path begins here, 1 if it ends here.
    pub(crate) end: usize,
}

/// How a junction is controlled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rule {
    Signals,
    /// Minor arms stop.
    Stop,
    /// Minor arms give way.
    Yield,
}

/// A junction.
#[derive(Debug, Clone)]
pub(crate) struct Node {
    /// Counter-clockwise.
    pub(crate) arms: Vec<Arm>,
    /// Whether each arm belongs to the main road.
    pub(crate) main: Vec<bool>,
    pub(crate) rule: Rule,
    /// Signal of each arm's approach, where signalised.
    pub(crate) signals: Vec<SignalId>,
}

/// All streets and junctions.
#[derive(Debug, Clone)]
pub(crate) struct Plan {
    pub(crate) streets: Vec<Street>,
    pub(crate) nodes: Vec<Node>,
}

impl Plan {
    /// Place along an arm: `distance` from the junction's middle, `left` to the left looking outwards.
    pub(crate) fn arm_point(&self, arm: Arm, distance: f64, left: f64) -> DVec2 {
        let street = &self.streets[arm.street];
        if arm.end == 0 { street.point(distance, left) } else { street.point(street.length() - distance, -left) }
    }

    /// Direction away from the junction at a distance along an arm.
    pub(crate) fn arm_direction(&self, arm: Arm, distance: f64) -> DVec2 {
        let street = &self.streets[arm.street];
        let (s, sign) = if arm.end == 0 { (distance, 1.0) } else { (street.length() - distance, -1.0) };
        let (sin, cos) = sin_cos(street.heading(s));
        DVec2::new(cos, sin) * sign
    }

    pub(crate) fn arm_profile(&self, arm: Arm) -> &Profile {
        &self.streets[arm.street].profile
    }

    /// Distance from the junction's middle at which the arm's junction area ends.
    pub(crate) fn arm_cut(&self, arm: Arm) -> f64 {
        self.streets[arm.street].cuts[arm.end]
    }

    /// Distance of the stop line from the junction's middle.
    pub(crate) fn arm_stop(&self, arm: Arm) -> f64 {
        self.streets[arm.street].stops[arm.end]
    }

    /// `s` on the arm's street of a distance from the junction.
    pub(crate) fn arm_s(&self, arm: Arm, distance: f64) -> f64 {
        if arm.end == 0 { distance } else { self.streets[arm.street].length() - distance }
    }

    /// Lanes that leave the junction by this arm, leftmost first.
    pub(crate) fn lanes_out(&self, arm: Arm) -> &[LaneId] {
        &self.streets[arm.street].lanes[arm.end]
    }

    /// Lanes that reach the junction by this arm, leftmost first.
    pub(crate) fn lanes_in(&self, arm: Arm) -> &[LaneId] {
        &self.streets[arm.street].lanes[1 - arm.end]
    }

    /// A line around the corner between arm `i` of a node and the next one, from arm to arm: `offset` metres behind
    /// the kerb face, `sharpness` 0 for the kerb's own roundness to 1 for a pointed corner.
    pub(crate) fn corner(&self, node: &Node, i: usize, offset: f64, sharpness: f64) -> Vec<DVec2> {
        let (a, b) = (node.arms[i], node.arms[(i + 1) % node.arms.len()]);
        self.corner_between(a, self.arm_profile(a).kerb() + offset, b, self.arm_profile(b).kerb() + offset, sharpness)
    }

    /// The same with a distance of its own from each arm's reference line.
    pub(crate) fn corner_between(&self, a: Arm, left: f64, b: Arm, right: f64, sharpness: f64) -> Vec<DVec2> {
        let (cut_a, cut_b) = (self.arm_cut(a), self.arm_cut(b));
        let from = self.arm_point(a, cut_a, left);
        let to = self.arm_point(b, cut_b, -right);
        let (u, v) = (-self.arm_direction(a, cut_a), self.arm_direction(b, cut_b));
        rounded(from, u, to, v, sharpness, CORNER_SEGMENTS)
    }
}

/// Segments of every corner line, so that neighbouring lines can be joined by quads.
pub(crate) const CORNER_SEGMENTS: usize = 10;

/// A smooth line from `from` (heading `u`) to `to` (heading `v`), both unit vectors.
pub(crate) fn rounded(from: DVec2, u: DVec2, to: DVec2, v: DVec2, sharpness: f64, segments: usize) -> Vec<DVec2> {
    // Handles reach towards the point where the two tangents meet; 0.55 of the way gives nearly a circle.
    let reach = 0.5523 + (0.93 - 0.5523) * sharpness;
    let span = from.distance(to);
    let cross = u.perp_dot(v);
    let (mut h0, mut h1) = (span * 0.36, span * 0.36);
    if cross.abs() > 0.2 {
        let (a, b) = ((to - from).perp_dot(v) / cross, (to - from).perp_dot(u) / cross);
        if a > 0.0 && b > 0.0 && a < 3.0 * span && b < 3.0 * span {
            (h0, h1) = (a * reach, b * reach);
        }
    }
    let (c0, c1) = (from + u * h0, to - v * h1);
    (0..=segments)
        .map(|k| {
            let t = k as f64 / segments as f64;
            let w = 1.0 - t;
            from * (w * w * w) + c0 * (3.0 * w * w * t) + c1 * (3.0 * w * t * t) + to * (t * t * t)
        })
        .collect()
}

/// Direction of a vector, radians from east.
pub(crate) fn angle(v: DVec2) -> f64 {
    atan2(v.y, v.x)
}

/// A plan point at road height.
pub(crate) fn on_road(p: DVec2) -> DVec3 {
    p.extend(0.0)
}
