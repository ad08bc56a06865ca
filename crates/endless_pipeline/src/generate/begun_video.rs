//! A video that is begun.

use endless_dataset::{BuildIdentity, DatasetError, SceneRecord, VideoLayout, read_json};
use endless_world::SceneSettings;

/// What a video's folder says of itself.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BegunVideo {
    /// The builds that worked on it.
    pub(super) builds: Vec<BuildIdentity>,
    /// Boxes of its cameras, once it is complete.
    pub(super) boxes: Option<Vec<u64>>,
}

impl BegunVideo {
    /// Looks into a folder; none if nothing whole lies there.
    pub(super) fn look(video: &VideoLayout, settings: &SceneSettings) -> Result<Option<Self>, DatasetError> {
        if !video.is_begun()? {
            return Ok(None);
        }
        let builds = video.read_builds().unwrap_or_else(|| vec![BuildIdentity::unknown()]);
        let record = read_json::<SceneRecord>(&video.scene()).ok().filter(|record| record.settings == *settings);
        Ok(Some(Self { builds, boxes: record.map(|record| record.boxes) }))
    }
}
