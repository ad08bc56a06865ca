//! Makes a dataset to time it, and leaves nothing of it.

use crate::{args::BenchArgs, build_info::this_build};
use anyhow::{Context, Result};
use endless_dataset::{DatasetLayout, RecipeDraft};
use endless_pipeline::{GenerateOptions, Generated, MapSource, SilentProgress, Simulator, generate, resolve_recipe};
use std::{
    fs::{self, File},
    path::Path,
};

/// What the names of the bench's datasets begin with; the number of its process follows.
const FOLDER: &str = ".endless-bench-";

/// How much is recorded if nothing else is asked for, seconds.
const DURATION_S: f64 = 2.0;

/// What all benches have in common.
pub(super) fn draft(args: &BenchArgs) -> RecipeDraft {
    RecipeDraft {
        videos: Some(1),
        size: args.size.clone(),
        duration: Some(args.duration.unwrap_or(DURATION_S)),
        maps: args.maps.clone(),
        layers: args.layers.clone(),
        // A rig is recorded by itself.
        cameras_per_scene: args.cameras_per_scene.or(args.rig.as_ref().map(|_| 0)),
        ..RecipeDraft::default()
    }
}

/// Makes a dataset, and leaves nothing of it.
pub(super) fn film<S: Simulator + MapSource>(simulator: &S, draft: RecipeDraft, threads: usize) -> Result<Generated> {
    film_for(simulator, draft, threads, |_out| Ok(()))
}

/// Makes a dataset for something, and leaves nothing of it.
pub(super) fn film_for<S: Simulator + MapSource>(
    simulator: &S,
    draft: RecipeDraft,
    threads: usize,
    with: impl FnOnce(&Path) -> Result<()>,
) -> Result<Generated> {
    let recipe = resolve_recipe(draft, simulator)?;
    let folder = std::env::current_dir()?;
    remove_leftovers(&folder)?;
    let out = folder.join(format!("{FOLDER}{}", std::process::id()));
    let options =
        GenerateOptions { build: this_build(), allow_other_build: false, threads, plan_only: false, shard: None };
    let made = generate(simulator, &recipe, &out, &options, &SilentProgress);
    let used = if made.is_ok() { with(&out) } else { Ok(()) };
    if out.exists() {
        fs::remove_dir_all(&out).context("cannot remove the bench's files")?;
    }
    used?;
    Ok(made?)
}

/// Removes what benches that were killed left behind: datasets that nobody writes any more.
fn remove_leftovers(folder: &Path) -> Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if !entry.file_name().to_string_lossy().starts_with(FOLDER) {
            continue;
        }
        // One without a lock is just being removed, or never was begun.
        let lock = File::open(DatasetLayout::new(entry.path()).lock());
        if lock.is_ok_and(|lock| lock.try_lock().is_ok()) {
            fs::remove_dir_all(entry.path()).context("cannot remove the files of a bench that was killed")?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_killed_benches_left_goes_and_what_is_being_written_stays() {
        let folder = tempfile::tempdir().expect("temp");
        let bench = |name: &str| {
            let out = folder.path().join(name);
            fs::create_dir(&out).expect("writable");
            fs::write(out.join("dataset.json"), "{}").expect("writable");
            (File::create(out.join(".lock")).expect("writable"), out)
        };
        let ((killed_lock, killed), (lock, running), (_, dear)) =
            (bench(".endless-bench-1"), bench(".endless-bench-2"), bench("thesis"));
        drop(killed_lock);
        lock.try_lock().expect("free");
        remove_leftovers(folder.path()).expect("removable");
        assert!(!killed.exists() && running.exists() && dear.exists());
    }
}
