//! Tables of plain text whose rows are printed as they come.

use std::io::{self, StdoutLock, Write};

/// Width of the first column, characters.
const FIRST: usize = 12;
/// Least width of the others.
const OTHERS: usize = 8;

/// A table: the first column to the left, the others, which are numbers, to the right.
pub(super) struct Table {
    out: StdoutLock<'static>,
    widths: Vec<usize>,
}

impl Table {
    /// Prints what the table is about and the heads of its columns.
    pub(super) fn begin(title: &str, heads: &[&str]) -> io::Result<Self> {
        let widths = heads.iter().enumerate();
        let widths = widths.map(|(i, head)| head.chars().count().max(if i == 0 { FIRST } else { OTHERS })).collect();
        let mut table = Self { out: io::stdout().lock(), widths };
        writeln!(table.out, "{title}")?;
        table.row(heads.iter().map(ToString::to_string))?;
        Ok(table)
    }

    /// Prints a row at once: the next may take long.
    pub(super) fn row(&mut self, cells: impl IntoIterator<Item = String>) -> io::Result<()> {
        let padded = cells.into_iter().zip(&self.widths).enumerate();
        let padded = padded.map(|(i, (cell, &width))| match i {
            0 => format!("{cell:<width$}"),
            _ => format!("{cell:>width$}"),
        });
        writeln!(self.out, "  {}", padded.collect::<Vec<_>>().join("   ").trim_end())?;
        self.out.flush()
    }

    /// Prints what the rows have to keep to, and an empty line.
    pub(super) fn end(mut self, remark: &str) -> io::Result<()> {
        if !remark.is_empty() {
            writeln!(self.out, "  {remark}")?;
        }
        writeln!(self.out)
    }
}

/// A number as a share of another, two digits after the point.
pub(super) fn ratio(value: f64, of: f64) -> String {
    format!("{:.2}", value / of.max(f64::MIN_POSITIVE))
}
