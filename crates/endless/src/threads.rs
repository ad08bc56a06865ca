//! How many threads work.

use anyhow::Result;
use rayon::ThreadPoolBuilder;
use std::{num::NonZeroUsize, thread::available_parallelism};

/// All cores unless said otherwise.
pub(crate) fn threads(asked: Option<NonZeroUsize>) -> usize {
    asked.or_else(|| available_parallelism().ok()).map_or(1, Into::into)
}

/// Does work that spreads by itself on so many threads.
///
/// # Errors
/// Those of the work, and when there are no such threads.
pub(crate) fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> Result<T> + Send) -> Result<T> {
    ThreadPoolBuilder::new().num_threads(threads).build()?.install(work)
}
