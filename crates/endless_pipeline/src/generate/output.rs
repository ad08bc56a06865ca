//! The output folder: what it holds, and whether its dataset may be resumed.

use super::begun_video::BegunVideo;
use crate::{
    DatasetStore, GenerateError, Plan, StoreError,
    record::{Stream, stream_is_complete},
};
use endless_dataset::{
    BuildIdentity, Card, DatasetError, DatasetLayout, Manifest, Recipe, SceneRecord, SharedFiles, VideoLayout,
    read_json, sync_tree,
};
use endless_world::SceneSettings;
use std::{collections::BTreeSet, fs, io, path::Path};

/// The recipe, plan and build that want to resume the output folder.
#[derive(Debug, Clone, Copy)]
pub(super) struct ResumeRequest<'a> {
    pub(super) recipe: &'a Recipe,
    pub(super) plan: &'a Plan,
    /// The build that runs.
    pub(super) build: &'a BuildIdentity,
    /// Resume what another build began.
    pub(super) allow_other_build: bool,
    /// Where the dataset is kept.
    pub(super) store: &'a dyn DatasetStore,
}

/// The state of the output folder: which videos of a plan are complete.
#[derive(Debug, Default)]
pub(super) struct OutputFolder {
    complete: BTreeSet<u32>,
}

impl OutputFolder {
    /// Inspects the folder without changing anything: every video for who made it, those of a part for being complete.
    pub(super) fn inspect(
        layout: &DatasetLayout,
        claim: &ResumeRequest<'_>,
        part: &[u32],
    ) -> Result<Self, GenerateError> {
        let root = layout.root();
        if let Some(file) = root.ancestors().find(|p| p.is_file()) {
            return Err(GenerateError::OutputIsFile { path: file.to_owned() });
        }
        if !root.exists() {
            return Ok(Self::default());
        }
        if layout.manifest().exists() {
            let found = Manifest::read(&layout.manifest())?;
            if found.format != Manifest::FORMAT {
                return Err(GenerateError::OlderFormat { found: found.format, path: root.to_owned() });
            }
            refuse_other_build(layout, &found.builds, claim)?;
            refuse_other_recipe(layout, &found, claim.recipe)?;
            refuse_other_scenes(layout, claim.plan)?;
        } else {
            refuse_strangers(root)?;
            refuse_other_scenes(layout, claim.plan)?;
            refuse_unproven_videos(layout, claim)?;
        }
        let mut output = Self::default();
        let part: BTreeSet<u32> = part.iter().copied().collect();
        for settings in &claim.plan.scenes {
            let video = layout.video(settings);
            let Some(begun) = BegunVideo::look(&video, settings)? else { continue };
            if !claim.allow_other_build && begun.builds.contains(&BuildIdentity::unknown()) {
                return Err(GenerateError::UnknownBuild { path: video.folder().to_owned() });
            }
            refuse_other_build(layout, &begun.builds, claim)?;
            if part.contains(&settings.video) && begun.boxes.is_some() && is_whole(&video, claim, settings)? {
                output.complete.insert(settings.video);
            }
        }
        Ok(output)
    }

    /// Scenes of the videos of a part that are not complete, in its order.
    pub(super) fn remaining_scenes<'p>(&self, plan: &'p Plan, part: &[u32]) -> Vec<&'p SceneSettings> {
        let missing = part.iter().filter(|video| !self.complete.contains(video));
        missing.map(|video| &plan.scenes[*video as usize]).collect()
    }
}

/// Writes the settings of every scene.
pub(super) fn write_plan(layout: &DatasetLayout, plan: &Plan, files: &SharedFiles) -> Result<(), DatasetError> {
    for folder in [layout.scenes(), layout.videos()] {
        fs::create_dir_all(&folder).map_err(|e| DatasetError::io("cannot make the folder", &folder, e))?;
    }
    let missing: Vec<&SceneSettings> = plan.scenes.iter().filter(|s| is_missing(&layout.scene(s.video))).collect();
    for settings in &missing {
        files.write_json(&layout.scene(settings.video), *settings)?;
    }
    if !missing.is_empty() {
        sync_tree(&layout.scenes())?;
    }
    Ok(())
}

/// Takes from videos that have lost files what says that they are complete.
pub(super) fn reopen(
    layout: &DatasetLayout,
    remaining: &[&SceneSettings],
    store: &dyn DatasetStore,
) -> Result<(), StoreError> {
    for settings in remaining {
        let video = layout.video(settings);
        match fs::remove_file(video.scene()) {
            Ok(()) => store.reopen_video(&video)?,
            Err(e) if e.kind() == io::ErrorKind::NotFound => {}
            Err(e) => return Err(DatasetError::io("cannot remove", video.scene(), e).into()),
        }
    }
    Ok(())
}

