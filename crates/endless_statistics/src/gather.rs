//! Counts a dataset, video by video.

use crate::video_count::{VideoCount, all_classes, count_video};
use crate::{DatasetStatistics, Miniset, StatisticsError, WorldStatistics};
use endless_dataset::{DatasetLayout, Manifest, ModelSpec, VideoEntry, VideoState};
use rayon::prelude::*;
use std::{
    fmt,
    path::Path,
    sync::atomic::{AtomicU64, Ordering},
};

/// Videos whose counts are in memory at once, in addition to the sum of those before.
const AT_ONCE: usize = 32;

/// Settings of a count.
#[derive(Clone, Copy)]
pub struct GatherOptions<'a> {
    /// Looks at one frame of so many; 1 for all.
    pub stride: u32,
    /// Told how many camera frames are done, and of how many, by any thread.
    pub progress: Option<&'a (dyn Fn(u64, u64) + Sync)>,
}

impl Default for GatherOptions<'_> {
    fn default() -> Self {
        Self { stride: 1, progress: None }
    }
}

impl fmt::Debug for GatherOptions<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("GatherOptions").field("stride", &self.stride).finish_non_exhaustive()
    }
}

impl DatasetStatistics {
    /// Counts the complete videos of a dataset, on the threads of the current pool. Labels are read line by line, images
    /// not at all.
    ///
    /// # Errors
    /// When there is no dataset with a complete video, or one of its files is not what it should be.
    pub fn of_dataset(root: &Path, options: &GatherOptions<'_>) -> Result<Self, StatisticsError> {
        let layout = DatasetLayout::new(root);
        if !root.is_dir() || !layout.manifest().is_file() {
            return Err(StatisticsError::NoDataset { path: root.to_owned() });
        }
        let manifest = Manifest::read(&layout.manifest())?;
        let complete: Vec<&VideoEntry> = manifest.videos.iter().filter(|v| v.state == VideoState::Complete).collect();
        if complete.is_empty() {
            return Err(StatisticsError::NoVideo { path: root.to_owned() });
        }
        let stride = options.stride.max(1);
        let (done, total) = (AtomicU64::new(0), camera_frames(&manifest, &complete));
        let progress = |frames: u64| {
            let done = done.fetch_add(frames, Ordering::Relaxed) + frames;
            if let Some(listener) = options.progress {
                listener(done, total.max(done));
            }
        };
        let mut all = Self {
            format: Self::FORMAT,
            stride,
            classes: all_classes(),
            world: Some(WorldStatistics::default()),
            ..Self::default()
        };
        let (mut max_vehicles, mut max_pedestrians) = (0, 0);
        for videos in complete.chunks(AT_ONCE) {
            let count = |video: &&VideoEntry| count_video(&layout, &manifest.recipe, video, stride, &progress);
            let counted: Vec<Result<VideoCount, StatisticsError>> = videos.par_iter().map(count).collect();
            // In their order, so that the first fault is told, whoever finds one first.
            for video in counted {
                let VideoCount { statistics, spawned } = video?;
                all = all.and(statistics);
                max_vehicles = max_vehicles.max(spawned.vehicles);
                max_pedestrians = max_pedestrians.max(spawned.pedestrians);
            }
        }
        all.datasets = vec![Miniset {
            name: name_of(root),
            videos: Some(complete.len() as u64),
            incomplete_videos: Some((manifest.videos.len() - complete.len()) as u64),
            camera_frames: all.totals.camera_frames,
            boxes: all.totals.boxes,
            max_vehicles: Some(max_vehicles.into()),
            max_pedestrians: Some(max_pedestrians.into()),
        }];
        Ok(all.finish())
    }
}

/// How many there should be.
fn camera_frames(manifest: &Manifest, complete: &[&VideoEntry]) -> u64 {
    let recipe = &manifest.recipe;
    let of_sensor = |video: &VideoEntry| -> u64 {
        let cameras = recipe.sensor.iter().filter(|sensor| matches!(sensor.model, ModelSpec::Camera(_)));
        cameras.map(|sensor| u64::from(video.frames.div_ceil(recipe.every(sensor).max(1)))).sum()
    };
    complete.iter().map(|video| u64::from(video.frames) * video.cameras.len() as u64 + of_sensor(video)).sum()
}

/// The last part of a path, as a name.
pub(crate) fn name_of(path: &Path) -> String {
    let whole = path.canonicalize();
    let whole = whole.as_deref().unwrap_or(path);
    whole.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}
