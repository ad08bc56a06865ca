//! From a binary tree to an eight-wide one, by dynamic programming over the surface area heuristic
//! (after Ylitie, Karras, Laine: Efficient incoherent ray traversal on GPUs, HPG 2017, section 3.1).

use glam::Vec3A;
use obvhs::bvh2::Bvh2;
use wide::f32x8;

use super::node::{BvhNode, EMPTY_BOX, NodeLink, union};

/// Costs of intersection tests, relative to one test of a node's eight boxes.
#[derive(Clone, Copy, Debug)]
pub(super) struct SahCosts {
    /// Test of one group of primitives in a leaf.
    pub(super) group: f32,
    /// Primitives per group.
    pub(super) group_size: u32,
    /// Most primitives in one leaf.
    pub(super) max_leaf: u32,
}

/// An eight-wide tree. Children come after their parents.
#[derive(Clone, Debug)]
pub(super) struct Bvh {
    pub(super) nodes: Vec<BvhNode>,
    pub(super) root: NodeLink,
}

impl Bvh {
    /// A tree of nothing.
    pub(super) fn empty() -> Self {
        Bvh { nodes: Vec::new(), root: NodeLink::EMPTY }
    }

    /// Computes all boxes bottom-up from those of the leaves and returns the box around everything.
    pub(super) fn fit(&mut self, mut leaf_box: impl FnMut(NodeLink) -> (Vec3A, Vec3A)) -> (Vec3A, Vec3A) {
        let mut boxes = vec![EMPTY_BOX; self.nodes.len()];
        for (index, node) in self.nodes.iter_mut().enumerate().rev() {
            let mut children = [EMPTY_BOX; 8];
            for (child, &link) in children.iter_mut().zip(&node.links) {
                *child = match link {
                    NodeLink::EMPTY => continue,
                    leaf if leaf.is_leaf() => leaf_box(leaf),
                    inner => boxes[inner.node()],
                };
            }
            node.set_boxes(&children);
            boxes[index] = children.into_iter().fold(EMPTY_BOX, union);
        }
        match self.root {
            NodeLink::EMPTY => EMPTY_BOX,
            root if root.is_leaf() => leaf_box(root),
            root => boxes[root.node()],
        }
    }
}

/// Collapses a binary tree with one piece per leaf, of `size` things each; `leaf` stores a run of pieces and says where.
/// Boxes are left to `Bvh::fit`.
pub(super) fn collapse(
    source: &Bvh2,
    costs: SahCosts,
    size: impl Fn(u32) -> u32,
    leaf: impl FnMut(&[u32]) -> NodeLink,
) -> Bvh {
    if source.nodes.is_empty() {
        return Bvh::empty();
    }
    let plan = plan(source, costs, size);
    // More than are ever needed: what is not touched costs nothing, and growing does.
    let nodes = Vec::with_capacity(source.primitive_indices.len() / 2 + 1);
    let mut writer = NodeWriter { source, plan: &plan, nodes, leaf, open: Vec::new(), pieces: Vec::new() };
    let root = writer.link(0);
    let mut open = Vec::new();
    if root == NodeLink::inner(0) {
        writer.nodes.push(BvhNode::EMPTY);
        open.push((0, 0));
    }
    while let Some((from, to)) = open.pop() {
        writer.write(from, to, &mut open);
    }
    let mut nodes = writer.nodes;
    nodes.shrink_to_fit();
    Bvh { nodes, root }
}

/// The best way to represent one binary subtree.
#[derive(Clone, Copy)]
struct CollapsePlan {
    /// Least cost of the subtree as at most `i + 1` child slots.
    cost: [f32; 8],
    /// With at most `i + 1` slots: how many go to the left child; 0 for "as with one slot fewer".
    left: [u8; 8],
    /// As a node of its own: how many of its eight slots go to the left child; 0 for a leaf.
    own_left: u8,
    things: u32,
}

fn plan(source: &Bvh2, costs: SahCosts, size: impl Fn(u32) -> u32) -> Vec<CollapsePlan> {
    let blank = CollapsePlan { cost: [0.0; 8], left: [0; 8], own_left: 0, things: 1 };
    let mut plans = vec![blank; source.nodes.len()];
    let mut parents_first = Vec::with_capacity(source.nodes.len());
    let mut open = vec![0];
    while let Some(index) = open.pop() {
        parents_first.push(index);
        let node = &source.nodes[index];
        if !node.is_leaf() {
            open.extend([node.first_index as usize + 1, node.first_index as usize]);
        }
    }
    for &index in parents_first.iter().rev() {
        let node = &source.nodes[index];
        let area = node.aabb().half_area();
        if node.is_leaf() {
            let things = size(source.primitive_indices[node.first_index as usize]);
            plans[index] = CollapsePlan { cost: [area * costs.group; 8], things, ..blank };
        } else {
            let (left, right) = (&plans[node.first_index as usize], &plans[node.first_index as usize + 1]);
            plans[index] = plan_inner(left, right, area, costs);
        }
    }
    plans
}

