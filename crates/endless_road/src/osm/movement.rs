//! Ways through an intersection: which arm leads to which, and which lane to which.

use super::curve::angle;
use super::graph::StreetSegmentEnd;
use super::plan::StreetPlan;
use super::restriction::Restrictions;
use super::section::{LaneUse, TurnArrows};
use crate::Turn;
use endless_world::math::f64::wrap_angle;

/// Straight on up to this bend, radians.
const STRAIGHT_RAD: f64 = 0.7;
/// Back from this bend on.
const BACK_RAD: f64 = 2.6;

/// A ring is followed past so many exits.
const MOST_EXITS: usize = 24;

/// From a lane of one arm to a lane of another; bands of their streets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Movement {
    pub(super) from: StreetSegmentEnd,
    pub(super) lane_in: usize,
    pub(super) to: StreetSegmentEnd,
    pub(super) lane_out: usize,
    pub(super) turn: Turn,
}

/// An arm to leave by.
#[derive(Debug, Clone, Copy)]
struct ArmExit {
    to: StreetSegmentEnd,
    turn: Turn,
    /// To the left of straight on, radians.
    bend: f64,
}

/// All movements of an intersection.
pub(super) fn movements(plan: &StreetPlan, intersection: usize, restrictions: &Restrictions) -> Vec<Movement> {
    if let Some([left, right]) = lanes_add_up(plan, intersection) {
        return side_by_side(plan, intersection, left, right);
    }
    let arms = &plan.intersections[intersection].arms;
    let mut all: Vec<Movement> = Vec::new();
    for &from in arms.iter().filter(|&&arm| !plan.lanes_in(arm).is_empty()) {
        let exits = exits(plan, intersection, from, restrictions);
        all.extend(assign(plan, from, &exits));
    }
    connect_unused_lanes(plan, intersection, &mut all);
    all
}

/// Two one-way roads that become one with all their lanes, from left to right: nobody has to give way.
pub(super) fn lanes_add_up(plan: &StreetPlan, intersection: usize) -> Option<[StreetSegmentEnd; 2]> {
    let arms = &plan.intersections[intersection].arms;
    let oneway = arms.iter().all(|&arm| plan.street(arm).oneway() && !plan.street(arm).roundabout);
    let (ins, outs): (Vec<StreetSegmentEnd>, Vec<StreetSegmentEnd>) =
        arms.iter().partition(|&&arm| !plan.lanes_in(arm).is_empty());
    let ([a, b], [to]) = (&ins[..], &outs[..]) else { return None };
    let ahead = bend(plan, *a, *to).abs() < STRAIGHT_RAD && bend(plan, *b, *to).abs() < STRAIGHT_RAD;
    if !oneway || !ahead || plan.lanes_in(*a).len() + plan.lanes_in(*b).len() != plan.lanes_out(*to).len() {
        return None;
    }
    let place = |arm: &StreetSegmentEnd| plan.arm_point(*arm, plan.cut(*arm), 0.0).truncate();
    let to_the_left = plan.arm_direction(*to, plan.cut(*to)).perp_dot(place(a) - place(b)) > 0.0;
    Some(if to_the_left { [*a, *b] } else { [*b, *a] })
}

fn side_by_side(
    plan: &StreetPlan,
    intersection: usize,
    left: StreetSegmentEnd,
    right: StreetSegmentEnd,
) -> Vec<Movement> {
    let to = plan.intersections[intersection].arms.iter().copied().find(|&arm| !plan.lanes_out(arm).is_empty());
    let lanes_in =
        [left, right].into_iter().flat_map(|arm| plan.lanes_in(arm).into_iter().map(move |lane| (arm, lane)));
    let lanes_out = to.into_iter().flat_map(|to| plan.lanes_out(to).into_iter().map(move |lane| (to, lane)));
    lanes_in
        .zip(lanes_out)
        .map(|((from, lane_in), (to, lane_out))| Movement { from, lane_in, to, lane_out, turn: Turn::Straight })
        .collect()
}

fn bend(plan: &StreetPlan, from: StreetSegmentEnd, to: StreetSegmentEnd) -> f64 {
    let heading_in = angle(-plan.arm_direction(from, plan.cut(from)));
    let heading_out = angle(plan.arm_direction(to, plan.cut(to)));
    wrap_angle(heading_out - heading_in)
}

