//! The output folder: what it holds, whether it may be gone on with, and the lock on it.

use crate::{GenerateError, Plan, record::camera_is_complete};
use endless_dataset::{
    DatasetError, DatasetLayout, Manifest, Recipe, SceneRecord, Tool, VideoEntry, VideoLayout, VideoState, read_json,
    write_json,
};
use endless_world::SceneSettings;
use std::{
    collections::BTreeMap,
    fs::{self, File, TryLockError},
    path::Path,
};

/// What the output folder holds of a plan.
#[derive(Debug)]
pub(super) struct Output {
    /// Boxes of the videos that are complete, by number.
    complete: BTreeMap<u32, [u64; 2]>,
}

impl Output {
    /// Looks, without changing anything.
    pub(super) fn inspect(layout: &DatasetLayout, recipe: &Recipe, plan: &Plan) -> Result<Self, GenerateError> {
        let nothing = Self { complete: BTreeMap::new() };
        let root = layout.root();
        if let Some(file) = root.ancestors().find(|p| p.is_file()) {
            return Err(GenerateError::OutputIsFile { path: file.to_owned() });
        }
        if !root.exists() {
            return Ok(nothing);
        }
        if layout.manifest().exists() {
            refuse_other_recipe(layout, recipe)?;
            refuse_other_scenes(layout, plan)?;
        } else {
            refuse_strangers(root)?;
            refuse_other_scenes(layout, plan)?;
            refuse_unproven_videos(layout, plan)?;
        }
        let mut complete = BTreeMap::new();
        for settings in &plan.scenes {
            if let Some(record) = complete_video(layout, recipe, settings)? {
                complete.insert(settings.video, record.boxes);
            }
        }
        Ok(Self { complete })
    }

    /// Scenes of the videos that are not complete, in the order of work.
    pub(super) fn to_do<'p>(&self, plan: &'p Plan) -> Vec<&'p SceneSettings> {
        let missing = plan.work_order().into_iter().filter(|video| !self.complete.contains_key(video));
        missing.map(|video| &plan.scenes[video as usize]).collect()
    }

    /// The manifest's list.
    pub(super) fn entries(&self, plan: &Plan) -> Vec<VideoEntry> {
        plan.scenes
            .iter()
            .map(|settings| match self.complete.get(&settings.video) {
                Some(boxes) => entry(settings, VideoState::Complete, Some(*boxes)),
                None => entry(settings, VideoState::Planned, None),
            })
            .collect()
    }
}

/// A video's entry in the manifest.
pub(super) fn entry(settings: &SceneSettings, state: VideoState, boxes: Option<[u64; 2]>) -> VideoEntry {
    VideoEntry {
        video: settings.video,
        name: VideoLayout::name(settings),
        state,
        map: settings.map.clone(),
        weather: settings.weather,
        time_of_day: settings.time_of_day,
        cameras: settings.cameras.each_ref().map(|c| c.name.clone()),
        frames: settings.frames,
        boxes,
    }
}

/// Writes the manifest, then the settings of every scene.
pub(super) fn write_plan(layout: &DatasetLayout, manifest: &Manifest, plan: &Plan) -> Result<(), DatasetError> {
    for folder in [layout.scenes(), layout.videos()] {
        fs::create_dir_all(&folder).map_err(|e| DatasetError::io("cannot make the folder", &folder, e))?;
    }
    endless_dataset::remove_temporaries(&layout.scenes())?;
    for settings in &plan.scenes {
        let path = layout.scene(settings.video);
        if !path.exists() {
            write_json(&path, settings)?;
        }
    }
    write_json(&layout.manifest(), manifest)
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

fn refuse_other_recipe(layout: &DatasetLayout, recipe: &Recipe) -> Result<(), GenerateError> {
    let found: Manifest = read_json(&layout.manifest())?;
    let other = |field: &str, theirs: String, mine: String| GenerateError::OtherRecipe {
        field: field.to_owned(),
        theirs,
        mine,
        path: layout.root().to_owned(),
    };
    let tool = Tool::current();
    if found.format != Manifest::FORMAT || found.tool != tool {
        return Err(other("the version of endless", found.tool.version, tool.version));
    }
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
        if path.exists() && read_json::<SceneSettings>(&path).ok().as_ref() != Some(settings) {
            return Err(GenerateError::OtherScene { path });
        }
    }
    Ok(())
}

/// Without a manifest, images are gone on with only where the scene's settings lie beside them.
fn refuse_unproven_videos(layout: &DatasetLayout, plan: &Plan) -> Result<(), GenerateError> {
    let Ok(entries) = fs::read_dir(layout.videos()) else { return Ok(()) };
    for entry in entries {
        let path = entry.map_err(|e| DatasetError::io("cannot read the folder", layout.videos(), e))?.path();
        let planned = plan.scenes.iter().find(|s| layout.video(s).folder() == path);
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

fn complete_video(
    layout: &DatasetLayout,
    recipe: &Recipe,
    settings: &SceneSettings,
) -> Result<Option<SceneRecord>, GenerateError> {
    let video = layout.video(settings);
    let Ok(record) = read_json::<SceneRecord>(&video.scene()) else { return Ok(None) };
    let whole = record.settings == *settings
        && camera_is_complete(&video.camera(0), recipe)?
        && camera_is_complete(&video.camera(1), recipe)?;
    Ok(whole.then_some(record))
}

/// Keeps a second process out. Released when the process ends, however it ends; leaves no trace when it is dropped.
#[derive(Debug)]
pub(super) struct Lock {
    _file: File,
    path: std::path::PathBuf,
}

impl Lock {
    pub(super) fn take(layout: &DatasetLayout) -> Result<Self, GenerateError> {
        let root = layout.root();
        fs::create_dir_all(root).map_err(|e| DatasetError::io("cannot make the folder", root, e))?;
        let path = layout.lock();
        let file = File::create(&path).map_err(|e| DatasetError::io("cannot write", root, e))?;
        match file.try_lock() {
            Ok(()) => Ok(Self { _file: file, path }),
            Err(TryLockError::WouldBlock) => Err(GenerateError::Locked { path: root.to_owned() }),
            Err(TryLockError::Error(e)) => Err(DatasetError::io("cannot lock", root, e).into()),
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.path);
    }
}
