//! The version of CARLA that this is.

/// What clients are told, and must be themselves.
pub const VERSION: &str = "0.9.16";
