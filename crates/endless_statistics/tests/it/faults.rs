//! What is no dataset, or a damaged one, is refused in a line that names the file.

use crate::hand_made::{dataset, write};
use endless_statistics::{CocoClasses, DatasetStatistics, GatherOptions};
use proptest::{prelude::*, sample::Index};
use std::{
    fs,
    path::{Path, PathBuf},
};

fn refused(root: &Path) -> String {
    let counted = DatasetStatistics::of_dataset(root, &GatherOptions::default());
    let message = counted.expect_err("it is damaged").to_string();
    assert_eq!(message.lines().count(), 1, "{message}");
    message
}

#[test]
fn damaged_datasets_are_refused_with_the_place() {
    type Damage = fn(&Path);
    let damages: [(&str, Damage); 9] = [
        ("no dataset", |root| fs::remove_file(root.join("dataset.json")).expect("there")),
        ("no video of it is complete", |root| {
            let text = fs::read_to_string(root.join("dataset.json")).expect("there");
            write(&root.join("dataset.json"), &text.replace("\"complete\"", "\"planned\""));
        }),
        ("line 2:", |root| {
            let path = root.join("videos/first/camera_a/objects.jsonl");
            let text = fs::read_to_string(&path).expect("there");
            write(&path, &text.replacen("\"frame\":1", "\"frame\":-1", 1));
        }),
        ("without area", |root| {
            let path = root.join("videos/second/camera_a/objects.jsonl");
            let text = fs::read_to_string(&path).expect("there");
            write(&path, &text.replace("[40,20,20,10]", "[40,20,0,10]"));
        }),
        ("cannot read", |root| fs::remove_file(root.join("videos/first/camera_b/objects.jsonl")).expect("there")),
        ("no size", |root| {
            write(&root.join("videos/first/camera_b/camera.json"), r#"{"size":{"width":0,"height":50},"fps":10.0}"#);
        }),
        ("frames a second", |root| {
            let path = root.join("videos/first/scene.json");
            let text = fs::read_to_string(&path).expect("there");
            write(&path, &text.replace("10.0", "0.0"));
        }),
        ("frames.jsonl", |root| write(&root.join("videos/first/frames.jsonl"), "{\"frame\":0}\n")),
        ("actors.json", |root| write(&root.join("videos/first/actors.json"), "[{\"id\":1,\"reid\":\"xyz\"}]")),
    ];
    for (said, damage) in damages {
        let folder = dataset();
        damage(folder.path());
        let message = refused(folder.path());
        assert!(message.contains(said), "{said}: {message}");
    }
    assert!(refused(Path::new("nowhere")).contains("no dataset"));
}

#[test]
fn without_actors_and_frames_the_rest_is_counted() {
    // As of simulators that know neither their objects nor their scenes.
    let folder = dataset();
    for video in ["first", "second"] {
        for file in ["actors.json", "frames.jsonl"] {
            fs::remove_file(folder.path().join("videos").join(video).join(file)).expect("there");
        }
    }
    let counted = DatasetStatistics::of_dataset(folder.path(), &GatherOptions::default()).expect("a dataset");
    let world = counted.world.as_ref().expect("a dataset of ours");
    assert_eq!((counted.totals.boxes, world.people.all.objects, world.looks.vehicles.objects()), (13, 0, 0));
    assert!(endless_statistics::Report::of_dataset(&counted).text().contains("== Tracks =="));
}

#[test]
fn what_is_no_coco_file_is_refused_with_its_name() {
    let folder = tempfile::tempdir().expect("temp");
    let path = folder.path().join("labels.json");
    for text in ["", "[]", "{\"images\": 3}", "{\"images\": [], \"annotations\": []}"] {
        write(&path, text);
        let message = DatasetStatistics::of_coco(&path, &CocoClasses::default()).expect_err("no COCO file").to_string();
        assert!(message.contains("COCO form") && message.contains("labels.json"), "{message}");
        assert_eq!(message.lines().count(), 1);
    }
    assert!(DatasetStatistics::of_coco(folder.path(), &CocoClasses::default()).is_err());
}

/// All files of a dataset, by path.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = Vec::new();
    for entry in fs::read_dir(folder).expect("there") {
        let path = entry.expect("readable").path();
        if path.is_dir() { files.extend(files_below(&path)) } else { files.push(path) }
    }
    files.sort();
    files
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    #[test]
    fn no_damage_makes_it_panic(file in any::<Index>(), place in any::<Index>(), by in "(-|9999999999|1e300|null|\\[|\"|)", take in 0..4usize) {
        let folder = dataset();
        let path = file.get(&files_below(folder.path())).clone();
        let mut bytes = fs::read(&path).expect("there");
        let at = place.index(bytes.len());
        let end = (at + take).min(bytes.len());
        bytes.splice(at..end, by.bytes());
        fs::write(&path, bytes).expect("writable");
        match DatasetStatistics::of_dataset(folder.path(), &GatherOptions::default()) {
            Ok(counted) => {
                let report = endless_statistics::Report::of_dataset(&counted);
                prop_assert!(serde_json::to_string(&counted).is_ok() && !report.text().is_empty() && !report.page().is_empty());
            }
            Err(error) => prop_assert_eq!(error.to_string().lines().count(), 1),
        }
    }
}
