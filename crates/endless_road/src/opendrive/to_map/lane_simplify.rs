//! Simplifies the graph of lanes: lanes that go on in the next section become one, tapers are trimmed, and very short lanes
//! are joined to their neighbours.

use super::lanes::{LaneGraph, LaneNode, SHORTEST_M, middle_width};
use glam::DVec3;
use std::collections::BTreeMap;

/// Lanes that widen from nothing begin at this share of their width.
const WIDE_ENOUGH: f64 = 0.9;

impl LaneGraph {
    /// Makes one lane of those that simply go on in the next section, and lets none be very short.
    pub(super) fn simplify(&mut self) {
        self.join_sections();
        self.trim_tapers();
        self.join_short();
    }

    /// A lane that nothing leads into begins where it is wide enough, and one that leads nowhere ends there: what widens
    /// from nothing beside another lane would lie on it.
    fn trim_tapers(&mut self) {
        for node in self.nodes.iter_mut().filter(|node| !node.gone && node.junction.is_none()) {
            let enough = WIDE_ENOUGH * middle_width(node);
            let narrow = |width: &&f64| **width < enough;
            let first = if node.before.is_empty() { node.widths.iter().take_while(narrow).count() } else { 0 };
            let last = if node.next.is_empty() { node.widths.iter().rev().take_while(narrow).count() } else { 0 };
            let end = node.points.len() - last;
            if first + last == 0 || first + 2 > end {
                continue;
            }
            // Exactly where it is wide enough.
            let between = |from: usize, to: usize| {
                let share = ((enough - node.widths[from]) / (node.widths[to] - node.widths[from])).clamp(0.0, 1.0);
                node.points[from].lerp(node.points[to], share)
            };
            let (mut points, mut widths) = (node.points[first..end].to_vec(), node.widths[first..end].to_vec());
            if first > 0 {
                points.insert(0, between(first - 1, first));
                widths.insert(0, enough);
            }
            if last > 0 {
                points.push(between(end, end - 1));
                widths.push(enough);
            }
            (node.points, node.widths) = (points, widths);
        }
    }

    /// Sections whose lanes in one direction follow one another one to one are joined, all lanes at once: lanes side
    /// by side stay side by side.
    fn join_sections(&mut self) {
        // Lanes by road, direction and section.
        let mut sides: BTreeMap<(usize, bool), BTreeMap<usize, Vec<usize>>> = BTreeMap::new();
        for (&key, &node) in &self.owner {
            sides.entry((key.road, self.nodes[node].along)).or_default().entry(key.section).or_default().push(node);
        }
        for ((_, along), sections) in sides {
            let mut order: Vec<(usize, Vec<usize>)> = sections.into_iter().collect();
            if !along {
                order.reverse();
            }
            let mut heads: Vec<usize> = Vec::new();
            let mut last_section = None;
            for (section, nodes) in order {
                let adjacent = last_section.is_some_and(|last: usize| last.abs_diff(section) == 1);
                let follows = |graph: &Self, tail: usize| match graph.nodes[tail].next[..] {
                    [next] => (graph.nodes[next].before.len() == 1 && nodes.contains(&next)).then_some(next),
                    _ => None,
                };
                let matches =
                    adjacent && heads.len() == nodes.len() && heads.iter().all(|&head| follows(self, head).is_some());
                if matches {
                    for head in heads.clone() {
                        if let Some(next) = follows(self, head) {
                            self.append(head, next);
                        }
                    }
                } else {
                    heads = nodes;
                }
                last_section = Some(section);
            }
        }
    }

