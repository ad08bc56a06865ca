//! The recorder and the replayer of a world.

use super::folder::RecordingFolder;
use super::replayer::Replayer;
use super::writer::Recorder;
use crate::server::call_error::CallError;
use std::path::PathBuf;

/// The recorder, the replayer, and where their files are.
pub(in crate::server) struct Recordings {
    pub(super) folder: Option<RecordingFolder>,
    pub(super) recorder: Option<Recorder>,
    pub(super) replayer: Option<Replayer>,
    pub(super) options: ReplayOptions,
}

/// How recordings are replayed, this one and those that follow.
pub(super) struct ReplayOptions {
    /// Seconds of the recording for one of the world.
    pub(super) time_factor: f64,
    pub(super) ignores_hero: bool,
    pub(super) ignores_spectator: bool,
}

impl Recordings {
    /// With files in a folder; without one nothing can be recorded or replayed.
    pub(in crate::server) fn new(folder: Option<PathBuf>) -> Self {
        let options = ReplayOptions { time_factor: 1.0, ignores_hero: false, ignores_spectator: true };
        Self { folder: folder.map(RecordingFolder::new), recorder: None, replayer: None, options }
    }

    /// Another episode begins: what was recorded ends, and so does what is replayed.
    pub(in crate::server) fn end(&mut self) {
        self.recorder = None;
        self.replayer = None;
    }

    pub(in crate::server) fn set_time_factor(&mut self, factor: f64) {
        /// The most that a step of the world goes on in a recording.
        const FASTEST: f64 = 1000.0;
        if factor.is_finite() {
            self.options.time_factor = factor.clamp(0.0, FASTEST);
        }
    }

    pub(in crate::server) fn ignore_hero(&mut self, ignores: bool) {
        self.options.ignores_hero = ignores;
    }

    pub(in crate::server) fn ignore_spectator(&mut self, ignores: bool) {
        self.options.ignores_spectator = ignores;
    }

    /// The path of a recording, which may not exist.
    pub(in crate::server) fn path(&self, name: &str) -> Result<PathBuf, CallError> {
        self.folder()?.path(name)
    }

    pub(super) fn folder(&self) -> Result<&RecordingFolder, CallError> {
        let missing = "there is no folder for recordings: start the server with --recordings DIR";
        self.folder.as_ref().ok_or_else(|| CallError::refused(missing))
    }
}