fn exits(plan: &StreetPlan, intersection: usize, from: StreetSegmentEnd, restrictions: &Restrictions) -> Vec<ArmExit> {
    let k = &plan.intersections[intersection];
    let dead_end = k.arms.len() == 1 && !k.open || k.turnaround;
    let mut exits: Vec<ArmExit> = k
        .arms
        .iter()
        .filter(|&&to| !plan.lanes_out(to).is_empty() && (to != from || dead_end))
        .filter(|&&to| dead_end || restrictions.allow(plan, intersection, from, to))
        .map(|&to| {
            let bend = if to == from { std::f64::consts::PI } else { bend(plan, from, to) };
            let turn = match bend {
                b if b.abs() < STRAIGHT_RAD => Turn::Straight,
                b if b.abs() > BACK_RAD => Turn::UTurn,
                b if b > 0.0 => Turn::Left,
                _ => Turn::Right,
            };
            ArmExit { to, turn, bend }
        })
        .collect();
    let ring = plan.street(from).roundabout;
    for exit in exits.iter_mut().filter(|e| ring && plan.street(e.to).roundabout) {
        exit.turn = Turn::Straight;
    }
    if exits.iter().any(|e| e.turn != Turn::UTurn) {
        let arrows = plan.lanes_in(from).iter().any(|&b| arrows(plan, from, b).is_some_and(|a| a.back));
        exits.retain(|e| e.turn != Turn::UTurn || arrows);
    }
    // Of several that lead straight on, the straightest does; the others turn off.
    let score = |e: &ArmExit| e.bend.abs() + if ring && plan.street(e.to).roundabout { -3.0 } else { 0.0 };
    let straightest = exits.iter().filter(|e| e.turn == Turn::Straight).map(score).fold(f64::INFINITY, f64::min);
    let ahead = exits.iter().find(|e| e.turn == Turn::Straight && score(e) <= straightest).map(|e| e.bend);
    for exit in exits.iter_mut().filter(|e| e.turn == Turn::Straight && score(e) > straightest) {
        exit.turn = if exit.bend > ahead.unwrap_or(0.0) { Turn::Left } else { Turn::Right };
    }
    exits.sort_by(|a, b| b.bend.total_cmp(&a.bend));
    exits
}

fn arrows(plan: &StreetPlan, arm: StreetSegmentEnd, band: usize) -> Option<TurnArrows> {
    match plan.street(arm).section.bands[band].what {
        LaneUse::Lane { arrows, .. } => arrows,
        _ => None,
    }
}

fn allows(arrows: TurnArrows, turn: Turn) -> bool {
    match turn {
        Turn::Left => arrows.left,
        Turn::Right => arrows.right,
        Turn::Straight => arrows.through,
        Turn::UTurn => arrows.back,
    }
}

/// Lanes, from left to right, from which an exit may be taken.
fn lanes_for(plan: &StreetPlan, from: StreetSegmentEnd, exit: &ArmExit, exits: &[ArmExit]) -> Vec<usize> {
    let bands = plan.lanes_in(from);
    let n = bands.len();
    let painted: Vec<usize> =
        (0..n).filter(|&k| arrows(plan, from, bands[k]).is_some_and(|a| allows(a, exit.turn))).collect();
    if !painted.is_empty() {
        return painted;
    }
    let has = |turn: Turn| exits.iter().any(|e| e.turn == turn);
    let out = plan.lanes_out(exit.to).len();
    if plan.street(from).roundabout && !plan.street(exit.to).roundabout {
        // Nobody changes lanes in a ring: who enters on the inside must get out again, where most lanes lead out.
        let widest = out >= widest_exit(plan, from);
        return (if widest { 0 } else { n - out.min(n) }..n).collect();
    }
    match exit.turn {
        Turn::Straight => {
            let (mut first, mut last) = (0, n);
            if has(Turn::Left) && last - first > 1 && (last - first > out || n > 2) {
                first += 1;
            }
            if has(Turn::Right) && last - first > out.max(1) {
                last -= 1;
            }
            (first..last).collect()
        }
        Turn::Left if !has(Turn::Straight) => (0..if has(Turn::Right) { (n / 2).max(1) } else { n }).collect(),
        Turn::Right if !has(Turn::Straight) => (if has(Turn::Left) { n / 2 } else { 0 }..n).collect(),
        Turn::Left => vec![0],
        Turn::Right => vec![n - 1],
        Turn::UTurn if exits.len() == 1 => (0..n).collect(),
        Turn::UTurn => vec![0],
    }
}

