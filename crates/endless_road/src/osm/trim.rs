//! How far roads are cut back where they meet, so that their borders do not overlap and kerbs find room for a radius;
//! and which places are so close together that they are one junction.

use super::class::RoadClass;
use super::connector::DEAD_END_RADIUS_M;
use super::curve::angle;
use super::graph::StreetSegmentEnd;
use super::plan::StreetPlan;
use endless_world::math::f64::{cos, wrap_angle};
use glam::DVec2;

/// Roads are never cut back further than this, metres.
const MOST_M: f64 = 40.0;
/// Nor where a road parts slowly from a fast one than this, metres.
const MOST_RAMP_M: f64 = 120.0;
const STEP_M: f64 = 0.5;
/// Where two roads merely follow one another, each gives this much for the change, metres.
const CHANGE_M: f64 = 4.0;
/// Junctions nearer to one another than this are one, metres.
const NEAR_M: f64 = 12.0;
/// A junction of several nodes spans at most this, metres.
const WIDEST_M: f64 = 55.0;
/// Junctions have no more arms than this: every lane of each leads to every other, and is checked against all others.
pub(super) const MOST_ARMS: usize = 20;
/// Shortest street that is left between two junctions, metres.
const SHORTEST_M: f64 = 4.0;

/// Cuts all streets, and makes one of junctions that would overlap.
pub(super) fn trim(plan: &mut StreetPlan) {
    for intersection in 0..plan.intersections.len() {
        cut_knot(plan, intersection);
    }
    for _ in 0..12 {
        let touched = contract(plan);
        if touched.is_empty() {
            break;
        }
        for intersection in touched {
            cut_knot(plan, intersection);
        }
    }
    for street in 0..plan.streets.len() {
        fit(plan, street);
    }
    for intersection in 0..plan.intersections.len() {
        align(plan, intersection);
        plan.sort_arms(intersection);
    }
}

/// The first metres of an intersection's arm, outwards from its end.
struct ArmReach {
    line: Vec<DVec2>,
    left: f64,
    right: f64,
    outwards: DVec2,
    corner_m: f64,
    most: f64,
    /// The same beside a road to which it is nearly parallel.
    most_beside: f64,
}

fn reach(plan: &StreetPlan, arm: StreetSegmentEnd) -> ArmReach {
    let street = plan.street(arm);
    let section = plan.arm_section(arm);
    let length = street.length();
    let ramp = street.oneway() && (street.link || street.class >= RoadClass::Trunk);
    let most = if ramp { MOST_RAMP_M } else { MOST_M };
    let far = length.min(most + 15.0);
    let n = (far / 2.5).ceil().max(2.0) as usize;
    ArmReach {
        line: (0..=n).map(|k| plan.arm_point(arm, far * k as f64 / n as f64, 0.0).truncate()).collect(),
        left: section.kerbs[0],
        right: -section.kerbs[1],
        outwards: (plan.arm_point(arm, far.min(14.0), 0.0) - plan.arm_point(arm, 0.0, 0.0))
            .truncate()
            .normalize_or(DVec2::X),
        corner_m: street.class.corner_m(),
        most: MOST_M.min(0.92 * length),
        most_beside: most.min(if ramp { 0.45 } else { 0.92 } * length).max(MOST_M.min(0.92 * length)),
    }
}

/// How far outside the asphalt of a road a point lies; negative inside. Behind its beginning it is outside.
fn outside(road: &ArmReach, p: DVec2) -> f64 {
    let mut best = (f64::INFINITY, f64::INFINITY);
    for (k, pair) in road.line.windows(2).enumerate() {
        let along = pair[1] - pair[0];
        let raw = (p - pair[0]).dot(along) / along.length_squared().max(1e-12);
        if k == 0 && raw < 0.0 {
            continue;
        }
        let off = p - (pair[0] + along * raw.clamp(0.0, 1.0));
        let distance = off.length();
        if distance < best.0 {
            let half = if along.perp_dot(off) > 0.0 { road.left } else { road.right };
            best = (distance, distance - half);
        }
    }
    best.1
}

