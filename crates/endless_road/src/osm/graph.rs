//! From ways to a graph: street segments between the intersections where they meet.

use super::class::RoadClass;
use super::import_context::ImportContext;
use super::street_segment::StreetSegment;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// The end of a street segment at an intersection.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct StreetSegmentEnd {
    pub(super) stretch: usize,
    /// 0 for its beginning, 1 for its end.
    pub(super) end: usize,
}

/// Takes away what is there twice: of roads between the same two nodes the most important one stays.
pub(super) fn without_duplicates(stretches: &[StreetSegment], context: &mut ImportContext<'_>) -> Vec<StreetSegment> {
    let mut order: Vec<usize> = (0..stretches.len()).collect();
    order.sort_by_key(|&i| (Reverse(stretches[i].class), i));
    let mut taken: BTreeSet<(i64, i64)> = BTreeSet::new();
    let mut parts: Vec<Vec<StreetSegment>> = vec![Vec::new(); stretches.len()];
    for i in order {
        let stretch = &stretches[i];
        let mut from = 0;
        let last = stretch.vertices.len() - 1;
        for k in 0..last {
            let [a, b] = [k, k + 1].map(|k| stretch.vertices[k].node);
            if !taken.insert((a.min(b), a.max(b))) {
                context.note(format!("way {}", stretch.ways[0]), "runs twice between the same nodes: once is enough");
                if k > from {
                    parts[i].push(stretch.part(from, k));
                }
                from = k + 1;
            }
        }
        if last > from {
            parts[i].push(stretch.part(from, last));
        }
    }
    parts.into_iter().flatten().collect()
}

/// Cuts stretches where they share nodes.
pub(super) fn split(stretches: &[StreetSegment]) -> Vec<StreetSegment> {
    let mut uses: BTreeMap<i64, usize> = BTreeMap::new();
    for stretch in stretches {
        let last = stretch.vertices.len() - 1;
        for (i, vertex) in stretch.vertices.iter().enumerate() {
            // A node inside a stretch that another touches is a place to cut; ends count alike.
            *uses.entry(vertex.node).or_default() += if i == 0 || i == last { 1 } else { 2 };
        }
    }
    let mut parts = Vec::new();
    for stretch in stretches {
        let mut from = 0;
        let last = stretch.vertices.len() - 1;
        for i in 1..=last {
            if i == last || uses[&stretch.vertices[i].node] > 2 {
                parts.push(stretch.part(from, i));
                from = i;
            }
        }
    }
    parts
}

/// The ends at each node.
pub(super) fn ends(stretches: &[StreetSegment]) -> BTreeMap<i64, Vec<StreetSegmentEnd>> {
    let mut ends: BTreeMap<i64, Vec<StreetSegmentEnd>> = BTreeMap::new();
    for (stretch, data) in stretches.iter().enumerate() {
        for end in 0..2 {
            ends.entry(data.end_node(end)).or_default().push(StreetSegmentEnd { stretch, end });
        }
    }
    ends
}

