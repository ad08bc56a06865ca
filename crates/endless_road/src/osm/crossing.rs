//! Where people cross: at mapped crossings, at lights, over minor arms, and wherever else a block would be an island.

use super::class::RoadClass;
use super::extract::OsmTags;
use super::graph::StreetSegmentEnd;
use super::import_context::ImportContext;
use super::plan::{FootwayCrossing, StreetPlan};
use super::rules::{nodes_on, walkable};
use crate::TrafficControl;

/// Along the road, metres.
pub(super) const CROSSING_M: f64 = 3.2;
/// From the junction's area to the crossing.
pub(super) const BEFORE_M: f64 = 0.8;
/// From the crossing to the stop line.
pub(super) const AFTER_M: f64 = 1.2;
/// From the junction's area to the stop line where nobody crosses.
const WITHOUT_M: f64 = 0.6;
/// Shortest lane between stop lines, metres.
const LANE_M: f64 = 3.0;
/// Crossings between junctions keep this from stop lines, metres.
const CLEAR_M: f64 = 7.0;

fn is_crossing(tags: &OsmTags) -> bool {
    tags.is("highway", &["crossing"]) && !tags.is("crossing", &["no"])
}

fn is_painted(tags: &OsmTags) -> bool {
    !tags.is("crossing", &["unmarked", "informal"]) && !tags.is("crossing:markings", &["no"])
}

/// Decides on all crossings, and thereby on all stop lines.
pub(super) fn decide(plan: &mut StreetPlan, context: &ImportContext<'_>) {
    let mut wanted = wishes(plan, context);
    make_room(plan, &mut wanted);
    prune(plan, &mut wanted);
    link_islands(plan, &mut wanted);
    place(plan, &wanted);
    between_junctions(plan, context);
}

/// What is wished for at the end of a street: nothing, or a crossing and whether it is painted.
type WantedCrossing = Option<bool>;

/// By street and end.
fn wishes(plan: &StreetPlan, context: &ImportContext<'_>) -> Vec<[WantedCrossing; 2]> {
    let mut wanted = vec![[None; 2]; plan.streets.len()];
    for intersection in &plan.intersections {
        let sidewalks = intersection.arms.iter().any(|&arm| has_walk(plan, arm, true) || has_walk(plan, arm, false));
        if intersection.arms.len() < 2 || intersection.turnaround || !sidewalks {
            continue;
        }
        let rules: Vec<TrafficControl> = intersection.arms.iter().map(|&a| plan.street(a).control[a.end]).collect();
        let free = rules.iter().all(|r| *r == TrafficControl::Free || *r == TrafficControl::Stop);
        for (i, &arm) in intersection.arms.iter().enumerate() {
            let street = plan.street(arm);
            if street.roundabout || street.class >= RoadClass::Trunk {
                continue;
            }
            let wish = mapped(plan, context, intersection.nodes.len() > 1, arm).or_else(|| {
                if intersection.signals {
                    // A lone light between junctions has one crossing.
                    (intersection.arms.len() > 2 || i == 0).then_some(true)
                } else if intersection.arms.len() > 2 && walkable(street.class, street.speed_mps) {
                    (free || rules[i] != TrafficControl::Free || street.class <= RoadClass::Living).then_some(false)
                } else {
                    None
                }
            });
            wanted[arm.stretch][arm.end] = wish;
        }
    }
    wanted
}

/// A mapped crossing near enough to belong to the junction.
fn mapped(plan: &StreetPlan, context: &ImportContext<'_>, cluster: bool, arm: StreetSegmentEnd) -> WantedCrossing {
    let cut = plan.cut(arm);
    let reach = (cut + BEFORE_M + CROSSING_M + CLEAR_M + AFTER_M).min(0.6 * plan.street(arm).length());
    nodes_on(plan, arm).into_iter().filter(|&(_, d)| d < reach && (d > 0.5 || cluster)).find_map(|(node, _)| {
        let tags = context.node_tags(node).filter(|tags| is_crossing(tags))?;
        Some(is_painted(tags))
    })
}

/// Drops what finds no room between the ends of a street.
fn make_room(plan: &StreetPlan, wanted: &mut [[WantedCrossing; 2]]) {
    for (street, wishes) in plan.streets.iter().zip(wanted) {
        let room = street.length() - street.cuts[0] - street.cuts[1] - LANE_M;
        let need = |w: &WantedCrossing| if w.is_some() { BEFORE_M + CROSSING_M + AFTER_M } else { WITHOUT_M };
        while wishes.iter().map(need).sum::<f64>() > room && wishes.iter().any(Option::is_some) {
            // The unpainted one first.
            let first = if wishes[0].is_some() && (wishes[1].is_none() || wishes[0] == Some(false)) { 0 } else { 1 };
            wishes[first] = None;
        }
    }
}

/// Whether there is a sidewalk on the left (true) or right of an arm, looking outwards.
pub(super) fn has_walk(plan: &StreetPlan, arm: StreetSegmentEnd, left: bool) -> bool {
    let side = usize::from(left == (arm.end == 1));
    plan.street(arm).section.sidewalks[side] > 0.0
}

