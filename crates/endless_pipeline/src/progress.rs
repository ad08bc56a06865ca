//! Progress events of a run.

use crate::{DiskEstimate, Shard};
use endless_world::IncidentKind;

/// An event of a run.
#[derive(Debug, Clone, PartialEq)]
pub enum ProgressEvent<'a> {
    /// The run starts.
    Start {
        /// Videos to make or complete.
        videos: u32,
        /// Videos that are complete already.
        complete: u32,
        /// Frames to make, and disk space.
        estimate: DiskEstimate,
        /// The part that these numbers are of; none of all.
        shard: Option<Shard>,
    },
    /// The file system knows no locks: nothing keeps out a process that makes the same shard.
    NoLocks,
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
    /// Fewer actors were placed than the recipe asks for.
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
    /// An event that the recipe asks for cannot be had where the cameras of a scene look.
    EventMissed {
        /// Its kind.
        kind: IncidentKind,
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
        /// Whether it was on disk already.
        resumed: bool,
    },
    /// A video failed and is begun again.
    VideoAgain {
        /// Its folder's name.
        name: &'a str,
        /// Why it failed.
        reason: &'a str,
    },
    /// A video is complete.
    VideoDone {
        /// Its folder's name.
        name: &'a str,
    },
}

/// Watches a run: receives progress events, from several threads, and may end it.
pub trait Progress: Sync {
    /// Receives an event.
    fn event(&self, event: &ProgressEvent<'_>);

    /// Whether the run shall end. It is asked before each frame, so that what is complete stays and the same call goes on.
    fn is_stopped(&self) -> bool {
        false
    }
}

/// Ignores all events.
#[derive(Debug, Clone, Copy, Default)]
pub struct SilentProgress;

impl Progress for SilentProgress {
    fn event(&self, _event: &ProgressEvent<'_>) {}
}
