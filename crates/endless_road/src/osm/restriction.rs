//! Turn restrictions, and which ways lead through a junction of several nodes.

use super::extract::{OsmExtract, OsmMemberKind};
use super::graph::StreetSegmentEnd;
use super::plan::StreetPlan;
use std::collections::{BTreeMap, BTreeSet};

/// Who may not turn where.
#[derive(Debug, Clone, Default)]
pub(super) struct Restrictions {
    /// From way, via node, to way.
    forbidden: BTreeSet<(i64, i64, i64)>,
    /// From way and via node: the only ways on.
    only: BTreeMap<(i64, i64), BTreeSet<i64>>,
}

impl Restrictions {
    /// From the relations of an extract. Those for a kind of vehicle only, or for hours of the day, do not count.
    pub(super) fn new(extract: &OsmExtract) -> Self {
        let mut restrictions = Self::default();
        for relation in extract.relations.iter().filter(|r| r.tags.is("type", &["restriction"])) {
            let Some(rule) = relation.tags.get("restriction").or_else(|| relation.tags.get("restriction:motorcar"))
            else {
                continue;
            };
            let role = |role: &str, kind: OsmMemberKind| -> Vec<i64> {
                relation.members.iter().filter(|m| m.role == role && m.kind == kind).map(|m| m.id).collect()
            };
            let (from, to) = (role("from", OsmMemberKind::Way), role("to", OsmMemberKind::Way));
            for &via in &role("via", OsmMemberKind::Node) {
                for &from in &from {
                    for &to in &to {
                        if rule.starts_with("no_") {
                            restrictions.forbidden.insert((from, via, to));
                        } else if rule.starts_with("only_") {
                            restrictions.only.entry((from, via)).or_default().insert(to);
                        }
                    }
                }
            }
        }
        restrictions
    }

    fn allowed(&self, from: i64, via: i64, to: i64) -> bool {
        !self.forbidden.contains(&(from, via, to)) && self.only.get(&(from, via)).is_none_or(|only| only.contains(&to))
    }

    /// Whether an intersection may be entered by one arm and left by another: along the streets inside it, in their direction,
    /// without turning back there, and against no restriction.
    pub(super) fn allow(
        &self,
        plan: &StreetPlan,
        intersection: usize,
        from: StreetSegmentEnd,
        to: StreetSegmentEnd,
    ) -> bool {
        let node_of = |arm: StreetSegmentEnd| plan.street(arm).nodes[arm.end];
        let way_of = |arm: StreetSegmentEnd| plan.street(arm).ways[arm.end];
        let goal = (node_of(to), way_of(to));
        let inside = &plan.intersections[intersection].inside;
        let mut seen: BTreeSet<(i64, i64, usize)> = BTreeSet::new();
        let mut open = vec![(node_of(from), way_of(from), usize::MAX)];
        while let Some((node, way, by)) = open.pop() {
            if !seen.insert((node, way, by)) {
                continue;
            }
            if node == goal.0 && self.allowed(way, node, goal.1) {
                return true;
            }
            for &street in inside.iter().filter(|&&s| s != by) {
                let data = &plan.streets[street];
                for end in 0..2 {
                    let leads = !data.section.lanes(end == 0).is_empty();
                    if data.nodes[end] == node && leads && self.allowed(way, node, data.ways[end]) {
                        open.push((data.nodes[1 - end], data.ways[1 - end], street));
                    }
                }
            }
        }
        false
    }
}
