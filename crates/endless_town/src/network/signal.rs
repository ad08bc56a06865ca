//! Signal groups and programs: opposite arms together, walk signals concurrent with the parallel road.

use super::plan::{Node, Plan, Rule};
use endless_road::{Phase, RoadNetwork, SignalProgram};
use endless_world::{SignalAspect, SignalId, Stream};

/// Seconds of yellow, of all-red, and of walk at least.
const YELLOW_S: f64 = 3.0;
const ALL_RED_S: f64 = 2.0;
const WALK_S: f64 = 7.0;
/// The speed for which clearance is reckoned.
const CLEARANCE_MPS: f64 = 1.25;

/// Gives every arm of signalised junctions a signal group; walk groups follow them, one an arm.
pub(crate) fn number_signals(plan: &mut Plan, network: &mut RoadNetwork) {
    for node in plan.nodes.iter_mut().filter(|n| n.rule == Rule::Signals) {
        let n = node.arms.len() as u16;
        node.signals = (0..n).map(|k| SignalId(network.signal_groups + k)).collect();
        network.signal_groups += 2 * n;
    }
}

/// The walk group of arm `k`.
fn walk_group(node: &Node, k: usize) -> SignalId {
    SignalId(node.signals[0].0 + node.arms.len() as u16 + k as u16)
}

/// Writes the program of every signalised junction.
pub(crate) fn add_programs(plan: &Plan, network: &mut RoadNetwork, seed: u64) {
    for (n, node) in plan.nodes.iter().enumerate().filter(|(_, node)| node.rule == Rule::Signals) {
        let mut phases = Vec::new();
        for stage in stages(plan, node) {
            phases.extend(stage_phases(plan, node, &stage));
        }
        let cycle: f64 = phases.iter().map(|p| p.duration_s).sum();
        let offset_s = Stream::named(seed, "town/signal", &[n as u64]).range_f64(0.0, cycle).floor();
        network.junctions[n].program = Some(SignalProgram { phases, offset_s });
    }
}

fn opposite(plan: &Plan, node: &Node, i: usize, j: usize) -> bool {
    plan.arm_direction(node.arms[i], 15.0).dot(plan.arm_direction(node.arms[j], 15.0)) < -0.7
}

/// Arms that are green together: opposite pairs, the main road first.
fn stages(plan: &Plan, node: &Node) -> Vec<Vec<usize>> {
    let n = node.arms.len();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by_key(|&k| !node.main[k]);
    let mut stages: Vec<Vec<usize>> = Vec::new();
    for k in order {
        let partner = stages.iter_mut().find(|s| s.len() == 1 && opposite(plan, node, s[0], k));
        match partner {
            Some(stage) => stage.push(k),
            None => stages.push(vec![k]),
        }
    }
    stages
}

fn stage_phases(plan: &Plan, node: &Node, stage: &[usize]) -> Vec<Phase> {
    let n = node.arms.len();
    // People may walk over an arm that is red and that nobody enters straight on; who turns into it gives way.
    let walks: Vec<usize> =
        (0..n).filter(|k| !stage.contains(k) && !stage.iter().any(|&s| opposite(plan, node, s, *k))).collect();
    let longest = walks.iter().map(|&k| 2.0 * plan.arm_profile(node.arms[k]).kerb()).fold(0.0, f64::max);
    let clearance = (longest / CLEARANCE_MPS).ceil();
    let main = stage.iter().any(|&k| node.main[k]);
    let least: f64 = if main { 18.0 } else { 11.0 };
    let green = least.max(WALK_S + clearance);
    let phase = |duration_s: f64, vehicles: SignalAspect, people: SignalAspect| Phase {
        duration_s,
        aspects: (0..n)
            .map(|k| (node.signals[k], if stage.contains(&k) { vehicles } else { SignalAspect::Red }))
            .chain((0..n).map(|k| (walk_group(node, k), if walks.contains(&k) { people } else { SignalAspect::Red })))
            .collect(),
    };
    let mut phases = vec![phase(green - clearance, SignalAspect::Green, SignalAspect::Green)];
    if clearance > 0.0 {
        phases.push(phase(clearance, SignalAspect::Green, SignalAspect::Yellow));
    }
    phases.push(phase(YELLOW_S, SignalAspect::Yellow, SignalAspect::Red));
    phases.push(phase(ALL_RED_S, SignalAspect::Red, SignalAspect::Red));
    phases
}
