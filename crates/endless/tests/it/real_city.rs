//! The program itself on the built-in city, small: a rainy night, so that lamps, wet mirrors, head lights and rain all
//! take part. Threads, kills and extension do not change a byte.

use crate::contents::contents;
use std::{
    collections::BTreeMap,
    fs,
    path::Path,
    process::{Child, Command, ExitStatus, Stdio},
    time::{Duration, Instant},
};

const RECIPE: &str = "--maps Town02 --weathers rainy --times night --size 97x55 --fps 5 --duration 1 --vehicles 40 \
                      --cameras-per-scene 1 --min-pixels 5 --mp4 rgb,depth,instance";

/// A switch of the video encoder's experiments: it changes the bytes when the codec is built with `std` and looks at it.
const SWITCH: (&str, &str) = ("RUSTY_FAST_INTRA", "0");

fn endless(command: &str, out: &Path, more: &str) -> Command {
    let mut process = Command::new(env!("CARGO_BIN_EXE_endless"));
    process.arg(command).arg(out).args(more.split_whitespace()).stdout(Stdio::null()).stderr(Stdio::null());
    process
}

fn generate(out: &Path, videos: u32, threads: u32) -> Command {
    endless("generate", out, &format!("{RECIPE} --videos {videos} --threads {threads}"))
}

fn succeed(mut command: Command) {
    let output = command.stderr(Stdio::piped()).output().expect("starts");
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
}

/// Names that are missing, added or other, not megabytes of bytes.
fn differences(a: &BTreeMap<String, Vec<u8>>, b: &BTreeMap<String, Vec<u8>>) -> Vec<String> {
    let differs = |name: &&String| a.get(*name) != b.get(*name);
    let names: std::collections::BTreeSet<&String> = a.keys().chain(b.keys()).collect();
    names.into_iter().filter(differs).cloned().collect()
}

/// Waits until so many files lie below the folder's videos, or the process ended.
fn wait_for_files(process: &mut Child, out: &Path, files: usize) -> Option<ExitStatus> {
    let start = Instant::now();
    while start.elapsed() < Duration::from_secs(60) {
        if let Some(status) = process.try_wait().expect("asks") {
            return Some(status);
        }
        if out.join("videos").is_dir() && count_files(&out.join("videos")) >= files {
            return None;
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    panic!("{files} files never came");
}

/// Files come and go while they are counted.
fn count_files(folder: &Path) -> usize {
    let Ok(entries) = fs::read_dir(folder) else { return 0 };
    let count = |path: std::path::PathBuf| if path.is_dir() { count_files(&path) } else { 1 };
    entries.flatten().map(|entry| count(entry.path())).sum()
}

#[test]
fn threads_environment_kills_and_extension_do_not_change_a_byte() {
    let folder = tempfile::tempdir().expect("temp");
    let [one, two, killed] = ["one", "two", "killed"].map(|name| folder.path().join(name));
    succeed(generate(&one, 1, 1));
    let mut with_switch = generate(&two, 1, 2);
    with_switch.env(SWITCH.0, SWITCH.1);
    succeed(with_switch);
    let whole = contents(&one);
    assert_eq!(differences(&whole, &contents(&two)), [""; 0], "one thread and two");
    let boxes = &whole["videos/0000_Town02_rainy_night/camera_a/objects.jsonl"];
    assert_eq!(boxes.iter().filter(|b| **b == b'\n').count(), 5, "one line a frame");

    // Before anything is recorded, in the middle of the frames, and with the last ones.
    let mut interrupted = 0;
    for files in [1, 6, 14] {
        let mut process = generate(&killed, 1, 2).spawn().expect("starts");
        interrupted += u32::from(wait_for_files(&mut process, &killed, files).is_none());
        process.kill().expect("killed or ended");
        process.wait().expect("waits");
    }
    assert!(interrupted >= 2, "only {interrupted} of 3 kills came in time");
    succeed(generate(&killed, 1, 2));
    assert_eq!(differences(&whole, &contents(&killed)), [""; 0], "killed three times and resumed");

    succeed(generate(&killed, 2, 2));
    let extended = contents(&killed);
    let changed: Vec<&String> =
        whole.iter().filter(|(name, bytes)| extended.get(*name) != Some(bytes)).map(|(name, _)| name).collect();
    assert_eq!(changed, ["README.md", "croissant.json", "dataset.json"], "a second video leaves the first as it is");
    assert!(extended.contains_key("videos/0001_Town02_rainy_night/scene.json"));
    succeed(endless("check", &killed, ""));
}
