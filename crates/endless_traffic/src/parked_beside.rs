//! Parked vehicles that reach over a walk: nobody walks into them.

use crate::body_contact::{Bound, bound};
use crate::walk_strip::BODY_M;
use endless_road::swept::OrientedRectangle;
use endless_road::{RoadNetwork, WalkEdgeId};
use endless_world::math::segment::share_along;
use endless_world::{ParkedVehicle, VehicleSpec};
use glam::DVec2;
use std::collections::BTreeMap;

/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 2.0;

/// The bodies of parked vehicles by the edges of the walk network whose walkers could touch them.
#[derive(Debug, Clone, Default)]
pub(crate) struct ParkedBeside(BTreeMap<WalkEdgeId, Vec<OrientedRectangle>>);

impl ParkedBeside {
    pub(crate) fn new(network: &RoadNetwork, specs: &[VehicleSpec], parked: &[ParkedVehicle]) -> Self {
        let mut beside: BTreeMap<WalkEdgeId, Vec<OrientedRectangle>> = BTreeMap::new();
        for ParkedVehicle { vehicle, pose } in parked {
            let spec = &specs[vehicle.model.index()];
            let at = pose.position.as_dvec3();
            let body = OrientedRectangle::new(spec, at.truncate(), f64::from(pose.yaw_rad), 0.0);
            for (number, edge) in (0..).zip(&network.walk.edges) {
                let [a, b] = edge.nodes.map(|node| network.walk.nodes[node.index()]);
                let nearest = a.lerp(b, share_along(at.truncate(), a.truncate(), b.truncate()));
                let apart_m = nearest.truncate().distance(at.truncate());
                let reach_m = body.half.length() + 0.5 * edge.width_m + 2.0 * BODY_M;
                if apart_m < reach_m && (nearest.z - at.z).abs() < STOREY_M {
                    beside.entry(WalkEdgeId(number)).or_default().push(body);
                }
            }
        }
        Self(beside)
    }

    /// The bounds that those beside an edge put on the velocity of somebody at a place, for a step.
    pub(crate) fn bounds(&self, edge: WalkEdgeId, at: DVec2, step_s: f64) -> impl Iterator<Item = Bound> {
        self.0.get(&edge).into_iter().flatten().filter_map(move |body| {
            let away = nearest(body, at) - at;
            let distance = away.length();
            // Whose middle is inside already has to get out.
            (distance > 1e-6).then(|| bound(away / distance, distance - BODY_M, step_s))
        })
    }
}

/// The place of a body that is nearest to another place.
fn nearest(body: &OrientedRectangle, at: DVec2) -> DVec2 {
    let away = at - body.center;
    let local = DVec2::new(away.dot(body.axis), away.dot(body.axis.perp()));
    let inside = local.clamp(-body.half, body.half);
    body.place(inside.x, inside.y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body_contact::nearest_within;
    use endless_road::{WalkEdge, WalkKind, WalkNetwork};
    use endless_world::{Pose, VehicleModelId, VehicleRef};
    use glam::DVec3;

    #[test]
    fn who_walks_towards_a_parked_vehicle_comes_up_to_it_and_past_it() {
        let specs = [VehicleSpec::default()];
        let half_width = 0.5 * f64::from(specs[0].width_m);
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
        let beside = ParkedBeside::new(&network, &specs, &[parked]);
        assert_eq!(beside.bounds(WalkEdgeId(1), DVec2::ZERO, 0.1).count(), 0, "it stands below the bridge");
        let mut at = DVec2::new(0.3, 3.0);
        for _ in 0..100 {
            let bounds: Vec<Bound> = beside.bounds(WalkEdgeId(0), at, 0.1).collect();
            assert_eq!(bounds.len(), 1);
            at += nearest_within(&bounds, DVec2::new(0.1, -1.0)) * 0.1;
        }
        assert!((at.y - half_width - BODY_M).abs() < 1e-6, "comes up to its side, {at}");
        assert!((at.x - 1.3).abs() < 1e-6, "and goes on along it, {at}");
    }
}
