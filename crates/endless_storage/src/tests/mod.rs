//! A dataset in a bucket, whose run is stopped at any request.

mod failing_store;

use crate::{
    bucket::Bucket,
    dataset::RemoteDataset,
    work_folder::{SCENE, WorkFolder},
};
use endless_dataset::{DatasetLayout, write_atomic};
use endless_pipeline::{DatasetStore, StoreError, StoredFiles};
use failing_store::FailingStore;
use futures_util::TryStreamExt;
use object_store::{ObjectStore, ObjectStoreExt, memory::InMemory};
use proptest::prelude::*;
use std::{
    collections::BTreeMap,
    fs,
    path::Path,
    sync::{Arc, atomic::Ordering},
};

const VIDEOS: [&str; 3] = ["0000_a", "0001_a", "0002_b"];

/// Files of a video, but for the last.
fn files(video: &str) -> Vec<(String, Vec<u8>)> {
    let frame = |i| (format!("camera_a/rgb/{i:06}.png"), format!("{video} {i}").into_bytes());
    let others = ["builds.json", "actors.json"].map(|name| (name.to_owned(), name.as_bytes().to_vec()));
    others.into_iter().chain((0..5).map(frame)).collect()
}

/// What `generate` does, with files of a few bytes. How many videos it made, and how many requests it took.
fn run(bucket: &Arc<InMemory>, answers: usize, work: &Path) -> (Result<usize, StoreError>, usize) {
    let (store, asked) = FailingStore::new(bucket, answers);
    let store = RemoteDataset::of(Bucket::of(Arc::new(store)), WorkFolder::at(work)).expect("threads");
    let made = make(&store, &store.folder());
    (made, asked.load(Ordering::SeqCst))
}

fn make(store: &RemoteDataset, layout: &DatasetLayout) -> Result<usize, StoreError> {
    store.open(layout)?;
    fs::create_dir_all(layout.scenes()).expect("writable");
    for number in 0..VIDEOS.len() as u32 {
        write_atomic(&layout.scene(number), b"{}")?;
    }
    store.put_scenes(layout)?;
    let mut made = 0;
    for name in VIDEOS {
        let video = layout.video_named(name);
        let wanted: StoredFiles = files(name).into_iter().map(|(file, _)| file).chain([SCENE.to_owned()]).collect();
        if video.scene().is_file() && store.files(&video)? == wanted {
            continue;
        }
        for (file, bytes) in files(name) {
            let path = video.folder().join(file);
            fs::create_dir_all(path.parent().expect("a folder")).expect("writable");
            write_atomic(&path, &bytes)?;
        }
        write_atomic(&video.scene(), name.as_bytes())?;
        store.put_video(&video)?;
        made += 1;
    }
    store.wait()?;
    store.refresh(layout)?;
    let complete: Vec<&str> = VIDEOS.into_iter().filter(|name| layout.video_named(name).scene().is_file()).collect();
    write_atomic(&layout.manifest(), complete.join(",").as_bytes())?;
    store.put_index(layout)?;
    store.close(layout)?;
    Ok(made)
}

/// All objects with their bytes.
fn objects(bucket: &Arc<InMemory>) -> BTreeMap<String, Vec<u8>> {
    let runtime = crate::dataset::runtime().expect("threads");
    runtime.block_on(async {
        let mut all = BTreeMap::new();
        for object in bucket.list(None).try_collect::<Vec<_>>().await.expect("in memory") {
            let bytes = bucket.get(&object.location).await.expect("there").bytes().await.expect("in memory");
            all.insert(object.location.to_string(), bytes.to_vec());
        }
        all
    })
}

fn remove(bucket: &Arc<InMemory>, name: &str) {
    let runtime = crate::dataset::runtime().expect("threads");
    runtime.block_on(bucket.delete(&name.into())).expect("in memory");
}

/// A whole run, and how many requests it takes.
fn whole() -> (BTreeMap<String, Vec<u8>>, usize) {
    let (bucket, work) = (Arc::new(InMemory::new()), tempfile::tempdir().expect("temp"));
    let (made, asked) = run(&bucket, usize::MAX, work.path());
    assert_eq!(made.expect("answers"), 3);
    let left = fs::read_dir(work.path()).map_or(0, Iterator::count);
    assert_eq!(left, 0, "a run that is done leaves nothing in its folder of work");
    (objects(&bucket), asked)
}

