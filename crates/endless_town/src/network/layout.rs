//! From a layout's bent grid to streets between junctions.

use super::plan::{Arm, Node, Plan, Rule, Street, angle, on_road, rounded};
use super::{Profile, cut};
use crate::character::{Along, Layout};
use endless_road::Polyline;
use endless_world::Stream;
use glam::DVec2;

/// Radius of the ring road's corners, metres.
const RING_CORNER_M: f64 = 26.0;
/// Distance between points of reference lines, metres.
const STEP_M: f64 = 2.0;

/// A piece of a grid line between neighbouring grid points.
struct Piece {
    ends: [usize; 2],
    points: Vec<DVec2>,
    profile: Profile,
}

/// Lays out the streets of a town.
pub(crate) fn lay_out(layout: &Layout, seed: u64) -> Plan {
    let grid = Grid::new(layout, seed);
    let pieces = grid.pieces(layout);
    let mut plan = join(&grid.points, pieces);
    sort_arms(&mut plan);
    for node in 0..plan.nodes.len() {
        decide_rule(&mut plan, node, layout, seed);
    }
    cut::cut_streets(&mut plan, layout.corner_m);
    plan
}

struct Grid {
    nx: usize,
    ny: usize,
    points: Vec<DVec2>,
}

impl Grid {
    fn new(layout: &Layout, seed: u64) -> Self {
        let (nx, ny) = (layout.xs.len(), layout.ys.len());
        let mut points = Vec::with_capacity(nx * ny);
        for j in 0..ny {
            for i in 0..nx {
                let mut stream = Stream::named(seed, "town/grid", &[i as u64, j as u64]);
                // The ring bends less, so that it stays convex enough to close the town off.
                let inner_x = i > 0 && i + 1 < nx;
                let inner_y = j > 0 && j + 1 < ny;
                let sway = |inner: bool, x: f64| layout.bend_m * x * if inner { 1.0 } else { 0.35 };
                let corner = !inner_x && !inner_y;
                let dx = stream.range_f64(-1.0, 1.0);
                let dy = stream.range_f64(-1.0, 1.0);
                let stray = if corner { DVec2::ZERO } else { DVec2::new(sway(inner_x, dx), sway(inner_y, dy)) };
                points.push(DVec2::new(layout.xs[i], layout.ys[j]) + stray);
            }
        }
        Self { nx, ny, points }
    }

    fn index(&self, i: usize, j: usize) -> usize {
        j * self.nx + i
    }

    fn pieces(&self, layout: &Layout) -> Vec<Piece> {
        let mut pieces = Vec::new();
        for j in 0..self.ny {
            let line: Vec<usize> = (0..self.nx).map(|i| self.index(i, j)).collect();
            self.line_pieces(layout, Along::Row, j, &line, layout.rows[j], &mut pieces);
        }
        for i in 0..self.nx {
            let line: Vec<usize> = (0..self.ny).map(|j| self.index(i, j)).collect();
            self.line_pieces(layout, Along::Column, i, &line, layout.columns[i], &mut pieces);
        }
        pieces
    }

    /// Hermite pieces through a grid line's points, smooth across them.
    fn line_pieces(
        &self,
        layout: &Layout,
        along: Along,
        line: usize,
        nodes: &[usize],
        profile: Profile,
        out: &mut Vec<Piece>,
    ) {
        let axis = if along == Along::Row { DVec2::X } else { DVec2::Y };
        let tangent = |k: usize| {
            if k == 0 || k + 1 == nodes.len() {
                axis
            } else {
                (self.points[nodes[k + 1]] - self.points[nodes[k - 1]]).normalize_or(axis)
            }
        };
        for k in 0..nodes.len() - 1 {
            if layout.gaps.contains(&(along, line, k)) {
                continue;
            }
            let (a, b) = (self.points[nodes[k]], self.points[nodes[k + 1]]);
            let span = a.distance(b);
            let (u, v) = (tangent(k) * span, tangent(k + 1) * span);
            let steps = (span / STEP_M).ceil() as usize;
            let points = (0..=steps)
                .map(|i| {
                    let t = i as f64 / steps as f64;
                    let (t2, t3) = (t * t, t * t * t);
                    a * (2.0 * t3 - 3.0 * t2 + 1.0)
                        + u * (t3 - 2.0 * t2 + t)
                        + b * (3.0 * t2 - 2.0 * t3)
                        + v * (t3 - t2)
                })
                .collect();
            out.push(Piece { ends: [nodes[k], nodes[k + 1]], points, profile });
        }
    }
}