/// Whether a file is to be written: after a power failure some may be there with nothing in them.
fn is_missing(path: &Path) -> bool {
    fs::metadata(path).map_or(true, |file| file.len() == 0)
}

fn refuse_strangers(root: &Path) -> Result<(), GenerateError> {
    let entries = fs::read_dir(root).map_err(|e| DatasetError::io("cannot read the folder", root, e))?;
    for entry in entries {
        let name = entry.map_err(|e| DatasetError::io("cannot read the folder", root, e))?.file_name();
        let name = name.to_string_lossy();
        // Another shard may have written the manifest a moment ago.
        let ours = ["scenes", "videos", "dataset.json"].contains(&&*name)
            || name.starts_with(".lock")
            || Card::is_ours(&root.join(&*name))
            || ["dataset.json"]
                .iter()
                .chain(&Card::NAMES)
                .any(|file| name.starts_with(&format!(".{file}")) && name.ends_with(".tmp"));
        if !ours {
            return Err(GenerateError::OutputInUse { found: name.into_owned(), path: root.to_owned() });
        }
    }
    Ok(())
}

/// Without a manifest only a scene's settings beside or in a video say of which recipe it is.
fn refuse_unproven_videos(layout: &DatasetLayout, claim: &ResumeRequest<'_>) -> Result<(), GenerateError> {
    let Ok(entries) = fs::read_dir(layout.videos()) else { return Ok(()) };
    for entry in entries {
        let path = entry.map_err(|e| DatasetError::io("cannot read the folder", layout.videos(), e))?.path();
        let planned = claim.plan.scenes.iter().find(|s| layout.video(s).folder() == path);
        let proven = planned.is_some_and(|settings| {
            let record = read_json::<SceneRecord>(&layout.video(settings).scene());
            layout.scene(settings.video).exists() || record.is_ok_and(|r| r.settings == *settings)
        });
        if !proven {
            return Err(GenerateError::UnprovenVideo { path });
        }
    }
    Ok(())
}

fn refuse_other_build(
    layout: &DatasetLayout,
    found: &[BuildIdentity],
    claim: &ResumeRequest<'_>,
) -> Result<(), GenerateError> {
    match found.iter().find(|build| !build.makes_same_bytes(claim.build)) {
        Some(other) if !claim.allow_other_build => Err(GenerateError::OtherBuild {
            theirs: Box::new(other.clone()),
            mine: Box::new(claim.build.clone()),
            path: layout.root().to_owned(),
        }),
        _ => Ok(()),
    }
}

fn refuse_other_recipe(layout: &DatasetLayout, found: &Manifest, recipe: &Recipe) -> Result<(), GenerateError> {
    let other = |field: &str, theirs: String, mine: String| GenerateError::OtherRecipe {
        field: field.to_owned(),
        theirs,
        mine,
        path: layout.root().to_owned(),
    };
    if let Some((field, mine, theirs)) = recipe.first_difference(&found.recipe) {
        return Err(other(&field, theirs, mine));
    }
    if found.recipe.videos > recipe.videos {
        return Err(other("videos", found.recipe.videos.to_string(), recipe.videos.to_string()));
    }
    Ok(())
}

fn refuse_other_scenes(layout: &DatasetLayout, plan: &Plan) -> Result<(), GenerateError> {
    for settings in &plan.scenes {
        let path = layout.scene(settings.video);
        if !is_missing(&path) && read_json::<SceneSettings>(&path).ok().as_ref() != Some(settings) {
            return Err(GenerateError::OtherScene { path });
        }
    }
    Ok(())
}

/// Whether all files of a video are there whose `scene.json` says so.
fn is_whole(video: &VideoLayout, claim: &ResumeRequest<'_>, settings: &SceneSettings) -> Result<bool, GenerateError> {
    let Ok(record) = read_json::<SceneRecord>(&video.scene()) else { return Ok(false) };
    let files = claim.store.files(video)?;
    let is_there = |path: &Path| files.has(video, path);
    if record.actors.is_some() && !is_there(&video.actors()) {
        return Ok(false);
    }
    for stream in Stream::all(claim.recipe, settings, video) {
        if !stream_is_complete(&stream, is_there) {
            return Ok(false);
        }
    }
    Ok(true)
}
