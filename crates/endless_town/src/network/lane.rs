//! Driving lanes along streets.

use super::plan::{Plan, Rule, Street, on_road};
use endless_road::{Control, Lane, LaneId, Polyline, RoadNetwork, Turn};

/// Distance between points of centre lines, metres.
const STEP_M: f64 = 2.0;

/// Lays the lanes of every street, both directions, leftmost first.
pub(crate) fn add_lanes(plan: &mut Plan, network: &mut RoadNetwork) {
    for street in 0..plan.streets.len() {
        for direction in 0..2 {
            let count = plan.streets[street].profile.lanes;
            let base = network.lanes.len();
            let id = |k: usize| LaneId(u32::try_from(base + k).expect("few lanes"));
            let control = end_control(plan, street, 1 - direction);
            let street = &mut plan.streets[street];
            for k in 0..count {
                network.lanes.push(Lane {
                    id: id(k),
                    centerline: centerline(street, direction, k),
                    width_m: street.profile.lane,
                    speed_limit_mps: street.profile.speed_mps,
                    successors: Vec::new(),
                    predecessors: Vec::new(),
                    left: (k > 0).then(|| id(k - 1)),
                    right: (k + 1 < count).then(|| id(k + 1)),
                    junction: None,
                    turn: Turn::Straight,
                    end_control: control,
                });
                street.lanes[direction].push(id(k));
            }
        }
    }
}

/// Lanes run between the stop lines: direction 0 along the path on its right, 1 back on its left.
fn centerline(street: &Street, direction: usize, k: usize) -> Polyline {
    let (from, to) = street.lane_range();
    let t = street.profile.lane_centre(k) * if direction == 0 { -1.0 } else { 1.0 };
    let steps = ((to - from) / STEP_M).ceil().max(2.0) as usize;
    let mut points: Vec<_> =
        (0..=steps).map(|i| on_road(street.point(from + (to - from) * i as f64 / steps as f64, t))).collect();
    if direction == 1 {
        points.reverse();
    }
    Polyline::new(points)
}

/// What governs lanes that arrive at an end of a street.
fn end_control(plan: &Plan, street: usize, end: usize) -> Control {
    let node = &plan.nodes[plan.streets[street].ends[end]];
    let k = node.arms.iter().position(|a| a.street == street && a.end == end).expect("every end is an arm");
    match node.rule {
        Rule::Signals => Control::Signal(node.signals[k]),
        _ if node.main[k] => Control::Free,
        Rule::Stop => Control::Stop,
        Rule::Yield => Control::Yield,
    }
}
