//! `endless stats` and `endless compare`.

use crate::args::{CompareArgs, StatsArgs, StatsOutputs};
use crate::file::{make_folder_of, write};
use crate::{progress_bar::bar_of, storage};
use anyhow::{Result, bail};
use endless_dataset::{DatasetError, write_json_durable};
use endless_statistics::{CocoClasses, Comparison, DatasetStatistics, GatherOptions, Report};
use std::{io::Write, path::Path, process::ExitCode};

pub(crate) fn stats(args: &StatsArgs) -> Result<ExitCode> {
    may_be_written(&args.outputs)?;
    let mut all: Option<DatasetStatistics> = None;
    for folder in &args.out {
        let next = of_dataset(folder, args.outputs.stride)?;
        all = Some(match all {
            Some(before) => before.and(next),
            None => next,
        });
    }
    let Some(statistics) = all else { bail!("give the folder of a dataset") };
    let json = |path: &Path| write_json_durable(path, &statistics);
    write_all(&args.outputs, json, || Report::of_dataset(&statistics))
}

pub(crate) fn compare(args: &CompareArgs) -> Result<ExitCode> {
    may_be_written(&args.outputs)?;
    if args.b.is_none() && args.coco.is_none() {
        bail!("there is nothing to compare it with: give a second folder, or --coco FILE.json");
    }
    // What is soon read is read first, so that its faults are soon told.
    let classes = args.coco_classes.as_deref().map(CocoClasses::read).transpose()?.unwrap_or_default();
    let mut sides = vec![of_dataset(&args.a, args.outputs.stride)?];
    if let Some(folder) = &args.b {
        sides.push(of_dataset(folder, args.outputs.stride)?);
    }
    if let Some(file) = &args.coco {
        sides.push(DatasetStatistics::of_coco(file, &classes)?);
    }
    let comparison = Comparison::new(sides);
    let json = |path: &Path| write_json_durable(path, &comparison);
    write_all(&args.outputs, json, || Report::of_comparison(&comparison))
}

fn of_dataset(folder: &Path, stride: u32) -> Result<DatasetStatistics> {
    let folder = &storage::folder(folder)?;
    let bar = bar_of("camera frames");
    let progress = |done, total| {
        bar.set_length(total);
        bar.set_position(done);
    };
    let counted = DatasetStatistics::of_dataset(folder, &GatherOptions { stride, progress: Some(&progress) });
    bar.finish_and_clear();
    Ok(counted?)
}

/// Looked at before the work: no file is replaced unasked.
fn may_be_written(outputs: &StatsOutputs) -> Result<()> {
    let files = [&outputs.json, &outputs.html];
    for path in files.into_iter().flatten() {
        if path.is_dir() {
            bail!("this is a folder: give the name of a file: {}", path.display());
        }
        if path.exists() && !outputs.force {
            bail!("this file exists: give another name, or --force to replace it: {}", path.display());
        }
    }
    if outputs.json.is_some() && outputs.json == outputs.html {
        bail!("--json and --html name the same file: give two names");
    }
    Ok(())
}

/// Text where no file is asked for.
fn write_all(
    outputs: &StatsOutputs,
    json: impl Fn(&Path) -> Result<(), DatasetError>,
    report: impl Fn() -> Report,
) -> Result<ExitCode> {
    if let Some(path) = &outputs.json {
        make_folder_of(path)?;
        json(path)?;
    }
    if let Some(path) = &outputs.html {
        write(path, report().page().as_bytes())?;
    }
    if outputs.json.is_none() && outputs.html.is_none() {
        std::io::stdout().lock().write_all(report().text().as_bytes())?;
    }
    Ok(ExitCode::SUCCESS)
}
