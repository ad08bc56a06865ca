//! Paint: lines along streets, bays, crossings, stop lines and arrows.

use super::PAINT_M;
use super::street::{BAY_M, bays};
use super::strip::patch;
use crate::character::Character;
use crate::network::{Arm, Node, Plan, Rule, Street};
use crate::palette::{WHITE_PAINT, YELLOW_PAINT};
use endless_road::{RoadNetwork, Turn};
use endless_scene::{Material, MeshBuilder};
use glam::{DVec2, Vec2};

/// Width of lines along the street.
const LINE_M: f64 = 0.12;
/// Lane lines are unbroken this far before a stop line.
const SOLID_M: f64 = 14.0;

pub(crate) fn add_street(mesh: &mut MeshBuilder, street: &Street, character: &Character) {
    add_centre(mesh, street, if character.yellow_centre { YELLOW_PAINT } else { WHITE_PAINT });
    add_lane_lines(mesh, street);
    add_edges(mesh, street);
    for crossing in &street.crossings {
        let (s, half) = (crossing.s, crossing.width / 2.0);
        let kerb = street.profile.kerb() - 0.35;
        if crossing.signal.is_some() && !character.layout.zebra_everywhere {
            for edge in [s - half, s + half - 0.25] {
                patch(mesh, street, (edge, edge + 0.25), (-kerb, kerb), PAINT_M, WHITE_PAINT);
            }
        } else {
            add_zebra(mesh, street, (s - half, s + half), kerb);
        }
    }
}

fn line(mesh: &mut MeshBuilder, street: &Street, range: (f64, f64), t: f64, paint: Material) {
    patch(mesh, street, range, (t - LINE_M / 2.0, t + LINE_M / 2.0), PAINT_M, paint);
}

/// Parts of a range that no crossing covers.
fn between_crossings(street: &Street, (from, to): (f64, f64)) -> Vec<(f64, f64)> {
    let mut cuts: Vec<_> = street.crossings.iter().filter(|c| c.s > from && c.s < to).collect();
    cuts.sort_by(|a, b| a.s.total_cmp(&b.s));
    let mut start = from;
    let mut parts = Vec::new();
    for c in cuts {
        parts.push((start, c.s - c.width / 2.0 - 1.2));
        start = c.s + c.width / 2.0 + 1.2;
    }
    parts.push((start, to));
    parts.retain(|(a, b)| b - a > 1.0);
    parts
}

fn dashes(mesh: &mut MeshBuilder, street: &Street, (from, to): (f64, f64), t: f64, paint: Material) {
    let mut s = from;
    while s + 1.0 < to {
        line(mesh, street, (s, (s + 3.0).min(to)), t, paint);
        s += 7.5;
    }
}

fn add_centre(mesh: &mut MeshBuilder, street: &Street, paint: Material) {
    let profile = &street.profile;
    for (from, to) in between_crossings(street, street.lane_range()) {
        if profile.median > 0.0 {
            for t in [-1.0, 1.0] {
                line(mesh, street, (from, to), t * (profile.median / 2.0 + 0.2), paint);
            }
        } else if profile.lanes > 1 {
            for t in [-0.12, 0.12] {
                line(mesh, street, (from, to), t, paint);
            }
        } else if profile.priority > 1 {
            let solid = SOLID_M.min((to - from) / 3.0);
            line(mesh, street, (from, from + solid), 0.0, paint);
            line(mesh, street, (to - solid, to), 0.0, paint);
            dashes(mesh, street, (from + solid + 3.0, to - solid - 1.5), 0.0, paint);
        } else {
            dashes(mesh, street, (from + 1.0, to - 1.0), 0.0, paint);
        }
    }
}

fn add_lane_lines(mesh: &mut MeshBuilder, street: &Street) {
    let profile = &street.profile;
    for k in 1..profile.lanes {
        let t = profile.median / 2.0 + k as f64 * profile.lane;
        for (from, to) in between_crossings(street, street.lane_range()) {
            let solid = SOLID_M.min((to - from) / 3.0);
            // Unbroken towards the stop line of each direction.
            line(mesh, street, (to - solid, to), -t, WHITE_PAINT);
            dashes(mesh, street, (from + 2.0, to - solid - 2.0), -t, WHITE_PAINT);
            line(mesh, street, (from, from + solid), t, WHITE_PAINT);
            dashes(mesh, street, (from + solid + 3.0, to - 1.0), t, WHITE_PAINT);
        }
    }
}

/// Edge lines where nobody parks, bays where they do.
fn add_edges(mesh: &mut MeshBuilder, street: &Street) {
    let profile = &street.profile;
    let edge = profile.lane_edge();
    if profile.parking == 0.0 {
        if profile.priority > 1 {
            for (from, to) in between_crossings(street, street.lane_range()) {
                line(mesh, street, (from, to), edge - 0.08, WHITE_PAINT);
                line(mesh, street, (from, to), 0.08 - edge, WHITE_PAINT);
            }
        }
        return;
    }
    for s in bays(street) {
        let half = BAY_M / 2.0;
        for side in [-1.0, 1.0] {
            let across = |a: f64, b: f64| if side > 0.0 { (a, b) } else { (-b, -a) };
            patch(
                mesh,
                street,
                (s - half, s - half + 0.1),
                across(edge + 0.1, edge + profile.parking),
                PAINT_M,
                WHITE_PAINT,
            );
            patch(mesh, street, (s - half, s + half), across(edge, edge + 0.1), PAINT_M, WHITE_PAINT);
        }
    }
}

