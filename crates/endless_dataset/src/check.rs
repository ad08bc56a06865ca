//! Checks a dataset: reads every file and lists all errors.

mod actors;
mod agreement;
mod camera;
mod camera_way;
mod frames;
mod incidents;
mod map;
mod objects;
mod progress;
mod report;
mod rig;
mod sensor_files;
mod tracks;
mod unexpected_files;
mod video;

pub use report::{CheckReport, Finding};

use crate::{CameraOutput, DatasetError, DatasetLayout, Manifest, ModelSpec, SensorSpec, VideoEntry, VideoState};
use progress::CheckProgress;
use rayon::{ThreadPoolBuilder, prelude::*};
use std::{collections::BTreeSet, fmt, io, path::Path};
use unexpected_files::unexpected_files;
use video::check_video;

/// Settings of a check.
#[derive(Clone, Copy, Default)]
pub struct CheckOptions<'a> {
    /// Threads; all cores where 0.
    pub threads: usize,
    /// Told how many frames of images and videos are done, and of how many, by any thread.
    pub progress: Option<&'a (dyn Fn(u64, u64) + Sync)>,
    /// The number of the only video that is looked into; all where none is named.
    pub only: Option<usize>,
}

impl fmt::Debug for CheckOptions<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("CheckOptions").field("threads", &self.threads).finish_non_exhaustive()
    }
}

/// Checks everything in a dataset's folder, on all cores.
///
/// # Errors
/// When there is no dataset to check.
pub fn check(root: &Path) -> Result<CheckReport, DatasetError> {
    check_with(root, &CheckOptions::default())
}

/// Checks everything in a dataset's folder.
///
/// # Errors
/// When there is no dataset to check, or no threads to do it.
pub fn check_with(root: &Path, options: &CheckOptions<'_>) -> Result<CheckReport, DatasetError> {
    let pool = ThreadPoolBuilder::new().num_threads(options.threads).build();
    let pool = pool.map_err(|e| DatasetError::io("cannot start threads", root, io::Error::other(e)))?;
    let layout = DatasetLayout::new(root);
    let manifest = Manifest::read(&layout.manifest())?;
    let mut report = CheckReport { videos: manifest.videos.len(), ..Default::default() };
    report.findings.extend(check_manifest(&layout, &manifest));
    let progress = CheckProgress::new(frames_to_check(&manifest), options.progress);
    let videos: Vec<&VideoEntry> = match options.only {
        Some(number) => manifest.videos.get(number).into_iter().collect(),
        None => manifest.videos.iter().collect(),
    };
    let videos: Vec<CheckReport> =
        pool.install(|| videos.par_iter().map(|video| check_video(&layout, &manifest, video, &progress)).collect());
    for video in videos {
        report.merge(video);
    }
    report.findings.sort_by(|a, b| (&a.path, &a.problem).cmp(&(&b.path, &b.problem)));
    Ok(report)
}

/// Frames of all images, and those of each video file.
fn frames_to_check(manifest: &Manifest) -> u64 {
    let recipe = &manifest.recipe;
    let complete = manifest.videos.iter().filter(|video| video.state == VideoState::Complete).count() as u64;
    let frames = |output: CameraOutput| u64::from(output.count()) * (1 + output.mp4.len() as u64);
    let of_rig = |sensor: &SensorSpec| match &sensor.model {
        ModelSpec::Camera(camera) => frames(recipe.rig_camera_output(sensor, camera)),
        _ => u64::from(recipe.frames().div_ceil(recipe.every(sensor))),
    };
    let cameras = u64::from(recipe.cameras_per_scene) * frames(recipe.camera_output());
    complete * (cameras + recipe.sensor.iter().map(of_rig).sum::<u64>())
}

fn check_manifest(layout: &DatasetLayout, manifest: &Manifest) -> Vec<Finding> {
    let mut findings = Vec::new();
    let path = layout.manifest();
    if manifest.videos.len() != manifest.recipe.videos as usize {
        let problem = format!("lists {} videos, its recipe says {}", manifest.videos.len(), manifest.recipe.videos);
        findings.push(Finding::new(&path, problem));
    }
    for (video, number) in manifest.videos.iter().zip(0..) {
        if video.video != number {
            findings.push(Finding::new(&path, format!("video {} stands in place {number}", video.video)));
        }
        let begun = video.state != VideoState::Planned;
        if (begun && video.builds.is_empty()) || video.builds.iter().any(|build| *build >= manifest.builds.len()) {
            findings.push(Finding::new(&path, format!("does not say which build made video {number}")));
        }
    }
    let expected_videos: BTreeSet<String> = manifest.videos.iter().map(|v| v.name.clone()).collect();
    let expected_scenes: BTreeSet<String> = manifest.videos.iter().map(|v| format!("{:04}.json", v.video)).collect();
    findings.extend(unexpected_files(&layout.videos(), &expected_videos));
    findings.extend(unexpected_files(&layout.scenes(), &expected_scenes));
    findings
}
