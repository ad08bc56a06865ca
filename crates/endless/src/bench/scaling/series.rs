//! What grows.

use clap::ValueEnum;

/// A series of scenes in which one thing grows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ScalingSeries {
    /// Pixels of a picture.
    Pixels,
    /// Vehicles and people.
    Objects,
    /// Vehicles that no camera sees.
    Unseen,
    /// Light: by day, at night, at night in fog.
    Lamps,
    /// Triangles of a town.
    Triangles,
    /// Cameras of a town.
    Cameras,
    /// Threads that work.
    Threads,
}

impl ScalingSeries {
    /// All, in the order in which they are printed.
    pub(crate) const ALL: [Self; 7] =
        [Self::Pixels, Self::Objects, Self::Unseen, Self::Lamps, Self::Triangles, Self::Cameras, Self::Threads];
}
