//! `endless bench --export`: what each format costs.

use super::film::{draft, film_for};
use crate::{args::BenchArgs, memory, threads::on_threads};
use anyhow::Result;
use endless_dataset::DatasetLayout;
use endless_export::{ExportError, ExportOptions, Format, export};
use endless_pipeline::{MapSource, Simulator};
use std::{fs, io::Write, path::Path, process::ExitCode, time::Instant};

/// Exports the dataset that is given, or one that is made for it, to every format.
pub(super) fn run<S: Simulator + MapSource>(
    simulator: &S,
    args: &BenchArgs,
    dataset: Option<&Path>,
    threads: usize,
) -> Result<ExitCode> {
    match dataset {
        Some(dataset) => on_threads(threads, || time(dataset))?,
        None => drop(film_for(simulator, draft(args), threads, |out| on_threads(threads, || time(out)))?),
    }
    Ok(ExitCode::SUCCESS)
}

/// A line a format. What is written goes beside the dataset, so that pictures are hard links, and goes away.
fn time(dataset: &Path) -> Result<()> {
    let mut out = std::io::stdout().lock();
    writeln!(out, "format             seconds   frames   a second")?;
    let layout = DatasetLayout::new(dataset);
    for &format in Format::ALL {
        let name = format!(".endless-bench-export-{}", std::process::id());
        let to = layout.root().parent().unwrap_or(Path::new(".")).join(name);
        let options = ExportOptions::new(format, to.clone());
        let begin = Instant::now();
        let made = export(dataset, &options);
        let seconds = begin.elapsed().as_secs_f64();
        if to.exists() {
            fs::remove_dir_all(&to)?;
        }
        match made {
            Ok(made) => {
                let rate = made.frames as f64 / seconds.max(1e-9);
                writeln!(out, "{:<16} {seconds:>9.2} {:>8} {rate:>10.0}", format.name(), made.frames)?;
            }
            Err(error @ (ExportError::MissingLayer { .. } | ExportError::Unfit { .. })) => {
                writeln!(out, "{:<16} {error}", format.name())?;
            }
            Err(error) => return Err(error.into()),
        }
    }
    if let Some(peak) = memory::peak_megabytes() {
        writeln!(out, "peak memory      {peak:.0} MB")?;
    }
    Ok(())
}
