//! Traffic without pictures: trajectories, views from above, audits.

use crate::program::{endless, refused, succeed};
use std::{fs, path::Path};

#[test]
fn a_simulation_is_written_drawn_audited_and_filmed_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = "--out files/t.csv --top-view files/t.png";
    let (said, _) =
        succeed(folder.path(), &format!("simulate Town02 --seconds 2 --vehicles 10 --pedestrians 5 --audit {files}"));
    assert!(said.starts_with("Town02: 10 vehicles (of at most "), "{said}");
    assert!(said.contains("PASS  collisions between vehicles") && !said.contains("FAIL"), "{said}");
    let text = fs::read_to_string(folder.path().join("files/t.csv")).expect("a table");
    assert!(text.starts_with("time,id,class,x,y,z,yaw,speed,"), "{text}");
    assert_eq!(text.lines().count(), 1 + 15 * 21, "15 road users ten times a second, at both ends");
    let picture = fs::read(folder.path().join("files/t.png")).expect("a picture");
    assert!(picture.starts_with(b"\x89PNG"));
    succeed(folder.path(), "generate out --maps Town02 --traffic files/t.csv --duration 1 --plan-only");

    // What is written changes nothing of the traffic, and the same seed repeats it.
    succeed(folder.path(), "simulate Town02 --seconds 2 --vehicles 10 --pedestrians 5 --out again.csv");
    assert!(text == fs::read_to_string(folder.path().join("again.csv")).expect("a table"));
    succeed(folder.path(), "simulate Town02 --seconds 2 --vehicles 10 --pedestrians 5 --seed 1 --out other.csv");
    assert!(text != fs::read_to_string(folder.path().join("other.csv")).expect("a table"));
}

#[test]
fn a_map_file_is_simulated_at_its_capacity() {
    let folder = tempfile::tempdir().expect("a folder");
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../endless_road/tests/data/crossroads.xodr");
    fs::copy(data, folder.path().join("crossroads.xodr")).expect("the file is there");
    let wanted = "--out t.fcd.xml --top-view t.mp4 --fps 5 --seconds 1";
    let (said, _) =
        succeed(folder.path(), &format!("simulate crossroads.xodr --vehicles max --pedestrians 0 {wanted}"));
    let numbers: Vec<u32> =
        said.split_whitespace().filter_map(|word| word.trim_end_matches(')').parse().ok()).collect();
    assert!(numbers[0] > 0 && numbers[0] <= numbers[1], "{said}");
    let fcd = fs::read_to_string(folder.path().join("t.fcd.xml")).expect("text");
    assert_eq!(fcd.matches("<timestep ").count(), 6);
    assert!(fs::read(folder.path().join("t.mp4")).expect("a video")[4..].starts_with(b"ftyp"));
    succeed(folder.path(), "simulate crossroads.xodr --out t.parquet --seconds 1");
    assert!(fs::read(folder.path().join("t.parquet")).expect("a table").starts_with(b"PAR1"));
}

#[test]
fn what_cannot_be_simulated_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    assert!(refused(folder.path(), "simulate Town99 --audit").contains("unknown map 'Town99'"));
    assert!(refused(folder.path(), "simulate missing.xodr --audit").contains("cannot read the map"));
    for args in ["simulate Town02", "simulate Town02 --out t.json", "simulate Town02 --audit --vehicles many"] {
        assert_eq!(endless(folder.path(), args).status.code(), Some(2), "{args}");
    }
}
