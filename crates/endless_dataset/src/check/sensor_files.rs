//! The files of a sensor other than a camera: all are there and can be read.

use super::{
    progress::CheckProgress,
    report::{CheckReport, Finding},
    unexpected_files::unexpected_files,
};
use crate::{CameraLayout, DatasetError, FrameFolder, ModelSpec, read_lines};
use endless_annotate::{CollisionEvent, LaneInvasionEvent};
use endless_world::{GnssRecord, ImuRecord};
use rayon::prelude::*;
use std::{collections::BTreeSet, fs, path::Path};

/// What is wrong with the files of a sensor that measured at these frames.
pub(super) fn check_sensor_files(
    files: &CameraLayout,
    model: &ModelSpec,
    frames: &[u32],
    progress: &CheckProgress<'_>,
) -> CheckReport {
    let folders = model.frame_folders();
    let mut expected = BTreeSet::from(["sensor.json".to_owned(), "poses.jsonl".to_owned()]);
    expected.extend(folders.iter().map(|folder| folder.name().to_owned()));
    expected.extend(model.lines_file().map(str::to_owned));
    let mut report = CheckReport::default();
    report.findings.extend(unexpected_files(files.folder(), &expected));
    for &folder in &folders {
        let names = frames.iter().map(|frame| folder.file(*frame)).collect();
        report.findings.extend(unexpected_files(&files.frame_folder(folder), &names));
    }
    let of_frame = |frame: &u32| {
        let findings = wrong_frame(files, &folders, *frame);
        progress.add(1);
        findings
    };
    let wrong: Vec<Finding> = frames.par_iter().flat_map_iter(of_frame).collect();
    report.findings.extend(wrong);
    if let Some(name) = model.lines_file() {
        report.findings.extend(wrong_lines(&files.folder().join(name), model, frames));
    }
    report
}

/// The files of a frame can be read, and those of a LiDAR have as many points as one another.
fn wrong_frame(files: &CameraLayout, folders: &[FrameFolder], frame: u32) -> Vec<Finding> {
    let count = |folder: &FrameFolder| {
        let path = files.frame_file(*folder, frame);
        let bytes = fs::read(&path).map_err(|e| Finding::from(DatasetError::io("cannot read", &path, e)))?;
        folder.count(&bytes).map_err(|problem| Finding::new(path, problem))
    };
    let (counts, mut findings): (Vec<usize>, Vec<Finding>) = {
        let (good, bad): (Vec<_>, Vec<_>) = folders.iter().map(count).partition(Result::is_ok);
        (good.into_iter().flatten().collect(), bad.into_iter().filter_map(Result::err).collect())
    };
    if counts.windows(2).any(|pair| pair[0] != pair[1]) {
        let path = files.frame_file(folders[0], frame);
        findings.push(Finding::new(path, "has not as many points as the other files of its frame"));
    }
    findings
}

/// Lines of an IMU and of a receiver are those of its frames; of what happens, frames go up.
fn wrong_lines(path: &Path, model: &ModelSpec, frames: &[u32]) -> Option<Finding> {
    let told: Result<Vec<u32>, DatasetError> = match model {
        ModelSpec::Imu(_) => read_lines::<ImuRecord>(path).map(|lines| lines.iter().map(|l| l.frame).collect()),
        ModelSpec::Gnss(_) => read_lines::<GnssRecord>(path).map(|lines| lines.iter().map(|l| l.frame).collect()),
        ModelSpec::Collision => read_lines::<CollisionEvent>(path).map(|lines| lines.iter().map(|l| l.frame).collect()),
        _ => read_lines::<LaneInvasionEvent>(path).map(|lines| lines.iter().map(|l| l.frame).collect()),
    };
    let each_frame = matches!(model, ModelSpec::Imu(_) | ModelSpec::Gnss(_));
    match told {
        Err(error) => Some(error.into()),
        Ok(told) if each_frame && told != frames => {
            Some(Finding::new(path, format!("has {} lines for {} frames, or others", told.len(), frames.len())))
        }
        Ok(told) if !each_frame && !told.is_sorted() => Some(Finding::new(path, "is not in the order of frames")),
        Ok(_) => None,
    }
}
