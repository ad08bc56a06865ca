//! A world that is recorded.

use super::writer::Recorder;
use crate::server::call_error::CallError;
use crate::server::world::World;
use std::time::{SystemTime, UNIX_EPOCH};

impl World {
    /// Begins to record; gives the path of the file.
    pub(in crate::server) fn start_recorder(&mut self, name: &str, tells_more: bool) -> Result<String, CallError> {
        self.stop_replayer(false);
        self.recordings.recorder = None;
        let (file, path) = self.recordings.folder()?.create(name)?;
        let now_s = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs() as i64);
        let failed = |error| CallError::refused(format!("cannot record to '{name}': {error}"));
        let recorder = Recorder::new(file, &self.episode.map_name, now_s, tells_more).map_err(failed)?;
        self.recordings.recorder = Some(recorder);
        Ok(path.display().to_string())
    }

    pub(in crate::server) fn stop_recorder(&mut self) {
        self.recordings.recorder = None;
    }

    /// After a step: what there is now goes into the file, if one is recorded.
    pub(in crate::server) fn record(&mut self) {
        let changed = self.episode.lamps.take_changed();
        let Some(recorder) = &mut self.recordings.recorder else { return };
        if let Err(error) = recorder.record(&self.episode, changed) {
            tracing::warn!("the recording ends: {error}");
            self.recordings.recorder = None;
        }
    }
}
