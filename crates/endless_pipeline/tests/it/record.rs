//! From recipe to files, with the fake simulator.

use crate::fake::{Fake, assert_same, contents, draft, first_video, make, options, recipe};
use endless_dataset::{Layer, RecipeDraft, check};
use endless_pipeline::{
    GenerateError, GenerateOptions, Progress, ProgressEvent, SilentProgress, SimulatorError, generate,
};
use std::{
    fs,
    sync::atomic::{AtomicU32, Ordering},
};

fn all_layers() -> RecipeDraft {
    let all: Vec<String> = Layer::ALL.iter().map(ToString::to_string).collect();
    RecipeDraft { layers: Some(all.clone()), mp4: Some(all), ..draft() }
}

#[test]
fn the_dataset_is_whole_and_loads_each_map_once() {
    let out = tempfile::tempdir().expect("temp");
    let fake = Fake::default();
    let recipe = recipe(all_layers());
    let generated = make(&fake, &recipe, out.path(), 2);
    assert_eq!((generated.videos, generated.camera_frames), (3, 120));
    assert!(fake.maps_loaded.load(Ordering::SeqCst) <= 2);
    let report = check(out.path()).expect("a dataset");
    assert_eq!(report.findings, []);
    assert_eq!((report.videos, report.images), (3, 3 * 2 * Layer::ALL.len() as u64 * 20));
    assert!(report.boxes > 100, "{} boxes", report.boxes);
}

#[test]
fn threads_and_runs_do_not_change_a_byte() {
    for format in ["png", "jpg"] {
        let recipe = recipe(RecipeDraft { rgb_format: Some(format.into()), ..all_layers() });
        let outs = [1, 2, 5].map(|threads| {
            let out = tempfile::tempdir().expect("temp");
            make(&Fake::default(), &recipe, out.path(), threads);
            out
        });
        assert_same(outs[0].path(), outs[1].path());
        assert_same(outs[0].path(), outs[2].path());
    }
}

#[test]
fn a_complete_dataset_is_left_alone() {
    let out = tempfile::tempdir().expect("temp");
    let recipe = recipe(draft());
    make(&Fake::default(), &recipe, out.path(), 2);
    let fake = Fake::default();
    assert_eq!(make(&fake, &recipe, out.path(), 2).videos, 0);
    assert_eq!((fake.bakes.into_inner(), fake.renders.into_inner(), fake.maps_loaded.into_inner()), (0, 0, 0));
}

#[test]
fn more_videos_extend_the_dataset() {
    let (grown, whole) = (tempfile::tempdir().expect("temp"), tempfile::tempdir().expect("temp"));
    let of = |videos| recipe(RecipeDraft { videos: Some(videos), ..draft() });
    make(&Fake::default(), &of(2), grown.path(), 2);
    let fake = Fake::default();
    assert_eq!(make(&fake, &of(4), grown.path(), 2).videos, 2);
    assert_eq!(fake.bakes.into_inner(), 2);
    make(&Fake::default(), &of(4), whole.path(), 2);
    assert_same(grown.path(), whole.path());
}

#[test]
fn what_was_deleted_or_spoilt_comes_back() {
    let (out, whole) = (tempfile::tempdir().expect("temp"), tempfile::tempdir().expect("temp"));
    let recipe = recipe(all_layers());
    for folder in [&out, &whole] {
        make(&Fake::default(), &recipe, folder.path(), 2);
    }
    let video = first_video(out.path());
    let camera = video.camera(1);
    // Only the video file: nothing is rendered, nothing baked.
    fs::remove_file(camera.mp4(Layer::Rgb)).expect("there");
    let fake = Fake::default();
    make(&fake, &recipe, out.path(), 2);
    assert_eq!((fake.bakes.into_inner(), fake.renders.into_inner()), (0, 0));
    assert_same(out.path(), whole.path());
    // What stays the same of the objects.
    fs::remove_file(video.actors()).expect("there");
    let fake = Fake::default();
    make(&fake, &recipe, out.path(), 2);
    assert_eq!((fake.bakes.into_inner(), fake.renders.into_inner()), (0, 0));
    assert_same(out.path(), whole.path());
    // Some images and a scene.
    fs::remove_file(camera.frame(Layer::Depth, 3, recipe.rgb_format)).expect("there");
    fs::remove_file(out.path().join("scenes/0001.json")).expect("there");
    let fake = Fake::default();
    make(&fake, &recipe, out.path(), 2);
    assert_eq!((fake.bakes.into_inner(), fake.renders.into_inner()), (1, 1));
    assert_same(out.path(), whole.path());
    // A spoilt image is noticed when its video is gone through.
    fs::write(camera.frame(Layer::Instance, 7, recipe.rgb_format), "spoilt").expect("writable");
    fs::remove_file(video.scene()).expect("there");
    make(&Fake::default(), &recipe, out.path(), 2);
    assert_same(out.path(), whole.path());
}

