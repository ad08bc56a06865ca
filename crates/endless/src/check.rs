//! `endless check`.

use crate::{args::CheckArgs, exit::FAILURE};
use anyhow::{Context, Result};
use endless_dataset::DatasetError;
use std::{io::Write, process::ExitCode};

pub(crate) fn run(args: &CheckArgs) -> Result<ExitCode> {
    let report = match endless_dataset::check(&args.out) {
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
