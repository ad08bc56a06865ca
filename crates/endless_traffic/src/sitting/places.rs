//! Seats that can be reached from a sidewalk.

use endless_road::{RoadNetwork, WalkEdge, WalkEdgeId, WalkKind};
use endless_world::BenchSeat;
use endless_world::math::f64::sin_cos;
use glam::{DVec2, DVec3};

/// Seats are reached from where the sidewalk is nearest to this far before them, metres, and no further away than that.
const BEFORE_M: f64 = 0.42;
const REACH_M: f64 = 2.5;
/// Who leaves the sidewalk for a seat is at least so far before the middle of it: not behind the bench, metres.
const IN_FRONT_M: f64 = 0.35;
/// And so far from the ends of a piece of it, metres.
const FROM_ENDS_M: f64 = 0.3;
/// Who passes keeps so far before the middle of a seat, metres: knees reach that far, and two bodies are half as wide each.
const PASSES_M: f64 = 0.9;
/// The room that is left to those who pass, for the middles of bodies, metres.
const ROOM_M: f64 = 0.4;
/// Benches look across a sidewalk, or are no matter of those who walk along it: least sine of the angle between.
const ACROSS: f64 = 0.7;
/// Seats and sidewalks further above or below are on another level, metres.
const STOREY_M: f64 = 1.0;

/// A seat beside a sidewalk.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BenchPlace {
    /// Of the seat, in the list of all.
    pub(crate) seat: usize,
    pub(crate) edge: WalkEdgeId,
    /// Where one leaves the sidewalk.
    pub(crate) from: DVec2,
    /// Below who sits, on the ground.
    pub(crate) at: DVec3,
    /// Where they look, radians, and the same as a unit vector.
    pub(crate) yaw: f64,
    pub(crate) facing: DVec2,
}

impl BenchPlace {
    /// Whether a place is at least so far behind the seat, metres, and no further away from it.
    pub(super) fn is_behind(&self, at: DVec2, [least_m, within_m]: [f64; 2]) -> bool {
        let from_seat = at - self.at.truncate();
        from_seat.dot(self.facing) < -least_m && from_seat.length() < within_m
    }
}

/// All of them, by sidewalk.
#[derive(Debug, Clone, Default)]
pub(crate) struct BenchPlaces(Vec<BenchPlace>);

/// Where those keep who pass a seat so far to the left of the middle of a sidewalk, whose look goes so far across it to the left: from
/// so far to the left of the middle on, and up to so far, metres.
pub(super) fn passing_range(left: f64, across: f64) -> [f64; 2] {
    match across {
        _ if across > ACROSS => [left + PASSES_M, f64::INFINITY],
        _ if across < -ACROSS => [f64::NEG_INFINITY, left - PASSES_M],
        _ => [f64::NEG_INFINITY, f64::INFINITY],
    }
}

impl BenchPlaces {
    /// For bodies of this radius, metres.
    pub(crate) fn new(network: &RoadNetwork, seats: &[BenchSeat], body_m: f64) -> Self {
        let of_seat = |(seat, at): (usize, &BenchSeat)| place(network, seat, at, body_m);
        let mut all: Vec<BenchPlace> = seats.iter().enumerate().filter_map(of_seat).collect();
        all.sort_by_key(|place| (place.edge.index(), place.seat));
        Self(all)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn all(&self) -> &[BenchPlace] {
        &self.0
    }

    pub(crate) fn on(&self, edge: WalkEdgeId) -> &[BenchPlace] {
        let from = self.0.partition_point(|place| place.edge.index() < edge.index());
        let number = self.0[from..].partition_point(|place| place.edge == edge);
        &self.0[from..from + number]
    }
}

fn place(network: &RoadNetwork, seat: usize, on: &BenchSeat, body_m: f64) -> Option<BenchPlace> {
    let walk = &network.walk;
    let (at, yaw) = (on.position.as_dvec3(), f64::from(on.yaw_rad));
    let (sin, cos) = sin_cos(yaw);
    let facing = DVec2::new(cos, sin);
    let before = at.truncate() + facing * BEFORE_M;
    let found = |(number, edge): (usize, &WalkEdge)| {
        let [a, b] = edge.nodes.map(|node| walk.nodes[node.index()]);
        let [from, to] = [a, b].map(DVec3::truncate);
        let length = from.distance(to);
        if edge.kind != WalkKind::Sidewalk || length < 2.0 * FROM_ENDS_M {
            return None;
        }
        let along = (to - from) / length;
        let s = (before - from).dot(along).clamp(FROM_ENDS_M, length - FROM_ENDS_M);
        let usable_m = (0.5 * edge.width_m - body_m).max(0.0);
        let t = along.perp_dot(before - from).clamp(-usable_m, usable_m);
        let leaves = from + along * s + along.perp() * t;
        let level = (a.z + (b.z - a.z) * (s / length) - at.z).abs() < STOREY_M;
        let in_front = (leaves - at.truncate()).dot(facing) > IN_FRONT_M;
        let away_m = leaves.distance(before);
        let edge = WalkEdgeId(number as u32);
        // Others pass before it.
        let [least, most] = passing_range(along.perp_dot(at.truncate() - from), along.perp_dot(facing));
        let leaves_room = usable_m - least >= ROOM_M && usable_m + most >= ROOM_M;
        let usable = level && in_front && away_m < REACH_M && leaves_room;
        usable.then_some((away_m, BenchPlace { seat, edge, from: leaves, at, yaw, facing }))
    };
    let edges = walk.edges.iter().enumerate().filter_map(found);
    edges.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, place)| place)
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::{WalkNetwork, WalkNodeId};
    use std::f64::consts::{FRAC_PI_2, PI};

    /// A sidewalk of 3 m along x, at y from -1.5 to 1.5.
    fn sidewalk() -> RoadNetwork {
        let edge = WalkEdge { nodes: [WalkNodeId(0), WalkNodeId(1)], width_m: 3.0, kind: WalkKind::Sidewalk };
        let nodes = vec![DVec3::ZERO, DVec3::new(40.0, 0.0, 0.0)];
        RoadNetwork { walk: WalkNetwork { nodes, edges: vec![edge] }, ..RoadNetwork::default() }
    }

    fn seat(x: f64, y: f64, z: f64, yaw: f64) -> BenchSeat {
        BenchSeat { position: DVec3::new(x, y, z).as_vec3(), yaw_rad: yaw as f32 }
    }

    #[test]
    fn seats_are_reached_from_their_front() {
        let seats = [
            // On the sidewalk, at the kerb, and beside it.
            seat(10.0, -0.9, 0.1, FRAC_PI_2),
            seat(20.0, 2.5, 0.0, -FRAC_PI_2),
            // Looking away from it, too far away, and on a bridge above.
            seat(20.0, 2.5, 0.0, FRAC_PI_2),
            seat(20.0, 9.0, 0.0, -FRAC_PI_2),
            seat(20.0, 0.0, 4.0, PI),
        ];
        let places = BenchPlaces::new(&sidewalk(), &seats, 0.25);
        let reached: Vec<usize> = places.on(WalkEdgeId(0)).iter().map(|place| place.seat).collect();
        assert_eq!(reached, [0, 1]);
        assert!(places.all().len() == 2 && places.on(WalkEdgeId(1)).is_empty());
        for place in places.all() {
            assert!(place.from.y.abs() <= 1.25 + 1e-9, "leaves the sidewalk at {}", place.from);
            assert!((place.from - place.at.truncate()).dot(place.facing) > IN_FRONT_M);
        }
    }
}