#[test]
fn a_run_that_fails_at_any_request_goes_on_to_the_same_objects() {
    let (wanted, requests) = whole();
    assert_eq!(wanted.len(), 1 + 3 + 3 * 8);
    assert_eq!(wanted["dataset.json"], VIDEOS.join(",").as_bytes());
    for answers in 0..requests {
        let (bucket, work) = (Arc::new(InMemory::new()), tempfile::tempdir().expect("temp"));
        let (made, _) = run(&bucket, answers, work.path());
        let refused = made.expect_err("no answer").to_string();
        assert!(refused.contains("the same command goes on") && !refused.contains('\n'), "{refused}");
        assert_scene_is_last(&objects(&bucket));
        run(&bucket, usize::MAX, work.path()).0.expect("answers");
        assert_eq!(objects(&bucket), wanted, "after {answers} answers");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn so_does_one_that_fails_again_and_again_also_on_other_machines(
        stops in prop::collection::vec((0..60_usize, prop::bool::ANY), 1..6),
    ) {
        let bucket = Arc::new(InMemory::new());
        let mut work = tempfile::tempdir().expect("temp");
        for (answers, other_machine) in stops {
            if other_machine {
                work = tempfile::tempdir().expect("temp");
            }
            let _ = run(&bucket, answers, work.path());
            assert_scene_is_last(&objects(&bucket));
        }
        run(&bucket, usize::MAX, work.path()).0.expect("answers");
        prop_assert_eq!(objects(&bucket), whole().0);
    }
}

/// Where `scene.json` is, all other files are.
fn assert_scene_is_last(objects: &BTreeMap<String, Vec<u8>>) {
    for name in VIDEOS.iter().filter(|name| objects.contains_key(&format!("videos/{name}/{SCENE}"))) {
        assert!(files(name).iter().all(|(file, _)| objects.contains_key(&format!("videos/{name}/{file}"))));
    }
}

#[test]
fn what_is_complete_is_not_made_again_and_what_was_deleted_is() {
    let (wanted, _) = whole();
    let (bucket, work) = (Arc::new(InMemory::new()), tempfile::tempdir().expect("temp"));
    let again = |made| assert_eq!(run(&bucket, usize::MAX, work.path()).0.expect("answers"), made);
    again(3);
    again(0);
    remove(&bucket, "videos/0001_a/camera_a/rgb/000003.png");
    again(1);
    remove(&bucket, "videos/0002_b/scene.json");
    again(1);
    assert_eq!(objects(&bucket), wanted);
}

#[test]
fn a_bucket_that_is_emptied_in_the_middle_is_filled_again() {
    let (wanted, requests) = whole();
    for answers in (0..requests).step_by(3) {
        let (bucket, work) = (Arc::new(InMemory::new()), tempfile::tempdir().expect("temp"));
        let _ = run(&bucket, answers, work.path());
        for name in objects(&bucket).into_keys() {
            remove(&bucket, &name);
        }
        // A video of which a part was uploaded is told of, and made again.
        if let Err(error) = run(&bucket, usize::MAX, work.path()).0 {
            assert!(error.to_string().contains("makes the video again"), "{error}");
            run(&bucket, usize::MAX, work.path()).0.expect("answers");
        }
        assert_eq!(objects(&bucket), wanted, "after {answers} answers");
    }
}

#[test]
fn large_files_go_in_pieces() {
    let (bucket, work) = (Arc::new(InMemory::new()), tempfile::tempdir().expect("temp"));
    let bytes: Vec<u8> = (0..20_000_000_u32).map(|i| (i >> 7) as u8).collect();
    let path = work.path().join("rgb.mp4");
    fs::write(&path, &bytes).expect("writable");
    let runtime = crate::dataset::runtime().expect("threads");
    runtime.block_on(Bucket::of(bucket.clone()).put_file("a/rgb.mp4", &path)).expect("in memory");
    assert!(objects(&bucket)["a/rgb.mp4"] == bytes);
}
