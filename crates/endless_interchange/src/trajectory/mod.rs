//! Trajectories: who was where, written as CSV, Parquet or SUMO's FCD. `docs/simulate.md` describes the columns.

mod column;
mod csv;
mod fcd;
mod format;
mod parquet;
mod row;
mod writer;

pub use format::TrajectoryFormat;
pub use row::{TrajectoryLane, TrajectoryRow, TrajectoryScene};
pub use writer::TrajectoryWriter;

#[cfg(test)]
mod tests;
