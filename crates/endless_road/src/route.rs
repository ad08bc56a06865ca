//! Ways through the lanes: what can be reached, and a random way that never ends.

use crate::{Lane, LaneId, RoadNetwork, Turn};
use endless_world::Stream;
use std::collections::BTreeMap;

impl RoadNetwork {
    /// The number of each lane's strongly connected component over successors and lane changes (Tarjan 1972).
    /// Lanes of the same number can reach one another.
    pub fn lane_components(&self) -> Vec<u32> {
        Tarjan::new(self).run()
    }

    /// For every lane the share of the lanes joined to it, however they are directed, that can be reached from it by
    /// successors and lane changes; 1 for all.
    pub fn lane_reach(&self) -> Vec<f64> {
        let component = self.lane_components();
        let whole = self.joined_lanes();
        let mut size: BTreeMap<u32, usize> = BTreeMap::new();
        for &part in &whole {
            *size.entry(part).or_default() += 1;
        }
        // All lanes of a component reach the same lanes.
        let mut reached: BTreeMap<u32, usize> = BTreeMap::new();
        let mut seen = vec![usize::MAX; self.lanes.len()];
        for start in 0..self.lanes.len() {
            reached.entry(component[start]).or_insert_with(|| {
                let mut open = vec![start];
                let mut count = 0;
                seen[start] = start;
                while let Some(lane) = open.pop() {
                    count += 1;
                    for next in neighbours(&self.lanes[lane]) {
                        if std::mem::replace(&mut seen[next.index()], start) != start {
                            open.push(next.index());
                        }
                    }
                }
                count
            });
        }
        (0..self.lanes.len()).map(|i| reached[&component[i]] as f64 / size[&whole[i]] as f64).collect()
    }

    /// The number of the part of the network that each lane is joined to, however it is directed.
    fn joined_lanes(&self) -> Vec<u32> {
        let mut joined: Vec<Vec<usize>> = vec![Vec::new(); self.lanes.len()];
        for lane in &self.lanes {
            for next in neighbours(lane) {
                joined[lane.id.index()].push(next.index());
                joined[next.index()].push(lane.id.index());
            }
        }
        let mut part = vec![UNSEEN; self.lanes.len()];
        let mut parts = 0;
        for root in 0..self.lanes.len() {
            if part[root] != UNSEEN {
                continue;
            }
            let mut open = vec![root];
            part[root] = parts;
            while let Some(lane) = open.pop() {
                for &next in &joined[lane] {
                    if std::mem::replace(&mut part[next], parts) == UNSEEN {
                        open.push(next);
                    }
                }
            }
            parts += 1;
        }
        part
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
        let weight = |next: &LaneId| match self.lane(*next).turn {
            Turn::Straight => 2.0,
            Turn::Left | Turn::Right => 1.0,
            Turn::UTurn => 0.02,
        };
        let weights: Vec<f64> = choices.iter().map(weight).zip(preference(&choices)).map(|(w, p)| w * p).collect();
        Some(choices[stream.weighted(&weights)])
    }
}

/// Tarjan's algorithm with its own stack, so that large maps do not exhaust the thread's.
struct Tarjan<'a> {
    network: &'a RoadNetwork,
    index: Vec<u32>,
    low: Vec<u32>,
    component: Vec<u32>,
    stack: Vec<usize>,
    next_index: u32,
    next_component: u32,
}

const UNSEEN: u32 = u32::MAX;

impl<'a> Tarjan<'a> {
    fn new(network: &'a RoadNetwork) -> Self {
        let n = network.lanes.len();
        Self {
            network,
            index: vec![UNSEEN; n],
            low: vec![0; n],
            component: vec![UNSEEN; n],
            stack: Vec::new(),
            next_index: 0,
            next_component: 0,
        }
    }

    fn run(mut self) -> Vec<u32> {
        for root in 0..self.network.lanes.len() {
            if self.index[root] == UNSEEN {
                self.visit(root);
            }
        }
        self.component
    }

    fn visit(&mut self, root: usize) {
        let mut calls = vec![(root, neighbours(&self.network.lanes[root]))];
        self.open(root);
        while let Some((v, rest)) = calls.last_mut() {
            let v = *v;
            if let Some(w) = rest.pop() {
                let w = w.index();
                if self.index[w] == UNSEEN {
                    self.open(w);
                    calls.push((w, neighbours(&self.network.lanes[w])));
                } else if self.component[w] == UNSEEN {
                    self.low[v] = self.low[v].min(self.index[w]);
                }
                continue;
            }
            calls.pop();
            if let Some(&(parent, _)) = calls.last() {
                self.low[parent] = self.low[parent].min(self.low[v]);
            }
            if self.low[v] == self.index[v] {
                while let Some(w) = self.stack.pop() {
                    self.component[w] = self.next_component;
                    if w == v {
                        break;
                    }
                }
                self.next_component += 1;
            }
        }
    }

    fn open(&mut self, v: usize) {
        self.index[v] = self.next_index;
        self.low[v] = self.next_index;
        self.next_index += 1;
        self.stack.push(v);
    }
}

fn neighbours(lane: &Lane) -> Vec<LaneId> {
    lane.successors.iter().chain(&lane.left).chain(&lane.right).copied().collect()
}
