//! Signals and objects.

use super::super::OpenDriveError;
use super::super::document::{Corner, Object, Repeat, Road, Signal, SignalReference, Stands};
use super::super::xml::Element;
use super::fields::{Fields, orientation, text};

/// An object repeated more often than this along one road is a mistake.
const MOST_REPEATS: f64 = 2000.0;

impl Fields {
    pub(super) fn read_signals(&mut self, element: &Element, road: &mut Road) -> Result<(), OpenDriveError> {
        let Some(signals) = element.first("signals") else { return Ok(()) };
        for signal in signals.all("signal") {
            road.signals.push(Signal {
                id: text(signal, "id"),
                line: signal.line,
                name: text(signal, "name"),
                s: self.number(signal, "s")?,
                t: self.number(signal, "t")?,
                z_offset: self.number_or(signal, "zOffset", 0.0),
                h_offset: self.number_or(signal, "hOffset", 0.0),
                orientation: orientation(signal),
                dynamic: signal.attribute("dynamic") == Some("yes"),
                country: text(signal, "country"),
                kind: text(signal, "type"),
                subtype: text(signal, "subtype"),
                value: self.optional(signal, "value"),
                unit: text(signal, "unit"),
                text: text(signal, "text"),
                validity: self.validity(signal)?,
                stands: self.stands(signal),
            });
        }
        for reference in signals.all("signalReference") {
            road.signal_references.push(SignalReference {
                id: text(reference, "id"),
                s: self.number(reference, "s")?,
                orientation: orientation(reference),
                validity: self.validity(reference)?,
            });
        }
        Ok(())
    }

    fn stands(&mut self, signal: &Element) -> Option<Stands> {
        if let Some(place) = signal.first("positionInertial") {
            let [x, y, z] = ["x", "y", "z"].map(|name| self.optional(place, name));
            return Some(Stands::Inertial([x?, y?, z.unwrap_or(0.0)]));
        }
        let place = signal.first("positionRoad")?;
        Some(Stands::Road(text(place, "roadId"), [self.optional(place, "s")?, self.optional(place, "t")?]))
    }

    fn validity(&mut self, element: &Element) -> Result<Vec<(i32, i32)>, OpenDriveError> {
        let mut ranges = Vec::new();
        for range in element.all("validity") {
            let (a, b) = (self.lane_id(range, "fromLane")?, self.lane_id(range, "toLane")?);
            ranges.push((a.min(b), a.max(b)));
        }
        Ok(ranges)
    }

    pub(super) fn read_objects(&mut self, element: &Element, road: &mut Road) -> Result<(), OpenDriveError> {
        let Some(objects) = element.first("objects") else { return Ok(()) };
        for object in objects.all("object") {
            let read = self.object(object)?;
            road.objects.push(read);
        }
        for bridge in objects.all("bridge") {
            let s = self.number(bridge, "s")?;
            road.bridges.push((s, s + self.number(bridge, "length")?.max(0.0)));
        }
        Ok(())
    }

    fn object(&mut self, element: &Element) -> Result<Object, OpenDriveError> {
        let mut object = Object {
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
            ..Object::default()
        };
        // 1.4 has one outline in the object, later versions several in <outlines>.
        let outlines = element.first("outlines").into_iter().flat_map(|all| all.all("outline"));
        for outline in element.all("outline").chain(outlines) {
            let mut corners = Vec::new();
            for corner in &outline.children {
                match corner.name.as_str() {
                    "cornerRoad" => corners.push(Corner::Road([
                        self.number(corner, "s")?,
                        self.number(corner, "t")?,
                        self.number_or(corner, "dz", 0.0),
                    ])),
                    "cornerLocal" => corners.push(Corner::Local([
                        self.number(corner, "u")?,
                        self.number(corner, "v")?,
                        self.number_or(corner, "z", 0.0),
                    ])),
                    _ => {}
                }
            }
            object.outlines.push(corners);
        }
        for repeat in element.all("repeat") {
            let read = self.repeat(repeat, &object)?;
            if read.distance > 0.0 && read.length / read.distance > MOST_REPEATS {
                self.note(repeat, format!("repeats an object more than {MOST_REPEATS} times and was left out"));
            } else {
                object.repeats.push(read);
            }
        }
        Ok(object)
    }

    fn repeat(&mut self, element: &Element, object: &Object) -> Result<Repeat, OpenDriveError> {
        Ok(Repeat {
            s: self.number(element, "s")?,
            length: self.number(element, "length")?.max(0.0),
            distance: self.number(element, "distance")?.max(0.0),
            t: ["tStart", "tEnd"].map(|name| self.number_or(element, name, object.t)),
            z_offset: ["zOffsetStart", "zOffsetEnd"].map(|name| self.number_or(element, name, object.z_offset)),
        })
    }
}
