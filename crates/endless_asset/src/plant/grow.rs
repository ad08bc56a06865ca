//! Growth of wood by space colonisation (Runions, Lane, Prusinkiewicz 2007): branches grow towards points of light
//! that they use up; their thickness follows from what they bear (pipe model).

use crate::shape::Sculpt;
use endless_scene::Material;
use endless_world::{Stream, math};
use glam::Vec3;

/// Length of one step of growth, metres, and how near a branch uses up a point of light.
const STEP_M: f32 = 0.30;
const USED_UP_M: f32 = 0.52;
/// Radius of the thinnest twigs, metres, and the exponent of the pipe model.
const TWIG_M: f32 = 0.009;
const PIPE: f32 = 2.35;
const MOST_STEPS: usize = 120;

/// A point of the wood.
#[derive(Debug, Clone, Copy)]
pub(super) struct BranchNode {
    pub(super) at: Vec3,
    pub(super) parent: usize,
    pub(super) radius: f32,
    /// How many branches leave it.
    pub(super) children: usize,
}

/// Grows a trunk up to its fork and on towards the light; `droop` bends young wood down (or up, below zero).
pub(super) fn grow(fork_m: f32, trunk_m: f32, droop: f32, mut light: Vec<Vec3>, s: &mut Stream) -> Vec<BranchNode> {
    let mut nodes: Vec<BranchNode> = Vec::new();
    let steps = (fork_m / STEP_M).ceil().max(2.0) as usize;
    let lean = Vec3::new(s.range_f32(-0.10, 0.10), s.range_f32(-0.10, 0.10), 0.0);
    for k in 0..=steps {
        let t = k as f32 / steps as f32;
        let sway = Vec3::new(math::sin(5.0 * t), math::cos(4.0 * t) - 1.0, 0.0) * 0.03;
        let at = Vec3::Z * (fork_m * t - 0.05) + lean * t * t + sway;
        nodes.push(BranchNode { at, parent: k.saturating_sub(1), radius: 0.0, children: 0 });
    }
    // The nearest node of each point, kept up to date with new nodes alone.
    let nearest = |p: Vec3, nodes: &[BranchNode], from: usize, best: (f32, usize)| {
        nodes.iter().enumerate().skip(from).fold(best, |best, (i, n)| {
            let d = n.at.distance_squared(p);
            if d < best.0 { (d, i) } else { best }
        })
    };
    let mut known: Vec<(f32, usize)> = light.iter().map(|&p| nearest(p, &nodes, steps / 2, (f32::MAX, 0))).collect();
    for _ in 0..MOST_STEPS {
        let mut pull = vec![Vec3::ZERO; nodes.len()];
        for (p, (_, i)) in light.iter().zip(&known) {
            pull[*i] += (*p - nodes[*i].at).normalize_or_zero();
        }
        let before = nodes.len();
        for i in 0..before {
            if pull[i] == Vec3::ZERO {
                continue;
            }
            let way = (pull[i].normalize_or(Vec3::Z) - Vec3::Z * droop + super::leaf::direction(s) * 0.12)
                .normalize_or(Vec3::Z);
            let at = nodes[i].at + way * STEP_M;
            // Two points that pull one node about equally would grow the same twig for ever.
            let grown = nodes.iter().skip(i + 1).any(|n| n.parent == i && n.at.distance(at) < 0.45 * STEP_M);
            if !grown {
                nodes.push(BranchNode { at, parent: i, radius: 0.0, children: 0 });
            }
        }
        if nodes.len() == before {
            break;
        }
        for (p, best) in light.iter().zip(&mut known) {
            *best = nearest(*p, &nodes, before, *best);
        }
        let kept: Vec<bool> = known.iter().map(|k| k.0 > USED_UP_M * USED_UP_M).collect();
        let mut keep = kept.iter();
        light.retain(|_| *keep.next().unwrap_or(&false));
        let mut keep = kept.iter();
        known.retain(|_| *keep.next().unwrap_or(&false));
    }
    thicken(&mut nodes, trunk_m);
    nodes
}

/// Radii from the twigs down, so that the foot has that of the trunk.
fn thicken(nodes: &mut [BranchNode], trunk_m: f32) {
    let mut load = vec![0.0f32; nodes.len()];
    for i in (1..nodes.len()).rev() {
        load[i] = load[i].max(1.0);
        load[nodes[i].parent] += load[i];
        nodes[nodes[i].parent].children += 1;
    }
    let whole = load[0].max(2.0);
    // The exponent that brings the foot to its radius with twigs of theirs.
    let exponent = (math::ln(trunk_m / TWIG_M) / math::ln(whole)).clamp(0.2, 1.0 / PIPE + 0.25);
    for (node, load) in nodes.iter_mut().zip(load) {
        node.radius = TWIG_M * math::pow(load.max(1.0), exponent);
    }
}

/// The wood as tubes: each branch follows its thickest child.
pub(super) fn wood(nodes: &[BranchNode], material: Material) -> Sculpt {
    let mut heir = vec![usize::MAX; nodes.len()];
    for (i, node) in nodes.iter().enumerate().skip(1) {
        let best = &mut heir[node.parent];
        if *best == usize::MAX || nodes[*best].radius < node.radius {
            *best = i;
        }
    }
    let mut s = Sculpt::new();
    for first in 0..nodes.len() {
        let starts = first == 0 || heir[nodes[first].parent] != first;
        if !starts {
            continue;
        }
        let mut path = Vec::new();
        if first > 0 {
            path.push((nodes[nodes[first].parent].at, nodes[first].radius));
        }
        let mut at = first;
        loop {
            // Roots spread at the foot.
            let flare = 1.0 + 0.55 * (1.0 - nodes[at].at.z / 0.5).clamp(0.0, 1.0) * f32::from(u8::from(first == 0));
            path.push((nodes[at].at, nodes[at].radius * flare));
            if heir[at] == usize::MAX {
                break;
            }
            at = heir[at];
        }
        if path.len() < 2 {
            continue;
        }
        let thick = path[0].1;
        let sides = if thick > 0.09 {
            10
        } else if thick > 0.035 {
            6
        } else {
            3
        };
        s.add(Sculpt::tube(&path, sides, material));
    }
    s
}
