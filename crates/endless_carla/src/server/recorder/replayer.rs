//! A recording that is replayed.

use super::replay_frame::ReplayFrame;
use crate::recording::LogReader;
use crate::wire::Transform;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::io::BufReader;

/// A recording that is replayed.
pub(super) struct Replayer {
    pub(super) log: LogReader<BufReader<File>>,
    /// The last frame that has begun.
    pub(super) now: ReplayFrame,
    /// The one after it.
    pub(super) next: Option<ReplayFrame>,
    /// Since the first frame, seconds.
    pub(super) time_s: f64,
    pub(super) end_s: f64,
    pub(super) part: ReplayPart,
}

/// Who takes part.
pub(super) struct ReplayPart {
    /// Actors here, by their numbers in the recording.
    pub(super) ids: BTreeMap<u32, u32>,
    /// Those that have come for the recording, by their numbers here.
    pub(super) made: BTreeSet<u32>,
    /// By their numbers in the recording.
    pub(super) heroes: BTreeSet<u32>,
    pub(super) has_sensors: bool,
    /// Whom the spectator follows, by its number in the recording, and from where.
    pub(super) follows: Option<(u32, Transform)>,
}

/// What is to be replayed.
pub(in crate::server) struct ReplayRequest {
    /// The recording.
    pub(in crate::server) name: String,
    /// Seconds after its beginning; before its end if negative.
    pub(in crate::server) start_s: f64,
    /// Seconds; 0 for all of it.
    pub(in crate::server) duration_s: f64,
    /// Whom the spectator follows, by its number in the recording; 0 for nobody.
    pub(in crate::server) follow: u32,
    /// Whether sensors come, too.
    pub(in crate::server) sensors: bool,
    /// Where the spectator is on whom it follows.
    pub(in crate::server) offset: Transform,
}
