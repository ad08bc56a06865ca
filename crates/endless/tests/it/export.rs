//! `endless export`: every format is whole, the same each time and on any number of threads, and resumed to the same bytes.

use crate::program::{endless, refused, succeed};
use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

/// Two videos of one camera, in `out`.
fn dataset() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("temp");
    let recipe =
        "--videos 2 --maps Town02 --cameras-per-scene 1 --size 97x55 --fps 4 --duration 0.5 --min-pixels 5 --mp4 rgb";
    succeed(folder.path(), &format!("generate out {recipe}"));
    folder
}

fn formats(folder: &Path) -> Vec<String> {
    let (list, _) = succeed(folder, "export --list");
    list.lines().filter_map(|line| line.split_whitespace().next()).map(String::from).collect()
}

/// What lies below a folder: the bytes of files, and where links lead.
fn tree(root: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let (mut found, mut folders) = (BTreeMap::new(), vec![root.to_owned()]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("readable") {
            let path = entry.expect("readable").path();
            let below = path.strip_prefix(root).expect("below").to_owned();
            if path.is_symlink() {
                assert!(path.is_file(), "{} leads nowhere", path.display());
                found.insert(below, fs::read_link(&path).expect("a link").to_string_lossy().into_owned().into_bytes());
            } else if path.is_dir() {
                folders.push(path);
            } else {
                found.insert(below, fs::read(&path).expect("readable"));
            }
        }
    }
    found
}

#[test]
fn every_format_is_the_same_each_time_and_resumed() {
    let folder = dataset();
    let at = folder.path();
    let last =
        fs::read_dir(at.join("out/videos")).expect("there").map(|e| e.expect("readable").path()).max().expect("two");
    let labels = last.join("camera_a/objects.jsonl");
    let whole = fs::read(&labels).expect("labels");
    for format in formats(at) {
        let export = |to: &str, more: &str| succeed(at, &format!("export out --format {format} --to {to} {more}"));
        let (_, said) = export(&format!("a/{format}"), "--threads 1");
        assert!(said.starts_with(&format!("done: {format} of 4 frames")), "{said}");
        let made = tree(&at.join(format!("a/{format}")));
        assert!(made.len() > 2 || format == "market1501", "{format}: {:?}", made.keys());
        assert!(made.keys().all(|path| !path.starts_with(".endless_export")), "{format}");
        let (_, said) = export(&format!("a/{format}"), "");
        assert!(said.starts_with("was complete already: "), "{said}");
        // The second video's labels cannot be read: the first one stays, and all is well once they can.
        fs::write(&labels, "{\n").expect("writable");
        let broken = refused(at, &format!("export out --format {format} --to b/{format} --threads 2"));
        assert!(broken.contains("objects.jsonl"), "{broken}");
        fs::write(&labels, &whole).expect("writable");
        let done = at.join(format!("b/{format}/.endless_export/done"));
        assert_eq!(fs::read_dir(&done).expect("work").count(), 1, "{format}");
        export(&format!("b/{format}"), "--threads 2");
        let again = tree(&at.join(format!("b/{format}")));
        assert_eq!(again.keys().collect::<Vec<_>>(), made.keys().collect::<Vec<_>>(), "{format}");
        let differing = made.iter().find(|(path, bytes)| again[*path] != **bytes);
        assert_eq!(differing.map(|(path, _)| path), None, "{format}");
    }
}

#[test]
fn what_cannot_be_exported_is_told_in_a_line() {
    let folder = dataset();
    let at = folder.path();
    let said = |args: &str| refused(at, &format!("export {args}"));
    fs::write(at.join("tram.toml"), "[[classes]]\nname = \"rail\"\nfrom = [\"tram\"]\n").expect("writable");
    fs::write(at.join("people.toml"), "[[classes]]\nname = \"people\"\nfrom = [\"pedestrian\"]\n").expect("writable");
    fs::create_dir(at.join("full")).expect("writable");
    fs::write(at.join("full/thesis.tex"), "x").expect("writable");
    let lines = [
        "out --format vhs --to x",
        "out --format coco",
        "--format coco --to x",
        "nowhere --format coco --to x",
        "out --format coco --to x --split train=0.8,val=0.1",
        "out --format coco --to x --split train",
        "out --format coco --to x --split a=0.4,b=0.3,c=0.3",
        "out --format coco --to x --split a=0.5,b=0.5 --by map",
        "out --format coco --to x --by weather",
        "out --format coco --to x --classes tram.toml",
        "out --format coco --to x --classes missing.toml",
        "out --format coco --to x --min-visibility 2",
        "out --format coco --to x --stride 0",
        "out --format coco --to x --copy --link",
        "out --format coco --to full",
    ];
    let text: String = lines.iter().map(|args| format!("endless export {args}\n  {}", said(args))).collect();
    insta::assert_snapshot!(text);
    assert!(!at.join("x").exists(), "nothing is written");
    assert_eq!(fs::read_dir(at.join("full")).expect("there").count(), 1);
    // The same folder for something else.
    succeed(at, "export out --format yolo --to y --classes people.toml");
    assert!(said("out --format yolo --to y").contains("holds an export of something else"));
    // A layer that is not stored, and a lens without a matrix.
    let recipe = "--videos 1 --maps Town02 --cameras-per-scene 1 --size 97x55 --fps 2 --duration 0.5 --layers rgb";
    succeed(at, &format!("generate pictures {recipe}"));
    let line = said("pictures --format coco --to z");
    assert!(line.contains("needs the layer instance") && line.contains("--layers rgb,instance"), "{line}");
    let video = fs::read_dir(at.join("pictures/videos")).expect("there").next().expect("one").expect("readable").path();
    let camera = video.join("camera_a/camera.json");
    let record = fs::read_to_string(&camera).expect("a record").replace("\"pinhole\"", "\"equirectangular\"");
    fs::write(&camera, record).expect("writable");
    assert!(said("pictures --format kitti_object --to z").contains("its lens is equirectangular"));
    assert!(!at.join("z").exists());
}

#[test]
fn copies_are_files_and_strides_skip_frames() {
    let folder = dataset();
    let at = folder.path();
    let (_, said) = succeed(at, "export out --format yolo --to copied --copy --stride 2 --split all=1");
    assert_eq!(said.trim_end(), "done: yolo of 2 frames in copied (all 2 videos, 2 frames)");
    let pictures = fs::read_dir(at.join("copied/images/all")).expect("there").map(|e| e.expect("readable").path());
    let pictures: Vec<PathBuf> = pictures.collect();
    assert_eq!(pictures.len(), 2);
    assert!(pictures.iter().all(|path| path.is_file() && !path.is_symlink()));
    assert!(pictures.iter().all(|path| path.to_string_lossy().ends_with("_000000.png")));
}

#[test]
fn a_target_that_another_run_writes_is_left_alone() {
    let folder = dataset();
    let at = folder.path();
    fs::create_dir_all(at.join("x/.endless_export")).expect("writable");
    let lock = fs::File::create(at.join("x/.endless_export/lock")).expect("writable");
    lock.lock().expect("ours");
    assert!(refused(at, "export out --format mot --to x").contains("another run"));
    drop(lock);
    assert!(endless(at, "export out --format mot --to x").status.success());
}
