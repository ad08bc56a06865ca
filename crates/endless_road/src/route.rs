//! Ways through the lanes: what can be reached, and a random way that never ends.

use crate::{Lane, LaneId, RoadNetwork, Turn};
use endless_world::Stream;
use petgraph::algo::kosaraju_scc;
use petgraph::graph::{DiGraph, NodeIndex};
use petgraph::unionfind::UnionFind;
use petgraph::visit::{Dfs, EdgeRef};
use std::collections::BTreeMap;

impl RoadNetwork {
    /// The number of each lane's strongly connected component over successors and lane changes. Lanes of the same
    /// number can reach one another.
    pub fn lane_components(&self) -> Vec<u32> {
        components(&self.lane_graph())
    }

    /// For every lane the share of the lanes joined to it, however they are directed, that can be reached from it by
    /// successors and lane changes; 1 for all.
    pub fn lane_reach(&self) -> Vec<f64> {
        let graph = self.lane_graph();
        let component = components(&graph);
        let mut joined = UnionFind::<u32>::new(self.lanes.len());
        for edge in graph.edge_references() {
            joined.union(edge.source().index() as u32, edge.target().index() as u32);
        }
        let whole = joined.into_labeling();
        let mut size: BTreeMap<u32, usize> = BTreeMap::new();
        for &part in &whole {
            *size.entry(part).or_default() += 1;
        }
        // All lanes of a component reach the same lanes.
        let mut reached: BTreeMap<u32, usize> = BTreeMap::new();
        let mut search = Dfs::empty(&graph);
        for start in graph.node_indices() {
            reached.entry(component[start.index()]).or_insert_with(|| {
                search.reset(&graph);
                search.move_to(start);
                std::iter::from_fn(|| search.next(&graph)).count()
            });
        }
        (0..self.lanes.len()).map(|i| reached[&component[i]] as f64 / size[&whole[i]] as f64).collect()
    }

    /// An edge from each lane to every one that a vehicle may go on to; nodes have the lanes' numbers.
    fn lane_graph(&self) -> DiGraph<(), ()> {
        let mut graph = DiGraph::with_capacity(self.lanes.len(), 2 * self.lanes.len());
        for _ in &self.lanes {
            graph.add_node(());
        }
        for lane in &self.lanes {
            for next in lane.successors.iter().chain(&lane.left).chain(&lane.right) {
                graph.add_edge(NodeIndex::new(lane.id.index()), NodeIndex::new(next.index()), ());
            }
        }
        graph
    }

    /// The lanes among which a vehicle can drive for ever: the largest component by length, without the lanes that
    /// can only be left by changing lanes. Each has a successor among them. All `false` if there is no cycle.
    pub fn circulating_lanes(&self) -> Vec<bool> {
        let component = self.lane_components();
        let count = component.iter().max().map_or(0, |&c| c as usize + 1);
        let mut size = vec![(0.0, 0u32); count];
        for lane in &self.lanes {
            let entry = &mut size[component[lane.id.index()] as usize];
            entry.0 += lane.centerline.length();
            entry.1 += 1;
        }
        let best = (0..count).filter(|&c| size[c].1 > 1).max_by(|&a, &b| size[a].0.total_cmp(&size[b].0));
        let mut stays: Vec<bool> = component.iter().map(|&c| Some(c as usize) == best).collect();
        loop {
            let goes_on = |lane: &Lane| lane.successors.iter().any(|next| stays[next.index()]);
            let stuck: Vec<usize> =
                self.lanes.iter().filter(|l| stays[l.id.index()] && !goes_on(l)).map(|l| l.id.index()).collect();
            if stuck.is_empty() {
                return stays;
            }
            for lane in stuck {
                stays[lane] = false;
            }
        }
    }

    /// The next lane of a random walk: straight on is likelier than turning, turning back is rare. Only lanes that
    /// are `allowed` (indexed by lane); `None` if there is none.
    pub fn next_lane(&self, lane: LaneId, allowed: &[bool], stream: &mut Stream) -> Option<LaneId> {
        self.next_lane_preferring(lane, allowed, |choices| vec![1.0; choices.len()], stream)
    }

    /// The same with a preference: factors on the likelihood of each of the choices it is given.
    pub fn next_lane_preferring(
        &self,
        lane: LaneId,
        allowed: &[bool],
        preference: impl FnOnce(&[LaneId]) -> Vec<f64>,
        stream: &mut Stream,
    ) -> Option<LaneId> {
        let choices: Vec<LaneId> =
            self.lane(lane).successors.iter().copied().filter(|next| allowed[next.index()]).collect();
        if choices.is_empty() {
            return None;
        }
        let weight = |next: &LaneId| likelihood_of(self.lane(*next).turn);
        let weights: Vec<f64> = choices.iter().map(weight).zip(preference(&choices)).map(|(w, p)| w * p).collect();
        Some(choices[stream.weighted(&weights)])
    }
}

/// How likely drivers make a turn, relative to others.
pub fn likelihood_of(turn: Turn) -> f64 {
    match turn {
        Turn::Straight => 2.0,
        Turn::Left | Turn::Right => 1.0,
        Turn::UTurn => 0.02,
    }
}

/// The number of each node's strongly connected component. Kosaraju's algorithm, because `petgraph`'s `tarjan_scc`
/// recurses, so that a long road would exhaust the thread's stack.
fn components(graph: &DiGraph<(), ()>) -> Vec<u32> {
    let mut component = vec![0; graph.node_count()];
    for (number, nodes) in (0..).zip(kosaraju_scc(graph)) {
        for node in nodes {
            component[node.index()] = number;
        }
    }
    component
}
