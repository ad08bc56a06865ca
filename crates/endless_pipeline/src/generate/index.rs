//! `dataset.json`: an index that anybody can make again of the recipe, its plan and what lies in `videos`.

use super::{begun_video::BegunVideo, output::ResumeRequest};
use crate::StoreError;
use endless_dataset::{
    BuildIdentity, Card, DatasetError, DatasetLayout, Manifest, SharedFiles, VideoEntry, VideoLayout, VideoState,
};
use endless_world::SceneSettings;
use std::{
    collections::{BTreeMap, BTreeSet},
    fs, io,
};

/// The index, and what it was made of.
///
/// Several processes may write it, without a lock: each looks again at the folder after it has written, and writes again
/// if something has come. So the last to write has seen everything.
#[derive(Debug)]
pub(super) struct DatasetIndex<'a> {
    layout: &'a DatasetLayout,
    request: ResumeRequest<'a>,
    files: &'a SharedFiles,
    begun: BTreeMap<u32, BegunVideo>,
}

impl<'a> DatasetIndex<'a> {
    pub(super) fn new(layout: &'a DatasetLayout, request: ResumeRequest<'a>, files: &'a SharedFiles) -> Self {
        Self { layout, request, files, begun: BTreeMap::new() }
    }

    /// Writes the index of what is there now, and the cards, which follow from it.
    pub(super) fn update(&mut self) -> Result<(), StoreError> {
        self.look()?;
        loop {
            let manifest = self.manifest();
            Card::write_all(self.layout, &manifest, self.files)?;
            self.files.write_json_durable(&self.layout.manifest(), &manifest)?;
            self.request.store.put_index(self.layout)?;
            if !self.look()? {
                return Ok(());
            }
        }
    }

    /// Looks at what can have changed: all that is not complete. Returns whether it has.
    ///
    /// Folders are listed, which asks the server of a network's file system for what is new; the mere name of a file may
    /// still be unknown here when another machine has written it.
    fn look(&mut self) -> Result<bool, StoreError> {
        self.request.store.refresh(self.layout)?;
        let names = names(self.layout)?;
        let mut changed = false;
        for settings in &self.request.plan.scenes {
            let number = settings.video;
            let known = self.begun.get(&number);
            let found = if !names.contains(&VideoLayout::name(settings)) {
                None
            } else if known.is_some_and(|video| video.boxes.is_some()) {
                continue;
            } else {
                BegunVideo::look(&self.layout.video(settings), settings)?
            };
            changed |= known != found.as_ref();
            match found {
                Some(video) => self.begun.insert(number, video),
                None => self.begun.remove(&number),
            };
        }
        Ok(changed)
    }

    fn manifest(&self) -> Manifest {
        let mut builds: Vec<BuildIdentity> = Vec::new();
        let mut place = |build: &BuildIdentity| {
            let listed = builds.iter().position(|other| other == build || other.makes_same_bytes(build));
            listed.unwrap_or_else(|| {
                builds.push(build.clone());
                builds.len() - 1
            })
        };
        let mut videos = Vec::with_capacity(self.request.plan.scenes.len());
        for settings in &self.request.plan.scenes {
            let mut entry = planned(settings);
            if let Some(video) = self.begun.get(&settings.video) {
                entry.builds = video.builds.iter().map(&mut place).collect();
                entry.boxes.clone_from(&video.boxes);
                entry.state = if video.boxes.is_some() { VideoState::Complete } else { VideoState::Planned };
            }
            videos.push(entry);
        }
        if builds.is_empty() {
            builds.push(self.request.build.clone());
        }
        Manifest::new(self.request.recipe.clone(), builds, videos)
    }
}

/// Names of the folders of videos.
fn names(layout: &DatasetLayout) -> Result<BTreeSet<String>, DatasetError> {
    let failed = |e| DatasetError::io("cannot read the folder", layout.videos(), e);
    let entries = match fs::read_dir(layout.videos()) {
        Ok(entries) => entries,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(BTreeSet::new()),
        Err(e) => return Err(failed(e)),
    };
    entries.map(|entry| Ok(entry.map_err(failed)?.file_name().to_string_lossy().into_owned())).collect()
}

/// The entry of a video that is not begun.
fn planned(settings: &SceneSettings) -> VideoEntry {
    VideoEntry {
        video: settings.video,
        name: VideoLayout::name(settings),
        state: VideoState::Planned,
        map: settings.map.clone(),
        weather: settings.weather,
        time_of_day: settings.time_of_day,
        cameras: settings.cameras.iter().map(|c| c.site.name.clone()).collect(),
        frames: settings.frames,
        boxes: None,
        builds: Vec::new(),
    }
}