#[test]
fn other_recipes_and_other_files_are_refused_and_nothing_is_harmed() {
    let out = tempfile::tempdir().expect("temp");
    let fake = Fake::default();
    make(&fake, &recipe(draft()), out.path(), 2);
    let before = contents(out.path());
    let options = options(2);
    let refuse = |draft: RecipeDraft| {
        generate(&fake, &recipe(draft), out.path(), &options, &SilentProgress).expect_err("refused").to_string()
    };
    let fps = refuse(RecipeDraft { fps: Some(5.0), ..draft() });
    assert!(fps.contains("(fps is 10.0 there, 5.0 here)"), "{fps}");
    let fewer = refuse(RecipeDraft { videos: Some(1), ..draft() });
    assert!(fewer.contains("(videos is 3 there, 1 here)"), "{fewer}");
    fs::remove_file(out.path().join("dataset.json")).expect("there");
    let seed = refuse(RecipeDraft { seed: Some(9), ..draft() });
    assert!(seed.contains("scenes/0000.json"), "{seed}");
    let mut after = contents(out.path());
    after.insert("dataset.json".into(), before["dataset.json"].clone());
    assert!(before == after, "nothing changed");

    fs::remove_dir_all(out.path().join("scenes")).expect("there");
    let unproven = refuse(RecipeDraft { seed: Some(9), ..draft() });
    assert!(unproven.contains("nothing says that this video is of this recipe"), "{unproven}");
    let other = tempfile::tempdir().expect("temp");
    fs::write(other.path().join("thesis.tex"), "dear").expect("writable");
    let error = generate(&fake, &recipe(draft()), other.path(), &options, &SilentProgress).expect_err("refused");
    assert!(matches!(error, GenerateError::OutputInUse { .. }));
    assert_eq!(contents(other.path()).len(), 1);
}

#[test]
fn a_second_process_is_kept_out() {
    let out = tempfile::tempdir().expect("temp");
    let lock = fs::File::create(out.path().join(".lock")).expect("writable");
    lock.try_lock().expect("free");
    let error = generate(&Fake::default(), &recipe(draft()), out.path(), &options(1), &SilentProgress);
    assert!(matches!(error, Err(GenerateError::Locked { .. })));
    drop(lock);
    make(&Fake::default(), &recipe(draft()), out.path(), 1);
}

#[test]
fn the_plan_alone_can_be_written_and_then_recorded() {
    let (out, whole) = (tempfile::tempdir().expect("temp"), tempfile::tempdir().expect("temp"));
    let recipe = recipe(draft());
    let options = GenerateOptions { plan_only: true, ..options(1) };
    let planned = generate(&Fake::default(), &recipe, out.path(), &options, &SilentProgress).expect("plans");
    assert_eq!(planned.plan.scenes.len(), 3);
    assert_eq!(contents(out.path()).len(), 6, "three scenes, the manifest and two cards");
    assert_eq!(check(out.path()).expect("a dataset").findings.len(), 3, "three videos are not complete");
    make(&Fake::default(), &recipe, out.path(), 2);
    make(&Fake::default(), &recipe, whole.path(), 2);
    assert_same(out.path(), whole.path());
}