/// Joins pieces that meet where no other street does, and numbers what is left.
fn join(points: &[DVec2], mut pieces: Vec<Piece>) -> Plan {
    for node in 0..points.len() {
        let here: Vec<usize> = (0..pieces.len()).filter(|&p| pieces[p].ends.contains(&node)).collect();
        let [first, second] = here[..] else { continue };
        let back = pieces.remove(second);
        let front = pieces.remove(first);
        pieces.push(join_two(front, back, node));
    }
    let mut used: Vec<usize> = pieces.iter().flat_map(|p| p.ends).collect();
    used.sort_unstable();
    used.dedup();
    let number = |grid: usize| used.binary_search(&grid).expect("every end is used");
    let nodes = used
        .iter()
        .map(|_| Node { arms: Vec::new(), main: Vec::new(), rule: Rule::Yield, signals: Vec::new() })
        .collect();
    let streets = pieces
        .into_iter()
        .map(|p| Street {
            ends: p.ends.map(number),
            path: Polyline::new(p.points.into_iter().map(on_road)),
            profile: p.profile,
            cuts: [0.0; 2],
            stops: [0.0; 2],
            crossings: Vec::new(),
            lanes: [Vec::new(), Vec::new()],
        })
        .collect();
    Plan { streets, nodes }
}

/// One piece out of two that share `node`; a corner is rounded.
fn join_two(mut front: Piece, mut back: Piece, node: usize) -> Piece {
    if front.ends[1] != node {
        front.points.reverse();
        front.ends.reverse();
    }
    if back.ends[0] != node {
        back.points.reverse();
        back.ends.reverse();
    }
    let profile = if front.profile.priority >= back.profile.priority { front.profile } else { back.profile };
    let ends = [front.ends[0], back.ends[1]];
    let heading_in = (front.points[front.points.len() - 1] - front.points[front.points.len() - 2]).normalize();
    let heading_out = (back.points[1] - back.points[0]).normalize();
    let mut points = front.points;
    if heading_in.dot(heading_out) > 0.9 {
        points.extend(back.points.into_iter().skip(1));
    } else {
        let drop = (RING_CORNER_M / STEP_M) as usize;
        points.truncate(points.len() - drop.min(points.len() / 2));
        let rest = &back.points[drop.min(back.points.len() / 2)..];
        let (a, b) = (points[points.len() - 1], rest[0]);
        let u = (a - points[points.len() - 2]).normalize();
        let v = (rest[1] - rest[0]).normalize();
        let arc = rounded(a, u, b, v, 0.0, 24);
        points.extend(&arc[1..arc.len() - 1]);
        points.extend(rest);
    }
    Piece { ends, points, profile }
}

fn sort_arms(plan: &mut Plan) {
    for node in 0..plan.nodes.len() {
        let mut arms: Vec<Arm> = (0..plan.streets.len())
            .flat_map(|street| [0, 1].map(|end| Arm { street, end }))
            .filter(|arm| plan.streets[arm.street].ends[arm.end] == node)
            .collect();
        arms.sort_by(|&a, &b| angle(plan.arm_direction(a, 15.0)).total_cmp(&angle(plan.arm_direction(b, 15.0))));
        plan.nodes[node].arms = arms;
    }
}

/// Finds the main road through a junction and how the others wait for it.
fn decide_rule(plan: &mut Plan, index: usize, layout: &Layout, seed: u64) {
    let node = &plan.nodes[index];
    let n = node.arms.len();
    let mut best = (i32::MIN, 0, 0);
    for i in 0..n {
        for j in i + 1..n {
            let (a, b) = (node.arms[i], node.arms[j]);
            let straight = plan.arm_direction(a, 15.0).dot(plan.arm_direction(b, 15.0)) < -0.7;
            let rank = i32::from(plan.arm_profile(a).priority) + i32::from(plan.arm_profile(b).priority);
            let score = rank + if straight { 100 } else { 0 };
            if score > best.0 {
                best = (score, i, j);
            }
        }
    }
    let main: Vec<bool> = (0..n).map(|k| k == best.1 || k == best.2).collect();
    let minor = (0..n).filter(|&k| !main[k]).map(|k| plan.arm_profile(node.arms[k]).priority).max().unwrap_or(0);
    let mut stream = Stream::named(seed, "town/rule", &[index as u64]);
    let rule = if minor >= layout.signals_from {
        Rule::Signals
    } else if stream.chance(0.5) {
        Rule::Stop
    } else {
        Rule::Yield
    };
    let node = &mut plan.nodes[index];
    node.main = main;
    node.rule = rule;
}
