//! CSV: a line for each row, below a header.

use super::column::{COLUMNS, Cell, ColumnKind};
use super::row::TrajectoryRow;
use std::fmt::Write;

pub(super) fn header() -> String {
    let names: Vec<&str> = COLUMNS.iter().map(|column| column.name).collect();
    format!("{}\n", names.join(","))
}

pub(super) fn write_rows(rows: &[TrajectoryRow<'_>], into: &mut String) {
    for row in rows {
        for (place, column) in COLUMNS.iter().enumerate() {
            if place > 0 {
                into.push(',');
            }
            let digits = if let ColumnKind::Number(digits) = column.kind { digits } else { 0 };
            // A string takes everything.
            let _ = match (column.cell)(row) {
                Cell::Number(Some(number)) => write!(into, "{number:.digits$}"),
                Cell::Whole(Some(number)) => write!(into, "{number}"),
                Cell::Text(text) => write!(into, "{text}"),
                Cell::Number(None) | Cell::Whole(None) => Ok(()),
            };
        }
        into.push('\n');
    }
}
