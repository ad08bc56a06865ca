//! A dataset is gone on with by the build that began it, or by another on request, and says who was at work.

use crate::fake::{Fake, build, contents, draft, make, options, recipe};
use endless_dataset::{BuildIdentity, Card, DatasetError, DatasetLayout, Manifest, RecipeDraft, check};
use endless_pipeline::{GenerateError, GenerateOptions, Progress, ProgressEvent, SilentProgress, generate};
use std::{fs, path::Path};

fn manifest(out: &Path) -> Manifest {
    Manifest::read(&DatasetLayout::new(out).manifest()).expect("a manifest")
}

fn of(videos: i64) -> endless_dataset::Recipe {
    recipe(RecipeDraft { videos: Some(videos), ..draft() })
}

fn other_build(allow_other_build: bool) -> GenerateOptions {
    GenerateOptions { build: build("other"), allow_other_build, ..options(2) }
}

/// Panics, as a stand-in for a kill, when a video's frames begin to come.
struct StopAtFrame;

impl Progress for StopAtFrame {
    fn event(&self, event: &ProgressEvent<'_>) {
        assert!(!matches!(event, ProgressEvent::Frame { .. }), "stopped on purpose");
    }
}

#[test]
fn another_build_is_refused_and_noted_when_it_is_allowed() {
    let out = tempfile::tempdir().expect("temp");
    make(&Fake::default(), &of(2), out.path(), 2);
    let before = contents(out.path());
    let error =
        generate(&Fake::default(), &of(3), out.path(), &other_build(false), &SilentProgress).expect_err("refused");
    let message = error.to_string();
    assert!(matches!(error, GenerateError::OtherBuild { .. }) && message.contains("--allow-other-build"), "{message}");
    assert!(message.contains("sources fake") && message.contains("sources other"), "{message}");
    assert!(before == contents(out.path()), "nothing changed");

    // A commit alone makes no other build.
    let same = BuildIdentity { commit: Some("abc".into()), ..build("fake") };
    let same = GenerateOptions { build: same, ..options(2) };
    assert_eq!(
        generate(&Fake::default(), &of(2), out.path(), &same, &SilentProgress).expect("nothing to do").videos,
        0
    );

    generate(&Fake::default(), &of(3), out.path(), &other_build(true), &SilentProgress).expect("goes on");
    let mixed = manifest(out.path());
    assert_eq!(mixed.builds, [build("fake"), build("other")]);
    assert_eq!(mixed.videos.iter().map(|v| v.builds.clone()).collect::<Vec<_>>(), [vec![0], vec![0], vec![1]]);
    assert_eq!(check(out.path()).expect("a dataset").findings, []);
    // Neither of the two goes on with what both made, unless it is allowed to.
    for build in [options(2), other_build(false)] {
        let refused = generate(&Fake::default(), &of(4), out.path(), &build, &SilentProgress);
        assert!(matches!(refused, Err(GenerateError::OtherBuild { .. })));
    }
}

#[test]
fn a_video_that_two_builds_made_names_both() {
    let out = tempfile::tempdir().expect("temp");
    let stopped = std::panic::catch_unwind(|| {
        generate(&Fake::default(), &of(1), out.path(), &options(1), &StopAtFrame).expect("stops")
    });
    assert!(stopped.is_err());
    assert_eq!(manifest(out.path()).videos[0].builds, [0], "noted before the first image");
    generate(&Fake::default(), &of(1), out.path(), &other_build(true), &SilentProgress).expect("goes on");
    assert_eq!(manifest(out.path()).videos[0].builds, [0, 1]);
    // Who made a video that was thrown away is forgotten.
    fs::remove_dir_all(DatasetLayout::new(out.path()).videos()).expect("there");
    generate(&Fake::default(), &of(1), out.path(), &other_build(true), &SilentProgress).expect("begins anew");
    let anew = manifest(out.path());
    assert_eq!((anew.builds, anew.videos[0].builds.as_slice()), (vec![build("other")], &[0][..]));
}

