//! `endless schema`: the JSON schema of recipes.

use anyhow::Result;
use std::{io::Write, process::ExitCode};

pub(crate) fn run() -> Result<ExitCode> {
    let mut out = std::io::stdout().lock();
    writeln!(out, "{:#}", endless_dataset::recipe_schema())?;
    Ok(ExitCode::SUCCESS)
}
