//! Exit codes.

/// What went wrong was what was asked for.
pub(crate) const USAGE: u8 = 2;
/// It could not be done.
pub(crate) const FAILURE: u8 = 1;
/// The user wanted to stop: 128 and the number of that signal.
pub(crate) const INTERRUPTED: u8 = 130;
