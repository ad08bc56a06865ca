//! Junctions and controllers.

use super::super::document::{ContactPoint, JunctionConnection, JunctionRecord, JunctionType, SignalController};
use super::super::xml::XmlElement;
use super::fields::{ElementFields, text};

impl ElementFields {
    pub(super) fn junction(&mut self, element: &XmlElement) -> JunctionRecord {
        let kind = match element.attribute("type") {
            Some("direct") => JunctionType::Direct,
            Some("virtual") => JunctionType::Virtual,
            Some("crossing") => JunctionType::Crossing,
            _ => JunctionType::Default,
        };
        let mut junction = JunctionRecord {
            id: text(element, "id"),
            line: element.line,
            name: text(element, "name"),
            kind,
            ..JunctionRecord::default()
        };
        for connection in element.all("connection") {
            let mut lane_links = Vec::new();
            for link in connection.all("laneLink") {
                let ends = self.lane_id(link, "from").and_then(|from| Ok((from, self.lane_id(link, "to")?)));
                lane_links.extend(self.keep(ends));
            }
            let connecting = if kind == JunctionType::Direct { "linkedRoad" } else { "connectingRoad" };
            junction.connections.push(JunctionConnection {
                line: connection.line,
                incoming: text(connection, "incomingRoad"),
                connecting: text(connection, connecting),
                contact: self.contact(connection, ContactPoint::Start),
                lane_links,
            });
        }
        for priority in element.all("priority") {
            junction.priorities.push((text(priority, "high"), text(priority, "low")));
        }
        for controller in element.all("controller") {
            let sequence = self.number_or(controller, "sequence", 0.0).max(0.0) as u32;
            junction.controllers.push((text(controller, "id"), sequence));
        }
        junction
    }

    pub(super) fn controller(&mut self, element: &XmlElement) -> SignalController {
        SignalController {
            id: text(element, "id"),
            name: text(element, "name"),
            sequence: self.optional(element, "sequence").map(|value| value.max(0.0) as u32),
            signals: element.all("control").map(|control| text(control, "signalId")).collect(),
        }
    }
}
