//! Which lane ends are joined: lane links inside roads, from road to road, and through junctions.

use super::super::document::{ContactPoint, JunctionConnection, JunctionRecord, JunctionType, RoadLink};
use super::sampled::{LaneKey, SampledDocument};
use crate::ImportNote;
use std::collections::BTreeSet;

/// An end of a lane of a section, by `s`.
pub(super) type LaneEnd = (LaneKey, ContactPoint);

/// All pairs of joined ends, each once.
pub(super) fn joins(sampled: &SampledDocument<'_>, notes: &mut Vec<ImportNote>) -> BTreeSet<(LaneEnd, LaneEnd)> {
    let mut joins = LaneLinks { sampled, notes, pairs: BTreeSet::new() };
    for road in 0..sampled.document.roads.len() {
        joins.inside_road(road);
        joins.join_next_road(road, ContactPoint::Start);
        joins.join_next_road(road, ContactPoint::End);
    }
    for junction in &sampled.document.junctions {
        joins.through_junction(junction);
    }
    joins.pairs
}

struct LaneLinks<'a, 'b> {
    sampled: &'a SampledDocument<'a>,
    notes: &'b mut Vec<ImportNote>,
    pairs: BTreeSet<(LaneEnd, LaneEnd)>,
}

impl LaneLinks<'_, '_> {
    fn add(&mut self, a: LaneEnd, b: LaneEnd) {
        let exists = |key: LaneKey| self.sampled.record(key).is_some();
        if !exists(b.0) || !exists(a.0) {
            let (here, there) = if exists(a.0) { (a.0, b.0) } else { (b.0, a.0) };
            let line = self.sampled.record(here).map_or(0, |lane| lane.line);
            let road = &self.sampled.document.roads[there.road].id;
            self.note(
                line,
                format!("lane {} is linked to lane {} of road {road}, which has none", here.lane, there.lane),
            );
        } else if a != b {
            self.pairs.insert((a.min(b), a.max(b)));
        }
    }

    fn note(&mut self, line: usize, text: String) {
        self.notes.push(ImportNote { place: format!("line {line}"), text });
    }

    fn links(&self, key: LaneKey, end: ContactPoint) -> &[i32] {
        self.sampled.record(key).map_or(&[], |lane| match end {
            ContactPoint::Start => &lane.predecessors,
            ContactPoint::End => &lane.successors,
        })
    }

    fn lane_ids(&self, road: usize, section: usize) -> Vec<i32> {
        let lanes = &self.sampled.document.roads[road].sections[section].lanes;
        lanes.iter().map(|lane| lane.id).filter(|&id| id != 0).collect()
    }

    /// Joins a section's end to another's. Where neither side has any link, lanes of the same number are joined, as
    /// programs do that leave obvious links out.
    fn sections(
        &mut self,
        (road, section, end): (usize, usize, ContactPoint),
        (next_road, next_section, next_end): (usize, usize, ContactPoint),
    ) {
        let key = |lane| LaneKey { road, section, lane };
        let next_key = |lane| LaneKey { road: next_road, section: next_section, lane };
        let (ids, next_ids) = (self.lane_ids(road, section), self.lane_ids(next_road, next_section));
        let mut any = false;
        for &id in &ids {
            for to in self.links(key(id), end).to_vec() {
                any = true;
                if to != 0 {
                    self.add((key(id), end), (next_key(to), next_end));
                }
            }
        }
        any |= next_ids.iter().any(|&id| !self.links(next_key(id), next_end).is_empty());
        if !any {
            let sign = if end == next_end { -1 } else { 1 };
            for id in ids.into_iter().filter(|id| next_ids.contains(&(sign * id))) {
                let kind = |key| self.sampled.record(key).map(|lane| lane.kind.as_str());
                if kind(key(id)) == kind(next_key(sign * id)) {
                    self.add((key(id), end), (next_key(sign * id), next_end));
                }
            }
        }
    }

    fn inside_road(&mut self, road: usize) {
        for section in 1..self.sampled.document.roads[road].sections.len() {
            self.sections((road, section - 1, ContactPoint::End), (road, section, ContactPoint::Start));
            self.sections((road, section, ContactPoint::Start), (road, section - 1, ContactPoint::End));
        }
    }

    fn join_next_road(&mut self, road: usize, end: ContactPoint) {
        let record = &self.sampled.document.roads[road];
        let link = if end == ContactPoint::Start { &record.predecessor } else { &record.successor };
        match link {
            Some(RoadLink::Road { id, contact }) => match self.sampled.road(id) {
                Some(next) => {
                    let section = self.sampled.section_at(road, end);
                    self.sections((road, section, end), (next, self.sampled.section_at(next, *contact), *contact));
                }
                None => {
                    self.note(record.line, format!("road {} is linked to road {id}, which does not exist", record.id));
                }
            },
            Some(RoadLink::Junction { id }) if !self.sampled.document.junctions.iter().any(|j| j.id == *id) => {
                let text = format!("road {} is linked to junction {id}, which does not exist", record.id);
                self.note(record.line, text);
            }
            _ => {}
        }
    }

    fn through_junction(&mut self, junction: &JunctionRecord) {
        let why = match junction.kind {
            JunctionType::Crossing => "roads that cross at a level: vehicles do not mind one another there",
            JunctionType::Virtual => "is virtual: nobody turns off the road that goes on",
            JunctionType::Default | JunctionType::Direct => "",
        };
        if !why.is_empty() {
            self.note(junction.line, format!("junction {} {why}", junction.id));
            return;
        }
        for connection in &junction.connections {
            let places = (self.sampled.road(&connection.incoming), self.sampled.road(&connection.connecting));
            let (Some(incoming), Some(connecting)) = places else {
                let text = format!("junction {} connects a road that does not exist", junction.id);
                self.note(connection.line, text);
                continue;
            };
            let end = self.incoming_end(junction, connection, incoming, connecting);
            let section = self.sampled.section_at(incoming, end);
            let next_section = self.sampled.section_at(connecting, connection.contact);
            for &(from, to) in &connection.lane_links {
                let a = LaneKey { road: incoming, section, lane: from };
                let b = LaneKey { road: connecting, section: next_section, lane: to };
                self.add((a, end), (b, connection.contact));
            }
        }
    }

    /// The end of the incoming road that lies at the junction: the one linked to it, or the nearer one.
    fn incoming_end(
        &self,
        junction: &JunctionRecord,
        connection: &JunctionConnection,
        incoming: usize,
        connecting: usize,
    ) -> ContactPoint {
        let record = &self.sampled.document.roads[incoming];
        let linked = |link: &Option<RoadLink>| matches!(link, Some(RoadLink::Junction { id }) if *id == junction.id);
        match (linked(&record.predecessor), linked(&record.successor)) {
            (true, false) => ContactPoint::Start,
            (false, true) => ContactPoint::End,
            _ => {
                let place = |road: usize, end: ContactPoint| {
                    let s = if end == ContactPoint::Start { 0.0 } else { self.sampled.document.roads[road].length };
                    self.sampled.roads[road].pose(s).position
                };
                let there = place(connecting, connection.contact);
                let distance = |end: ContactPoint| place(incoming, end).distance(there);
                if distance(ContactPoint::Start) < distance(ContactPoint::End) {
                    ContactPoint::Start
                } else {
                    ContactPoint::End
                }
            }
        }
    }
}
