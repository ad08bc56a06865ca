//! The files of a sensor that is no camera: one or more a measurement.

use super::streams::Stream;
use crate::SensorReading;
use endless_dataset::{DatasetError, write_atomic};
use std::fs;

/// Writes the files of a measurement.
pub(super) fn write(stream: &Stream<'_>, frame: u32, reading: &SensorReading) -> Result<(), DatasetError> {
    for &folder in &stream.folders {
        let bytes = match reading {
            SensorReading::Lidar(sweep) => folder.of_sweep(sweep),
            SensorReading::Radar(scan) => folder.of_scan(scan),
            SensorReading::Camera(_) => None,
        };
        let path = stream.files.frame_file(folder, frame);
        let bytes =
            bytes.ok_or_else(|| DatasetError::malformed(&path, "cannot be: the simulator gives another reading"))?;
        write_atomic(&path, &bytes)?;
    }
    Ok(())
}

/// Whether the files of a measurement can be read.
pub(super) fn read(stream: &Stream<'_>, frame: u32) -> Result<(), DatasetError> {
    for &folder in &stream.folders {
        let path = stream.files.frame_file(folder, frame);
        let bytes = fs::read(&path).map_err(|e| DatasetError::io("cannot read", &path, e))?;
        folder.count(&bytes).map_err(|problem| DatasetError::malformed(&path, problem))?;
    }
    Ok(())
}
