//! Recording from a simulator that gives frames in order and only once, and fails now and then.

use crate::fake::{Fault, LiveFake, contents, draft, make, options, recipe};
use endless_dataset::{
    DatasetLayout, Layer, Manifest, Recipe, RgbFormat, VideoState, check, read_json, read_objects, read_rgb,
};
use endless_pipeline::{GenerateError, SilentProgress, SimulatorError, generate};
use std::{collections::BTreeSet, path::Path};

/// The number of the session that each frame of a video is from, over all cameras.
fn sessions(out: &Path, recipe: &Recipe, video: usize) -> BTreeSet<u8> {
    let layout = DatasetLayout::new(out);
    let manifest: Manifest = read_json(&layout.manifest()).expect("planned");
    let folder = layout.video_named(&manifest.videos[video].name);
    let frames = (0..recipe.frames()).flat_map(|f| folder.cameras(2).map(move |c| (f, c)).collect::<Vec<_>>());
    frames
        .map(|(f, camera)| read_rgb(&camera.frame(Layer::Rgb, f, recipe.rgb_format), RgbFormat::Png).expect("an image"))
        .map(|image| image.rgb8().expect("8 bits").data[0][0])
        .collect()
}

#[test]
fn actors_that_come_and_go_are_labelled() {
    for threads in [1, 4] {
        let out = tempfile::tempdir().expect("temp");
        let recipe = recipe(draft());
        make(&LiveFake::default(), &recipe, out.path(), threads);
        let report = check(out.path()).expect("a dataset");
        assert_eq!((report.findings, report.images), (vec![], 3 * 2 * 3 * 20));
        let layout = DatasetLayout::new(out.path());
        let manifest: Manifest = read_json(&layout.manifest()).expect("complete");
        let video = layout.video_named(&manifest.videos[0].name);
        assert!(!video.actors().exists(), "who comes later is not known at first");
        let camera = video.camera(0);
        let lines = read_objects(&camera.objects()).expect("labelled");
        let ids = |frame: usize| lines[frame].objects.iter().map(|o| o.id).collect::<BTreeSet<_>>();
        assert!(ids(10).difference(&ids(0)).count() > 0 && ids(0).difference(&ids(10)).count() > 0);
    }
}

#[test]
fn after_any_failure_the_same_command_finishes_the_job() {
    let faults = [
        Fault::NoScene,
        Fault::DiesAt(0),
        Fault::DiesAt(11),
        Fault::HangsAt(7),
        Fault::SkipsAt(4),
        Fault::SensorsSkipAt(19),
    ];
    for (fault, threads) in faults.into_iter().zip([1, 3].into_iter().cycle()) {
        let out = tempfile::tempdir().expect("temp");
        let recipe = recipe(draft());
        let simulator = LiveFake::default();
        // The second video of three fails, and once more when it is begun again.
        simulator.faults.lock().expect("unpoisoned").extend([Fault::None, fault, Fault::DiesAt(3)]);
        let fail =
            || generate(&simulator, &recipe, out.path(), &options(threads), &SilentProgress).expect_err("it fails");
        let error = fail();
        let GenerateError::Simulator(told) = &error else { panic!("{error}") };
        match (fault, told) {
            (Fault::NoScene, SimulatorError::Scene { .. })
            | (Fault::DiesAt(_), SimulatorError::ConnectionLost { .. })
            | (Fault::HangsAt(_), SimulatorError::Timeout { .. })
            | (Fault::SkipsAt(4), SimulatorError::FramesDropped { expected: 4, got: 5 })
            | (Fault::SensorsSkipAt(19), SimulatorError::FramesDropped { expected: 19, got: 20 }) => {}
            other => panic!("{other:?}"),
        }
        assert_eq!(error.to_string().lines().count(), 1);
        let layout = DatasetLayout::new(out.path());
        let states = || {
            let manifest: Manifest = read_json(&layout.manifest()).expect("planned");
            manifest.videos.into_iter().map(|v| v.state).collect::<Vec<_>>()
        };
        assert_eq!(states().iter().filter(|s| **s == VideoState::Complete).count(), 1, "what was made is there");
        let done = contents(out.path());
        fail();
        let generated = make(&simulator, &recipe, out.path(), threads);
        assert_eq!(generated.videos, 2);
        assert_eq!(simulator.sessions.load(std::sync::atomic::Ordering::SeqCst), 5);
        let report = check(out.path()).expect("a dataset");
        assert_eq!((report.findings, report.images), (vec![], 3 * 2 * 3 * 20), "frames asked are frames written");
        let mut from: Vec<u8> = Vec::new();
        for video in 0..3 {
            let sessions = sessions(out.path(), &recipe, video);
            assert_eq!(sessions.len(), 1, "a video is of one session");
            from.extend(sessions);
        }
        from.sort_unstable();
        assert_eq!(from, [1, 4, 5]);
        let after = contents(out.path());
        let scenes = done.keys().filter(|name| name.ends_with("scene.json")).collect::<Vec<_>>();
        assert_eq!(scenes.len(), 1);
        let whole = scenes[0].trim_end_matches("scene.json");
        assert!(done.iter().filter(|(name, _)| name.starts_with(whole)).all(|(name, bytes)| after[name] == *bytes));
    }
}

#[test]
fn an_image_lost_from_a_complete_video_costs_the_whole_video() {
    let out = tempfile::tempdir().expect("temp");
    let recipe = recipe(draft());
    let simulator = LiveFake::default();
    make(&simulator, &recipe, out.path(), 2);
    let camera = crate::fake::first_video(out.path()).camera(1);
    std::fs::remove_file(camera.frame(Layer::Depth, 13, recipe.rgb_format)).expect("there");
    assert_eq!(make(&simulator, &recipe, out.path(), 2).videos, 1);
    assert_eq!(check(out.path()).expect("a dataset").findings, []);
    assert_eq!(sessions(out.path(), &recipe, 0), [4].into());
}