/// Whether people stand at the corner after arm `i`.
fn alive(plan: &StreetPlan, arms: &[StreetSegmentEnd], wanted: &[[WantedCrossing; 2]], i: usize) -> bool {
    let (a, b) = (arms[i], arms[(i + 1) % arms.len()]);
    let crossed = |arm: StreetSegmentEnd| wanted[arm.stretch][arm.end].is_some();
    has_walk(plan, a, true) || has_walk(plan, b, false) || (crossed(a) && crossed(b) && a != b)
}

/// Drops crossings that lead to nowhere.
fn prune(plan: &StreetPlan, wanted: &mut [[WantedCrossing; 2]]) {
    loop {
        let mut changed = false;
        for intersection in &plan.intersections {
            let n = intersection.arms.len();
            for (i, &arm) in intersection.arms.iter().enumerate() {
                if wanted[arm.stretch][arm.end].is_some()
                    && !(alive(plan, &intersection.arms, wanted, i)
                        && alive(plan, &intersection.arms, wanted, (i + n - 1) % n))
                {
                    wanted[arm.stretch][arm.end] = None;
                    changed = true;
                }
            }
        }
        if !changed {
            return;
        }
    }
}

/// Union-find.
struct UnionFind(Vec<usize>);

impl UnionFind {
    fn root(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    fn join(&mut self, a: usize, b: usize) -> bool {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b);
        a != b
    }
}

/// Adds crossings without paint over main arms where the sidewalks of two blocks would not be joined at all.
fn link_islands(plan: &StreetPlan, wanted: &mut [[WantedCrossing; 2]]) {
    let sides = 2 * plan.streets.len();
    let mut first = Vec::new();
    let mut count = sides;
    for intersection in &plan.intersections {
        first.push(count);
        count += intersection.arms.len();
    }
    let mut parts = UnionFind((0..count).collect());
    let side_of = |arm: StreetSegmentEnd, left: bool| 2 * arm.stretch + usize::from(left == (arm.end == 1));
    for (intersection, &base) in plan.intersections.iter().zip(&first) {
        let n = intersection.arms.len();
        if n < 2 || intersection.turnaround {
            continue;
        }
        for i in 0..n {
            let (a, b) = (intersection.arms[i], intersection.arms[(i + 1) % n]);
            for (arm, left) in [(a, true), (b, false)] {
                if has_walk(plan, arm, left) {
                    parts.join(base + i, side_of(arm, left));
                }
            }
            if wanted[a.stretch][a.end].is_some() {
                parts.join(base + i, base + (i + n - 1) % n);
            }
        }
    }
    for (intersection, &base) in plan.intersections.iter().zip(&first) {
        let n = intersection.arms.len();
        for (i, &arm) in intersection.arms.iter().enumerate() {
            let street = plan.street(arm);
            let room =
                street.length() - street.cuts[0] - street.cuts[1] - LANE_M - 2.0 * (BEFORE_M + CROSSING_M + AFTER_M);
            let possible = n > 2
                && !intersection.turnaround
                && wanted[arm.stretch][arm.end].is_none()
                && !street.roundabout
                && walkable(street.class, street.speed_mps)
                && room > 0.0
                && alive(plan, &intersection.arms, wanted, i)
                && alive(plan, &intersection.arms, wanted, (i + n - 1) % n);
            if possible && parts.join(base + i, base + (i + n - 1) % n) {
                wanted[arm.stretch][arm.end] = Some(false);
            }
        }
    }
}

fn place(plan: &mut StreetPlan, wanted: &[[WantedCrossing; 2]]) {
    for (street, wishes) in plan.streets.iter_mut().zip(wanted) {
        let length = street.length();
        for end in 0..2 {
            let cut = street.cuts[end];
            street.stops[end] = cut + WITHOUT_M.min(0.05 * length);
            let Some(painted) = wishes[end] else { continue };
            street.stops[end] = cut + BEFORE_M + CROSSING_M + AFTER_M;
            let d = cut + BEFORE_M + 0.5 * CROSSING_M;
            let s = if end == 0 { d } else { length - d };
            street.crossings.push(FootwayCrossing { s, painted, signal: None, end: Some(end), id: None });
        }
    }
}

/// Mapped crossings between junctions, where there are sidewalks on both sides.
fn between_junctions(plan: &mut StreetPlan, context: &ImportContext<'_>) {
    for street in &mut plan.streets {
        if street.section.sidewalks.contains(&0.0) {
            continue;
        }
        let (from, to) = (street.stops[0] + CLEAR_M, street.length() - street.stops[1] - CLEAR_M);
        for i in 0..street.on.len() {
            let (node, s) = street.on[i];
            let Some(tags) = context.node_tags(node).filter(|tags| is_crossing(tags)) else { continue };
            let alone = street.crossings.iter().all(|c| (c.s - s).abs() > 3.0 * CROSSING_M);
            if s > from && s < to && alone {
                street.crossings.push(FootwayCrossing {
                    s,
                    painted: is_painted(tags),
                    signal: None,
                    end: None,
                    id: None,
                });
            }
        }
        street.crossings.sort_by(|a, b| a.s.total_cmp(&b.s));
    }
}
