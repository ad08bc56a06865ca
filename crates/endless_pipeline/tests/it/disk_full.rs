//! The disk runs full in the middle: said in one line, nothing half-written stays, and the run goes on when there is room.
//!
//! Needs the right to mount a small file system; skipped with a message where there is none.

use crate::fake::{Fake, assert_same, contents, draft, make, options, recipe};
use endless_dataset::{Card, Recipe, RecipeDraft};
use endless_pipeline::{GenerateError, Progress, ProgressEvent, generate};
use std::{
    fs::{self, File},
    io::{ErrorKind, Write},
    path::{Path, PathBuf},
    process::Command,
    sync::atomic::{AtomicU32, Ordering},
};

/// A file system in memory, gone when dropped.
struct SmallDisk {
    folder: tempfile::TempDir,
}

impl SmallDisk {
    fn mount(size: &str) -> Option<Self> {
        let folder = tempfile::tempdir().expect("temp");
        let mounted = run("mount", &["-t", "tmpfs", "-o", size, "tmpfs"], folder.path());
        mounted.then_some(Self { folder })
    }

    fn enlarge(&self, size: &str) {
        assert!(run("mount", &["-o", &format!("remount,{size}")], self.folder.path()));
    }

    fn out(&self) -> PathBuf {
        self.folder.path().join("out")
    }
}

impl Drop for SmallDisk {
    fn drop(&mut self) {
        run("umount", &[], self.folder.path());
    }
}

fn run(program: &str, args: &[&str], folder: &Path) -> bool {
    Command::new(program).args(args).arg(folder).output().is_ok_and(|o| o.status.success())
}

/// Fills the disk after so many events.
struct FillAfter<'a> {
    disk: &'a SmallDisk,
    events: u32,
    seen: AtomicU32,
}

impl Progress for FillAfter<'_> {
    fn event(&self, _event: &ProgressEvent<'_>) {
        if self.seen.fetch_add(1, Ordering::SeqCst) == self.events {
            let mut ballast = File::create(self.disk.folder.path().join("ballast")).expect("creatable");
            let full = loop {
                if let Err(error) = ballast.write_all(&[7; 4096]) {
                    break error;
                }
            };
            assert_eq!(full.kind(), ErrorKind::StorageFull);
        }
    }
}

#[test]
fn a_full_disk_stops_the_run_and_room_lets_it_go_on() {
    let recipe: Recipe = recipe(RecipeDraft {
        videos: Some(2),
        duration: Some(1.0),
        mp4: Some(["rgb", "instance"].map(String::from).to_vec()),
        ..draft()
    });
    let whole = tempfile::tempdir().expect("temp");
    make(&Fake::default(), &recipe, whole.path(), 2);
    // At the start, while the first video is recorded, just before it is completed, in the second.
    for events in [0, 4, 12, 13, 20] {
        let Some(disk) = SmallDisk::mount("size=3m") else {
            println!("skipped: no right to mount a file system");
            return;
        };
        let fill = FillAfter { disk: &disk, events, seen: AtomicU32::new(0) };
        let error = generate(&Fake::default(), &recipe, &disk.out(), &options(2), &fill).expect_err("the disk is full");
        let message = error.to_string();
        assert!(matches!(error, GenerateError::Dataset(_)), "{error:?}");
        assert!(message.starts_with("the disk is full: make room and run the same command again"), "{message}");
        assert_eq!(message.lines().count(), 1, "{message}");
        let left: Vec<String> = contents(&disk.out()).into_keys().filter(|name| is_temporary(name)).collect();
        assert!(left.is_empty(), "left behind after {events} events: {left:?}");
        // What bears its name is whole.
        let reference = contents(whole.path());
        let follows_videos = |name: &str| name == "dataset.json" || Card::NAMES.contains(&name);
        for (name, bytes) in contents(&disk.out()).iter().filter(|(name, _)| !follows_videos(name)) {
            assert!(reference[name] == *bytes, "{name} is not whole after {events} events");
        }
        disk.enlarge("size=64m");
        make(&Fake::default(), &recipe, &disk.out(), 2);
        assert_same(&disk.out(), whole.path());
        fs::remove_file(disk.folder.path().join("ballast")).expect("was written");
    }
}

fn is_temporary(name: &str) -> bool {
    Path::new(name).file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'))
}
