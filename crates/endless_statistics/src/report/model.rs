//! Sections, tables and charts.

use crate::HeatMap;

/// A report: sections under a title.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    /// Its title.
    pub title: String,
    /// What it is about, in a line.
    pub subtitle: String,
    /// Its sections.
    pub sections: Vec<Section>,
}

/// A section.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Section {
    /// Its title.
    pub title: String,
    /// How to read it; may be empty.
    pub note: String,
    /// What is in it.
    pub items: Vec<Item>,
}

/// Something in a section.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// Numbers to be seen first.
    Tiles(Vec<Tile>),
    /// A table.
    Table(Table),
    /// A chart.
    Chart(Chart),
    /// Heat maps, side by side.
    HeatMaps(Vec<HeatMapFigure>),
    /// Sentences.
    List(Vec<String>),
}

/// A number with its name.
#[derive(Debug, Clone, PartialEq)]
pub struct Tile {
    /// Its name.
    pub name: String,
    /// The number.
    pub value: String,
}

/// A table. Numbers stand to the right.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    /// Its title.
    pub title: String,
    /// Names of the columns; the first is that of the rows.
    pub columns: Vec<String>,
    /// As many cells as columns.
    pub rows: Vec<Vec<String>>,
    /// How many of the last rows are sums.
    pub sums: usize,
}

/// A chart of bars.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chart {
    /// Its title.
    pub title: String,
    /// What the labels are, with their unit.
    pub label_axis: String,
    /// What the values are, with their unit.
    pub value_axis: String,
    /// Places of the bars.
    pub labels: Vec<String>,
    /// Bars at these places.
    pub series: Vec<Series>,
    /// Whether series stand on one another, as parts of a whole; else beside one another.
    pub stacked: bool,
    /// Whether the labels are in the order of some quantity; else bars may lie, with the labels beside them.
    pub ordered: bool,
    /// Whether values are percent.
    pub percent: bool,
    /// What else is to be known, as the mean; may be empty.
    pub note: String,
}

/// Values of a chart.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Series {
    /// Its name.
    pub name: String,
    /// One a label.
    pub values: Vec<f64>,
}

/// A heat map with its title.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatMapFigure {
    /// Its title.
    pub title: String,
    /// The map.
    pub map: HeatMap,
}

impl Chart {
    /// Sums of the series at each label.
    pub(super) fn sums(&self) -> Vec<f64> {
        (0..self.labels.len()).map(|place| self.series.iter().map(|series| series.values[place]).sum()).collect()
    }
}
