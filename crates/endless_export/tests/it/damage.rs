//! Whatever is wrong with the files of a dataset, an export tells it and nothing panics.

use endless_export::{ExportOptions, Format, export};
use proptest::prelude::*;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// A small dataset of two videos' cameras.
const DATASET: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../endless_fuzz/datasets/three_layers");
const VIDEO: &str = "videos/0000_Town02_cloudy_morning";

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("writable");
    for entry in fs::read_dir(from).expect("readable") {
        let path = entry.expect("readable").path();
        let target = to.join(path.file_name().expect("a name"));
        if path.is_dir() {
            copy(&path, &target);
        } else {
            let _bytes = fs::copy(&path, &target).expect("writable");
        }
    }
}

/// The files of which labels are made.
fn files() -> impl Strategy<Value = PathBuf> {
    let below = |name: &str| PathBuf::from(VIDEO).join(name);
    prop::sample::select(vec![
        PathBuf::from("dataset.json"),
        below("camera_a/objects.jsonl"),
        below("camera_b/objects.jsonl"),
        below("camera_a/camera.json"),
        below("camera_a/instance/000000.png"),
        below("camera_a/rgb/000001.jpg"),
    ])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn damaged_datasets_are_told_of(
        file in files(),
        format in prop::sample::select(Format::ALL),
        place: prop::sample::Index,
        bytes in prop_oneof![
            prop::collection::vec(any::<u8>(), 0..6),
            // Numbers where numbers are.
            "[0-9]{1,12}".prop_map(String::into_bytes),
            "-[0-9]{1,3}".prop_map(String::into_bytes),
        ],
    ) {
        let folder = tempfile::tempdir().expect("temp");
        let out = folder.path().join("out");
        copy(Path::new(DATASET), &out);
        let path = out.join(&file);
        let mut damaged = fs::read(&path).expect("readable");
        let at = place.index(damaged.len());
        damaged.splice(at..(at + bytes.len()).min(damaged.len()), bytes);
        fs::write(&path, damaged).expect("writable");
        let to = folder.path().join("to");
        match export(&out, &ExportOptions::new(format, to.clone())) {
            Ok(report) => prop_assert!(report.frames <= 4 && to.join("endless_export.json").is_file()),
            Err(error) => prop_assert!(!error.to_string().contains('\n') && !to.join("endless_export.json").exists()),
        }
    }
}

#[test]
fn the_whole_dataset_is_exported_where_it_has_what_is_needed() {
    let folder = tempfile::tempdir().expect("temp");
    for &format in Format::ALL {
        let made = export(Path::new(DATASET), &ExportOptions::new(format, folder.path().join(format.name())));
        match format {
            // It is of a simulator that does not tell who is who.
            Format::Market1501 | Format::Veri => {
                assert!(made.expect_err("no actors").to_string().contains("actors.json"));
            }
            _ => assert_eq!(made.expect("whole").frames, 4, "{}", format.name()),
        }
    }
}
