//! Signals and objects.

use super::super::document::{ObjectRepeat, OutlineCorner, Road, RoadObject, Signal, SignalPosition, SignalReference};
use super::super::xml::XmlElement;
use super::fields::{ElementError, ElementFields, orientation, text};

/// An object repeated more often than this along one road is a mistake.
const MOST_REPEATS: f64 = 2000.0;

impl ElementFields {
    pub(super) fn read_signals(&mut self, element: &XmlElement, road: &mut Road) {
        let Some(signals) = element.first("signals") else { return };
        for signal in signals.all("signal") {
            let read = self.signal(signal);
            road.signals.extend(self.keep(read));
        }
        for reference in signals.all("signalReference") {
            let read = self.signal_reference(reference);
            road.signal_references.extend(self.keep(read));
        }
    }

    fn signal(&mut self, element: &XmlElement) -> Result<Signal, ElementError> {
        Ok(Signal {
            id: text(element, "id"),
            line: element.line,
            name: text(element, "name"),
            s: self.number(element, "s")?,
            t: self.number(element, "t")?,
            z_offset: self.number_or(element, "zOffset", 0.0),
            h_offset: self.number_or(element, "hOffset", 0.0),
            orientation: orientation(element),
            dynamic: element.attribute("dynamic") == Some("yes"),
            country: text(element, "country"),
            kind: text(element, "type"),
            subtype: text(element, "subtype"),
            value: self.optional(element, "value"),
            unit: text(element, "unit"),
            text: text(element, "text"),
            validity: self.validity(element)?,
            position: self.signal_position(element),
        })
    }

    fn signal_reference(&mut self, element: &XmlElement) -> Result<SignalReference, ElementError> {
        Ok(SignalReference {
            id: text(element, "id"),
            s: self.number(element, "s")?,
            orientation: orientation(element),
            validity: self.validity(element)?,
        })
    }

    fn signal_position(&mut self, signal: &XmlElement) -> Option<SignalPosition> {
        if let Some(place) = signal.first("positionInertial") {
            let [x, y, z] = ["x", "y", "z"].map(|name| self.optional(place, name));
            return Some(SignalPosition::Inertial([x?, y?, z.unwrap_or(0.0)]));
        }
        let place = signal.first("positionRoad")?;
        Some(SignalPosition::Road(text(place, "roadId"), [self.optional(place, "s")?, self.optional(place, "t")?]))
    }

    fn validity(&mut self, element: &XmlElement) -> Result<Vec<(i32, i32)>, ElementError> {
        let mut ranges = Vec::new();
        for range in element.all("validity") {
            let (a, b) = (self.lane_id(range, "fromLane")?, self.lane_id(range, "toLane")?);
            ranges.push((a.min(b), a.max(b)));
        }
        Ok(ranges)
    }

    pub(super) fn read_objects(&mut self, element: &XmlElement, road: &mut Road) {
        let Some(objects) = element.first("objects") else { return };
        for object in objects.all("object") {
            let read = self.object(object);
            road.objects.extend(self.keep(read));
        }
        for bridge in objects.all("bridge") {
            let range = self.number(bridge, "s").and_then(|s| Ok((s, s + self.number(bridge, "length")?.max(0.0))));
            road.bridges.extend(self.keep(range));
        }
    }

    fn object(&mut self, element: &XmlElement) -> Result<RoadObject, ElementError> {
        let mut object = RoadObject {
            id: text(element, "id"),
            line: element.line,
            name: text(element, "name"),
            kind: text(element, "type"),
            subtype: text(element, "subtype"),
            s: self.number(element, "s")?,
            t: self.number(element, "t")?,
            z_offset: self.number_or(element, "zOffset", 0.0),
            heading: self.number_or(element, "hdg", 0.0),
            size: ["length", "width", "height"].map(|name| self.number_or(element, name, 0.0).max(0.0)),
            radius: self.number_or(element, "radius", 0.0).max(0.0),
            ..RoadObject::default()
        };
        // 1.4 has one outline in the object, later versions several in <outlines>.
        let outlines = element.first("outlines").into_iter().flat_map(|all| all.all("outline"));
        for outline in element.all("outline").chain(outlines) {
            let corners = self.corners(outline);
            object.outlines.extend(self.keep(corners));
        }
        for repeat in element.all("repeat") {
            let read = self.repeat(repeat, &object);
            let Some(read) = self.keep(read) else { continue };
            if read.distance > 0.0 && read.length / read.distance > MOST_REPEATS {
                self.note(repeat, format!("repeats an object more than {MOST_REPEATS} times and was left out"));
            } else {
                object.repeats.push(read);
            }
        }
        Ok(object)
    }

    fn corners(&mut self, outline: &XmlElement) -> Result<Vec<OutlineCorner>, ElementError> {
        let mut corners = Vec::new();
        for corner in &outline.children {
            match corner.name.as_str() {
                "cornerRoad" => corners.push(OutlineCorner::Road([
                    self.number(corner, "s")?,
                    self.number(corner, "t")?,
                    self.number_or(corner, "dz", 0.0),
                ])),
                "cornerLocal" => corners.push(OutlineCorner::Local([
                    self.number(corner, "u")?,
                    self.number(corner, "v")?,
                    self.number_or(corner, "z", 0.0),
                ])),
                _ => {}
            }
        }
        Ok(corners)
    }

    fn repeat(&mut self, element: &XmlElement, object: &RoadObject) -> Result<ObjectRepeat, ElementError> {
        Ok(ObjectRepeat {
            s: self.number(element, "s")?,
            length: self.number(element, "length")?.max(0.0),
            distance: self.number(element, "distance")?.max(0.0),
            t: ["tStart", "tEnd"].map(|name| self.number_or(element, name, object.t)),
            z_offset: ["zOffsetStart", "zOffsetEnd"].map(|name| self.number_or(element, name, object.z_offset)),
        })
    }
}
