//! Lanes through junctions.

use super::plan::{Arm, Node, Plan, angle, on_road, rounded};
use endless_road::{Control, JunctionId, Lane, LaneId, Polyline, RoadNetwork, Turn};
use endless_world::math::f64::wrap_angle;
use glam::DVec2;
use std::f64::consts::FRAC_PI_4;

/// Adds a lane for every allowed way through every junction.
pub(crate) fn add_connectors(plan: &Plan, network: &mut RoadNetwork) {
    for (n, node) in plan.nodes.iter().enumerate() {
        let junction = JunctionId(u16::try_from(n).expect("few junctions"));
        for &from in &node.arms {
            for (lane_in, to, lane_out, turn) in ways(plan, node, from) {
                add(plan, network, junction, (from, lane_in), (to, lane_out), turn);
            }
        }
    }
}

/// The turn from one arm into another.
pub(crate) fn turn_between(plan: &Plan, from: Arm, to: Arm) -> Turn {
    let heading_in = angle(-plan.arm_direction(from, plan.arm_cut(from)));
    let heading_out = angle(plan.arm_direction(to, plan.arm_cut(to)));
    match wrap_angle(heading_out - heading_in) {
        d if d.abs() < FRAC_PI_4 * 1.1 => Turn::Straight,
        d if d > 0.0 => Turn::Left,
        _ => Turn::Right,
    }
}

/// Which lane of `from` leads to which lane of which arm: left turns from the leftmost lane, right turns from the
/// rightmost, straight on from all (but for a left-turn lane where there are three).
fn ways(plan: &Plan, node: &Node, from: Arm) -> Vec<(usize, Arm, usize, Turn)> {
    let lanes = plan.lanes_in(from).len();
    let others: Vec<(Arm, Turn)> =
        node.arms.iter().filter(|&&to| to != from).map(|&to| (to, turn_between(plan, from, to))).collect();
    let has = |turn: Turn| others.iter().any(|&(_, t)| t == turn);
    let mut ways = Vec::new();
    for &(to, turn) in &others {
        let exits = plan.lanes_out(to).len();
        match turn {
            Turn::Right => ways.push((lanes - 1, to, exits - 1, turn)),
            Turn::Straight => {
                let left_lane = has(Turn::Left) && (lanes > 2 || lanes > exits);
                let first = usize::from(left_lane);
                // Keep to the kerb side; what does not fit on the left has turned off.
                for k in first..lanes {
                    let from_right = lanes - 1 - k;
                    if from_right < exits {
                        ways.push((k, to, exits - 1 - from_right, turn));
                    }
                }
            }
            _ => {
                ways.push((0, to, 0, turn));
                if !has(Turn::Straight) && lanes > 2 && exits > 1 {
                    ways.push((1, to, 1, turn));
                }
            }
        }
    }
    // No lane may end here: one without a way takes that of its neighbour, which leads on furthest to its own side.
    for k in 0..lanes {
        if !ways.iter().any(|w| w.0 == k) {
            let nearest = ways.iter().copied().min_by_key(|w| w.0.abs_diff(k)).expect("a junction leads somewhere");
            ways.push((k, nearest.1, nearest.2, nearest.3));
        }
    }
    ways
}

fn add(
    plan: &Plan,
    network: &mut RoadNetwork,
    junction: JunctionId,
    (from, lane_in): (Arm, usize),
    (to, lane_out): (Arm, usize),
    turn: Turn,
) {
    let id = LaneId(u32::try_from(network.lanes.len()).expect("few lanes"));
    let before = plan.lanes_in(from)[lane_in];
    let after = plan.lanes_out(to)[lane_out];
    let (a, b) = (network.lane(before), network.lane(after));
    let limit = a.speed_limit_mps.min(b.speed_limit_mps);
    let speed_limit_mps = match turn {
        Turn::Straight => limit,
        Turn::Left => limit.min(7.5),
        _ => limit.min(5.5),
    };
    let lane = Lane {
        id,
        centerline: way_line(plan, (from, lane_in), (to, lane_out)),
        width_m: a.width_m.min(b.width_m),
        speed_limit_mps,
        successors: vec![after],
        predecessors: Vec::new(),
        left: None,
        right: None,
        junction: Some(junction),
        turn,
        end_control: Control::Free,
    };
    network.lanes.push(lane);
    network.lanes[before.index()].successors.push(id);
    network.junctions[junction.index()].lanes.push(id);
}

/// Straight over the crossing, a smooth curve through the junction's area, and straight over the next crossing.
fn way_line(plan: &Plan, (from, lane_in): (Arm, usize), (to, lane_out): (Arm, usize)) -> Polyline {
    let left = plan.arm_profile(from).lane_centre(lane_in);
    let right = -plan.arm_profile(to).lane_centre(lane_out);
    let leg = |arm: Arm, offset: f64| -> Vec<DVec2> {
        let (cut, stop) = (plan.arm_cut(arm), plan.arm_stop(arm));
        let steps = ((stop - cut) / 1.5).ceil() as usize;
        (0..=steps).map(|i| plan.arm_point(arm, cut + (stop - cut) * i as f64 / steps as f64, offset)).collect()
    };
    let mut points = leg(from, left);
    points.reverse();
    let exit = leg(to, right);
    let u = -plan.arm_direction(from, plan.arm_cut(from));
    let v = plan.arm_direction(to, plan.arm_cut(to));
    let curve = rounded(points[points.len() - 1], u, exit[0], v, 0.0, 20);
    points.extend(&curve[1..curve.len() - 1]);
    points.extend(exit);
    Polyline::new(points.into_iter().map(on_road))
}
