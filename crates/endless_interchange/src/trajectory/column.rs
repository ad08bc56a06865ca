//! The columns of CSV and Parquet.

use super::row::TrajectoryRow;
use ColumnKind::{Number, Text, Whole};

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ColumnKind {
    /// With so many digits after the point in text.
    Number(usize),
    Whole,
    Text,
}

/// What a row has in a column; nothing where it is not known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Cell<'a> {
    Number(Option<f64>),
    Whole(Option<i32>),
    Text(&'a str),
}

/// A column.
pub(super) struct Column {
    pub(super) name: &'static str,
    pub(super) kind: ColumnKind,
    pub(super) cell: for<'a> fn(&TrajectoryRow<'a>) -> Cell<'a>,
}

/// The columns, in order. The first of them are those that `endless generate --traffic` reads.
pub(super) const COLUMNS: &[Column] = &[
    Column { name: "time", kind: Number(4), cell: |row| Cell::Number(Some(row.time_s)) },
    Column { name: "id", kind: Whole, cell: |row| Cell::Whole(Some(row.id.0.into())) },
    Column { name: "class", kind: Text, cell: |row| Cell::Text(row.class.into()) },
    Column { name: "x", kind: Number(3), cell: |row| Cell::Number(Some(row.position[0])) },
    Column { name: "y", kind: Number(3), cell: |row| Cell::Number(Some(row.position[1])) },
    Column { name: "z", kind: Number(3), cell: |row| Cell::Number(Some(row.position[2])) },
    Column { name: "yaw", kind: Number(5), cell: |row| Cell::Number(Some(row.yaw_rad)) },
    Column { name: "speed", kind: Number(3), cell: |row| Cell::Number(Some(row.speed_mps)) },
    Column { name: "length", kind: Number(2), cell: |row| Cell::Number(Some(row.size_m[0])) },
    Column { name: "width", kind: Number(2), cell: |row| Cell::Number(Some(row.size_m[1])) },
    Column { name: "height", kind: Number(2), cell: |row| Cell::Number(Some(row.size_m[2])) },
    Column { name: "model", kind: Text, cell: |row| Cell::Text(row.model) },
    Column { name: "acceleration", kind: Number(3), cell: |row| Cell::Number(row.acceleration_mps2) },
    Column { name: "lane", kind: Whole, cell: |row| Cell::Whole(row.lane.map(|lane| lane.lane as i32)) },
    Column { name: "lane_s", kind: Number(3), cell: |row| Cell::Number(row.lane.map(|lane| lane.s_m)) },
    Column { name: "lane_left", kind: Number(3), cell: |row| Cell::Number(row.lane.map(|lane| lane.left_m)) },
    Column { name: "road", kind: Whole, cell: |row| Cell::Whole(row.lane.map(|lane| lane.name.road as i32)) },
    Column { name: "road_lane", kind: Whole, cell: |row| Cell::Whole(row.lane.map(|lane| lane.name.lane)) },
    Column { name: "crossing", kind: Whole, cell: |row| Cell::Whole(row.crossing.map(i32::from)) },
];