#[test]
fn cards_are_no_strangers_and_a_foreign_readme_is() {
    let (out, whole) = (tempfile::tempdir().expect("temp"), tempfile::tempdir().expect("temp"));
    let recipe = recipe(draft());
    fs::write(out.path().join("README.md"), "# Notes\n").expect("writable");
    let error = generate(&Fake::default(), &recipe, out.path(), &options(1), &SilentProgress).expect_err("in use");
    assert!(error.to_string().contains("README.md"), "{error}");
    assert_eq!(fs::read_to_string(out.path().join("README.md")).expect("there"), "# Notes\n");
    for folder in [&out, &whole] {
        let _ = fs::remove_file(folder.path().join("README.md"));
        make(&Fake::default(), &recipe, folder.path(), 2);
    }
    let card = fs::read_to_string(out.path().join("README.md")).expect("a card");
    assert!(card.contains("| videos | 3 |"), "{card}");
    fs::remove_file(out.path().join("dataset.json")).expect("there");
    fs::write(out.path().join(".croissant.json.tmp"), "{").expect("writable");
    make(&Fake::default(), &recipe, out.path(), 2);
    assert_same(out.path(), whole.path());
}

#[test]
fn layers_are_optional() {
    for layers in [&["rgb"][..], &["depth"], &["instance"], &["depth", "instance"], &["panoptic"]] {
        let out = tempfile::tempdir().expect("temp");
        let layers: Vec<String> = layers.iter().map(|l| (*l).to_owned()).collect();
        let recipe = recipe(RecipeDraft { layers: Some(layers.clone()), videos: Some(1), ..draft() });
        make(&Fake::default(), &recipe, out.path(), 2);
        let report = check(out.path()).expect("a dataset");
        assert_eq!((report.findings, report.images), (vec![], 40 * layers.len() as u64));
        assert!(report.boxes > 0, "boxes do not need the layer on disk");
        let again = make(&Fake::default(), &recipe, out.path(), 2);
        assert_eq!(again.videos, 0);
    }
}

#[test]
fn any_number_of_cameras_films_a_scene() {
    for cameras in [1, 3, 8] {
        let (out, whole) = (tempfile::tempdir().expect("temp"), tempfile::tempdir().expect("temp"));
        let draft = RecipeDraft { cameras_per_scene: Some(cameras), videos: Some(1), ..all_layers() };
        let recipe = recipe(draft);
        for (folder, threads) in [(&out, 1), (&whole, 3)] {
            let generated = make(&Fake::default(), &recipe, folder.path(), threads);
            assert_eq!(generated.camera_frames, cameras as u64 * 20);
        }
        assert_same(out.path(), whole.path());
        let report = check(out.path()).expect("a dataset");
        assert_eq!((report.findings, report.images), (vec![], cameras as u64 * Layer::ALL.len() as u64 * 20));
        let video = first_video(out.path());
        let last = video.camera(cameras as usize - 1);
        assert!(last.folder().ends_with(["camera_a", "camera_c", "camera_h"][cameras as usize / 3]));
        // What is lost of the last camera comes back.
        fs::remove_file(last.frame(Layer::Instance, 11, recipe.rgb_format)).expect("there");
        make(&Fake::default(), &recipe, out.path(), 2);
        assert_same(out.path(), whole.path());
    }
}

#[test]
fn fewer_vehicles_than_asked_for_are_recorded() {
    let out = tempfile::tempdir().expect("temp");
    let recipe = recipe(RecipeDraft { vehicles: Some(90), videos: Some(1), ..draft() });
    make(&Fake::default(), &recipe, out.path(), 2);
    let record: endless_dataset::SceneRecord =
        endless_dataset::read_json(&first_video(out.path()).scene()).expect("recorded");
    assert_eq!((record.settings.vehicles, record.spawned.vehicles), (90, 12));
}

