//! `endless bench --scaling`: what a bake and a frame cost while one thing grows and all others stay as they are.
//!
//! Each series is a file and prints a table. Bakes have all threads. A frame is timed on one thread, as the workers of a
//! recording render it, but without encoding anything; the first frame of a scene is left out.

mod cameras;
mod lamps;
mod objects;
mod pixels;
mod scene_timer;
mod series;
mod setup;
mod table;
mod threads;
mod triangles;
mod unseen;

use crate::args::BenchArgs;
use anyhow::Result;
use endless_pipeline::BuiltinSimulator;
use setup::ScalingSetup;
use std::{
    io::{self, Write},
    process::ExitCode,
};

pub(crate) use series::ScalingSeries;

/// Prints the tables that were asked for; all if none was named.
pub(super) fn run(
    simulator: &BuiltinSimulator,
    args: &BenchArgs,
    asked: &[ScalingSeries],
    threads: usize,
) -> Result<ExitCode> {
    let setup = ScalingSetup::new(simulator, args, threads)?;
    writeln!(io::stdout(), "{}\n", setup.summary()?)?;
    for series in ScalingSeries::ALL {
        if !asked.is_empty() && !asked.contains(&series) {
            continue;
        }
        match series {
            ScalingSeries::Pixels => pixels::run(&setup)?,
            ScalingSeries::Objects => objects::run(&setup)?,
            ScalingSeries::Unseen => unseen::run(&setup)?,
            ScalingSeries::Lamps => lamps::run(&setup)?,
            ScalingSeries::Triangles => triangles::run(&setup)?,
            ScalingSeries::Cameras => cameras::run(&setup)?,
            ScalingSeries::Threads => threads::run(&setup)?,
        }
    }
    Ok(ExitCode::SUCCESS)
}
