//! The settings of a recording, besides the simulator.

use super::{streams::Stream, times::StageClock};
use crate::Progress;
use endless_dataset::{Recipe, VideoLayout};
use endless_world::SceneSettings;

/// The settings of a recording, besides the simulator.
pub(crate) struct Recording<'a> {
    pub(crate) settings: &'a SceneSettings,
    pub(crate) recipe: &'a Recipe,
    pub(crate) layout: &'a VideoLayout,
    /// What is recorded.
    pub(crate) streams: &'a [Stream<'a>],
    /// Of as many threads as may work.
    pub(crate) pool: &'a rayon::ThreadPool,
    pub(crate) progress: &'a dyn Progress,
    pub(crate) clock: &'a StageClock,
}
