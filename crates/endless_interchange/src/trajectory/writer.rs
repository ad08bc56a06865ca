//! Writes a file of trajectories, instant by instant.

use super::csv;
use super::fcd;
use super::format::TrajectoryFormat;
use super::parquet::RowGroups;
use super::row::TrajectoryRow;
use endless_dataset::{AtomicFile, DatasetError};
use std::path::Path;

/// A file of trajectories. It gets its name when it is finished; memory does not grow with its length.
pub struct TrajectoryWriter {
    sink: Sink,
    /// Of one instant.
    text: String,
}

enum Sink {
    Csv(AtomicFile),
    Fcd(AtomicFile),
    Parquet(Box<RowGroups>),
}

impl std::fmt::Debug for TrajectoryWriter {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TrajectoryWriter").finish_non_exhaustive()
    }
}

impl TrajectoryWriter {
    /// Begins a file.
    ///
    /// # Errors
    /// When it cannot be created.
    pub fn create(path: &Path, format: TrajectoryFormat) -> Result<Self, DatasetError> {
        let mut file = AtomicFile::create(path)?;
        let sink = match format {
            TrajectoryFormat::Csv => {
                file.write(csv::header().as_bytes())?;
                Sink::Csv(file)
            }
            TrajectoryFormat::Fcd => {
                file.write(fcd::HEADER.as_bytes())?;
                Sink::Fcd(file)
            }
            TrajectoryFormat::Parquet => Sink::Parquet(Box::new(RowGroups::begin(file)?)),
        };
        Ok(Self { sink, text: String::new() })
    }

    /// Appends the rows of an instant; instants must ascend.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn push(&mut self, time_s: f64, rows: &[TrajectoryRow<'_>]) -> Result<(), DatasetError> {
        self.text.clear();
        match &mut self.sink {
            Sink::Csv(file) => {
                csv::write_rows(rows, &mut self.text);
                file.write(self.text.as_bytes())
            }
            Sink::Fcd(file) => {
                fcd::write_rows(time_s, rows, &mut self.text);
                file.write(self.text.as_bytes())
            }
            Sink::Parquet(groups) => groups.push(rows),
        }
    }

    /// Completes the file and gives it its name.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn finish(self) -> Result<(), DatasetError> {
        match self.sink {
            Sink::Csv(file) => file.finish_durable(),
            Sink::Fcd(mut file) => {
                file.write(fcd::FOOTER.as_bytes())?;
                file.finish_durable()
            }
            Sink::Parquet(groups) => groups.finish(),
        }
    }
}
