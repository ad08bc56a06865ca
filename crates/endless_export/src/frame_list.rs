//! Which frame of the dataset a number is, in formats that number pictures: `frames.csv`.

use crate::{ExportError, LabelledFrame, job::Export};

/// Name of the part that holds its lines.
pub(crate) const PART: &str = "frames";

/// A line.
pub(crate) fn line(number: impl std::fmt::Display, frame: &LabelledFrame<'_>) -> String {
    let sequence = frame.sequence;
    format!("{number},{},{},{},{}\n", sequence.video.name, sequence.camera_name, frame.frame, frame.time_s)
}

/// Writes the file from the parts of all videos.
pub(crate) fn write(export: &Export<'_>) -> Result<(), ExportError> {
    let mut file = export.target.create("frames.csv")?;
    file.write(b"name,video,camera,frame,time_s\n")?;
    for video in export.videos() {
        for line in export.target.part_lines(PART, video.number)? {
            file.write((line? + "\n").as_bytes())?;
        }
    }
    Ok(file.finish()?)
}