/// Parts yards and blind alleys from the roads: what leads nowhere is paved, but nobody circulates there.
pub(super) fn part_yards(stretches: Vec<StreetSegment>) -> (Vec<StreetSegment>, Vec<StreetSegment>) {
    let only_service = stretches.iter().all(|s| s.class == RoadClass::Service);
    if only_service {
        return (stretches, Vec::new());
    }
    let mut gone: Vec<bool> = stretches.iter().map(|s| s.yard).collect();
    let ends = ends(&stretches);
    loop {
        let mut changed = false;
        for (node, at) in &ends {
            let left: Vec<usize> = at.iter().map(|e| e.stretch).filter(|&s| !gone[s]).collect();
            if let [only] = left[..]
                && stretches[only].class == RoadClass::Service
            {
                let _ = node;
                gone[only] = true;
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
    let (mut roads, mut yards) = (Vec::new(), Vec::new());
    for (stretch, gone) in stretches.into_iter().zip(gone) {
        if gone { yards.push(stretch) } else { roads.push(stretch) }
    }
    (roads, yards)
}

/// Joins stretches that merely follow one another.
pub(super) fn merge(stretches: Vec<StreetSegment>) -> Vec<StreetSegment> {
    let mut slots: Vec<Option<StreetSegment>> = stretches.into_iter().map(Some).collect();
    let all: Vec<StreetSegment> = slots.iter().flatten().cloned().collect();
    let mut at = ends(&all);
    let nodes: Vec<i64> = at.iter().filter(|(_, e)| e.len() == 2).map(|(n, _)| *n).collect();
    for node in nodes {
        let [a, b] = at[&node][..] else { continue };
        if a.stretch == b.stretch {
            continue;
        }
        let (Some(first), Some(second)) = (slots[a.stretch].clone(), slots[b.stretch].clone()) else { continue };
        // The first towards the node, the second away from it.
        let first = if a.end == 1 { first } else { first.reversed() };
        let second = if b.end == 0 { second } else { second.reversed() };
        if !alike(&first, &second) {
            continue;
        }
        let far = second.end_node(1);
        let joined = join(first, second);
        if let Some(list) = at.get_mut(&far) {
            for end in list.iter_mut().filter(|e| **e == (StreetSegmentEnd { stretch: b.stretch, end: 1 - b.end })) {
                *end = StreetSegmentEnd { stretch: a.stretch, end: 1 };
            }
        }
        let near = joined.end_node(0);
        if let Some(list) = at.get_mut(&near) {
            for end in list.iter_mut().filter(|e| **e == (StreetSegmentEnd { stretch: a.stretch, end: 1 - a.end })) {
                *end = StreetSegmentEnd { stretch: a.stretch, end: 0 };
            }
        }
        slots[a.stretch] = Some(joined);
        slots[b.stretch] = None;
        at.remove(&node);
    }
    slots.into_iter().flatten().collect()
}

/// A stretch shorter than this does not change a road's section, metres.
const SCRAP_M: f64 = 16.0;

/// Gives short pieces of a road the section of what they follow, where their lanes are the same: bays that begin a car's
/// length before a junction would make a road of steps.
pub(super) fn without_scraps(mut stretches: Vec<StreetSegment>) -> Vec<StreetSegment> {
    let lanes = |s: &StreetSegment| (s.section.lanes(true).len(), s.section.lanes(false).len());
    for _ in 0..3 {
        let ends = ends(&stretches);
        for i in 0..stretches.len() {
            if stretches[i].length() > SCRAP_M {
                continue;
            }
            let neighbours = (0..2).filter_map(|end| {
                let [a, b] = ends[&stretches[i].end_node(end)][..] else { return None };
                let other = if a.stretch == i { b } else { a };
                // Running the same way, or turned round.
                Some((other.stretch, other.end != end))
            });
            let longest = neighbours
                .filter(|&(other, _)| other != i && stretches[other].length() > stretches[i].length())
                .max_by(|a, b| stretches[a.0].length().total_cmp(&stretches[b.0].length()));
            if let Some((other, same)) = longest {
                let section = &stretches[other].section;
                let section = if same { section.clone() } else { section.reversed() };
                let own = lanes(&stretches[i]);
                if own == (section.lanes(true).len(), section.lanes(false).len())
                    && stretches[i].class == stretches[other].class
                {
                    stretches[i].section = section;
                }
            }
        }
    }
    stretches
}

fn alike(a: &StreetSegment, b: &StreetSegment) -> bool {
    a.section.continues(&b.section) && a.link == b.link && a.roundabout == b.roundabout && a.class == b.class
}

fn join(mut a: StreetSegment, b: StreetSegment) -> StreetSegment {
    let (la, lb) = (a.length(), b.length());
    a.speed_mps = (a.speed_mps * la + b.speed_mps * lb) / (la + lb).max(1e-9);
    a.vertices.extend(&b.vertices[1..]);
    a.levels.extend(b.levels);
    a.ways[1] = b.ways[1];
    a
}
