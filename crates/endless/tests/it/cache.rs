//! `--cache` as its users run it.

use crate::program::succeed;
use std::fs;

#[test]
fn a_damaged_file_of_the_cache_is_told_of_and_made_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let make = |out: &str| {
        let recipe = "--videos 1 --maps Town02 --size 64x36 --fps 5 --duration 0.2 --vehicles 3 --pedestrians 3";
        succeed(folder.path(), &format!("generate {out} {recipe} --memory 10MB --cache kept")).1
    };
    assert!(!make("first").contains("damaged"));
    let kept: Vec<_> =
        fs::read_dir(folder.path().join("kept")).expect("a folder").map(|e| e.expect("a file")).collect();
    assert_eq!(kept.len(), 2, "a file a camera");
    let whole = fs::read(kept[0].path()).expect("readable");
    fs::write(kept[0].path(), &whole[1..]).expect("writable");
    let said = make("second");
    assert_eq!(said.lines().filter(|line| line.contains("is damaged: it is made again")).count(), 1, "{said}");
    assert!(fs::read(kept[0].path()).expect("readable") == whole);
    assert!(!make("third").contains("damaged"));
    let picture = |out: &str| {
        let scenes = fs::read_dir(folder.path().join(out).join("videos")).expect("videos");
        let video = scenes.map(|e| e.expect("a video").path()).next().expect("a video");
        fs::read(video.join("camera_a/rgb/000000.png")).expect("a picture")
    };
    assert!(picture("first") == picture("second") && picture("second") == picture("third"));
}
