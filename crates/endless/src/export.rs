//! `endless export`.

use crate::{args::ExportArgs, progress_bar::bar_of, storage};
use anyhow::{Context, Result};
use endless_export::{ClassMapping, ExportOptions, Format, Placing, export};
use std::{
    io::{self, Write},
    process::ExitCode,
};

pub(crate) fn run(args: &ExportArgs) -> Result<ExitCode> {
    let (Some(out), Some(format), Some(to), false) = (&args.out, args.format, &args.to, args.list) else {
        list(&mut io::stdout().lock())?;
        return Ok(ExitCode::SUCCESS);
    };
    let out = &storage::folder(out)?;
    let classes = match &args.classes {
        None => ClassMapping::default(),
        Some(path) if path.as_os_str() == "coco" => ClassMapping::coco(),
        Some(path) => ClassMapping::read(path)?,
    };
    let bar = bar_of("frames");
    let progress = |done, total| {
        bar.set_length(total);
        bar.set_position(done);
    };
    let options = ExportOptions {
        format,
        to: to.clone(),
        split: args.split.clone(),
        by: args.by,
        classes,
        min_visibility: args.min_visibility,
        stride: args.stride,
        placing: if args.copy { Placing::Copy } else { Placing::Link },
        progress: Some(&progress),
    };
    let exported = export(out, &options);
    bar.finish_and_clear();
    let report = exported.with_context(|| format!("cannot export to {}", format.name()))?;
    let parts = report.splits.iter().map(|(name, videos, frames)| format!("{name} {videos} videos, {frames} frames"));
    let parts = parts.collect::<Vec<_>>().join("; ");
    let before = if report.complete_before { "was complete already" } else { "done" };
    eprintln!("{before}: {} of {} frames in {} ({parts})", format.name(), report.frames, to.display());
    Ok(ExitCode::SUCCESS)
}

/// The formats, a line each.
fn list(out: &mut impl Write) -> Result<()> {
    for format in Format::ALL {
        let entry = format.entry();
        let layers: Vec<&str> = entry.layers.iter().map(|layer| layer.name()).collect();
        writeln!(out, "{:<16} {:<58} needs {}", format.name(), entry.about, layers.join(","))?;
    }
    Ok(())
}
