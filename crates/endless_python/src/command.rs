//! The program, for the command that comes with the package.

use pyo3::prelude::*;
use std::{ffi::OsString, process::ExitCode};

/// Does what the arguments of the program ask for, the first of which is its name; the exit code.
#[pyfunction]
pub(crate) fn run_command(py: Python<'_>, argv: Vec<OsString>) -> u8 {
    let exit = py.detach(|| endless::run_program(argv));
    // An exit code does not tell its number.
    (0..=u8::MAX).find(|&code| ExitCode::from(code) == exit).unwrap_or(1)
}