fn plan_inner(left: &CollapsePlan, right: &CollapsePlan, area: f32, costs: SahCosts) -> CollapsePlan {
    let things = left.things + right.things;
    let as_leaf = if things <= costs.max_leaf {
        area * costs.group * things.div_ceil(costs.group_size) as f32
    } else {
        f32::INFINITY
    };
    let (children, ks) = shares(&left.cost, &right.cost);
    let as_node = children[7] + area;
    let mut plan = CollapsePlan { cost: [as_leaf; 8], left: [0; 8], own_left: 0, things };
    // Not `<`: costs that overflow must not make a leaf of everything.
    if !(as_leaf <= as_node && things <= costs.max_leaf) {
        plan.cost[0] = as_node;
        plan.own_left = ks[7].max(1);
    }
    for i in 1..8 {
        plan.cost[i] = plan.cost[i - 1];
        if children[i] < plan.cost[i - 1] {
            (plan.cost[i], plan.left[i]) = (children[i], ks[i]);
        }
    }
    plan
}

/// Least cost of two subtrees that share `i + 1` slots, and how many of these the left one then takes: the first of
/// equals; 0 where they cannot share.
fn shares(left: &[f32; 8], right: &[f32; 8]) -> ([f32; 8], [u8; 8]) {
    // What the right one costs with the slots left over, for every number of slots at once.
    let mut over = [f32::INFINITY; 16];
    over[8..].copy_from_slice(right);
    let (mut best, mut taken) = (f32x8::splat(f32::INFINITY), f32x8::ZERO);
    for k in 1..8 {
        let rest: [f32; 8] = std::array::from_fn(|i| over[8 - k + i]);
        let cost = f32x8::splat(left[k - 1]) + f32x8::new(rest);
        let better = cost.simd_lt(best);
        best = better.select(cost, best);
        taken = better.select(f32x8::splat(k as f32), taken);
    }
    (best.to_array(), taken.to_array().map(|k| k as u8))
}

struct NodeWriter<'a, F> {
    source: &'a Bvh2,
    plan: &'a [CollapsePlan],
    nodes: Vec<BvhNode>,
    leaf: F,
    /// Subtrees of a leaf still to visit.
    open: Vec<usize>,
    pieces: Vec<u32>,
}

impl<F: FnMut(&[u32]) -> NodeLink> NodeWriter<'_, F> {
    /// The link to a binary subtree that takes one slot: a stored leaf, or the next free node.
    fn link(&mut self, index: usize) -> NodeLink {
        if self.plan[index].own_left > 0 {
            return NodeLink::inner(self.nodes.len());
        }
        self.pieces.clear();
        self.open.push(index);
        while let Some(index) = self.open.pop() {
            let node = &self.source.nodes[index];
            let first = node.first_index as usize;
            if node.is_leaf() {
                self.pieces.extend(&self.source.primitive_indices[first..first + node.prim_count as usize]);
            } else {
                self.open.extend([first + 1, first]);
            }
        }
        (self.leaf)(&self.pieces)
    }

    /// Fills node `to` from binary subtree `from`; its inner children get the next nodes, side by side.
    fn write(&mut self, from: usize, to: usize, open: &mut Vec<(usize, usize)>) {
        let mut children = NodeChildren { areas: [0.0; 8], nodes: [0; 8], count: 0 };
        let first = self.source.nodes[from].first_index as usize;
        let left = self.plan[from].own_left as usize;
        self.children(first, left, &mut children);
        self.children(first + 1, 8 - left, &mut children);
        let before = open.len();
        for (slot, &child) in children.nodes[..children.count].iter().enumerate() {
            let link = self.link(child);
            self.nodes[to].links[slot] = link;
            if !link.is_leaf() {
                open.push((child, self.nodes.len()));
                self.nodes.push(BvhNode::EMPTY);
            }
        }
        open[before..].reverse();
    }

    /// The subtrees that fill at most `slots` slots for `index`.
    fn children(&self, index: usize, mut slots: usize, out: &mut NodeChildren) {
        let plan = &self.plan[index];
        while slots > 1 && plan.left[slots - 1] == 0 {
            slots -= 1;
        }
        if slots == 1 {
            out.insert(index, self.source.nodes[index].aabb().half_area());
            return;
        }
        let first = self.source.nodes[index].first_index as usize;
        let left = plan.left[slots - 1] as usize;
        self.children(first, left, out);
        self.children(first + 1, slots - left, out);
    }
}

/// Up to eight subtrees, large boxes first: any-hit traversal takes children in this order.
struct NodeChildren {
    areas: [f32; 8],
    nodes: [usize; 8],
    count: usize,
}

impl NodeChildren {
    /// After those that are as large.
    fn insert(&mut self, node: usize, area: f32) {
        let mut at = self.count;
        while at > 0 && self.areas[at - 1].total_cmp(&area).is_lt() {
            (self.areas[at], self.nodes[at]) = (self.areas[at - 1], self.nodes[at - 1]);
            at -= 1;
        }
        (self.areas[at], self.nodes[at]) = (area, node);
        self.count += 1;
    }
}
