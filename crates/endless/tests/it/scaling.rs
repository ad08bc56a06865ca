//! `endless bench --scaling` prints a row for each step of what grows, and `--rig` one for each sensor. How long anything
//! takes is not looked at.

use crate::program::{refused, succeed};

/// The first words of each table's rows, below its title and its heads, by the first word of the title.
fn rows(text: &str) -> Vec<(String, Vec<String>)> {
    let word = |line: &str| line.split_whitespace().next().unwrap_or_default().trim_end_matches(':').to_owned();
    // The first block tells what all tables have in common.
    let tables = text.trim_end().split("\n\n").skip(1);
    tables.map(|table| (word(table), table.lines().skip(2).map(word).collect())).collect()
}

#[test]
fn every_step_has_a_row() {
    let folder = tempfile::tempdir().expect("a folder");
    let args =
        "bench --scaling threads,pixels --maps Town02 --cameras-per-scene 1 --size 64x36 --duration 0.1 --threads 2";
    let (text, _) = succeed(folder.path(), args);
    let expected = [("pixels", vec!["16x9", "32x18", "64x36"]), ("threads", vec!["1", "2"])];
    let expected = expected.map(|(title, rows)| (title.to_owned(), rows.into_iter().map(str::to_owned).collect()));
    assert_eq!(rows(&text), expected, "{text}");
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 0, "nothing is left");
}

#[test]
fn every_sensor_of_a_rig_has_a_row() {
    let folder = tempfile::tempdir().expect("a folder");
    let car = "mount = { on = \"vehicle\", class = \"car\", at = [0.5, 0.0, 1.7] }";
    let text = format!(
        "[[sensor]]\nname = \"front\"\ntype = \"camera\"\nsize = \"64x36\"\n{car}\n\
         [[sensor]]\nname = \"roof\"\ntype = \"lidar\"\npreset = \"vlp_16\"\nrate = 10\n{car}\n\
         [[sensor]]\nname = \"imu\"\ntype = \"imu\"\n{car}\n"
    );
    std::fs::write(folder.path().join("rig.toml"), text).expect("writable");
    let (text, _) = succeed(folder.path(), "bench --rig rig.toml --maps Town02 --duration 0.2 --threads 2");
    let (_, table) = text.split_once("\n\n").expect("stages, and sensors");
    let words: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split_whitespace().collect()).collect();
    let names: Vec<[&str; 2]> = words[..3].iter().map(|row| [row[0], row[1]]).collect();
    assert_eq!(names, [["front", "6"], ["roof", "2"], ["imu", "6"]], "{text}");
    assert!(words[1].len() == 5 && words[1][4].parse::<f64>().is_ok_and(|millions| millions > 0.0), "{text}");
    assert!(words[3].starts_with(&["all", "together", "14"]), "{text}");
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 1, "nothing is left");
}

#[test]
fn what_cannot_grow_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let said = refused(folder.path(), "bench --scaling speed");
    assert!(said.contains("pixels, objects, unseen, lamps, triangles, cameras, threads"), "{said}");
}
