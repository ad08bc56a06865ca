//! What an audit says.

use super::check::AuditCheck;
use std::fmt;

/// What one check found.
#[derive(Debug, Clone, PartialEq)]
pub struct AuditLine {
    /// The check.
    pub check: AuditCheck,
    /// What was measured, in the check's unit.
    pub measured: f64,
    /// Who, when and where: the first times, or the worst one.
    pub places: Vec<String>,
}

impl AuditLine {
    /// Whether the limit was kept.
    pub fn passed(&self) -> bool {
        self.measured <= self.check.limit()
    }
}

/// What an audit found.
#[derive(Debug, Clone, PartialEq)]
pub struct AuditReport {
    /// One for each check.
    pub lines: Vec<AuditLine>,
    /// Time between the first and the last frame, seconds.
    pub seconds: f64,
    /// Way of all vehicles together, metres.
    pub driven_m: f64,
    /// Way of all people together, metres.
    pub walked_m: f64,
}

impl AuditReport {
    /// Whether all limits were kept.
    pub fn passed(&self) -> bool {
        self.lines.iter().all(AuditLine::passed)
    }

    /// What was measured for one of the checks.
    ///
    /// # Panics
    /// Never: there is a line for each.
    pub fn measured(&self, check: AuditCheck) -> f64 {
        self.lines.iter().find(|line| line.check == check).expect("a line for each check").measured
    }
}

/// A row for each line: whether it passed, the check, what was measured and the limit; below those that failed, where.
impl fmt::Display for AuditReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for line in &self.lines {
            let (verdict, unit) = (if line.passed() { "PASS" } else { "FAIL" }, line.check.unit());
            let digits = match unit {
                "" => 0,
                "%" => 3,
                _ => 2,
            };
            let (measured, limit) = (line.measured, line.check.limit());
            writeln!(
                f,
                "{verdict}  {:<46} {measured:>10.digits$} {unit:<5}  at most {limit} {unit}",
                line.check.title()
            )?;
            if !line.passed() {
                line.places.iter().try_for_each(|place| writeln!(f, "        {place}"))?;
            }
        }
        Ok(())
    }
}