    /// `next`, which alone follows `node` and follows it alone, becomes part of it.
    fn append(&mut self, node: usize, next: usize) {
        let taken = std::mem::take(&mut self.nodes[next].points);
        let widths = std::mem::take(&mut self.nodes[next].widths);
        let keys = std::mem::take(&mut self.nodes[next].keys);
        let after = std::mem::take(&mut self.nodes[next].next);
        self.nodes[next].gone = true;
        for &key in &keys {
            self.owner.insert(key, node);
        }
        for &later in &after {
            for before in &mut self.nodes[later].before {
                if *before == next {
                    *before = node;
                }
            }
        }
        let target = &mut self.nodes[node];
        extend(&mut target.points, &mut target.widths, &taken, &widths);
        target.keys.extend(keys);
        target.next = after;
    }

    fn join_short(&mut self) {
        for short in 0..self.nodes.len() {
            if !self.nodes[short].gone && self.nodes[short].length() < SHORTEST_M {
                self.join_one(short);
            }
        }
    }

    /// Makes a short lane part of those before or after it; where it merges with others it becomes part of each.
    fn join_one(&mut self, short: usize) {
        let LaneNode { before, next, .. } = self.nodes[short].clone();
        let only = |list: &[usize]| (list.len() == 1 && list[0] != short).then(|| list[0]);
        if let Some(after) = only(&next).filter(|&after| self.nodes[after].before.len() == 1) {
            let kept = self.nodes[after].junction;
            self.append(short, after);
            self.nodes[short].junction = kept;
            return;
        }
        if let Some(earlier) = only(&before).filter(|&earlier| self.nodes[earlier].next.len() == 1) {
            self.append(earlier, short);
            return;
        }
        let leads_only_here = |list: &[usize], of: &dyn Fn(usize) -> usize| {
            !list.is_empty() && !list.contains(&short) && list.iter().all(|&other| of(other) == 1)
        };
        if leads_only_here(&before, &|other| self.nodes[other].next.len()) {
            let LaneNode { points, widths, .. } = self.nodes[short].clone();
            for &earlier in &before {
                let node = &mut self.nodes[earlier];
                extend(&mut node.points, &mut node.widths, &points, &widths);
            }
            self.bypass(short, before[0]);
        } else if leads_only_here(&next, &|other| self.nodes[other].before.len()) {
            let LaneNode { points, widths, .. } = self.nodes[short].clone();
            for &later in &next {
                let node = &mut self.nodes[later];
                let (mut all, mut all_widths) = (points.clone(), widths.clone());
                extend(&mut all, &mut all_widths, &node.points, &node.widths);
                (node.points, node.widths) = (all, all_widths);
            }
            self.bypass(short, next[0]);
        } else if before.is_empty() || next.is_empty() || self.nodes[short].length() < 0.5 {
            let heir = before.first().or(next.first()).copied().unwrap_or(short);
            self.bypass(short, heir);
        }
    }

    /// Drops a lane; those before it lead to those after it.
    fn bypass(&mut self, short: usize, heir: usize) {
        let LaneNode { before, next, keys, .. } = self.nodes[short].clone();
        for &earlier in &before {
            let list = &mut self.nodes[earlier].next;
            list.retain(|&n| n != short);
            for &later in next.iter().filter(|&&later| later != short) {
                if !list.contains(&later) {
                    list.push(later);
                }
            }
        }
        for &later in &next {
            let list = &mut self.nodes[later].before;
            list.retain(|&n| n != short);
            for &earlier in before.iter().filter(|&&earlier| earlier != short) {
                if !list.contains(&earlier) {
                    list.push(earlier);
                }
            }
        }
        for key in keys {
            if heir == short {
                self.owner.remove(&key);
            } else {
                self.owner.insert(key, heir);
            }
        }
        let node = &mut self.nodes[short];
        (node.before, node.next, node.gone) = (Vec::new(), Vec::new(), true);
    }
}

/// Puts a line after another; of two points nearly in one place the first is kept.
fn extend(points: &mut Vec<DVec3>, widths: &mut Vec<f64>, more: &[DVec3], more_widths: &[f64]) {
    let end = points[points.len() - 1];
    let skip = usize::from(more.len() > 1 && more[0].distance(end) < 0.1);
    points.extend(&more[skip..]);
    widths.extend(&more_widths[skip..]);
}
