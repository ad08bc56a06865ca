//! `endless`: a recipe in, an annotated urban dataset out.
//!
//! The command line is a library, so that the program and Python's package are one: [`main`] is all that the
//! program does.

mod args;
mod assets;
mod bench;
mod build_info;
mod check;
mod cluster;
mod cpu;
mod exit;
mod export;
mod file;
mod generate;
mod log;
mod maps;
mod memory;
mod plan;
mod progress_bar;
mod recipe_args;
mod report;
mod request;
mod schema;
mod serve;
mod simulate;
mod simulate_options;
mod statistics;
mod storage;
mod threads;
mod view;

use args::{Cli, Command};
use clap::Parser;
use endless_export::ExportError;
use endless_interchange::MapLibrary;
use endless_pipeline::{BuiltinSimulator, GenerateError, PlanError, RecipeError, SimulatorError};
use endless_storage::AddressError;
use exit::{FAILURE, INTERRUPTED, USAGE};
use std::{
    env,
    ffi::OsString,
    io::{self, Write},
    process::ExitCode,
};
use threads::on_threads;

pub use build_info::this_build;
pub use cpu::missing_cpu_feature;
pub use report::line_of;
pub use request::{Request, UsageError};

/// The program: what the arguments of this process ask for.
pub fn main() -> ExitCode {
    match missing_cpu_feature() {
        Some(message) => {
            // Nothing can be done when not even that can be said.
            let _ = io::stderr().write_all(message.as_bytes());
            ExitCode::from(FAILURE)
        }
        None => run(),
    }
}

/// Apart from `main`, which must not need what the processor may lack.
#[inline(never)]
fn run() -> ExitCode {
    run_program(env::args_os().collect())
}

/// Does what these arguments ask for, the first of which is the program's name.
pub fn run_program(args: Vec<OsString>) -> ExitCode {
    let cli = match Cli::try_parse_from(args) {
        Ok(cli) => cli,
        Err(error) => return refuse(&error),
    };
    log::start(cli.verbose);
    if let (Command::Generate(_) | Command::Bench(_), Some(advice)) = (&cli.command, cpu::advice()) {
        eprintln!("{advice}");
    }
    let library = MapLibrary::user();
    let threads = threads::threads(cli.threads);
    let result = match cli.command {
        Command::Generate(args) => generate::run(library, *args, threads),
        Command::Plan(args) => plan::run(library, *args, threads),
        Command::Cluster(args) => cluster::run(&args),
        Command::Check(args) => check::run(&args, threads),
        Command::Export(args) => on_threads(threads, || export::run(&args)),
        Command::Stats(args) => on_threads(threads, || statistics::stats(&args)),
        Command::Compare(args) => on_threads(threads, || statistics::compare(&args)),
        Command::View(args) => view::run(&args),
        Command::Schema => schema::run(),
        Command::Bench(args) => bench::run(&BuiltinSimulator::new(library), &args, threads),
        // One more, which answers, and waits while others render.
        Command::Serve(args) => on_threads(threads + 1, || serve::run(library, &args)),
        Command::Assets(args) => on_threads(threads, || assets::run(library, args)),
        Command::Simulate(args) => on_threads(threads, || simulate::run(&library, &args)),
        Command::Maps(args) => on_threads(threads, || maps::run(&library, args)),
    };
    match result {
        Ok(code) => code,
        // Whoever read a list has read enough of it.
        Err(error) if error.downcast_ref::<io::Error>().is_some_and(|e| e.kind() == io::ErrorKind::BrokenPipe) => {
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {}", one_line(&format!("{error:#}")));
            ExitCode::from(exit_code(&error))
        }
    }
}

fn exit_code(error: &anyhow::Error) -> u8 {
    let of_simulator = match (error.downcast_ref(), error.downcast_ref(), error.downcast_ref()) {
        (Some(GenerateError::Simulator(error) | GenerateError::Plan(PlanError::Simulator(error))), ..)
        | (_, Some(RecipeError::Map(error)), _)
        | (_, _, Some(error)) => Some(error),
        _ => None,
    };
    if matches!(of_simulator, Some(SimulatorError::Interrupted)) {
        return INTERRUPTED;
    }
    if cannot_be_asked(error) { USAGE } else { FAILURE }
}

/// Whether the mistake is in what was asked for.
fn cannot_be_asked(error: &anyhow::Error) -> bool {
    let plan = error.downcast_ref::<GenerateError>();
    error.is::<RecipeError>()
        || error.is::<AddressError>()
        || matches!(error.downcast_ref(), Some(ExportError::Split(_) | ExportError::Classes { .. }))
        || matches!(
            plan,
            Some(GenerateError::Plan(
                PlanError::FewCameras { .. } | PlanError::ManyCameras { .. } | PlanError::Rig { .. }
            ))
        )
}

/// Help and version as they are, a mistake in one line.
fn refuse(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() {
        // Nothing can be done when not even help can be printed.
        let _ = error.print();
        return ExitCode::SUCCESS;
    }
    eprintln!("{} (see endless --help)", said(error));
    ExitCode::from(USAGE)
}

/// What a mistake in the arguments is, in one line.
fn said(error: &clap::Error) -> String {
    one_line(error.to_string().split("\n\n").next().unwrap_or_default())
}

fn one_line(text: &str) -> String {
    text.lines().map(str::trim).filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" ")
}
