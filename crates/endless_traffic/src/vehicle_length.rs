//! From which length on vehicles are treated as long.

/// Vehicles longer than this are long, metres.
pub(crate) const LONG_M: f64 = 6.5;
/// Vehicles longer than this are given more room where ways meet in bends, metres.
pub(crate) const SWINGS_OUT_M: f64 = 5.4;