#[test]
fn a_manifest_that_is_lost_is_made_again_of_what_is_there() {
    let out = tempfile::tempdir().expect("temp");
    make(&Fake::default(), &of(2), out.path(), 2);
    generate(&Fake::default(), &of(3), out.path(), &other_build(true), &SilentProgress).expect("goes on");
    let before = contents(out.path());
    fs::remove_file(DatasetLayout::new(out.path()).manifest()).expect("there");
    let refused = generate(&Fake::default(), &of(3), out.path(), &options(2), &SilentProgress);
    assert!(matches!(refused, Err(GenerateError::OtherBuild { .. })), "the videos say who made them");
    generate(&Fake::default(), &of(3), out.path(), &other_build(true), &SilentProgress).expect("nothing to do");
    assert!(before == contents(out.path()));
}

#[test]
fn a_dataset_of_the_format_before_is_read_and_not_gone_on_with() {
    let out = tempfile::tempdir().expect("temp");
    make(&Fake::default(), &of(1), out.path(), 2);
    let path = DatasetLayout::new(out.path()).manifest();
    let text = fs::read_to_string(&path).expect("there").replacen("\"format\": 3", "\"format\": 2", 1);
    fs::write(&path, text).expect("writable");
    fs::remove_file(crate::fake::first_video(out.path()).builds()).expect("there");
    assert_eq!(check(out.path()).expect("is read").findings, []);
    let refused =
        generate(&Fake::default(), &of(1), out.path(), &other_build(true), &SilentProgress).expect_err("refused");
    assert!(matches!(refused, GenerateError::OlderFormat { found: 2, .. }), "{refused}");
}

#[test]
fn a_video_that_does_not_say_who_made_it_is_of_an_unknown_build() {
    let (out, whole) = (tempfile::tempdir().expect("temp"), tempfile::tempdir().expect("temp"));
    make(&Fake::default(), &of(2), out.path(), 2);
    make(&Fake::default(), &of(2), whole.path(), 2);
    let layout = DatasetLayout::new(out.path());
    let path = layout.manifest();
    let videos = manifest(out.path()).videos.into_iter().map(|entry| entry.name).collect::<Vec<_>>();
    fs::remove_file(&path).expect("there");
    fs::remove_file(out.path().join("scenes/0001.json")).expect("there");
    for name in &videos {
        fs::remove_file(layout.video_named(name).builds()).expect("there");
    }
    let refused = generate(&Fake::default(), &of(2), out.path(), &options(2), &SilentProgress).expect_err("refused");
    assert!(matches!(refused, GenerateError::UnknownBuild { .. }), "{refused}");
    let allowed = GenerateOptions { allow_other_build: true, ..options(2) };
    let fake = Fake::default();
    assert_eq!(generate(&fake, &of(2), out.path(), &allowed, &SilentProgress).expect("goes on").videos, 0);
    assert_eq!((fake.bakes.into_inner(), fake.renders.into_inner()), (0, 0));
    let manifest = manifest(out.path());
    assert_eq!(manifest.builds, [BuildIdentity::unknown()]);
    assert!(manifest.videos.iter().all(|video| video.builds == [0]));
    assert_eq!(check(out.path()).expect("a dataset").findings.len(), 2, "both videos lack it");
    fs::copy(DatasetLayout::new(whole.path()).manifest(), &path).expect("copies");
    for card in Card::NAMES {
        fs::copy(whole.path().join(card), out.path().join(card)).expect("copies");
    }
    for name in &videos {
        let (theirs, mine) = (DatasetLayout::new(whole.path()), &layout);
        fs::copy(theirs.video_named(name).builds(), mine.video_named(name).builds()).expect("copies");
    }
    crate::fake::assert_same(out.path(), whole.path());
}

#[test]
fn another_format_is_refused_in_one_line() {
    let out = tempfile::tempdir().expect("temp");
    make(&Fake::default(), &of(1), out.path(), 2);
    let path = DatasetLayout::new(out.path()).manifest();
    fs::write(&path, "{\"format\": 1, \"tool\": {\"name\": \"endless\", \"version\": \"0.1.0\"}}").expect("writable");
    let refused =
        generate(&Fake::default(), &of(1), out.path(), &other_build(true), &SilentProgress).expect_err("refused");
    assert!(refused.to_string().contains("has format 1, this program reads 2 to 3"), "{refused}");
    assert!(matches!(check(out.path()), Err(DatasetError::OtherFormat { found: 1, expected: 3, .. })));
}