fn cut_knot(plan: &mut StreetPlan, intersection: usize) {
    let arms = plan.intersections[intersection].arms.clone();
    let reaches: Vec<ArmReach> = arms.iter().map(|&arm| reach(plan, arm)).collect();
    for (i, &arm) in arms.iter().enumerate() {
        let cut = match arms.len() {
            1 if plan.intersections[intersection].open => 0.0,
            1 => dead_end_cut(plan, arm),
            // Room for the loop.
            2 if plan.intersections[intersection].turnaround => {
                let gap = reaches[0].line[0].distance(reaches[1].line[0]);
                (0.6 * gap + 3.0).min(0.4 * plan.street(arm).length())
            }
            n => {
                let least = if n == 2 { CHANGE_M } else { 1.5 };
                (0..n)
                    .filter(|&j| j != i)
                    .map(|j| cut_between(plan, arm, &reaches[i], &reaches[j], n))
                    .fold(least, f64::max)
            }
        };
        plan.streets[arm.stretch].cuts[arm.end] = cut;
    }
}

/// Room for a loop at the end of a two-way road.
fn dead_end_cut(plan: &StreetPlan, arm: StreetSegmentEnd) -> f64 {
    let street = plan.street(arm);
    if street.oneway() { 0.0 } else { (2.5 * DEAD_END_RADIUS_M).min(0.5 * street.length()) }
}

/// Where arm `a` is clear of arm `b`.
fn cut_between(plan: &StreetPlan, arm: StreetSegmentEnd, a: &ArmReach, b: &ArmReach, arms: usize) -> f64 {
    let theta = wrap_angle(angle(b.outwards) - angle(a.outwards)).abs();
    let apart = a.line[0].distance(b.line[0]);
    if theta > 2.75 && apart < 1.0 {
        return 0.0;
    }
    let parallel = theta < 0.35;
    if parallel && apart > 1.0 && apart + 0.3 > a.left.min(a.right) + b.left.min(b.right) {
        return 0.0;
    }
    let radius = if arms == 2 { 2.0 } else { a.corner_m.min(b.corner_m) };
    let clear = if parallel { 0.4 } else { radius * (1.0 + cos(theta)).min(1.2) };
    let mut d = 0.5;
    while d < if parallel { a.most_beside.min(b.most_beside) } else { a.most } {
        let worst = [a.left, 0.0, -a.right]
            .into_iter()
            .map(|t| outside(b, plan.arm_point(arm, d, t).truncate()))
            .fold(f64::INFINITY, f64::min);
        if worst > clear {
            return d;
        }
        d += STEP_M;
    }
    // It never is: they run side by side.
    if parallel { 12.0f64.min(a.most) } else { a.most }
}

/// Joins intersections whose streets between them are swallowed by their cuts; returns the intersections that changed.
fn contract(plan: &mut StreetPlan) -> Vec<usize> {
    let mut short: Vec<(f64, usize)> = Vec::new();
    for (i, street) in plan.streets.iter().enumerate() {
        let [a, b] = street.intersections;
        let real = |k: usize| plan.intersections[k].arms.len() > 2;
        if a == b || inside(plan, i) || !(real(a) && real(b)) {
            continue;
        }
        let length = street.length();
        let swallowed = street.cuts[0] + street.cuts[1] + SHORTEST_M > length && length < 45.0;
        let near = length < NEAR_M;
        if if street.roundabout { length < 3.0 || (swallowed && length < 9.0) } else { swallowed || near } {
            short.push((length, i));
        }
    }
    short.sort_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
    let mut touched: Vec<usize> = Vec::new();
    for (_, street) in short {
        let [a, b] = plan.streets[street].intersections;
        if touched.contains(&a) || touched.contains(&b) || a == b || !may_join(plan, a, b) {
            continue;
        }
        join(plan, a, b);
        touched.push(a);
    }
    touched
}

fn inside(plan: &StreetPlan, street: usize) -> bool {
    let s = &plan.streets[street];
    s.intersections[0] == s.intersections[1] && plan.intersections[s.intersections[0]].inside.contains(&street)
}

