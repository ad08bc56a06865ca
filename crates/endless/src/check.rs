//! `endless check`.

use crate::{args::CheckArgs, exit::FAILURE, progress_bar::bar_of, storage};
use anyhow::{Context, Result};
use endless_dataset::{CheckOptions, DatasetError, DatasetLayout, VideoLayout, check_with};
use endless_pipeline::{Plan, Shard};
use endless_storage::DatasetAddress;
use std::{io::Write, path::Path, process::ExitCode};

pub(crate) fn run(args: &CheckArgs, threads: usize) -> Result<ExitCode> {
    let bar = bar_of("frames of images and videos");
    let progress = |done, total| {
        bar.set_length(total);
        bar.set_position(done);
    };
    let (root, report, _temporary);
    match storage::address(&args.out)? {
        DatasetAddress::Folder(folder) => {
            let options = CheckOptions { threads, progress: Some(&progress), ..CheckOptions::default() };
            let checked = check_with(&folder, &options);
            bar.finish_and_clear();
            report = match checked {
                Err(error @ DatasetError::OtherFormat { .. }) => return Err(error.into()),
                other => other.context("there is no dataset to check")?,
            };
            root = folder;
        }
        DatasetAddress::Storage(address) => {
            let folder = tempfile::tempdir().context("cannot make a temporary folder")?;
            let checked = storage::check_there(&address, folder.path(), threads, &progress);
            bar.finish_and_clear();
            report = checked?;
            root = folder.path().to_owned();
            _temporary = folder;
        }
    }
    let mut out = std::io::stdout().lock();
    for finding in &report.findings {
        writeln!(out, "{finding}")?;
    }
    if let Some(shards) = args.shards {
        for (shard, missing) in missing_of_shards(&root, shards)? {
            writeln!(out, "shard {shard} still has to make {}: run it again", missing.join(", "))?;
        }
    }
    let counts = format!("{} videos, {} images, {} boxes", report.videos, report.images, report.boxes);
    match report.findings.len() {
        0 => {
            eprintln!("all is well: {counts}");
            Ok(ExitCode::SUCCESS)
        }
        wrong => {
            eprintln!("error: {wrong} findings in {counts}");
            Ok(ExitCode::from(FAILURE))
        }
    }
}

/// Shards whose videos are not all complete, and the names of these.
fn missing_of_shards(root: &Path, shards: u32) -> Result<Vec<(Shard, Vec<String>)>> {
    let layout = DatasetLayout::new(root);
    let plan = Plan::read(&layout)?;
    let missing = |videos: Vec<u32>| -> Vec<String> {
        let scenes = videos.into_iter().map(|video| &plan.scenes[video as usize]);
        scenes.filter(|scene| !layout.video(scene).scene().exists()).map(VideoLayout::name).collect()
    };
    let by_shard = Shard::all(shards).zip(plan.shards(shards)).map(|(shard, videos)| (shard, missing(videos)));
    Ok(by_shard.filter(|(_, missing)| !missing.is_empty()).collect())
}
