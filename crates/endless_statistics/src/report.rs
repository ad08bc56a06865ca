//! What is told of datasets, whoever reads it: the same sections, tables and charts are written as text and as a web page.

mod comparison;
mod dataset;
mod format;
mod model;
mod page;
mod text;

pub use model::{Chart, HeatMapFigure, Item, Report, Section, Series, Table, Tile};
