//! `--shard`: processes that know nothing of one another make one dataset.

use crate::{
    contents::contents,
    program::{endless, refused, succeed},
};
use std::{
    fs,
    path::Path,
    process::{Child, Command, Stdio},
    time::{Duration, Instant},
};

const RECIPE: &str = "--videos 6 --maps Town01,Town02 --size 64x36 --fps 5 --duration 1 --vehicles 3 --pedestrians 3 \
                      --cameras-per-scene 1 --threads 1";

fn start(folder: &Path, shard: &str) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_endless"));
    command.args(["generate", "out", "--shard", shard]).args(RECIPE.split_whitespace());
    command.current_dir(folder).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("starts")
}

fn assert_same(a: &Path, b: &Path) {
    let (a, b) = (contents(a), contents(b));
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>(), "the same files");
    let differ: Vec<&String> = a.keys().filter(|name| a[*name] != b[*name]).collect();
    assert!(differ.is_empty(), "these files differ: {differ:?}");
}

/// Waits until a video is begun whose images are not all there, and none is complete.
fn wait_for_begin(out: &Path) {
    let begin = Instant::now();
    let begun = || fs::read_dir(out.join("videos")).is_ok_and(|mut videos| videos.next().is_some());
    while !begun() {
        assert!(begin.elapsed() < Duration::from_secs(300), "nothing begins");
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn eight_shards_at_once_with_one_killed_make_the_bytes_of_one_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let (out, whole) = (folder.path().join("out"), folder.path().join("whole"));
    // The first one alone, so that it is killed at work.
    let mut killed = start(folder.path(), "1/8");
    wait_for_begin(&out);
    killed.kill().expect("at work");
    assert!(!killed.wait().expect("waits").success(), "killed before its end");
    let others: Vec<Child> = (2..=8).map(|number| start(folder.path(), &format!("{number}/8"))).collect();
    for other in others {
        let ended = other.wait_with_output().expect("waits");
        assert!(ended.status.success(), "{}", String::from_utf8_lossy(&ended.stderr));
    }
    let checked = endless(folder.path(), "check out --shards 8");
    let said = String::from_utf8_lossy(&checked.stdout).into_owned();
    assert!(!checked.status.success() && said.contains("shard 1/8 still has to make 000"), "{said}");
    assert_eq!(said.matches("still has to make").count(), 1, "{said}");

    let again = start(folder.path(), "1/8").wait_with_output().expect("waits");
    assert!(again.status.success(), "{}", String::from_utf8_lossy(&again.stderr));
    succeed(folder.path(), "check out --shards 8");
    succeed(folder.path(), &format!("generate whole {RECIPE}"));
    assert_same(&out, &whole);

    // What is complete is left alone by whoever comes, in whatever parts.
    for shard in ["", "--shard 2/3", "--shard 1/8"] {
        let (_, said) = succeed(folder.path(), &format!("generate out {RECIPE} {shard}"));
        assert!(said.contains("nothing to do"), "{said}");
    }
    let (_, said) = succeed(folder.path(), &format!("generate out {RECIPE} --shard 8/8"));
    assert!(said.contains("shard 8/8 has no videos"), "{said}");
    assert_same(&out, &whole);
}

#[test]
fn what_is_no_shard_is_told_in_a_line() {
    let folder = tempfile::tempdir().expect("a folder");
    for shard in ["0/4", "5/4", "4", "x"] {
        let said = refused(folder.path(), &format!("generate out --shard {shard}"));
        assert!(said.contains("give I/N, such as 3/8"), "{said}");
    }
    let (order, _) = succeed(folder.path(), &format!("generate out {RECIPE} --plan-only"));
    let parts: String = (1..=4)
        .map(|n| succeed(folder.path(), &format!("generate out {RECIPE} --plan-only --shard {n}/4")).0)
        .collect();
    assert_eq!(order, parts);
}
