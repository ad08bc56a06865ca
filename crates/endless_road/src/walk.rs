//! Ways on foot.

use crate::{WalkEdgeId, WalkKind, WalkNetwork, WalkNodeId};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Crossing a road is worth this detour, metres.
const CROSSING_COST_M: f64 = 8.0;

/// The walk network with the edges at each node, for searching.
#[derive(Debug, Clone, PartialEq)]
pub struct WalkGraph {
    /// Edges at each node, ascending.
    edges_at: Vec<Vec<WalkEdgeId>>,
    /// Number of the connected part each node lies in.
    part: Vec<u32>,
}

/// A cost as an ordered key, millimetres: whole numbers order without surprises.
fn millimetres(metres: f64) -> u64 {
    (metres * 1000.0) as u64
}

impl WalkGraph {
    /// The graph of a network.
    pub fn new(walk: &WalkNetwork) -> Self {
        let mut edges_at = vec![Vec::new(); walk.nodes.len()];
        for (place, edge) in walk.edges.iter().enumerate() {
            for node in edge.nodes {
                edges_at[node.index()].push(WalkEdgeId(place as u32));
            }
        }
        let mut graph = Self { edges_at, part: vec![u32::MAX; walk.nodes.len()] };
        let mut parts = 0;
        for root in 0..walk.nodes.len() {
            if graph.part[root] == u32::MAX {
                graph.flood(walk, root, parts);
                parts += 1;
            }
        }
        graph
    }

    fn flood(&mut self, walk: &WalkNetwork, root: usize, number: u32) {
        let mut open = vec![root];
        self.part[root] = number;
        while let Some(node) = open.pop() {
            for edge in &self.edges_at[node] {
                for next in walk.edges[edge.index()].nodes {
                    if self.part[next.index()] == u32::MAX {
                        self.part[next.index()] = number;
                        open.push(next.index());
                    }
                }
            }
        }
    }

    /// Edges at a node.
    pub fn edges_at(&self, node: WalkNodeId) -> &[WalkEdgeId] {
        &self.edges_at[node.index()]
    }

    /// Number of the connected part a node lies in.
    pub fn part(&self, node: WalkNodeId) -> u32 {
        self.part[node.index()]
    }

    /// The shortest way (Dijkstra 1959), as edges with the node each leads to; empty if there is none, or nothing to
    /// walk. Crossings cost a little extra.
    pub fn shortest(&self, walk: &WalkNetwork, from: WalkNodeId, to: WalkNodeId) -> Vec<(WalkEdgeId, WalkNodeId)> {
        if from == to || self.part(from) != self.part(to) {
            return Vec::new();
        }
        let mut best = vec![u64::MAX; walk.nodes.len()];
        let mut came_by: Vec<Option<(WalkEdgeId, WalkNodeId)>> = vec![None; walk.nodes.len()];
        let mut queue = BinaryHeap::from([Reverse((0, from))]);
        best[from.index()] = 0;
        while let Some(Reverse((cost, node))) = queue.pop() {
            if node == to {
                break;
            }
            if cost > best[node.index()] {
                continue;
            }
            for &edge_id in self.edges_at(node) {
                let edge = &walk.edges[edge_id.index()];
                let next = if edge.nodes[0] == node { edge.nodes[1] } else { edge.nodes[0] };
                let extra = if edge.kind == WalkKind::Sidewalk { 0.0 } else { CROSSING_COST_M };
                let length = walk.nodes[node.index()].distance(walk.nodes[next.index()]);
                let through = cost + millimetres(length + extra);
                if through < best[next.index()] {
                    best[next.index()] = through;
                    came_by[next.index()] = Some((edge_id, node));
                    queue.push(Reverse((through, next)));
                }
            }
        }
        let mut way = Vec::new();
        let mut node = to;
        while let Some((edge, before)) = came_by[node.index()] {
            way.push((edge, node));
            node = before;
        }
        way.reverse();
        way
    }
}
