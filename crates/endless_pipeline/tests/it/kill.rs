//! Killed at random instants and resumed each time: ends byte-identical to a run that was not killed.

use crate::fake::{Fake, assert_same, draft, make, recipe};
use endless_dataset::{Layer, RecipeDraft};
use endless_world::Stream;
use std::{
    env,
    path::Path,
    process::{Command, Stdio},
    time::{Duration, Instant},
};

/// Names the output for the process that is to be killed.
const OUT: &str = "ENDLESS_TEST_KILL_OUT";

fn the_draft() -> RecipeDraft {
    let layers = Some(Layer::ALL.iter().map(ToString::to_string).collect());
    RecipeDraft { videos: Some(4), size: Some("321x181".into()), duration: Some(2.0), layers, ..draft() }
}

/// Not a test of its own: what the other test starts and kills.
#[test]
fn child_that_is_killed() {
    if let Some(out) = env::var_os(OUT) {
        make(&Fake::default(), &recipe(the_draft()), Path::new(&out), 2);
    }
}

fn start(out: &Path) -> std::process::Child {
    Command::new(env::current_exe().expect("this test"))
        .args(["--exact", "kill::child_that_is_killed"])
        .env(OUT, out)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("starts")
}

#[test]
fn twenty_kills_leave_no_trace() {
    let (killed, whole) = (tempfile::tempdir().expect("temp"), tempfile::tempdir().expect("temp"));
    let begin = Instant::now();
    assert!(start(whole.path()).wait().expect("waits").success());
    // Kills come at any instant of a run; all twenty together take about as long as three runs.
    let run = begin.elapsed();
    let mut stream = Stream::named(u64::from(std::process::id()), "kill", &[]);
    let mut interrupted = 0;
    for kill in 0..20 {
        if killed.path().join("dataset.json").exists() && kill % 5 == 4 {
            // Begin anew now and then, so that all phases of a run are met.
            std::fs::remove_dir_all(killed.path()).expect("removable");
        }
        let mut child = start(killed.path());
        std::thread::sleep(Duration::from_secs_f64(run.as_secs_f64() * stream.range_f64(0.02, 0.3)));
        interrupted += u32::from(child.try_wait().expect("asks").is_none());
        child.kill().expect("killed or ended");
        child.wait().expect("waits");
    }
    assert!(interrupted >= 10, "only {interrupted} of 20 kills came in time");
    assert!(start(killed.path()).wait().expect("waits").success());
    assert_same(killed.path(), whole.path());
}
