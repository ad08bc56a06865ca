//! A video in which weather and time change is the same from one thread and from two, and after it was interrupted.

use crate::{
    city::city,
    fake::{assert_same, options},
};
use endless_dataset::{DatasetLayout, Layer, RecipeDraft, check};
use endless_pipeline::{SilentProgress, generate, resolve_recipe};
use std::fs;

#[test]
fn a_changing_video_is_resumed_to_the_same_bytes_by_any_number_of_threads() {
    let word = |word: &str| Some(vec![word.to_owned()]);
    let draft = RecipeDraft {
        videos: Some(1),
        maps: word("Town02"),
        weathers: Some(vec!["rainy".into(), "clear_sky".into()]),
        times: word("afternoon"),
        changing: Some("both".into()),
        cameras_per_scene: Some(1),
        size: Some("96x54".into()),
        fps: Some(10.0),
        duration: Some(2.8),
        min_pixels: Some(4),
        ..RecipeDraft::default()
    };
    let recipe = resolve_recipe(draft, city()).expect("a recipe");
    let [whole, broken] = [1, 2].map(|threads| {
        let out = tempfile::tempdir().expect("temp");
        let made = generate(city(), &recipe, out.path(), &options(threads), &SilentProgress).expect("a dataset");
        (out, made)
    });
    assert_same(whole.0.path(), broken.0.path());
    // As a kill leaves it: frames are missing on both sides of key frames, and nothing says that it is complete. Only the
    // key frames beside them are baked again.
    let video = DatasetLayout::new(broken.0.path()).video(&broken.1.plan.scenes[0]);
    for frame in [0, 8, 9, 10, 11] {
        let camera = video.camera(0);
        let gone = if frame % 2 == 0 { Layer::Rgb } else { Layer::Depth };
        fs::remove_file(camera.frame(gone, frame, recipe.rgb_format)).expect("it was there");
    }
    fs::remove_file(video.scene()).expect("it was there");
    generate(city(), &recipe, broken.0.path(), &options(2), &SilentProgress).expect("the rest");
    assert_same(whole.0.path(), broken.0.path());
    let report = check(whole.0.path()).expect("a dataset");
    assert!(report.findings.is_empty(), "{:?}", report.findings);
    let lines = fs::read_to_string(video.frames()).expect("lines");
    for name in ["rainy", "clear_sky", "afternoon"] {
        assert!(lines.contains(&format!(":\"{name}\"")), "{name}");
    }
    for path in [video.frames(), video.camera(0).map()] {
        fs::remove_file(&path).expect("it was there");
        let findings = check(broken.0.path()).expect("a dataset").findings;
        assert!(findings.iter().any(|f| f.to_string().contains("is missing")), "{}: {findings:?}", path.display());
    }
}
