//! The bytes of a tiny dataset of the built-in city in each weather. They change only on purpose: whoever changes them
//! updates the snapshot in the same commit (`INSTA_UPDATE=always cargo test -p endless_pipeline --test it golden`), with
//! a line in the changelog.

use crate::{city::city, fake::options};
use endless_dataset::{CameraLayout, DatasetLayout, Layer, RecipeDraft};
use endless_pipeline::{SilentProgress, generate, resolve_recipe};
use std::{fmt::Write, fs, path::Path};

/// Map, weather, time of day: each weather once, each time of day, five towns.
const SCENES: [[&str; 3]; 5] = [
    ["Town01", "clear_sky", "morning"],
    ["Town06", "rainy", "night"],
    ["Altstadt", "cloudy", "afternoon"],
    ["Town07", "foggy", "night"],
    ["Town10HD", "after_rain", "morning"],
];

fn draft([map, weather, time]: [&str; 3]) -> RecipeDraft {
    let one = |word: &str| Some(vec![word.to_owned()]);
    let all: Vec<String> = Layer::ALL.iter().map(ToString::to_string).collect();
    RecipeDraft {
        videos: Some(1),
        maps: one(map),
        weathers: one(weather),
        times: one(time),
        size: Some("160x90".into()),
        fps: Some(5.0),
        duration: Some(0.4),
        min_pixels: Some(4),
        layers: Some(all.clone()),
        mp4: Some(all),
        ..RecipeDraft::default()
    }
}

/// Hash of files one after the other.
fn digest<'a>(paths: impl IntoIterator<Item = &'a Path>) -> String {
    let mut hasher = blake3::Hasher::new();
    for path in paths {
        let bytes = fs::read(path).expect("a file of the dataset");
        assert!(!bytes.is_empty(), "{}", path.display());
        hasher.update(&bytes);
    }
    hasher.finalize().to_hex()[..32].to_owned()
}

/// A line a layer, a video file, a list of objects and a description of the camera.
fn camera_digests(table: &mut String, title: &str, camera: &CameraLayout) {
    let mut line = |what: &str, digest: String| writeln!(table, "{title} {what} {digest}").expect("memory");
    for &layer in Layer::ALL {
        let entries = fs::read_dir(camera.layer(layer)).expect("a layer");
        let mut images: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
        images.sort();
        assert_eq!(images.len(), 2);
        line(layer.name(), digest(images.iter().map(AsRef::as_ref)));
        line(&format!("{layer}.mp4"), digest([camera.mp4(layer).as_path()]));
    }
    line("objects.jsonl", digest([camera.objects().as_path()]));
    line("camera.json", digest([camera.camera().as_path()]));
    line("map.json", digest([camera.map().as_path()]));
}

#[test]
fn golden_digests_of_every_layer_and_label_file() {
    let mut table = String::new();
    for scene in SCENES {
        let out = tempfile::tempdir().expect("temp");
        let recipe = resolve_recipe(draft(scene), city()).expect("a recipe");
        let generated = generate(city(), &recipe, out.path(), &options(2), &SilentProgress).expect("a dataset");
        let layout = DatasetLayout::new(out.path());
        let video = layout.video(&generated.plan.scenes[0]);
        for (camera, name) in ["camera_a", "camera_b"].into_iter().enumerate() {
            camera_digests(&mut table, &format!("{} {name}", scene.join(" ")), &video.camera(camera));
        }
        for (name, path) in
            [("scene.json", video.scene()), ("actors.json", video.actors()), ("frames.jsonl", video.frames())]
        {
            writeln!(table, "{} {name} {}", scene.join(" "), digest([path.as_path()])).expect("memory");
        }
    }
    insta::assert_snapshot!(table);
}
