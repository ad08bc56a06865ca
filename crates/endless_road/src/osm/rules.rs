//! Right-of-way rules at intersections: lights and signs where they are mapped, otherwise by road class.

use super::class::RoadClass;
use super::extract::OsmTags;
use super::graph::StreetSegmentEnd;
use super::import_context::ImportContext;
use super::movement::lanes_add_up;
use super::plan::StreetPlan;
use super::street_segment::StreetSegment;
use crate::TrafficControl;
use endless_world::SignalId;

/// Lights and signs this far before a junction belong to it, metres.
pub(super) const APPROACH_M: f64 = 30.0;

/// Whether a node has traffic lights for vehicles.
pub(super) fn has_lights(tags: &OsmTags) -> bool {
    tags.is("highway", &["traffic_signals"])
        || (tags.is("highway", &["crossing"])
            && (tags.is("crossing", &["traffic_signals"]) || tags.is("crossing:signals", &["yes"])))
}

/// Cuts stretches at traffic lights between junctions, where only people cross.
pub(super) fn split_at_lights(stretches: Vec<StreetSegment>, context: &ImportContext<'_>) -> Vec<StreetSegment> {
    let mut out = Vec::new();
    for stretch in stretches {
        let total = stretch.length();
        let mut from = 0;
        let (mut s, mut last) = (0.0, 0.0);
        for i in 1..stretch.vertices.len() - 1 {
            s += stretch.vertices[i - 1].at.distance(stretch.vertices[i].at);
            let lit = context.node_tags(stretch.vertices[i].node).is_some_and(has_lights);
            if lit && s - last > APPROACH_M + 10.0 && total - s > APPROACH_M + 10.0 && !stretch.roundabout {
                out.push(stretch.part(from, i));
                from = i;
                last = s;
            }
        }
        let end = stretch.vertices.len() - 1;
        out.push(if from == 0 { stretch } else { stretch.part(from, end) });
    }
    out
}

/// Nodes on an arm with their distance from the intersection, nearest first.
pub(super) fn nodes_on(plan: &StreetPlan, arm: StreetSegmentEnd) -> Vec<(i64, f64)> {
    let street = plan.street(arm);
    let length = street.length();
    let mut nodes: Vec<(i64, f64)> =
        street.on.iter().map(|&(n, s)| (n, if arm.end == 0 { s } else { length - s })).collect();
    nodes.sort_by(|a, b| a.1.total_cmp(&b.1));
    nodes
}

/// Whether a sign on an arm stands for who drives towards the intersection.
fn faces_knot(tags: &OsmTags, arm: StreetSegmentEnd) -> bool {
    let direction = tags.get("direction").or_else(|| tags.get("traffic_signals:direction"));
    match direction {
        Some("forward") => arm.end == 1,
        Some("backward") => arm.end == 0,
        _ => true,
    }
}

/// Decides for all intersections; numbers the signal groups of vehicles.
pub(super) fn decide(plan: &mut StreetPlan, context: &ImportContext<'_>, groups: &mut usize) {
    for intersection in 0..plan.intersections.len() {
        let arms = plan.intersections[intersection].arms.clone();
        if arms.len() < 2 {
            continue;
        }
        let lit = lights(plan, context, intersection);
        plan.intersections[intersection].signals = lit;
        let rules = if lit {
            Vec::new()
        } else if arms.len() == 2 || lanes_add_up(plan, intersection).is_some() {
            vec![TrafficControl::Free; arms.len()]
        } else {
            signs(plan, context, intersection)
        };
        for (i, arm) in arms.into_iter().enumerate() {
            if plan.lanes_in(arm).is_empty() {
                continue;
            }
            plan.streets[arm.stretch].control[arm.end] = if lit {
                *groups += 1;
                TrafficControl::Signal(SignalId((*groups - 1).min(usize::from(u16::MAX)) as u16))
            } else {
                rules[i]
            };
        }
    }
}

