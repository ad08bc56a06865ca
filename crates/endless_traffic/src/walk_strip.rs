//! A sidewalk or crossing as a strip along which a pedestrian walks, and heights on it.

use crate::roads::Roads;
use endless_road::{WalkEdgeId, WalkKind, WalkNodeId};
use endless_world::math::f64::sin_cos;
use glam::DVec2;

/// Bodies are discs of this radius, metres.
pub(crate) const BODY_M: f64 = 0.25;
/// The middles of two bodies that touch are so far from one another, metres.
pub(crate) const APART_M: f64 = 2.0 * BODY_M;
/// The same where one of them turns their shoulders to get past, metres: a body is half as deep as it is wide.
pub(crate) const SIDEWAYS_APART_M: f64 = 0.36;

/// The same where a kerb may be, metres.
const KERB_ROUND_M: f64 = 0.3;

/// A directed strip: from, unit direction, length, usable half width.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DirectedEdge {
    pub(crate) from: DVec2,
    pub(crate) along: DVec2,
    pub(crate) length: f64,
    pub(crate) half_width: f64,
    pub(crate) kind: WalkKind,
    /// How far it reaches back beyond its beginning, metres: where one comes around a corner, all of its round end.
    pub(crate) round_m: f64,
}

impl DirectedEdge {
    pub(crate) fn new(roads: &Roads, from: WalkNodeId, edge: WalkEdgeId, to: WalkNodeId) -> Self {
        let walk = &roads.network.walk;
        let (a, b) = (walk.nodes[from.index()].truncate(), walk.nodes[to.index()].truncate());
        let data = &walk.edges[edge.index()];
        Self {
            from: a,
            along: (b - a).normalize_or(DVec2::X),
            length: a.distance(b),
            half_width: (0.5 * data.width_m - BODY_M).max(0.1),
            kind: data.kind,
            round_m: KERB_ROUND_M,
        }
    }

    /// Along and to the left.
    pub(crate) fn local(&self, p: DVec2) -> (f64, f64) {
        let d = p - self.from;
        (d.dot(self.along), self.along.perp_dot(d))
    }

    pub(crate) fn point(&self, along: f64, left: f64) -> DVec2 {
        self.from + self.along * along + self.along.perp() * left
    }

    /// How far outside the strip a point lies. Its beginning is round, as one comes around a corner there, but reaches no further
    /// back than to where a kerb may be; its end is not.
    pub(crate) fn outside(&self, p: DVec2) -> f64 {
        let (along, left) = self.local(p);
        let beside = if along < 0.0 { DVec2::new(along, left).length() } else { left.abs() };
        (along - self.length).max(-along - self.round_m).max(beside - self.half_width).max(0.0)
    }
}

/// What is underfoot and where it leads.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Footway<'a> {
    pub(crate) strip: &'a DirectedEdge,
    pub(crate) next: Option<&'a DirectedEdge>,
}

impl Footway<'_> {
    /// How far outside of both a point lies, metres.
    pub(crate) fn outside(&self, p: DVec2) -> f64 {
        self.strip.outside(p).min(self.next.map_or(f64::INFINITY, |next| next.outside(p)))
    }

    /// The first of some distances in a direction at which one is further outside than here, metres.
    pub(crate) fn free_path(&self, at: DVec2, direction: DVec2, stations_m: &[f64]) -> f64 {
        let here = self.outside(at) + 1e-6;
        let leaves = |&&m: &&f64| self.outside(at + direction * m) > here;
        stations_m.iter().find(leaves).copied().unwrap_or(f64::INFINITY)
    }
}

/// Height of the walking surface: sidewalks as drawn, crossings on the road between their kerbs.
pub(crate) fn height(roads: &Roads, from: WalkNodeId, (edge, to): (WalkEdgeId, WalkNodeId), at: DVec2) -> f64 {
    let walk = &roads.network.walk;
    let (a, b) = (walk.nodes[from.index()], walk.nodes[to.index()]);
    let strip = DirectedEdge::new(roads, from, edge, to);
    let u = (strip.local(at).0 / strip.length.max(1e-6)).clamp(0.0, 1.0);
    let high = a.z + (b.z - a.z) * u;
    let WalkKind::Crossing(id) = strip.kind else { return high };
    let [p, q] = roads.network.crossings[id.index()].ends;
    let d = (q - p).truncate();
    let length = d.length().max(1e-6);
    let along = (at - p.truncate()).dot(d) / length;
    let road = p.z + (q.z - p.z) * (along / length).clamp(0.0, 1.0);
    // A step down takes a foot's length.
    let on_road = (along.min(length - along) / 0.3 + 0.5).clamp(0.0, 1.0);
    high + (road - high) * on_road
}

/// The unit vector of an angle: `DVec2::from_angle` with the same bits on every machine.
pub(crate) fn unit_vector(angle: f64) -> DVec2 {
    let (sin, cos) = sin_cos(angle);
    DVec2::new(cos, sin)
}
