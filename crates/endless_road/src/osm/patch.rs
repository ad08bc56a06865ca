//! Patches of land: closed ways and multipolygons, as outlines with holes.

use super::extract::{OsmMemberKind, OsmTags};
use super::import_context::ImportContext;
use super::ring::{clipped, contains, joined, tidy};
use glam::DVec2;
use std::collections::{BTreeMap, BTreeSet};

/// An outline with holes and what is said of it.
#[derive(Debug, Clone)]
pub(super) struct TaggedArea<'a> {
    pub(super) outline: Vec<DVec2>,
    pub(super) holes: Vec<Vec<DVec2>>,
    pub(super) tags: &'a OsmTags,
}

/// All closed ways and multipolygons whose tags are wanted; clipped to the extract if `clip`.
pub(super) fn patches<'a>(
    context: &mut ImportContext<'a>,
    clip: bool,
    wanted: impl Fn(&OsmTags) -> bool,
) -> Vec<TaggedArea<'a>> {
    let mut patches = Vec::new();
    let extract = context.extract;
    let ways: BTreeMap<i64, &[i64]> = extract.ways.iter().map(|w| (w.id, w.nodes.as_slice())).collect();
    // Outlines of a multipolygon often repeat its tags.
    let mut taken: BTreeSet<i64> = BTreeSet::new();
    for relation in extract.relations.iter().filter(|r| r.tags.is("type", &["multipolygon"]) && wanted(&r.tags)) {
        let chains = |inner: bool| -> Vec<Vec<i64>> {
            let members =
                relation.members.iter().filter(|m| m.kind == OsmMemberKind::Way && (m.role == "inner") == inner);
            members.filter_map(|m| ways.get(&m.id).map(|nodes| nodes.to_vec())).collect()
        };
        let mut holes = rings(context, &chains(true), clip, false);
        for outline in rings(context, &chains(false), clip, true) {
            let (own, others) = holes.into_iter().partition(|h: &Vec<DVec2>| contains(&outline, h[0]));
            holes = others;
            patches.push(TaggedArea { outline, holes: own, tags: &relation.tags });
        }
        taken.extend(relation.members.iter().filter(|m| m.role != "inner").map(|m| m.id));
    }
    for way in extract.ways.iter().filter(|w| wanted(&w.tags) && !taken.contains(&w.id)) {
        if way.nodes.len() < 4 || way.nodes[0] != way.nodes[way.nodes.len() - 1] {
            continue;
        }
        let found = rings(context, std::slice::from_ref(&way.nodes), clip, true);
        if found.is_empty() && way.nodes.iter().all(|&n| context.place(n).is_some_and(|p| context.inside(p))) {
            context.note(format!("way {}", way.id), "its outline crosses itself or has no area: it is left out");
        }
        patches.extend(found.into_iter().map(|outline| TaggedArea { outline, holes: Vec::new(), tags: &way.tags }));
    }
    patches
}

fn rings(context: &ImportContext<'_>, chains: &[Vec<i64>], clip: bool, counter_clockwise: bool) -> Vec<Vec<DVec2>> {
    let place = |ring: Vec<i64>| -> Option<Vec<DVec2>> {
        let points: Vec<DVec2> = ring.iter().map(|&n| context.place(n)).collect::<Option<_>>()?;
        let points = match context.bounds() {
            Some(bounds) if clip => clipped(&points, bounds),
            _ if points.iter().filter(|&&p| context.inside(p)).count() * 2 > points.len() => points,
            _ => return None,
        };
        tidy(&points, counter_clockwise)
    };
    joined(chains.to_vec()).into_iter().filter_map(place).collect()
}
