//! The native module of the Python package `endless_city`. Nothing is decided here: values are converted, and the work is
//! that of the other crates, done without the interpreter's lock.

mod command;

use pyo3::prelude::*;

/// What `endless_city` is made of. Not for use by itself.
#[pymodule]
mod _native {
    #[pymodule_export]
    use super::command::run_command;
}
