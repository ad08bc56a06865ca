//! Parquet: the columns of the CSV, a group of rows at a time.

use super::column::{COLUMNS, Cell, ColumnKind};
use super::row::TrajectoryRow;
use endless_dataset::{AtomicFile, DatasetError};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use std::io;
use std::sync::Arc;

/// Rows of a group: they are kept in memory until it is written.
const GROUP: usize = 1 << 16;

/// A file that is written group by group.
pub(super) struct RowGroups {
    writer: SerializedFileWriter<AtomicSink>,
    columns: Vec<Values>,
    rows: usize,
}

/// What a group has in a column, with 1 for each value and 0 where there is none.
struct Values {
    present: Vec<i16>,
    values: TypedValues,
}

enum TypedValues {
    Numbers(Vec<f64>),
    Whole(Vec<i32>),
    Texts(Vec<ByteArray>),
}

/// The file as the library wants it.
struct AtomicSink(AtomicFile);

impl io::Write for AtomicSink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes).map_err(io::Error::other)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Says what the disk said, as far as the library tells.
fn refused(error: ParquetError) -> DatasetError {
    let cause = match error {
        ParquetError::External(cause) => match cause.downcast::<io::Error>() {
            Ok(cause) => *cause,
            Err(cause) => io::Error::other(cause),
        },
        other => io::Error::other(other),
    };
    DatasetError::io("cannot write", "trajectories", cause)
}

/// The schema, in Parquet's own notation.
fn schema() -> String {
    let fields = COLUMNS.iter().map(|column| {
        let kind = match column.kind {
            ColumnKind::Number(_) => "double",
            ColumnKind::Whole => "int32",
            ColumnKind::Text => "binary",
        };
        let annotation = if column.kind == ColumnKind::Text { " (UTF8)" } else { "" };
        format!("optional {kind} {}{annotation};", column.name)
    });
    format!("message trajectories {{ {} }}", fields.collect::<Vec<_>>().join(" "))
}

fn empty_columns() -> Vec<Values> {
    let values = COLUMNS.iter().map(|column| match column.kind {
        ColumnKind::Number(_) => TypedValues::Numbers(Vec::new()),
        ColumnKind::Whole => TypedValues::Whole(Vec::new()),
        ColumnKind::Text => TypedValues::Texts(Vec::new()),
    });
    values.map(|values| Values { present: Vec::new(), values }).collect()
}

impl RowGroups {
    pub(super) fn begin(file: AtomicFile) -> Result<Self, DatasetError> {
        let schema = Arc::new(parse_message_type(&schema()).map_err(refused)?);
        let properties = Arc::new(WriterProperties::builder().build());
        let writer = SerializedFileWriter::new(AtomicSink(file), schema, properties).map_err(refused)?;
        Ok(Self { writer, columns: empty_columns(), rows: 0 })
    }

    pub(super) fn push(&mut self, rows: &[TrajectoryRow<'_>]) -> Result<(), DatasetError> {
        for row in rows {
            for (column, of) in self.columns.iter_mut().zip(COLUMNS) {
                let present = match ((of.cell)(row), &mut column.values) {
                    (Cell::Number(number), TypedValues::Numbers(values)) => push_some(values, number),
                    (Cell::Whole(number), TypedValues::Whole(values)) => push_some(values, number),
                    (Cell::Text(text), TypedValues::Texts(values)) => push_some(values, Some(text.into())),
                    _ => false,
                };
                column.present.push(i16::from(present));
            }
        }
        self.rows += rows.len();
        if self.rows >= GROUP { self.write_group() } else { Ok(()) }
    }

    fn write_group(&mut self) -> Result<(), DatasetError> {
        let mut group = self.writer.next_row_group().map_err(refused)?;
        for column in std::mem::replace(&mut self.columns, empty_columns()) {
            let Some(mut writer) = group.next_column().map_err(refused)? else { break };
            let present = Some(&column.present[..]);
            let written = match (writer.untyped(), &column.values) {
                (ColumnWriter::DoubleColumnWriter(writer), TypedValues::Numbers(values)) => {
                    writer.write_batch(values, present, None)
                }
                (ColumnWriter::Int32ColumnWriter(writer), TypedValues::Whole(values)) => {
                    writer.write_batch(values, present, None)
                }
                (ColumnWriter::ByteArrayColumnWriter(writer), TypedValues::Texts(values)) => {
                    writer.write_batch(values, present, None)
                }
                _ => Ok(0),
            };
            written.map_err(refused)?;
            writer.close().map_err(refused)?;
        }
        group.close().map_err(refused)?;
        self.rows = 0;
        Ok(())
    }

    pub(super) fn finish(mut self) -> Result<(), DatasetError> {
        if self.rows > 0 {
            self.write_group()?;
        }
        self.writer.into_inner().map_err(refused)?.0.finish_durable()
    }
}

/// Appends a value if there is one; whether there is.
fn push_some<T>(values: &mut Vec<T>, value: Option<T>) -> bool {
    let present = value.is_some();
    values.extend(value);
    present
}