/// The most lanes that lead out of the ring of an arm, at any of its exits.
fn widest_exit(plan: &StreetPlan, from: StreetSegmentEnd) -> usize {
    let (mut at, mut most) = (from, 0);
    for _ in 0..MOST_EXITS {
        let street = plan.street(at);
        let arms = &plan.intersections[street.intersections[at.end]].arms;
        let outwards = |ring: bool| {
            arms.iter().filter(move |&&arm| plan.street(arm).roundabout == ring && !plan.lanes_out(arm).is_empty())
        };
        most = outwards(false).map(|&arm| plan.lanes_out(arm).len()).fold(most, usize::max);
        let Some(next) = outwards(true).next() else { break };
        at = StreetSegmentEnd { end: 1 - next.end, ..*next };
        if at == from {
            break;
        }
    }
    most
}

fn assign(plan: &StreetPlan, from: StreetSegmentEnd, exits: &[ArmExit]) -> Vec<Movement> {
    let bands = plan.lanes_in(from);
    let n = bands.len();
    let mut out: Vec<Movement> = Vec::new();
    let mut add = |k: usize, exit: &ArmExit, lane_out: usize| {
        let movement = Movement { from, lane_in: bands[k], to: exit.to, lane_out, turn: exit.turn };
        if !out.contains(&movement) {
            out.push(movement);
        }
    };
    let mut used = vec![false; n];
    for exit in exits {
        let ways_out = plan.lanes_out(exit.to);
        let m = ways_out.len();
        let lanes = lanes_for(plan, from, exit, exits);
        let from_left = matches!(exit.turn, Turn::Left | Turn::UTurn);
        for (place, &k) in lanes.iter().enumerate() {
            let j = if from_left { place.min(m - 1) } else { (m - 1).saturating_sub(lanes.len() - 1 - place) };
            // Straight over from the left: a lane too many on the other side stays empty.
            used[k] = true;
            add(k, exit, ways_out[j]);
        }
    }
    // No lane ends here: one without a way takes its neighbour's.
    for k in (0..n).filter(|&k| !used[k]) {
        let nearest = (0..n).filter(|&o| used[o]).min_by_key(|o| o.abs_diff(k));
        let Some(exit) = nearest.and_then(|o| {
            let lane = bands[o];
            exits.iter().filter(|e| lanes_for(plan, from, e, exits).iter().any(|&l| bands[l] == lane)).min_by(|a, b| {
                let off = |e: &ArmExit| if k > o { e.bend } else { -e.bend };
                off(a).total_cmp(&off(b))
            })
        }) else {
            continue;
        };
        let ways_out = plan.lanes_out(exit.to);
        let m = ways_out.len();
        add(k, exit, ways_out[if nearest.is_some_and(|o| k > o) { m - 1 } else { 0 }]);
    }
    out
}

/// Lanes that nobody leads to are fed from the lane beside the one that is, or from the straightest arm.
fn connect_unused_lanes(plan: &StreetPlan, intersection: usize, all: &mut Vec<Movement>) {
    let arms = plan.intersections[intersection].arms.clone();
    for &to in &arms {
        let ways_out = plan.lanes_out(to);
        let fed: Vec<bool> =
            ways_out.iter().map(|&lane| all.iter().any(|m| m.to == to && m.lane_out == lane)).collect();
        for j in (0..ways_out.len()).filter(|&j| !fed[j]) {
            let near = |m: &&Movement| {
                let place = ways_out.iter().position(|&l| l == m.lane_out).unwrap_or(0);
                (m.turn != Turn::Straight, place.abs_diff(j))
            };
            let model = all.iter().filter(|m| m.to == to).min_by_key(near).copied();
            if let Some(model) = model {
                // The lane on the side towards which the road widens.
                let place = ways_out.iter().position(|&l| l == model.lane_out).unwrap_or(0);
                let same = all.iter().filter(|m| m.to == to && m.from == model.from && m.lane_out == model.lane_out);
                let bands = plan.lanes_in(model.from);
                let rank = |m: &&Movement| bands.iter().position(|&b| b == m.lane_in).unwrap_or(0);
                let best = if j < place { same.min_by_key(rank) } else { same.max_by_key(rank) };
                let chosen = best.copied().unwrap_or(model);
                all.push(Movement { lane_out: ways_out[j], ..chosen });
            }
        }
    }
}
