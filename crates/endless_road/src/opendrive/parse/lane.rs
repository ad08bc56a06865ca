//! Lane sections.

use super::super::document::{LaneRecord, LaneSection, MarkLine, RoadMark};
use super::super::xml::XmlElement;
use super::fields::{ElementError, ElementFields, text};

impl ElementFields {
    pub(super) fn lane_sections(&mut self, lanes: &XmlElement) -> Result<Vec<LaneSection>, ElementError> {
        let mut sections = Vec::new();
        for element in lanes.all("laneSection") {
            let s = self.number(element, "s");
            let Some(s) = self.keep(s) else { continue };
            let mut section = LaneSection { s, line: element.line, lanes: Vec::new() };
            for side in ["left", "center", "right"].iter().filter_map(|side| element.first(side)) {
                for lane in side.all("lane") {
                    let read = self.lane(lane);
                    section.lanes.extend(self.keep(read));
                }
            }
            section.lanes.sort_by_key(|lane| -lane.id);
            section.lanes.dedup_by(|later, first| {
                let twice = later.id == first.id;
                if twice {
                    self.note(element, format!("has two lanes of id {}; the second was left out", first.id));
                }
                twice
            });
            if !section.lanes.iter().any(|lane| lane.id == 0) {
                self.note(element, "has no centre lane".to_owned());
                let at = section.lanes.partition_point(|lane| lane.id > 0);
                section.lanes.insert(at, LaneRecord { kind: "none".to_owned(), ..LaneRecord::default() });
            }
            sections.push(section);
        }
        if sections.is_empty() {
            return Err(ElementError::new(lanes, "has no <laneSection>"));
        }
        sections.sort_by(|a, b| a.s.total_cmp(&b.s));
        Ok(sections)
    }

    fn lane(&mut self, element: &XmlElement) -> Result<LaneRecord, ElementError> {
        let mut lane = LaneRecord {
            id: self.lane_id(element, "id")?,
            line: element.line,
            kind: text(element, "type"),
            level: matches!(element.attribute("level"), Some("true" | "1")),
            reversed: element.attribute("direction") == Some("reversed"),
            widths: self.cubics(Some(element), "width", "sOffset"),
            borders: self.cubics(Some(element), "border", "sOffset"),
            ..LaneRecord::default()
        };
        if lane.kind == "bidirectional" {
            self.note(element, "is for both directions: it is drawn, and nobody drives there".to_owned());
        } else if element.attribute("direction") == Some("both") {
            self.note(element, "is for both directions: traffic runs as on its side of the road".to_owned());
        }
        if let Some(link) = element.first("link") {
            for (name, ids) in [("predecessor", &mut lane.predecessors), ("successor", &mut lane.successors)] {
                for linked in link.all(name) {
                    let id = self.lane_id(linked, "id");
                    ids.extend(self.keep(id));
                }
            }
        }
        for height in element.all("height") {
            let values = ["sOffset", "inner", "outer"].map(|name| self.number_or(height, name, 0.0));
            lane.heights.push(values);
        }
        lane.heights.sort_by(|a, b| a[0].total_cmp(&b[0]));
        for speed in element.all("speed") {
            if let Some(limit) = self.speed(speed) {
                lane.speeds.push((self.number_or(speed, "sOffset", 0.0), limit));
            }
        }
        lane.speeds.sort_by(|a, b| a.0.total_cmp(&b.0));
        for material in element.all("material") {
            lane.materials.push((self.number_or(material, "sOffset", 0.0), text(material, "surface")));
        }
        lane.materials.sort_by(|a, b| a.0.total_cmp(&b.0));
        for mark in element.all("roadMark") {
            lane.marks.push(self.road_mark(mark));
        }
        lane.marks.sort_by(|a, b| a.s.total_cmp(&b.s));
        Ok(lane)
    }

    fn road_mark(&mut self, element: &XmlElement) -> RoadMark {
        let mut mark = RoadMark {
            s: self.number_or(element, "sOffset", 0.0),
            kind: text(element, "type"),
            color: text(element, "color"),
            bold: element.attribute("weight") == Some("bold"),
            width: self.optional(element, "width").filter(|width| *width > 0.0 && *width < 5.0),
            lane_change: element.attribute("laneChange").map(str::to_owned),
            lines: Vec::new(),
        };
        // `type` says how a mark repeats, `explicit` where each line lies.
        for (name, explicit) in [("type", false), ("explicit", true)] {
            let Some(detail) = element.first(name) else { continue };
            let common = self.optional(detail, "width");
            for line in detail.all("line") {
                mark.lines.push(MarkLine {
                    length: self.number_or(line, "length", 0.0).max(0.0),
                    space: if explicit { 0.0 } else { self.number_or(line, "space", 0.0).max(0.0) },
                    once: explicit,
                    t_offset: self.number_or(line, "tOffset", 0.0).clamp(-5.0, 5.0),
                    s_offset: self.number_or(line, "sOffset", 0.0),
                    width: self.optional(line, "width").or(common).filter(|width| *width > 0.0 && *width < 5.0),
                });
            }
        }
        mark
    }
}
