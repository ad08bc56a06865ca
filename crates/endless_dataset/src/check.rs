//! Reopens a whole dataset and names everything that is wrong with it.

mod camera;
mod report;
mod tracks;

pub use report::{CheckReport, Finding};

use crate::{
    DatasetError, DatasetLayout, MAX_CAMERAS, Manifest, SceneRecord, VideoEntry, VideoLayout, VideoState, read_json,
};
use endless_world::SceneSettings;
use rayon::prelude::*;
use report::strangers;
use std::path::Path;

/// Checks everything in a dataset's folder.
///
/// # Errors
/// When there is no dataset to check.
pub fn check(root: &Path) -> Result<CheckReport, DatasetError> {
    let layout = DatasetLayout::new(root);
    let manifest = Manifest::read(&layout.manifest())?;
    let mut report = CheckReport { videos: manifest.videos.len(), ..Default::default() };
    report.findings.extend(check_manifest(&layout, &manifest));
    for video in &manifest.videos {
        report.merge(check_video(&layout, &manifest, video));
    }
    report.findings.sort_by(|a, b| (&a.path, &a.problem).cmp(&(&b.path, &b.problem)));
    Ok(report)
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
    let expected_videos: Vec<String> = manifest.videos.iter().map(|v| v.name.clone()).collect();
    let expected_scenes: Vec<String> = manifest.videos.iter().map(|v| format!("{:04}.json", v.video)).collect();
    findings.extend(strangers(&layout.videos(), &expected_videos));
    findings.extend(strangers(&layout.scenes(), &expected_scenes));
    findings
}

fn check_video(layout: &DatasetLayout, manifest: &Manifest, entry: &VideoEntry) -> CheckReport {
    let video = layout.video_named(&entry.name);
    let mut report = CheckReport::default();
    if entry.state != VideoState::Complete {
        report.findings.push(Finding::new(video.folder(), "is not complete: run the same command again"));
        return report;
    }
    let planned: Result<SceneSettings, _> = read_json(&layout.scene(entry.video));
    let record: Result<SceneRecord, _> = read_json(&video.scene());
    let (planned, record) = match (planned, record) {
        (Ok(planned), Ok(record)) => (planned, record),
        (planned, record) => {
            report.findings.extend(planned.err().map(Finding::from));
            report.findings.extend(record.err().map(Finding::from));
            return report;
        }
    };
    if record.settings != planned {
        report.findings.push(Finding::new(video.scene(), "differs from the planned settings in scenes/"));
    }
    if record.recorded_frames != manifest.recipe.frames() || entry.frames != record.recorded_frames {
        let problem = format!("{} frames recorded, {} asked for", record.recorded_frames, manifest.recipe.frames());
        report.findings.push(Finding::new(video.scene(), problem));
    }
    let count = manifest.recipe.cameras_per_scene as usize;
    if count > MAX_CAMERAS as usize || record.settings.cameras.len() != count || record.boxes.len() != count {
        let problem = format!("does not speak of {count} cameras, as the recipe does");
        report.findings.push(Finding::new(video.scene(), problem));
        return report;
    }
    let folders: Vec<String> = (0..count).map(VideoLayout::camera_name).chain(["scene.json".to_owned()]).collect();
    report.findings.extend(strangers(video.folder(), &folders));
    let cameras: Vec<camera::CameraCheck> = (0..count)
        .into_par_iter()
        .map(|i| camera::check_camera(&video.camera(i), &record.settings, i, &manifest.recipe))
        .collect();
    for (i, camera) in cameras.iter().enumerate() {
        if camera.report.boxes != record.boxes[i] {
            let name = VideoLayout::camera_name(i);
            let problem = format!("says {} boxes, {name} has {}", record.boxes[i], camera.report.boxes);
            report.findings.push(Finding::new(video.scene(), problem));
        }
    }
    let tracks: Vec<_> = cameras.iter().map(|c| &c.tracks).collect();
    report.findings.extend(tracks::disagreements(video.folder(), &tracks));
    for camera in cameras {
        report.merge(camera.report);
    }
    report
}
