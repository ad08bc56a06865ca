//! `endless bench`: the whole pipeline on a fixed recipe, under all conditions, while one thing grows, or exported.

mod conditions;
mod exports;
mod film;
mod scaling;
mod sensors;
mod stages;

use crate::args::BenchArgs;
use anyhow::Result;
use endless_pipeline::BuiltinSimulator;
use std::process::ExitCode;

pub(crate) use scaling::ScalingSeries;

pub(crate) fn run(simulator: &BuiltinSimulator, args: &BenchArgs, threads: usize) -> Result<ExitCode> {
    if let Some(dataset) = &args.export {
        return exports::run(simulator, args, dataset.as_deref(), threads);
    }
    if let Some(series) = &args.scaling {
        return scaling::run(simulator, args, series, threads);
    }
    if args.conditions {
        return conditions::run(simulator, args, threads);
    }
    stages::run(simulator, args, threads)
}
