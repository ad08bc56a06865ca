//! `--threads` bounds all work, whatever is asked for.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

/// The most threads that the program has at once, its main one included.
fn most_threads(folder: &Path, args: &str) -> usize {
    let mut command = Command::new(env!("CARGO_BIN_EXE_endless"));
    command.args(args.split_whitespace()).current_dir(folder).env("ENDLESS_MAPS", folder.join("maps"));
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("starts");
    let tasks = format!("/proc/{}/task", child.id());
    let mut most = 0;
    let status = loop {
        most = most.max(std::fs::read_dir(&tasks).map_or(0, Iterator::count));
        match child.try_wait().expect("a child") {
            Some(status) => break status,
            None => std::thread::sleep(Duration::from_millis(5)),
        }
    };
    assert!(status.success(), "endless {args}");
    most
}

#[test]
#[cfg_attr(not(target_os = "linux"), ignore = "counts the threads that Linux tells of")]
fn no_command_has_more_threads_than_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let dataset = concat!(env!("CARGO_MANIFEST_DIR"), "/../endless_fuzz/datasets/three_layers");
    for command in [
        "maps list Town02".to_owned(),
        "assets preview bench --out bench.png".to_owned(),
        "generate out --maps Town02 --plan-only".to_owned(),
        format!("check {dataset}"),
    ] {
        let most = most_threads(folder.path(), &format!("{command} --threads 1"));
        assert!(most <= 2, "endless {command} --threads 1 has {most}, of which the main one waits");
    }
}
