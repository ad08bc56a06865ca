//! The numbers and shares of each side.

use crate::DatasetStatistics;
use serde::Serialize;

/// One of the datasets.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Side {
    /// `A`, `B`, …
    pub letter: char,
    /// Name of its folder or file.
    pub name: String,
    /// All of its statistics, with the classes that are compared.
    #[serde(skip)]
    pub statistics: DatasetStatistics,
}

/// A number of each side; none where a side does not know it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NumberRow {
    /// What it is, with its unit.
    pub name: &'static str,
    /// One a side.
    pub values: Vec<Option<f64>>,
}

/// The shares of a distribution on each side.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShareTable {
    /// Name of the distribution.
    pub key: String,
    /// Its title.
    pub title: String,
    /// What is counted.
    pub of: &'static str,
    /// What the labels are.
    pub axis: String,
    /// Whether they are in the order of a quantity.
    pub ordered: bool,
    /// Total variation distance of each side from the last, 0 to 1; none where one of them does not know it.
    pub distances: Vec<Option<f64>>,
    /// The kinds.
    pub labels: Vec<String>,
    /// Shares, 0 to 1, one a label, of each side; none where a side does not know it.
    pub shares: Vec<Option<Vec<f64>>>,
}

impl ShareTable {
    /// The largest of the distances.
    pub fn distance(&self) -> f64 {
        self.distances.iter().flatten().copied().fold(0.0, f64::max)
    }
}