fn node_places(plan: &StreetPlan, intersection: usize) -> Vec<DVec2> {
    let k = &plan.intersections[intersection];
    let ends = k.arms.iter().map(|&arm| plan.arm_point(arm, 0.0, 0.0).truncate());
    ends.chain(k.inside.iter().flat_map(|&s| {
        let line = plan.streets[s].line.points();
        [line[0].truncate(), line[line.len() - 1].truncate()]
    }))
    .collect()
}

fn may_join(plan: &StreetPlan, a: usize, b: usize) -> bool {
    let (pa, pb) = (node_places(plan, a), node_places(plan, b));
    let widest = pa.iter().flat_map(|p| pb.iter().map(|q| p.distance(*q))).fold(0.0, f64::max);
    let ring = |k: usize| plan.intersections[k].arms.iter().any(|&arm| plan.street(arm).roundabout);
    if plan.intersections[a].arms.len() + plan.intersections[b].arms.len() > MOST_ARMS {
        return false;
    }
    widest < if ring(a) && ring(b) { 16.0 } else { WIDEST_M }
}

/// Makes intersection `b` part of intersection `a`; short streets between them come to lie inside.
pub(super) fn join(plan: &mut StreetPlan, a: usize, b: usize) {
    let moved = std::mem::take(&mut plan.intersections[b]);
    for arm in &moved.arms {
        plan.streets[arm.stretch].intersections[arm.end] = a;
    }
    for &street in &moved.inside {
        plan.streets[street].intersections = [a, a];
    }
    let intersection = &mut plan.intersections[a];
    let weight = intersection.nodes.len() as f64;
    let other = moved.nodes.len() as f64;
    intersection.at = (intersection.at * weight + moved.at * other) / (weight + other);
    intersection.nodes.extend(moved.nodes);
    intersection.inside.extend(moved.inside);
    intersection.arms.extend(moved.arms);
    let swallowed: Vec<usize> = {
        let arms = &plan.intersections[a].arms;
        let both = |s: usize| arms.iter().filter(|e| e.stretch == s).count() == 2;
        let mut list: Vec<usize> = arms.iter().map(|e| e.stretch).filter(|&s| both(s)).collect();
        list.sort_unstable();
        list.dedup();
        list.retain(|&s| plan.streets[s].length() < 45.0);
        list
    };
    let intersection = &mut plan.intersections[a];
    intersection.arms.retain(|e| !swallowed.contains(&e.stretch));
    intersection.inside.extend(swallowed);
}

/// Leaves something of every street.
fn fit(plan: &mut StreetPlan, street: usize) {
    let s = &mut plan.streets[street];
    let length = s.length();
    let room = length - SHORTEST_M.min(0.4 * length);
    let asked = s.cuts[0] + s.cuts[1];
    if asked > room {
        let scale = room / asked;
        s.cuts = s.cuts.map(|c| c * scale);
    }
}

/// Arms that leave side by side, as the two carriageways of one road do, begin side by side.
fn align(plan: &mut StreetPlan, intersection: usize) {
    let arms = plan.intersections[intersection].arms.clone();
    if plan.intersections[intersection].nodes.len() < 2 || arms.len() < 3 {
        return;
    }
    let ends: Vec<(DVec2, DVec2)> = arms
        .iter()
        .map(|&arm| {
            let cut = plan.cut(arm);
            (plan.arm_point(arm, cut, 0.0).truncate(), plan.arm_direction(arm, cut))
        })
        .collect();
    for i in 0..arms.len() {
        let (p, u) = ends[i];
        let further = (0..arms.len())
            .filter(|&j| j != i && ends[j].1.dot(u) > 0.92 && (ends[j].0 - p).perp_dot(u).abs() < 30.0)
            .map(|j| (ends[j].0 - p).dot(u))
            .fold(0.0, f64::max);
        let street = &mut plan.streets[arms[i].stretch];
        let other = street.cuts[1 - arms[i].end];
        let most = street.length() - other - SHORTEST_M;
        let cut = &mut street.cuts[arms[i].end];
        if further > 0.3 && further < 15.0 {
            *cut = (*cut + further).min(most.max(*cut));
        }
    }
}
