//! Formats of trajectories.

use std::path::Path;

/// The format of a file of trajectories.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TrajectoryFormat {
    /// Text: a line for each road user at each instant.
    Csv,
    /// SUMO's floating car data, XML.
    Fcd,
    /// Apache Parquet: the columns of the CSV, in full precision.
    Parquet,
}

impl TrajectoryFormat {
    /// The format that the ending of a file's name says: `.csv`, `.xml` (as in `.fcd.xml`) or `.parquet`.
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_ascii_lowercase().to_str()? {
            "csv" => Some(Self::Csv),
            "xml" => Some(Self::Fcd),
            "parquet" => Some(Self::Parquet),
            _ => None,
        }
    }
}
