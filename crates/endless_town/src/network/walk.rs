//! Sidewalks on both sides of every street, joined around corners and over crossings.

use super::plan::{Arm, Plan};
use super::profile::KERB_HEIGHT_M;
use endless_road::{RoadNetwork, WalkEdge, WalkKind, WalkNetwork, WalkNodeId};
use glam::DVec2;

/// Distance between nodes along a sidewalk, metres.
const STEP_M: f64 = 6.0;

/// First and last node of each side of each street: `[left, right]` of its path.
type SideEnds = Vec<[[WalkNodeId; 2]; 2]>;

/// Fills the walk network.
pub(crate) fn add_walks(plan: &Plan, network: &mut RoadNetwork) {
    let mut walk = WalkNetwork::default();
    let ends = add_sides(plan, &mut walk);
    for node in &plan.nodes {
        for (i, &a) in node.arms.iter().enumerate() {
            let b = node.arms[(i + 1) % node.arms.len()];
            let (pa, pb) = (plan.arm_profile(a), plan.arm_profile(b));
            let corner = plan.corner_between(a, pa.walk_line(), b, pb.walk_line(), 0.35);
            let width = pa.walk_width().min(pb.walk_width());
            let mut last = side_end(&ends, a, true);
            for p in [corner[3], corner[5], corner[7]] {
                let here = add_node(&mut walk, p);
                connect(&mut walk, last, here, width, WalkKind::Sidewalk);
                last = here;
            }
            connect(&mut walk, last, side_end(&ends, b, false), width, WalkKind::Sidewalk);
        }
    }
    network.walk = walk;
}

/// The node where the sidewalk on one side of an arm (left or right looking outwards) begins at the junction.
fn side_end(ends: &SideEnds, arm: Arm, left_outwards: bool) -> WalkNodeId {
    let left_of_path = left_outwards == (arm.end == 0);
    ends[arm.street][usize::from(!left_of_path)][arm.end]
}

fn add_sides(plan: &Plan, walk: &mut WalkNetwork) -> SideEnds {
    plan.streets
        .iter()
        .map(|street| {
            let (from, to) = street.body();
            let mut stations: Vec<f64> = street.crossings.iter().map(|c| c.s).chain([from, to]).collect();
            stations.sort_by(f64::total_cmp);
            let stations = subdivided(&stations, STEP_M);
            let width = street.profile.walk_width();
            let mut ends = [[WalkNodeId(0); 2]; 2];
            let mut at_crossing: Vec<[WalkNodeId; 2]> = vec![[WalkNodeId(0); 2]; street.crossings.len()];
            for (side, sign) in [(0, 1.0), (1, -1.0)] {
                let mut last = None;
                for &s in &stations {
                    let here = add_node(walk, street.point(s, sign * street.profile.walk_line()));
                    match last {
                        None => ends[side][0] = here,
                        Some(last) => connect(walk, last, here, width, WalkKind::Sidewalk),
                    }
                    if let Some(c) = street.crossings.iter().position(|c| (c.s - s).abs() < 1e-9) {
                        at_crossing[c][side] = here;
                    }
                    last = Some(here);
                    ends[side][1] = here;
                }
            }
            for (crossing, nodes) in street.crossings.iter().zip(at_crossing) {
                connect(walk, nodes[0], nodes[1], crossing.width - 0.4, WalkKind::Crossing(crossing.id));
            }
            ends
        })
        .collect()
}

/// The same stations with others between them, nowhere further apart than `step`.
pub(crate) fn subdivided(stations: &[f64], step: f64) -> Vec<f64> {
    let mut out = vec![stations[0]];
    for pair in stations.windows(2) {
        let n = ((pair[1] - pair[0]) / step).ceil().max(1.0) as usize;
        for i in 1..=n {
            // The station itself, to the last bit, where the piece ends.
            out.push(if i == n { pair[1] } else { pair[0] + (pair[1] - pair[0]) * i as f64 / n as f64 });
        }
    }
    out
}

fn add_node(walk: &mut WalkNetwork, p: DVec2) -> WalkNodeId {
    walk.nodes.push(p.extend(KERB_HEIGHT_M));
    WalkNodeId(u32::try_from(walk.nodes.len() - 1).expect("few nodes"))
}

fn connect(walk: &mut WalkNetwork, a: WalkNodeId, b: WalkNodeId, width_m: f64, kind: WalkKind) {
    walk.edges.push(WalkEdge { nodes: [a, b], width_m, kind });
}
