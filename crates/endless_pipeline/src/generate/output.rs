//! The output folder: what it holds, and whether its dataset may be resumed.

use crate::{
    GenerateError, Plan,
    record::{Stream, stream_is_complete},
};
use endless_dataset::{
    BuildIdentity, DatasetError, DatasetLayout, Manifest, Recipe, SceneRecord, VideoEntry, VideoLayout, VideoState,
    read_json, sync_tree, write_json, write_json_durable,
};
use endless_world::SceneSettings;
use std::{collections::BTreeMap, fs, path::Path};

/// The recipe, plan and build that want to resume the output folder.
#[derive(Debug, Clone, Copy)]
pub(super) struct ResumeRequest<'a> {
    pub(super) recipe: &'a Recipe,
    pub(super) plan: &'a Plan,
    /// The build that runs.
    pub(super) build: &'a BuildIdentity,
    /// Resume what another build began.
    pub(super) allow_other_build: bool,
}

/// The state of the output folder: which videos of a plan are complete, and which builds made them.
#[derive(Debug, Default)]
pub(super) struct OutputFolder {
    /// Boxes of the videos that are complete, by number.
    complete: BTreeMap<u32, Vec<u64>>,
    /// The builds that were at work.
    builds: Vec<BuildIdentity>,
    /// Which of them worked on a video, by its number.
    builds_of_video: BTreeMap<u32, Vec<usize>>,
}

impl OutputFolder {
    /// Inspects the folder without changing anything.
    pub(super) fn inspect(layout: &DatasetLayout, claim: &ResumeRequest<'_>) -> Result<Self, GenerateError> {
        let root = layout.root();
        if let Some(file) = root.ancestors().find(|p| p.is_file()) {
            return Err(GenerateError::OutputIsFile { path: file.to_owned() });
        }
        if !root.exists() {
            return Ok(Self::default());
        }
        let mut output = if layout.manifest().exists() {
            let found = Manifest::read(&layout.manifest())?;
            refuse_other_build(layout, &found, claim)?;
            refuse_other_recipe(layout, &found, claim.recipe)?;
            refuse_other_scenes(layout, claim.plan)?;
            let there = found.videos.into_iter().filter(|entry| layout.video_named(&entry.name).folder().exists());
            let builds_of_video = there.map(|entry| (entry.video, entry.builds)).collect();
            Self { complete: BTreeMap::new(), builds: found.builds, builds_of_video }
        } else {
            refuse_strangers(root)?;
            refuse_other_scenes(layout, claim.plan)?;
            Self::without_manifest(layout, claim)?
        };
        for settings in &claim.plan.scenes {
            if let Some(record) = complete_video(layout, claim.recipe, settings)? {
                output.complete.insert(settings.video, record.boxes);
            }
        }
        Ok(output)
    }

    /// Without a manifest nobody knows which build made the images, and only a scene's settings beside them say of which
    /// recipe they are.
    fn without_manifest(layout: &DatasetLayout, claim: &ResumeRequest<'_>) -> Result<Self, GenerateError> {
        let mut output = Self::default();
        let Ok(entries) = fs::read_dir(layout.videos()) else { return Ok(output) };
        for entry in entries {
            let path = entry.map_err(|e| DatasetError::io("cannot read the folder", layout.videos(), e))?.path();
            let planned = claim.plan.scenes.iter().find(|s| layout.video(s).folder() == path);
            let proven = planned.filter(|settings| {
                let record = read_json::<SceneRecord>(&layout.video(settings).scene());
                layout.scene(settings.video).exists() || record.is_ok_and(|r| r.settings == **settings)
            });
            let Some(settings) = proven else { return Err(GenerateError::UnprovenVideo { path }) };
            if !claim.allow_other_build {
                return Err(GenerateError::UnknownBuild { path });
            }
            output.builds = vec![BuildIdentity::unknown()];
            output.builds_of_video.insert(settings.video, vec![0]);
        }
        Ok(output)
    }

    /// The manifest of what is there and what is still to be made.
    pub(super) fn manifest(&self, claim: &ResumeRequest<'_>) -> Manifest {
        let entries = claim.plan.scenes.iter().map(|settings| {
            let boxes = self.complete.get(&settings.video).cloned();
            let state = if boxes.is_some() { VideoState::Complete } else { VideoState::Planned };
            let builds = self.builds_of_video.get(&settings.video).cloned().unwrap_or_default();
            VideoEntry { state, boxes, builds, ..planned(settings) }
        });
        let builds = if self.builds.is_empty() { vec![claim.build.clone()] } else { self.builds.clone() };
        Manifest::new(claim.recipe.clone(), builds, entries.collect())
    }

    /// Scenes of the videos that are not complete, in the order of work.
    pub(super) fn remaining_scenes<'p>(&self, plan: &'p Plan) -> Vec<&'p SceneSettings> {
        let missing = plan.work_order().into_iter().filter(|video| !self.complete.contains_key(video));
        missing.map(|video| &plan.scenes[video as usize]).collect()
    }
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

/// Writes the manifest, then the settings of every scene.
pub(super) fn write_plan(layout: &DatasetLayout, manifest: &Manifest, plan: &Plan) -> Result<(), DatasetError> {
    for folder in [layout.scenes(), layout.videos()] {
        fs::create_dir_all(&folder).map_err(|e| DatasetError::io("cannot make the folder", &folder, e))?;
    }
    endless_dataset::remove_temporaries(&layout.scenes())?;
    let missing: Vec<&SceneSettings> = plan.scenes.iter().filter(|s| is_missing(&layout.scene(s.video))).collect();
    for settings in &missing {
        write_json(&layout.scene(settings.video), *settings)?;
    }
    if !missing.is_empty() {
        sync_tree(&layout.scenes())?;
    }
    write_json_durable(&layout.manifest(), manifest)
}

/// Whether a file is to be written: after a power failure some may be there with nothing in them.
fn is_missing(path: &Path) -> bool {
    fs::metadata(path).map_or(true, |file| file.len() == 0)
}

fn refuse_strangers(root: &Path) -> Result<(), GenerateError> {
    let entries = fs::read_dir(root).map_err(|e| DatasetError::io("cannot read the folder", root, e))?;
    for entry in entries {
        let name = entry.map_err(|e| DatasetError::io("cannot read the folder", root, e))?.file_name();
        let ours = ["scenes", "videos", ".lock", ".dataset.json.tmp"].iter().any(|ours| name == *ours);
        if !ours {
            return Err(GenerateError::OutputInUse {
                found: name.to_string_lossy().into_owned(),
                path: root.to_owned(),
            });
        }
    }
    Ok(())
}

fn refuse_other_build(
    layout: &DatasetLayout,
    found: &Manifest,
    claim: &ResumeRequest<'_>,
) -> Result<(), GenerateError> {
    match found.builds.iter().find(|build| !build.makes_same_bytes(claim.build)) {
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

fn complete_video(
    layout: &DatasetLayout,
    recipe: &Recipe,
    settings: &SceneSettings,
) -> Result<Option<SceneRecord>, GenerateError> {
    let video = layout.video(settings);
    let Ok(record) = read_json::<SceneRecord>(&video.scene()) else { return Ok(None) };
    if record.settings != *settings || (record.actors.is_some() && !video.actors().is_file()) {
        return Ok(None);
    }
    for stream in Stream::all(recipe, settings, &video) {
        if !stream_is_complete(&stream)? {
            return Ok(None);
        }
    }
    Ok(Some(record))
}
