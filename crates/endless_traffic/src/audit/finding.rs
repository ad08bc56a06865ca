//! What was found: how often, how bad, and where.

use super::check::AuditCheck;
use super::report::AuditLine;

/// Places that are told of each check.
const TOLD: usize = 5;

/// Things that happen or do not.
#[derive(Debug, Default)]
pub(super) struct Incidents {
    count: u64,
    first: Vec<String>,
}

impl Incidents {
    pub(super) fn add(&mut self, what: impl FnOnce() -> String) {
        self.count += 1;
        if self.first.len() < TOLD {
            self.first.push(what());
        }
    }

    pub(super) fn line(&self, check: AuditCheck) -> AuditLine {
        AuditLine { check, measured: self.count as f64, places: self.first.clone() }
    }
}

/// The largest of some numbers.
#[derive(Debug, Default)]
pub(super) struct Worst {
    value: f64,
    place: Option<String>,
}

impl Worst {
    pub(super) fn note(&mut self, value: f64, what: impl FnOnce() -> String) {
        if value > self.value {
            (self.value, self.place) = (value, Some(what()));
        }
    }

    pub(super) fn line(&self, check: AuditCheck) -> AuditLine {
        AuditLine { check, measured: self.value, places: self.place.iter().cloned().collect() }
    }
}

/// How often a number is above a bound.
#[derive(Debug, Default)]
pub(super) struct Share {
    above: u64,
    of: u64,
}

impl Share {
    pub(super) fn note(&mut self, above: bool) {
        self.above += u64::from(above);
        self.of += 1;
    }

    /// In percent.
    pub(super) fn line(&self, check: AuditCheck) -> AuditLine {
        let percent = 100.0 * self.above as f64 / self.of.max(1) as f64;
        AuditLine { check, measured: percent, places: Vec::new() }
    }
}