fn lights(plan: &StreetPlan, context: &ImportContext<'_>, intersection: usize) -> bool {
    let k = &plan.intersections[intersection];
    let lit = |node: i64| context.node_tags(node).is_some_and(has_lights);
    if k.nodes.iter().any(|&n| lit(n)) {
        return true;
    }
    if k.arms.len() < 3 {
        return false;
    }
    let ring = k.arms.iter().any(|&arm| plan.street(arm).roundabout);
    let inside = k.inside.iter().any(|&s| plan.streets[s].on.iter().any(|&(n, _)| lit(n)));
    inside
        || k.arms.iter().filter(|arm| !ring || !plan.street(**arm).roundabout).any(|&arm| {
            let near = |d: f64| d < plan.cut(arm) + APPROACH_M && d < 0.6 * plan.street(arm).length();
            !plan.lanes_in(arm).is_empty()
                && nodes_on(plan, arm).into_iter().any(|(node, d)| {
                    near(d)
                        && context
                            .node_tags(node)
                            .is_some_and(|tags| tags.is("highway", &["traffic_signals"]) && faces_knot(tags, arm))
                })
        })
}

/// Ranks by class; a roundabout's ring before all.
fn rank(plan: &StreetPlan, arm: StreetSegmentEnd) -> u32 {
    let street = plan.street(arm);
    if street.roundabout {
        return 100;
    }
    2 * street.class as u32 + u32::from(!street.link)
}

fn signs(plan: &StreetPlan, context: &ImportContext<'_>, intersection: usize) -> Vec<TrafficControl> {
    let arms = &plan.intersections[intersection].arms;
    let ranks: Vec<u32> = arms.iter().map(|&arm| rank(plan, arm)).collect();
    let highest = ranks.iter().copied().max().unwrap_or(0);
    let all_stop = plan.intersections[intersection]
        .nodes
        .iter()
        .any(|&n| context.node_tags(n).is_some_and(|t| t.is("stop", &["all"])));
    // Nobody stops before a road that they merge into.
    let merges = arms.iter().all(|&arm| plan.street(arm).oneway())
        && arms.iter().filter(|&&arm| !plan.lanes_out(arm).is_empty()).count() == 1;
    let minor = if context.country.all_way_stop && highest < 100 && !merges {
        TrafficControl::Stop
    } else {
        TrafficControl::Yield
    };
    let equal = ranks.iter().all(|&r| r == highest);
    let mut rules: Vec<TrafficControl> = if all_stop || (equal && arms.len() > 3 && context.country.all_way_stop) {
        vec![TrafficControl::Stop; arms.len()]
    } else if equal && arms.len() > 3 {
        // Right before left.
        vec![TrafficControl::Free; arms.len()]
    } else {
        let main = through(plan, arms, &ranks, highest);
        (0..arms.len()).map(|i| if main.contains(&i) { TrafficControl::Free } else { minor }).collect()
    };
    for (rule, &arm) in rules.iter_mut().zip(arms) {
        if let Some(sign) = mapped(plan, context, arm) {
            *rule = sign;
        }
    }
    rules
}

/// The arms with priority: those of the highest rank if there are two or more and others besides; else the
/// straightest pair with one of them.
fn through(plan: &StreetPlan, arms: &[StreetSegmentEnd], ranks: &[u32], highest: u32) -> Vec<usize> {
    let top: Vec<usize> = (0..arms.len()).filter(|&i| ranks[i] == highest).collect();
    if top.len() >= 2 && (top.len() < arms.len() || highest == 100) {
        return top;
    }
    let mut best = (f64::INFINITY, Vec::new());
    for i in 0..arms.len() {
        for j in i + 1..arms.len() {
            if !top.contains(&i) && !top.contains(&j) {
                continue;
            }
            let direction = |k: usize| plan.arm_direction(arms[k], plan.cut(arms[k]));
            let bend = direction(i).dot(direction(j)) - 0.05 * f64::from(ranks[i].min(ranks[j]));
            if bend < best.0 {
                best = (bend, vec![i, j]);
            }
        }
    }
    best.1
}

/// A sign that is mapped on an arm.
fn mapped(plan: &StreetPlan, context: &ImportContext<'_>, arm: StreetSegmentEnd) -> Option<TrafficControl> {
    let street = plan.street(arm);
    nodes_on(plan, arm)
        .into_iter()
        .filter(|&(_, d)| d > 0.0 && d < plan.cut(arm) + APPROACH_M && d < 0.6 * street.length())
        .find_map(|(node, _)| {
            let tags = context.node_tags(node).filter(|tags| faces_knot(tags, arm))?;
            match tags.get("highway") {
                Some("stop") => Some(TrafficControl::Stop),
                Some("give_way") => Some(TrafficControl::Yield),
                _ => None,
            }
        })
}

/// Whether people may cross this road without lights or paint.
pub(super) fn walkable(class: RoadClass, speed_mps: f64) -> bool {
    class < RoadClass::Trunk && speed_mps < 20.0
}
