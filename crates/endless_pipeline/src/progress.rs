//! What a run tells while it works.

use crate::DiskEstimate;

/// Something worth telling.
#[derive(Debug, Clone, PartialEq)]
pub enum ProgressEvent<'a> {
    /// About to start.
    Start {
        /// Videos to make or complete.
        videos: u32,
        /// Videos that are complete already.
        complete: u32,
        /// What it takes.
        estimate: DiskEstimate,
    },
    /// A map is being loaded.
    LoadMap {
        /// Which.
        map: &'a str,
    },
    /// A video begins; its cameras are baked first.
    Video {
        /// Its folder's name.
        name: &'a str,
        /// Place in the work order, from 1.
        place: u32,
        /// Videos to do in all.
        of: u32,
        /// Camera frames it has.
        camera_frames: u64,
    },
    /// Fewer were placed than asked for.
    FewerSpawned {
        /// `vehicles` or `pedestrians`.
        what: &'static str,
        /// Asked for.
        asked: u32,
        /// Placed.
        placed: u32,
        /// The map.
        map: &'a str,
    },
    /// The cameras are ready after so many seconds.
    Baked {
        /// Seconds.
        seconds: f64,
    },
    /// One frame of all cameras is on disk.
    Frame {
        /// How many cameras.
        cameras: u32,
        /// Whether it was there already.
        resumed: bool,
    },
    /// A video is complete.
    VideoDone {
        /// Its folder's name.
        name: &'a str,
    },
}

/// Who listens. Called from several threads.
pub trait Progress: Sync {
    /// Something happened.
    fn event(&self, event: &ProgressEvent<'_>);
}

/// Nobody listens.
#[derive(Debug, Clone, Copy, Default)]
pub struct SilentProgress;

impl Progress for SilentProgress {
    fn event(&self, _event: &ProgressEvent<'_>) {}
}
