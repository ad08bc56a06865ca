//! One video: its settings, its cameras, and that they agree.

use super::{
    actors::check_actors,
    camera::{self, check_scene_camera},
    frames::check_frames,
    incidents::check_incidents,
    progress::CheckProgress,
    report::{CheckReport, Finding},
    rig::check_sensor,
    tracks,
    unexpected_files::unexpected_files,
};
use crate::{
    BuildIdentity, DatasetLayout, MAX_CAMERAS, Manifest, SceneRecord, VideoEntry, VideoLayout, VideoState, read_json,
};
use endless_world::SceneSettings;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Checks a video.
pub(super) fn check_video(
    layout: &DatasetLayout,
    manifest: &Manifest,
    entry: &VideoEntry,
    progress: &CheckProgress<'_>,
) -> CheckReport {
    let video = layout.video_named(&entry.name);
    let mut report = CheckReport::default();
    if entry.state != VideoState::Complete {
        let problem = if video.scene().exists() {
            "is complete, and dataset.json does not say so: run the same command again"
        } else {
            "is not complete: run the same command again"
        };
        report.findings.push(Finding::new(video.folder(), problem));
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
    let sensors = manifest.recipe.sensor.len();
    if record.settings.sensors.len() != sensors || record.sensor_boxes.len() != sensors {
        let problem = format!("does not speak of {sensors} sensors of a rig, as the recipe does");
        report.findings.push(Finding::new(video.scene(), problem));
        return report;
    }
    let mut folders: BTreeSet<String> =
        (0..count).map(VideoLayout::camera_name).chain(["scene.json".to_owned()]).collect();
    // Before format 3 there was none.
    folders.extend((manifest.format >= 3).then(|| "builds.json".to_owned()));
    folders.extend(record.settings.sensors.iter().map(|sensor| sensor.name.clone()));
    folders.extend(record.actors.map(|_| "actors.json".to_owned()));
    folders.extend(video.frames().is_file().then(|| "frames.jsonl".to_owned()));
    report.findings.extend(unexpected_files(video.folder(), &folders));
    report.findings.extend(missing_files(&video, &record));
    report.findings.extend(check_builds(&video, manifest, entry));
    report.findings.extend(check_frames(&video, &record.settings, &manifest.recipe));
    let cameras: Vec<camera::CameraCheck> = (0..count)
        .into_par_iter()
        .map(|i| check_scene_camera(&video.camera(i), &record.settings, i, &manifest.recipe, progress))
        .chain(
            (0..sensors).into_par_iter().map(|i| check_sensor(&video, &record.settings, &manifest.recipe, i, progress)),
        )
        .collect();
    let names = (0..count).map(VideoLayout::camera_name);
    let names = names.chain(record.settings.sensors.iter().map(|sensor| sensor.name.clone()));
    let told = record.boxes.iter().chain(&record.sensor_boxes);
    for ((camera, name), told) in cameras.iter().zip(names).zip(told) {
        if camera.report.boxes != *told {
            let problem = format!("says {told} boxes, {name} has {}", camera.report.boxes);
            report.findings.push(Finding::new(video.scene(), problem));
        }
    }
    let tracks: Vec<_> = cameras.iter().map(|c| &c.tracks).collect();
    report.findings.extend(tracks::disagreements(video.folder(), &tracks));
    report.findings.extend(check_actors(&video, &record, &tracks));
    report.findings.extend(check_incidents(&video, &record));
    for camera in cameras {
        report.merge(camera.report);
    }
    report
}

/// Checks that the video and the manifest name the same builds.
fn check_builds(video: &VideoLayout, manifest: &Manifest, entry: &VideoEntry) -> Option<Finding> {
    let same = |mine: &BuildIdentity, index: &usize| {
        manifest.builds.get(*index).is_some_and(|listed| listed == mine || listed.makes_same_bytes(mine))
    };
    match video.read_builds() {
        _ if manifest.format < 3 => None,
        None => Some(Finding::new(video.builds(), "does not say which build made the video")),
        Some(builds)
            if builds.len() == entry.builds.len() && builds.iter().zip(&entry.builds).all(|(b, i)| same(b, i)) =>
        {
            None
        }
        Some(_) => {
            Some(Finding::new(video.builds(), "names other builds than dataset.json: run the same command again"))
        }
    }
}

/// Files that `scene.json` says are there.
fn missing_files(video: &VideoLayout, record: &SceneRecord) -> Vec<Finding> {
    let frames = record.frame_lines.map(|_| video.frames());
    let maps = (0..record.camera_maps.unwrap_or(0) as usize).map(|camera| video.camera(camera).map());
    let missing = frames.into_iter().chain(maps).filter(|path| !path.is_file());
    missing.map(|path| Finding::new(path, "is missing, and scene.json says that it is there")).collect()
}
