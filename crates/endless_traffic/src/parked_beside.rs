//! Parked vehicles that reach over a walk: nobody walks into them.

use endless_road::swept::OrientedRectangle;
use endless_road::{RoadNetwork, WalkEdgeId};
use endless_world::math::segment::share_along;
use endless_world::{ParkedVehicle, VehicleSpec};
use glam::DVec2;
use std::collections::BTreeMap;

/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 2.0;

/// People who come from a walk, to a bus or a bench, are no further off it than this, metres.
const OFF_M: f64 = 3.0;

/// The bodies of parked vehicles by the edges of the walk network whose walkers could touch them.
#[derive(Debug, Clone, Default)]
pub(crate) struct ParkedBeside {
    by_edge: BTreeMap<WalkEdgeId, Vec<OrientedRectangle>>,
    /// Radius of a person, metres.
    body_m: f64,
}

impl ParkedBeside {
    /// Beside the ways of people who are discs of this radius, metres.
    pub(crate) fn new(network: &RoadNetwork, specs: &[VehicleSpec], parked: &[ParkedVehicle], body_m: f64) -> Self {
        let mut by_edge: BTreeMap<WalkEdgeId, Vec<OrientedRectangle>> = BTreeMap::new();
        for ParkedVehicle { vehicle, pose } in parked {
            let spec = &specs[vehicle.model.index()];
            let at = pose.position.as_dvec3();
            let body = OrientedRectangle::new(spec, at.truncate(), f64::from(pose.yaw_rad), 0.0);
            for (number, edge) in (0..).zip(&network.walk.edges) {
                let [a, b] = edge.nodes.map(|node| network.walk.nodes[node.index()]);
                let nearest = a.lerp(b, share_along(at.truncate(), a.truncate(), b.truncate()));
                let apart_m = nearest.truncate().distance(at.truncate());
                let reach_m = body.half.length() + 0.5 * edge.width_m + OFF_M;
                if apart_m < reach_m && (nearest.z - at.z).abs() < STOREY_M {
                    by_edge.entry(WalkEdgeId(number)).or_default().push(body);
                }
            }
        }
        Self { by_edge, body_m }
    }

    /// Where those beside an edge are, from somebody at a place: the direction, and the room between both bodies, metres.
    pub(crate) fn around(&self, edge: WalkEdgeId, at: DVec2) -> impl Iterator<Item = (DVec2, f64)> {
        self.by_edge.get(&edge).into_iter().flatten().filter_map(move |body| {
            let away = body.nearest(at) - at;
            let distance = away.length();
            // Whose middle is inside already has to get out.
            (distance > 1e-6).then(|| (away / distance, distance - self.body_m))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::{WalkEdge, WalkKind, WalkNetwork};
    use endless_world::{Pose, VehicleModelId, VehicleRef};
    use glam::DVec3;

    #[test]
    fn parked_vehicles_are_around_who_walks_beside_them_on_their_level() {
        let specs = [VehicleSpec::default()];
        let edge = |z: f64, first: u32| {
            let nodes = [first, first + 1].map(endless_road::WalkNodeId);
            (
                [DVec3::new(-20.0, 1.5, z), DVec3::new(20.0, 1.5, z)],
                WalkEdge { nodes, width_m: 2.0, kind: WalkKind::Sidewalk },
            )
        };
        let (ground, bridge) = (edge(0.0, 0), edge(6.0, 2));
        let walk = WalkNetwork { nodes: [ground.0, bridge.0].concat(), edges: vec![ground.1, bridge.1] };
        let network = RoadNetwork { walk, ..RoadNetwork::default() };
        let vehicle = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
        let parked = ParkedVehicle { vehicle, pose: Pose::default() };
        let beside = ParkedBeside::new(&network, &specs, &[parked], 0.25);
        let around = |edge: u32, at: DVec2| beside.around(WalkEdgeId(edge), at).collect::<Vec<_>>();
        assert_eq!(around(1, DVec2::new(0.3, 3.0)), [], "it stands below the bridge");
        let half = 0.5 * DVec2::new(f64::from(specs[0].length_m), f64::from(specs[0].width_m));
        let is_there = |at: DVec2, direction: DVec2, room_m: f64| {
            let found = around(0, at);
            let [(seen, room)] = found[..] else { return false };
            seen.distance(direction) < 1e-6 && (room - room_m).abs() < 1e-6
        };
        assert!(is_there(DVec2::new(0.3, 3.0), -DVec2::Y, 3.0 - half.y - 0.25), "to its side");
        let aslant = DVec2::new(-3.0, -4.0);
        assert!(is_there(half - aslant, aslant / 5.0, 5.0 - 0.25), "to its corner");
        assert!(is_there(DVec2::new(0.0, half.y + 0.2), -DVec2::Y, -0.05), "who touches it has no room");
        assert_eq!(around(0, DVec2::ZERO), []);
    }
}
