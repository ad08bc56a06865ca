//! The recorder and the replayer: what happens goes into files of CARLA's format, and comes out of them again.

mod folder;
mod recorded;
mod replay_events;
mod replay_frame;
mod replayer;
mod writer;

use crate::wire::Transform;
use folder::RecordingFolder;
use replayer::Replayer;
use std::path::PathBuf;
use writer::Recorder;

pub(super) use replayer::ReplayRequest;

/// The recorder, the replayer, and where their files are.
pub(super) struct Recordings {
    folder: Option<RecordingFolder>,
    recorder: Option<Recorder>,
    replayer: Option<Replayer>,
    options: ReplayOptions,
}

/// How recordings are replayed, this one and those that follow.
struct ReplayOptions {
    /// Seconds of the recording for one of the world.
    time_factor: f64,
    ignores_hero: bool,
    ignores_spectator: bool,
}

impl Recordings {
    /// With files in a folder; without one nothing can be recorded or replayed.
    pub(super) fn new(folder: Option<PathBuf>) -> Self {
        let options = ReplayOptions { time_factor: 1.0, ignores_hero: false, ignores_spectator: true };
        Self { folder: folder.map(RecordingFolder::new), recorder: None, replayer: None, options }
    }

    /// Another episode begins: what was recorded ends, and so does what is replayed.
    pub(super) fn end(&mut self) {
        self.recorder = None;
        self.replayer = None;
    }

    pub(super) fn set_time_factor(&mut self, factor: f64) {
        /// The most that a step of the world goes on in a recording.
        const FASTEST: f64 = 1000.0;
        if factor.is_finite() {
            self.options.time_factor = factor.clamp(0.0, FASTEST);
        }
    }

    pub(super) fn ignore_hero(&mut self, ignores: bool) {
        self.options.ignores_hero = ignores;
    }

    pub(super) fn ignore_spectator(&mut self, ignores: bool) {
        self.options.ignores_spectator = ignores;
    }
}

/// A place of a recording: centimetres there, metres here.
fn transform_of(location: [f32; 3], [roll, pitch, yaw]: [f32; 3]) -> Transform {
    let [x, y, z] = location.map(|cm| 0.01 * cm);
    Transform { location: crate::wire::Location { x, y, z }, rotation: crate::wire::Rotation { pitch, yaw, roll } }
}

/// The same the other way: location and rotation.
fn recorded_place(transform: &Transform) -> ([f32; 3], [f32; 3]) {
    let Transform { location: l, rotation: r } = transform;
    ([l.x, l.y, l.z].map(|m| 100.0 * m), [r.roll, r.pitch, r.yaw])
}
