//! The dataset that is shown, as it is on the disk at each question.

use crate::{
    cache::RecentCache,
    facts::VideoFacts,
    folder::{DatasetFolder, Stamp},
    line_index::LineIndex,
    refusal::Refusal,
    timeline::Timeline,
    video::Video,
};
use endless_dataset::{DatasetLayout, Manifest, VideoEntry, VideoState};
use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
    time::{Duration, Instant},
};

/// How long one question may let facts be gathered behind its back.
const GATHERING: Duration = Duration::from_millis(1500);

/// A dataset, and what of it was read last.
#[derive(Debug)]
pub(crate) struct Dataset {
    pub(crate) folder: DatasetFolder,
    pub(crate) layout: DatasetLayout,
    manifest: Mutex<Option<(Stamp, Arc<Manifest>)>>,
    videos: RecentCache<u32, (Stamp, VideoState), Arc<Video>>,
    timelines: RecentCache<u32, Stamp, Arc<Timeline>>,
    lines: RecentCache<PathBuf, Stamp, Arc<Mutex<LineIndex>>>,
    /// By video and its name, of complete ones.
    facts: Mutex<BTreeMap<(u32, String), Option<VideoFacts>>>,
    gathering: AtomicBool,
}

impl Dataset {
    pub(crate) fn new(folder: DatasetFolder) -> Self {
        Self {
            layout: folder.layout(),
            folder,
            manifest: Mutex::new(None),
            videos: RecentCache::new(32),
            timelines: RecentCache::new(4),
            lines: RecentCache::new(32),
            facts: Mutex::new(BTreeMap::new()),
            gathering: AtomicBool::new(false),
        }
    }

    /// `dataset.json` as it is now.
    pub(crate) fn manifest(&self) -> Result<Arc<Manifest>, Refusal> {
        let path = self.layout.manifest();
        let stamp = self.folder.stamp(&path)?;
        let mut known = self.manifest.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, manifest)) = known.as_ref().filter(|(old, _)| *old == stamp) {
            return Ok(Arc::clone(manifest));
        }
        let (text, stamp) = self.folder.read(&path)?;
        let manifest = Arc::new(parse(&text).map_err(|reason| Refusal::damaged(&path, reason))?);
        *known = Some((stamp, Arc::clone(&manifest)));
        Ok(manifest)
    }

    /// A video by its number.
    pub(crate) fn video(&self, number: u32) -> Result<Arc<Video>, Refusal> {
        let manifest = self.manifest()?;
        let entry = manifest.videos.iter().find(|entry| entry.video == number);
        let entry = entry.ok_or_else(|| Refusal::Missing(format!("video {number}")))?;
        self.opened(entry).map(|(video, _)| video)
    }

    fn opened(&self, entry: &VideoEntry) -> Result<(Arc<Video>, Stamp), Refusal> {
        let (video, stamp) = Video::source(&self.folder, &self.layout, entry)?;
        if let Some(known) = self.videos.get(&entry.video, &(stamp, entry.state)) {
            return Ok((known, stamp));
        }
        let video = Arc::new(Video::read(&self.folder, &self.layout, entry, video)?);
        self.videos.put(entry.video, (stamp, entry.state), Arc::clone(&video));
        Ok((video, stamp))
    }

    /// A video over time. Takes as long as it takes to read all its lines.
    pub(crate) fn timeline(&self, number: u32) -> Result<Arc<Timeline>, Refusal> {
        let video = self.video(number)?;
        let (video, stamp) = self.opened(&video.entry)?;
        self.timeline_of(&video, stamp)
    }

    fn timeline_of(&self, video: &Video, stamp: Stamp) -> Result<Arc<Timeline>, Refusal> {
        let number = video.entry.video;
        if let Some(known) = self.timelines.get(&number, &stamp) {
            return Ok(known);
        }
        let timeline = Arc::new(Timeline::read(&self.folder, video)?);
        if video.entry.state == VideoState::Complete {
            self.timelines.put(number, stamp, Arc::clone(&timeline));
        }
        Ok(timeline)
    }

    /// Lines of a file of the dataset, as a JSON array.
    pub(crate) fn lines(&self, path: &Path, from: u32, count: u32) -> Result<(Vec<u8>, Stamp), Refusal> {
        let mut file = self.folder.open(path)?;
        let key = path.to_owned();
        let index = self.lines.get(&key, &file.stamp).unwrap_or_else(|| {
            let index = Arc::<Mutex<LineIndex>>::default();
            self.lines.put(key, file.stamp, Arc::clone(&index));
            index
        });
        let array = index.lock().unwrap_or_else(PoisonError::into_inner).array(&mut file, from, count)?;
        Ok((array, file.stamp))
    }

    /// What is known of a video so far: nothing yet, or that nothing can be known.
    pub(crate) fn facts(&self, entry: &VideoEntry) -> Option<Option<VideoFacts>> {
        let facts = self.facts.lock().unwrap_or_else(PoisonError::into_inner);
        facts.get(&(entry.video, entry.name.clone())).cloned()
    }

    /// Forgets what was known of a video that is not complete any more: it is made again.
    pub(crate) fn forget_facts(&self, entry: &VideoEntry) {
        let mut facts = self.facts.lock().unwrap_or_else(PoisonError::into_inner);
        facts.remove(&(entry.video, entry.name.clone()));
    }

    /// Gathers facts of videos that have none, for a short while; one at a time.
    pub(crate) fn gather_facts(&self, manifest: &Manifest) {
        if self.gathering.swap(true, Ordering::AcqRel) {
            return;
        }
        let begin = Instant::now();
        let complete = manifest.videos.iter().filter(|entry| entry.state == VideoState::Complete);
        for entry in complete.filter(|entry| self.facts(entry).is_none()) {
            let read = || -> Result<VideoFacts, Refusal> {
                let (video, stamp) = self.opened(entry)?;
                let timeline = self.timeline_of(&video, stamp)?;
                Ok(VideoFacts::new(&timeline, video.record.as_ref()))
            };
            let facts = read().map_err(|refusal| tracing::warn!("{}: {refusal}", entry.name)).ok();
            let mut known = self.facts.lock().unwrap_or_else(PoisonError::into_inner);
            known.insert((entry.video, entry.name.clone()), facts);
            if begin.elapsed() > GATHERING {
                break;
            }
        }
        self.gathering.store(false, Ordering::Release);
    }
}

/// The manifest, or why it is none.
fn parse(text: &[u8]) -> Result<Manifest, String> {
    // A manifest of another format need not have the fields of this one.
    #[derive(serde::Deserialize)]
    struct FormatOnly {
        format: u32,
    }
    let FormatOnly { format } = serde_json::from_slice(text).map_err(|e| format!("is not a dataset's ({e})"))?;
    if !Manifest::reads(format) {
        let (from, to) = (Manifest::OLDEST_FORMAT, Manifest::FORMAT);
        return Err(format!("has format {format}, this program shows {from} to {to}: use the program that made it"));
    }
    serde_json::from_slice(text).map_err(|e| format!("is not what it should be ({e})"))
}
