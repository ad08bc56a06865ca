//! Parquet: a table of frames and one of objects, `frames/split=train/VIDEO.parquet` and `objects/split=train/VIDEO.parquet`, that
//! pyarrow, pandas, polars and DuckDB open as one (Hive partitions).

mod table;
mod tables;

pub(crate) use tables::ParquetTables;
