//! What both formats tell: one road user at one instant.

use super::TrackFault;
use endless_world::{TrackPoint, TrackSample};
use glam::DVec2;

/// Furthest coordinate, metres: beyond, single precision ends, and no town is so large.
const FAR: f64 = 1e7;
/// Longest time, seconds.
const LATE_S: f64 = 1e9;

/// One road user at one instant.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row<'a> {
    pub(super) id: &'a str,
    pub(super) kind: &'a str,
    pub(super) on_foot: bool,
    pub(super) length_m: Option<f64>,
    pub(super) point: TrackPoint,
    pub(super) sample: TrackSample,
}

/// Reads the numbers of one line.
pub(super) struct Numbers {
    pub(super) line: usize,
}

impl Numbers {
    pub(super) fn fault(&self, what: String) -> TrackFault {
        TrackFault::Line { line: self.line, what }
    }

    fn within(&self, name: &str, text: &str, most: f64) -> Result<f64, TrackFault> {
        let number = text.trim().parse().ok().filter(|number: &f64| number.abs() <= most);
        number.ok_or_else(|| {
            let shown: String = text.chars().filter(|c| !c.is_control()).take(40).collect();
            self.fault(format!("{name} is '{shown}': write a number of at most {most:e}"))
        })
    }

    pub(super) fn time_s(&self, text: &str) -> Result<f64, TrackFault> {
        self.within("time", text, LATE_S)
    }

    pub(super) fn position(&self, x: &str, y: &str) -> Result<DVec2, TrackFault> {
        Ok(DVec2::new(self.within("x", x, FAR)?, self.within("y", y, FAR)?))
    }

    pub(super) fn number(&self, name: &str, text: &str) -> Result<f64, TrackFault> {
        self.within(name, text, FAR)
    }

    pub(super) fn required<'a>(&self, name: &str, text: Option<&'a str>) -> Result<&'a str, TrackFault> {
        text.filter(|text| !text.is_empty()).ok_or_else(|| self.fault(format!("{name} is missing")))
    }

    /// A number that may be left out.
    pub(super) fn optional(&self, name: &str, text: Option<&str>) -> Result<Option<f64>, TrackFault> {
        let given = text.filter(|text| !text.trim().is_empty());
        given.map(|text| self.number(name, text)).transpose()
    }
}
