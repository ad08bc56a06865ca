//! Values of attributes, and complaints about them.

use super::super::document::{ContactPoint, CubicPolynomial, SignalOrientation};
use super::super::xml::XmlElement;
use crate::ImportNote;

/// Beyond this no coordinate or length means anything, metres. UTM's northings go to half of it.
pub(in crate::opendrive) const FARTHEST_M: f64 = 2e7;

/// Reads attributes; collects what had to be guessed.
#[derive(Debug, Default)]
pub(super) struct ElementFields {
    pub(super) notes: Vec<ImportNote>,
    /// The last geometry of the road at hand was impossible: where it leads follows from the next road.
    pub(super) loose_end: bool,
}

/// Why an element cannot be used.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ElementError {
    line: usize,
    element: String,
    what: String,
}

impl ElementError {
    pub(super) fn new(element: &XmlElement, what: impl Into<String>) -> Self {
        Self { line: element.line, element: element.name.clone(), what: what.into() }
    }

    /// For the user, with what was done about it.
    pub(super) fn note(self, done: &str) -> ImportNote {
        ImportNote { place: format!("line {}: {}", self.line, self.element), text: format!("{}; {done}", self.what) }
    }
}

impl ElementFields {
    pub(super) fn note(&mut self, element: &XmlElement, text: String) {
        let id = element.attribute("id").map(|id| format!(" {id}")).unwrap_or_default();
        self.notes.push(ImportNote { place: format!("line {}: {}{id}", element.line, element.name), text });
    }

    /// What was read; what cannot be used is left out, with a note.
    pub(super) fn keep<T>(&mut self, read: Result<T, ElementError>) -> Option<T> {
        read.map_err(|error| self.notes.push(error.note("it was left out"))).ok()
    }

    /// A number that must be there.
    pub(super) fn number(&self, element: &XmlElement, name: &str) -> Result<f64, ElementError> {
        let Some(text) = element.attribute(name) else {
            return Err(ElementError::new(element, format!("lacks the attribute {name}")));
        };
        match finite(text) {
            Some(value) => Ok(value),
            None => {
                Err(ElementError::new(element, format!("has {name}=\"{}\", which is no usable number", short(text))))
            }
        }
    }

    /// A number that may be missing; one that makes no sense counts as missing, with a note.
    pub(super) fn optional(&mut self, element: &XmlElement, name: &str) -> Option<f64> {
        let text = element.attribute(name)?;
        let value = finite(text);
        if value.is_none() && !text.trim().is_empty() {
            self.note(element, format!("{name}=\"{}\" is no usable number and was left out", short(text)));
        }
        value
    }

    pub(super) fn number_or(&mut self, element: &XmlElement, name: &str, default: f64) -> f64 {
        self.optional(element, name).unwrap_or(default)
    }

    pub(super) fn lane_id(&self, element: &XmlElement, name: &str) -> Result<i32, ElementError> {
        let text = element.attribute(name).unwrap_or_default();
        match text.trim().parse() {
            Ok(id) => Ok(id),
            Err(_) => Err(ElementError::new(element, format!("has {name}=\"{}\", which is no lane id", short(text)))),
        }
    }

    pub(super) fn cubic(&self, element: &XmlElement, start: &str) -> Result<CubicPolynomial, ElementError> {
        let s = self.number(element, start)?;
        Ok(CubicPolynomial { s, abcd: self.four(element, ["a", "b", "c", "d"])? })
    }

    pub(super) fn four(&self, element: &XmlElement, names: [&str; 4]) -> Result<[f64; 4], ElementError> {
        let mut values = [0.0; 4];
        for (value, name) in values.iter_mut().zip(names) {
            *value = self.number(element, name)?;
        }
        Ok(values)
    }

    /// All cubics of a name, in order of `s`.
    pub(super) fn cubics(&mut self, parent: Option<&XmlElement>, name: &str, start: &str) -> Vec<CubicPolynomial> {
        let mut cubics = Vec::new();
        for element in parent.into_iter().flat_map(|parent| parent.all(name)) {
            let read = self.cubic(element, start);
            cubics.extend(self.keep(read));
        }
        cubics.sort_by(|a, b| a.s.total_cmp(&b.s));
        cubics
    }

    /// A speed in metres a second.
    pub(super) fn speed(&mut self, element: &XmlElement) -> Option<f64> {
        let text = element.attribute("max").unwrap_or_default().trim();
        if matches!(text, "" | "no limit" | "undefined") {
            return None;
        }
        let value = self.optional(element, "max")?;
        let unit = element.attribute("unit").unwrap_or("m/s").trim();
        let factor = match unit {
            "m/s" | "" => 1.0,
            "km/h" | "kmh" => 1.0 / 3.6,
            "mph" => 0.44704,
            other => {
                self.note(element, format!("speed in unknown unit \"{}\" was left out", short(other)));
                return None;
            }
        };
        (value > 0.0).then_some(value * factor)
    }

    pub(super) fn contact(&mut self, element: &XmlElement, default: ContactPoint) -> ContactPoint {
        match element.attribute("contactPoint") {
            Some("start") => ContactPoint::Start,
            Some("end") => ContactPoint::End,
            None => default,
            Some(other) => {
                self.note(element, format!("contactPoint=\"{}\" is neither start nor end", short(other)));
                default
            }
        }
    }
}

pub(super) fn orientation(element: &XmlElement) -> SignalOrientation {
    match element.attribute("orientation") {
        Some("+") => SignalOrientation::Along,
        Some("-") => SignalOrientation::Against,
        _ => SignalOrientation::Both,
    }
}

pub(super) fn text(element: &XmlElement, name: &str) -> String {
    element.attribute(name).unwrap_or_default().trim().to_owned()
}

fn finite(text: &str) -> Option<f64> {
    text.trim().parse::<f64>().ok().filter(|value| value.abs() <= FARTHEST_M)
}

fn short(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).take(40).collect()
}
