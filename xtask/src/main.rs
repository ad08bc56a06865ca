//! Chores of the repository: `cargo xtask crates`, `cargo xtask cycles`, `cargo xtask glossary`.

mod crates;
mod cycles;
mod glossary;
mod manifests;

use anyhow::{Result, bail};
use std::{env, path::Path, process::ExitCode};

fn run(args: &[String]) -> Result<()> {
    let root = Path::new(".");
    match args.first().map(String::as_str) {
        Some("crates") => crates::check(root),
        Some("cycles") => cycles::check(root),
        Some("glossary") => glossary::check(root),
        other => {
            let other = other.unwrap_or_default();
            bail!("unknown chore '{other}': use crates, cycles or glossary")
        }
    }
}

fn main() -> ExitCode {
    let args: Vec<String> = env::args().skip(1).collect();
    match run(&args) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
