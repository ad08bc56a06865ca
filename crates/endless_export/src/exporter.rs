//! What every format does.

use crate::{
    ExportError, SourceDataset,
    job::{Export, VideoJob},
};

/// Writes a dataset in one format. Videos come in order; one that was not finished comes again.
pub(crate) trait Exporter: Sync {
    /// Whether the dataset can be told in this format, before anything is written.
    fn fits(&self, _dataset: &SourceDataset) -> Result<(), ExportError> {
        Ok(())
    }

    /// Writes what comes of one video.
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError>;

    /// Writes what comes of all, when every video is done.
    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError>;
}