#[test]
fn check_names_what_is_wrong() {
    let out = tempfile::tempdir().expect("temp");
    let recipe = recipe(draft());
    make(&Fake::default(), &recipe, out.path(), 2);
    let camera = first_video(out.path()).camera(0);
    let problems =
        || check(out.path()).expect("a dataset").findings.iter().map(ToString::to_string).collect::<Vec<_>>();
    let restore = |path: &std::path::Path, spoil: &dyn Fn(&std::path::Path), expected: &str| {
        let bytes = fs::read(path).expect("there");
        spoil(path);
        let found = problems();
        assert!(found.iter().any(|p| p.contains(expected)), "{found:?} lacks '{expected}'");
        fs::write(path, bytes).expect("writable");
    };
    let cut = |path: &std::path::Path| {
        let bytes = fs::read(path).expect("there");
        fs::write(path, &bytes[..bytes.len() / 2]).expect("writable");
    };
    let remove = |path: &std::path::Path| fs::remove_file(path).expect("there");
    restore(&camera.frame(Layer::Rgb, 4, recipe.rgb_format), &cut, "000004.png: does not decode");
    restore(&camera.frame(Layer::Depth, 5, recipe.rgb_format), &remove, "depth/000005.png: cannot read");
    restore(&camera.mp4(Layer::Rgb), &cut, "rgb.mp4: is not a whole MP4 file");
    restore(&camera.objects(), &cut, "objects.jsonl: line");
    restore(&camera.camera(), &cut, "camera.json: is not what it should be");
    let actors = first_video(out.path()).actors();
    restore(&actors, &cut, "actors.json: is not what it should be");
    restore(&actors, &remove, "actors.json: cannot read");
    let change = |from: &'static str, to: &'static str| {
        move |path: &std::path::Path| {
            let text = fs::read_to_string(path).expect("text");
            fs::write(path, text.replacen(from, to, 1)).expect("writable");
        }
    };
    restore(&actors, &change("\"truck\"", "\"bus\""), "is a bus, not a truck");
    restore(&actors, &change("\"id\":3", "\"id\":30"), "actors.json: lacks object 3, a truck");
    restore(&actors, &change("\"id\":3", "\"id\":30"), "actors.json: is not sorted by id");
    restore(&actors, &change("\"id\":2", "\"rider_id\":3,\"id\":2"), "rider and vehicle do not name each other");
    restore(&actors, &change("{\"id\":1,\"class\":\"van\",\"parked\":true},\n", ""), "scene.json says 11");
    let instance = |frame| camera.frame(Layer::Instance, frame, recipe.rgb_format);
    let swap = |path: &std::path::Path| {
        fs::copy(instance(9), path).expect("copies");
    };
    restore(&instance(2), &swap, "objects.jsonl: frame 2:");
    let relabel = |path: &std::path::Path| {
        let text = fs::read_to_string(path).expect("text");
        fs::write(path, text.replacen("\"truck\"", "\"bus\"", 1)).expect("writable");
    };
    restore(&camera.objects(), &relabel, "is truck and bus in different frames");
    fs::write(camera.layer(Layer::Rgb).join("000099.png"), "extra").expect("writable");
    assert_eq!(problems().len(), 1);
    assert!(problems()[0].ends_with("000099.png: does not belong here"));
}

/// Ends a run after so many frames.
struct StopAfter {
    frames: u32,
    seen: AtomicU32,
}

impl Progress for StopAfter {
    fn event(&self, event: &ProgressEvent<'_>) {
        if matches!(event, ProgressEvent::Frame { .. }) {
            self.seen.fetch_add(1, Ordering::SeqCst);
        }
    }

    fn is_stopped(&self) -> bool {
        self.seen.load(Ordering::SeqCst) >= self.frames
    }
}

#[test]
fn a_run_that_is_stopped_goes_on_to_the_same_bytes() {
    let (stopped, whole) = (tempfile::tempdir().expect("temp"), tempfile::tempdir().expect("temp"));
    let recipe = recipe(draft());
    for frames in [0, 7, 15] {
        let stop = StopAfter { frames, seen: AtomicU32::new(0) };
        let error = generate(&Fake::default(), &recipe, stopped.path(), &options(2), &stop).expect_err("stopped");
        assert!(matches!(error, GenerateError::Simulator(SimulatorError::Interrupted)), "{error}");
        assert!(stop.seen.into_inner() < frames + 3, "only what was under way is finished");
    }
    make(&Fake::default(), &recipe, stopped.path(), 2);
    make(&Fake::default(), &recipe, whole.path(), 2);
    assert_same(stopped.path(), whole.path());
}
