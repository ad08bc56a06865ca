//! How a stream is made, and how it ends.

use crate::Shard;

/// In which order videos are made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StreamOrder {
    /// Those of a map one after the other, as [`Plan::work_order`](crate::Plan::work_order) has them: each map is loaded once.
    #[default]
    ByMap,
    /// By their numbers: maps come as they are drawn, and are loaded again and again.
    ByNumber,
}

/// Settings of a stream that are not part of the recipe.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct StreamOptions {
    /// Number of threads.
    pub threads: usize,
    /// In which order videos are made.
    pub order: StreamOrder,
    /// The first frame that is handed over, counted over all videos in this order. Videos before it are not made.
    pub first_frame: u64,
    /// The part of the videos that is made; all of them without. Frames are counted over those of the part.
    pub shard: Option<Shard>,
}

/// Whether a stream came to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StreamEnd {
    /// All frames were handed over.
    Complete,
    /// Whoever took them wanted no more.
    Stopped,
}