fn add_zebra(mesh: &mut MeshBuilder, street: &Street, range: (f64, f64), kerb: f64) {
    const BAR_M: f64 = 0.5;
    let bars = (kerb / BAR_M).floor() as i32;
    // Bars and gaps of equal width, a bar in the middle.
    for k in (-bars..=bars).filter(|k| k % 2 == 0) {
        let t = f64::from(k) * BAR_M;
        if t.abs() + BAR_M / 2.0 <= kerb {
            patch(mesh, street, range, (t - BAR_M / 2.0, t + BAR_M / 2.0), PAINT_M, WHITE_PAINT);
        }
    }
}

/// Stop and give-way lines and the arrows before them.
pub(crate) fn add_node(mesh: &mut MeshBuilder, plan: &Plan, network: &RoadNetwork, node: &Node) {
    for (k, &arm) in node.arms.iter().enumerate() {
        let (profile, stop) = (plan.arm_profile(arm), plan.arm_stop(arm));
        let lanes = (profile.median / 2.0 + 0.15, profile.lane_edge() - 0.15);
        let waits = node.rule == Rule::Signals || !node.main[k];
        if waits && node.rule != Rule::Yield {
            arm_patch(mesh, plan, arm, (stop - 0.1, stop + 0.35), lanes);
        } else if waits {
            let mut t = lanes.0;
            while t + 0.5 <= lanes.1 {
                arm_patch(mesh, plan, arm, (stop, stop + 0.35), (t, t + 0.5));
                t += 0.8;
            }
        }
        if profile.lanes > 1 {
            for (l, &lane) in plan.lanes_in(arm).iter().enumerate() {
                let turns: Vec<Turn> =
                    network.lane(lane).successors.iter().map(|&next| network.lane(next).turn).collect();
                for back in [5.0, 26.0] {
                    add_arrow(mesh, plan, arm, (stop + back, profile.lane_centre(l)), &turns);
                }
            }
        }
    }
}

/// A patch given in an arm's own distances: out from the junction, and left looking outwards.
fn arm_patch(mesh: &mut MeshBuilder, plan: &Plan, arm: Arm, (d0, d1): (f64, f64), (l0, l1): (f64, f64)) {
    let street = &plan.streets[arm.street];
    let (a, b) = (plan.arm_s(arm, d0), plan.arm_s(arm, d1));
    let across = if arm.end == 0 { (l0, l1) } else { (-l1, -l0) };
    patch(mesh, street, (a.min(b), a.max(b)), across, PAINT_M, WHITE_PAINT);
}

/// An arrow on a lane, its foot `distance` out from the junction, pointing in.
fn add_arrow(mesh: &mut MeshBuilder, plan: &Plan, arm: Arm, (distance, left): (f64, f64), turns: &[Turn]) {
    let street = &plan.streets[arm.street];
    if distance + 5.0 > street.length() / 2.0 || street.near_crossing(plan.arm_s(arm, distance + 2.0), 6.0) {
        return;
    }
    // In the driver's frame: x forward, y left.
    let place = |p: DVec2| plan.arm_point(arm, distance + 4.0 - p.x, left - p.y).as_vec2().extend(PAINT_M);
    let mut triangle = |corners: [DVec2; 3]| {
        let turned = (corners[1] - corners[0]).perp_dot(corners[2] - corners[0]) < 0.0;
        let corners = if turned { [corners[0], corners[2], corners[1]] } else { corners };
        mesh.triangle(corners.map(place), corners.map(|p| p.as_vec2() + Vec2::splat(4.0)), WHITE_PAINT);
    };
    let mut quad = |a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]| {
        let [a, b, c, d] = [a, b, c, d].map(DVec2::from_array);
        triangle([a, b, c]);
        triangle([a, c, d]);
    };
    let straight = turns.contains(&Turn::Straight);
    let shaft = if straight { 2.6 } else { 2.0 };
    quad([0.0, -0.08], [shaft, -0.08], [shaft, 0.08], [0.0, 0.08]);
    if straight {
        triangle([DVec2::new(2.6, -0.3), DVec2::new(4.0, 0.0), DVec2::new(2.6, 0.3)]);
    }
    for (turn, side) in [(Turn::Left, 1.0), (Turn::Right, -1.0)] {
        if turns.contains(&turn) {
            // The branch leaves the shaft and bends outwards to its head.
            let y = |y: f64| side * y;
            let mut tri = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| triangle([a, b, c].map(DVec2::from_array));
            tri([1.5, y(0.08)], [2.2, y(0.5)], [1.95, y(0.62)]);
            tri([1.5, y(0.08)], [1.95, y(0.62)], [1.2, y(0.08)]);
            tri([1.6, y(0.62)], [2.5, y(0.42)], [2.15, y(1.05)]);
        }
    }
}
