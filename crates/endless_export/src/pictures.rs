//! Pictures in the file format that a format asks for.

use crate::{ExportError, LabelledFrame, job::VideoJob};
use endless_dataset::{DatasetError, Layer, encode_png, write_atomic};

/// Puts the picture of a frame there as PNG: the dataset's file where it is one.
pub(crate) fn place_png(video: &VideoJob<'_>, frame: &LabelledFrame<'_>, below: &str) -> Result<(), ExportError> {
    if frame.sequence.extension(Layer::Rgb) == "png" {
        return video.place_image(frame, Layer::Rgb, below);
    }
    let stored = frame.read(Layer::Rgb)?;
    let image = stored
        .rgb8()
        .map_err(|reason| DatasetError::malformed(frame.sequence.image(Layer::Rgb, frame.frame), reason))?;
    Ok(write_atomic(&video.export.target.path(below)?, &encode_png(image))?)
}
