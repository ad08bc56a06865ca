//! `endless stats` and `endless compare` on a dataset that the program made.

use crate::program::{endless, refused, succeed};
use std::{
    fs,
    path::{Path, PathBuf},
};

/// A video of one camera and two frames, fifteen boxes.
fn dataset() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../endless_fuzz/datasets/all_layers")
}

/// A folder with that dataset as `out`, and a COCO file.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("temp");
    copy(&dataset(), &folder.path().join("out"));
    let coco = r#"{"images": [{"id": 1, "width": 640, "height": 480}],
        "annotations": [{"image_id": 1, "category_id": 1, "bbox": [10, 10, 120, 200], "area": 9000, "iscrowd": 0}],
        "categories": [{"id": 1, "name": "person"}]}"#;
    fs::write(folder.path().join("coco.json"), coco).expect("writable");
    folder
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("writable");
    for entry in fs::read_dir(from).expect("there") {
        let entry = entry.expect("readable");
        let to = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &to);
        } else if entry.path().extension().is_some_and(|extension| extension != "png") {
            fs::copy(entry.path(), to).expect("writable");
        }
    }
}

#[test]
fn text_json_and_page_are_written() {
    let folder = folder();
    let (text, _) = succeed(folder.path(), "stats out");
    insta::assert_snapshot!(text);
    let (nothing, _) = succeed(folder.path(), "stats out --json new/stats.json --html new/stats.html");
    assert!(nothing.is_empty(), "text is printed where no file is asked for");
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("written");
    assert!(read("new/stats.json").contains("\"camera_frames\": 2") && read("new/stats.html").ends_with("</html>\n"));
    // The same with any number of threads.
    for threads in [1, 3] {
        succeed(folder.path(), &format!("stats out --threads {threads} --json {threads}.json --html {threads}.html"));
        assert_eq!(read(&format!("{threads}.json")), read("new/stats.json"));
        assert_eq!(read(&format!("{threads}.html")), read("new/stats.html"));
    }
    let (twice, _) = succeed(folder.path(), "stats out out");
    assert!(twice.contains("2 videos, 4 camera frames, 30 boxes"), "{twice}");
}

#[test]
fn datasets_are_compared_with_one_another_and_with_coco() {
    let folder = folder();
    let (same, _) = succeed(folder.path(), "compare out out");
    assert!(!same.contains("What differs"), "{same}");
    let (real, _) = succeed(folder.path(), "compare out --coco coco.json");
    assert!(real.contains("B has no car boxes") || real.contains("A has no"), "{real}");
    fs::write(folder.path().join("classes.toml"), "person = \"rider\"\n").expect("writable");
    succeed(folder.path(), "compare out out --coco coco.json --coco-classes classes.toml --json c.json --html c.html");
    let json = fs::read_to_string(folder.path().join("c.json")).expect("written");
    assert!(json.contains("\"letter\": \"C\""));
}

#[test]
fn what_cannot_be_counted_is_refused() {
    let folder = folder();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("writable");
    write("dear.json", "dear");
    write("classes.toml", "person = \"human\"\n");
    write("broken.toml", "person = = 3\n");
    fs::create_dir(folder.path().join("empty")).expect("writable");
    let commands = [
        "stats",
        "stats nowhere",
        "stats empty",
        "stats coco.json",
        "stats out --stride 0",
        "stats out --json dear.json",
        "stats out --json empty",
        "stats out --json new.json --html new.json",
        "stats out --json dear.json/below.json",
        "compare out",
        "compare out nowhere",
        "compare out --coco none.json",
        "compare out --coco dear.json",
        "compare out out --coco-classes classes.toml",
        "compare out --coco coco.json --coco-classes classes.toml",
        "compare out --coco coco.json --coco-classes broken.toml",
        "compare out --coco coco.json --coco-classes none.toml",
        "compare out out --html dear.json",
    ];
    let said = commands.map(|args| {
        let code = endless(folder.path(), args).status.code().expect("no signal");
        format!("endless {args}\n  {code}: {}", refused(folder.path(), args))
    });
    insta::assert_snapshot!(said.concat());
    assert_eq!(fs::read_to_string(folder.path().join("dear.json")).expect("there"), "dear");
    assert!(!folder.path().join("new.json").exists());
    succeed(folder.path(), "stats out --json dear.json --force");
    assert!(fs::read_to_string(folder.path().join("dear.json")).expect("there").starts_with('{'));
}
