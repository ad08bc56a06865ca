//! `endless check`.

use crate::{args::CheckArgs, exit::FAILURE, progress_bar::bar_of};
use anyhow::{Context, Result};
use endless_dataset::{CheckOptions, DatasetError, check_with};
use std::{io::Write, process::ExitCode};

pub(crate) fn run(args: &CheckArgs, threads: usize) -> Result<ExitCode> {
    let bar = bar_of("frames of images and videos");
    let progress = |done, total| {
        bar.set_length(total);
        bar.set_position(done);
    };
    let options = CheckOptions { threads, progress: Some(&progress) };
    let checked = check_with(&args.out, &options);
    bar.finish_and_clear();
    let report = match checked {
        Err(error @ DatasetError::OtherFormat { .. }) => return Err(error.into()),
        other => other.context("there is no dataset to check")?,
    };
    let mut out = std::io::stdout().lock();
    for finding in &report.findings {
        writeln!(out, "{finding}")?;
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
