//! The native module of the Python package `endless_city`. Nothing is decided here: values are converted, and the work is
//! that of the other crates, done without the interpreter's lock.
//!
//! ```text
//! endless_city (Python: types, documentation)
//!      │ numbers, words, JSON                    ▲ arrays without copies, exceptions
//!      ▼                                         │
//! _native ── draft, flags ──► endless::Request ──┘  on a thread of its own; this one waits, and looks for Ctrl-C
//! ```

#![expect(clippy::needless_pass_by_value, reason = "PyO3 makes arguments of their own of what it is given")]

mod arrays;
mod catalogue;
mod command;
mod dataset;
mod errors;
mod generate;
mod objects;
mod recipe;
mod render;
mod stream;
mod streamed;
mod supervised;
mod watch;

use pyo3::prelude::*;

/// What `endless_city` is made of. Not for use by itself.
#[pymodule]
mod _native {
    use pyo3::{exceptions::PyImportError, prelude::*};

    #[pymodule_export]
    use super::{
        catalogue::{asset_preview, assets, classes, map_preview, maps, options, tags, version},
        command::run_command,
        dataset::{DatasetReader, split},
        generate::{camera_frames_of_shards, generate},
        render::{encode_png, render},
        stream::FrameStream,
    };

    #[pymodule_init]
    fn init(_module: &Bound<'_, PyModule>) -> PyResult<()> {
        endless::missing_cpu_feature().map_or(Ok(()), |message| Err(PyImportError::new_err(message.trim_end())))
    }
}
