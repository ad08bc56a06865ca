//! What bakes of the same camera share is traced once, and a dataset is the same with it and without.

use crate::{
    city::city,
    fake::{contents, options},
};
use endless_dataset::{Recipe, RecipeDraft};
use endless_interchange::MapLibrary;
use endless_pipeline::{BakeCache, BuiltinSimulator, MapCatalog, SilentProgress, generate, resolve_recipe};
use std::{collections::BTreeMap, fs, path::Path};

/// Two cameras of one town, by day and at night.
fn recipe() -> Recipe {
    let sites = city().cameras("Town02").expect("a town").into_iter().take(2).collect();
    let words = |words: &[&str]| Some(words.iter().map(|&word| word.to_owned()).collect());
    let draft = RecipeDraft {
        videos: Some(2),
        maps: words(&["Town02"]),
        weathers: words(&["clear_sky"]),
        times: words(&["afternoon", "night"]),
        size: Some("96x54".into()),
        fps: Some(5.0),
        duration: Some(0.2),
        vehicles: Some(5),
        pedestrians: Some(5),
        min_pixels: Some(4),
        ..RecipeDraft::default()
    };
    let recipe = resolve_recipe(draft, city()).expect("a recipe");
    Recipe { cameras: BTreeMap::from([("Town02".to_owned(), sites)]), ..recipe }
}

/// All files of the dataset that is made with a cache.
fn made_with(cache: BakeCache) -> BTreeMap<String, Vec<u8>> {
    made_of(&recipe(), cache)
}

fn made_of(recipe: &Recipe, cache: BakeCache) -> BTreeMap<String, Vec<u8>> {
    let simulator = BuiltinSimulator::new(MapLibrary::builtin()).with_bake_cache(cache);
    let out = tempfile::tempdir().expect("temp");
    generate(&simulator, recipe, out.path(), &options(2), &SilentProgress).expect("a dataset");
    contents(out.path())
}

fn in_folder(path: &Path, build: &str) -> BakeCache {
    BakeCache::default().in_folder(path, build).expect("writable")
}

#[test]
fn a_dataset_is_the_same_whatever_is_kept() {
    let folder = tempfile::tempdir().expect("temp");
    let files = || fs::read_dir(folder.path()).expect("there").map(|entry| entry.expect("an entry").path());
    let plain = made_with(BakeCache::default());
    assert!(plain == made_with(BakeCache::in_memory(1 << 30)), "kept in memory");
    assert!(plain == made_with(BakeCache::in_memory(100_000)), "some kept in memory");
    assert!(plain == made_with(in_folder(folder.path(), "one")), "written to a folder");
    assert_eq!(files().count(), 2, "a file a camera");
    // One is damaged, one is read.
    let damaged = files().next().expect("a file");
    let whole = fs::read(&damaged).expect("readable");
    fs::write(&damaged, &whole[..whole.len() / 2]).expect("writable");
    assert!(plain == made_with(in_folder(folder.path(), "one")), "read from a folder");
    assert!(fs::read(&damaged).expect("readable") == whole, "it is made again");
    made_of(&Recipe { videos: 1, ..recipe() }, in_folder(folder.path(), "another"));
    assert_eq!(files().count(), 4, "another build keeps its own");
}
