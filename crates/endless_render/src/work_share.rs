//! How much work a thread takes at a time.
//!
//! Left alone, `rayon` halves a picture a few times: of two threads one may be left with a quarter of it, and trees make some
//! rows ten times as dear as others. Small shares cost next to nothing and end together.

/// Rows of a picture.
pub(crate) const ROWS: usize = 4;
/// Places at which light is gathered, or lists of them.
pub(crate) const PLACES: usize = 8;
