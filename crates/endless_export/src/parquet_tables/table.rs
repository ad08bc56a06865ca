//! A table that is written a group of rows at a time.

use crate::{ExportError, sink::Sink};
use endless_dataset::{AtomicFile, DatasetError};
use parquet::{
    basic::Compression,
    column::writer::ColumnWriter,
    data_type::ByteArray,
    errors::ParquetError,
    file::{properties::WriterProperties, writer::SerializedFileWriter},
    schema::parser::parse_message_type,
};
use std::{io, sync::Arc};

/// Rows of a group: they are kept in memory until it is written.
const GROUP: usize = 1 << 15;

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Whole,
    Number,
    Truth,
    Text,
    /// A list of numbers.
    Numbers,
}

/// A value of a row.
#[derive(Debug, Clone)]
pub(super) enum Cell {
    Missing,
    Whole(i64),
    Number(f64),
    Truth(bool),
    Text(String),
    Numbers(Vec<f64>),
}

impl<T: Into<Self>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Missing, Into::into)
    }
}

macro_rules! cells {
    ($($from:ty => $to:ident),*) => {
        $(impl From<$from> for Cell {
            fn from(value: $from) -> Self {
                Self::$to(value.into())
            }
        })*
    };
}
cells!(u32 => Whole, u16 => Whole, i32 => Whole, f64 => Number, bool => Truth, &str => Text, String => Text, Vec<f64> => Numbers);

/// A file that is written group by group.
pub(super) struct Table {
    writer: SerializedFileWriter<Sink>,
    kinds: Vec<Kind>,
    rows: Vec<Vec<Cell>>,
}

/// Says what the disk said, as far as the library tells.
fn refused(error: ParquetError) -> ExportError {
    let cause = match error {
        ParquetError::External(cause) => match cause.downcast::<io::Error>() {
            Ok(cause) => match cause.downcast::<DatasetError>() {
                Ok(own) => return own.into(),
                Err(cause) => cause,
            },
            Err(cause) => io::Error::other(cause),
        },
        other => io::Error::other(other),
    };
    DatasetError::io("cannot write", "a table", cause).into()
}

/// The schema, in Parquet's own notation.
fn schema(name: &str, columns: &[(&str, Kind)]) -> String {
    let field = |(name, kind): &(&str, Kind)| match kind {
        Kind::Whole => format!("optional int64 {name};"),
        Kind::Number => format!("optional double {name};"),
        Kind::Truth => format!("optional boolean {name};"),
        Kind::Text => format!("optional binary {name} (UTF8);"),
        Kind::Numbers => {
            format!("optional group {name} (LIST) {{ repeated group list {{ required double element; }} }}")
        }
    };
    format!("message {name} {{ {} }}", columns.iter().map(field).collect::<Vec<_>>().join(" "))
}

impl Table {
    pub(super) fn begin(file: AtomicFile, name: &str, columns: &[(&str, Kind)]) -> Result<Self, ExportError> {
        let schema = Arc::new(parse_message_type(&schema(name, columns)).map_err(refused)?);
        let properties = Arc::new(WriterProperties::builder().set_compression(Compression::SNAPPY).build());
        let writer = SerializedFileWriter::new(Sink(file), schema, properties).map_err(refused)?;
        Ok(Self { writer, kinds: columns.iter().map(|(_, kind)| *kind).collect(), rows: Vec::new() })
    }

    /// Appends a row: a cell a column.
    pub(super) fn push(&mut self, row: Vec<Cell>) -> Result<(), ExportError> {
        assert_eq!(row.len(), self.kinds.len(), "a cell a column");
        self.rows.push(row);
        if self.rows.len() >= GROUP { self.write_group() } else { Ok(()) }
    }

    fn write_group(&mut self) -> Result<(), ExportError> {
        let rows = std::mem::take(&mut self.rows);
        let mut group = self.writer.next_row_group().map_err(refused)?;
        for column in 0..self.kinds.len() {
            let Some(mut writer) = group.next_column().map_err(refused)? else { break };
            let cells = rows.iter().map(|row| &row[column]);
            write_column(writer.untyped(), cells).map_err(refused)?;
            writer.close().map_err(refused)?;
        }
        group.close().map_err(refused)?;
        Ok(())
    }

    pub(super) fn finish(mut self) -> Result<(), ExportError> {
        if !self.rows.is_empty() {
            self.write_group()?;
        }
        Ok(self.writer.into_inner().map_err(refused)?.0.finish()?)
    }
}

/// Levels tell which cells have values: 1 where there is one; of lists 0 where there is none, 1 of an empty one, 2 of a number.
fn write_column<'c>(
    writer: &mut ColumnWriter<'_>,
    cells: impl Iterator<Item = &'c Cell> + Clone,
) -> Result<usize, ParquetError> {
    let present: Vec<i16> = cells.clone().map(|cell| i16::from(!matches!(cell, Cell::Missing))).collect();
    let levels = Some(&present[..]);
    match writer {
        ColumnWriter::Int64ColumnWriter(writer) => {
            let values: Vec<i64> =
                cells.filter_map(|cell| if let Cell::Whole(v) = cell { Some(*v) } else { None }).collect();
            writer.write_batch(&values, levels, None)
        }
        ColumnWriter::BoolColumnWriter(writer) => {
            let values: Vec<bool> =
                cells.filter_map(|cell| if let Cell::Truth(v) = cell { Some(*v) } else { None }).collect();
            writer.write_batch(&values, levels, None)
        }
        ColumnWriter::ByteArrayColumnWriter(writer) => {
            let text = |cell: &Cell| if let Cell::Text(v) = cell { Some(ByteArray::from(v.as_str())) } else { None };
            let values: Vec<ByteArray> = cells.filter_map(text).collect();
            writer.write_batch(&values, levels, None)
        }
        ColumnWriter::DoubleColumnWriter(writer) => {
            let (mut values, mut defined, mut repeated, mut lists) = (Vec::new(), Vec::new(), Vec::new(), false);
            for cell in cells {
                match cell {
                    Cell::Number(value) => values.push(*value),
                    Cell::Numbers(list) => {
                        lists = true;
                        for (place, value) in list.iter().enumerate() {
                            values.push(*value);
                            defined.push(2);
                            repeated.push(i16::from(place > 0));
                        }
                        if list.is_empty() {
                            defined.push(1);
                            repeated.push(0);
                        }
                    }
                    _ => {
                        defined.push(0);
                        repeated.push(0);
                    }
                }
            }
            if lists || writer.get_descriptor().max_rep_level() > 0 {
                writer.write_batch(&values, Some(&defined), Some(&repeated))
            } else {
                writer.write_batch(&values, levels, None)
            }
        }
        _ => Ok(0),
    }
}
