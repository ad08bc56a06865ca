//! A folder of models, from its manifest to a checked dataset, and everything that can be wrong with it.

use crate::program::{refused, succeed};
use std::{fs, path::Path};

const SMALL: &str = "--videos 1 --maps Town02 --weathers cloudy --times morning --size 96x54 --fps 4 --duration 1 \
                     --vehicles 20 --pedestrians 4 --min-pixels 5 --mp4 none";

const MANIFEST: &str = "\
[[asset]]
file = \"sedan.glb\"
class = \"car\"
forward = \"+x\"
size = [4.6, 1.8, 1.45]
frequency = 5000

[[asset]]
file = \"bench.glb\"
name = \"seat\"
class = \"bench\"
forward = \"+x\"
size = [0.57, 1.8, 0.89]
";

fn models(folder: &Path) {
    succeed(folder, "assets export car.sedan --out models/sedan.glb");
    succeed(folder, "assets export bench --out models/bench.glb");
    fs::write(folder.join("models/assets.toml"), MANIFEST).expect("writable");
}

#[test]
fn a_folder_of_models_becomes_part_of_a_dataset() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    models(folder);
    let (list, _) = succeed(folder, "assets list imported --assets models");
    assert!(list.contains("imported.sedan") && list.contains("imported.seat"), "{list}");
    succeed(folder, "assets preview imported.seat --assets models --out seat.png");
    assert!(fs::read(folder.join("seat.png")).expect("written").starts_with(b"\x89PNG"));
    succeed(folder, "assets export imported.sedan --assets models --out again.glb");

    let generate = format!("generate out --assets models {SMALL}");
    succeed(folder, &generate);
    succeed(folder, "check out");
    let manifest = fs::read_to_string(folder.join("out/dataset.json")).expect("a manifest");
    assert!(manifest.contains("asset_files") && manifest.contains("sedan.glb"), "{manifest}");
    let (_, said) = succeed(folder, &generate);
    assert!(said.contains("nothing to do"), "{said}");

    // The same by a file, whose folder the path is seen from.
    fs::create_dir(folder.join("recipes")).expect("a folder");
    fs::write(folder.join("recipes/r.toml"), "assets = \"../models\"\n").expect("writable");
    let (_, said) = succeed(folder, &format!("generate out --config recipes/r.toml {SMALL}"));
    assert!(said.contains("nothing to do"), "{said}");

    // Another content is another recipe; so is none.
    assert!(refused(folder, &format!("generate out {SMALL}")).contains("asset_files"));
    let longer = MANIFEST.replace("frequency = 5000", "frequency = 5001");
    fs::write(folder.join("models/assets.toml"), longer).expect("writable");
    assert!(refused(folder, &generate).contains("asset_files"));
    fs::write(folder.join("models/assets.toml"), MANIFEST).expect("writable");
    succeed(folder, "assets export car.sedan --variant 1 --out models/sedan.glb");
    assert!(refused(folder, &generate).contains("another recipe"));
}

#[test]
fn what_is_broken_is_named_or_skipped() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    models(folder);
    let plan = format!("generate plan --plan-only {SMALL}");
    let with = format!("{plan} --assets models");
    assert!(refused(folder, &format!("{plan} --assets nowhere")).contains("nowhere has no assets.toml"));

    let sedan = fs::read(folder.join("models/sedan.glb")).expect("written");
    fs::write(folder.join("models/sedan.glb"), &sedan[..sedan.len() / 2]).expect("writable");
    for command in [with.as_str(), "assets list --assets models"] {
        let said = refused(folder, command);
        assert!(said.contains("sedan.glb") && said.contains("cut off"), "{said}");
    }
    let (list, warning) = succeed(folder, "assets list imported --assets models --skip-broken");
    assert!(list.contains("imported.seat") && !list.contains("imported.sedan"), "{list}");
    let skipped: Vec<&str> = warning.lines().filter(|l| l.starts_with("warning: skipped")).collect();
    assert!(skipped.len() == 1 && skipped[0].contains("sedan.glb"), "{warning}");
    succeed(folder, &format!("{with} --skip-broken"));
    let manifest = fs::read_to_string(folder.join("plan/dataset.json")).expect("a manifest");
    assert!(!manifest.contains("sedan.glb") && manifest.contains("bench.glb"), "{manifest}");
    // The mended file makes it another recipe.
    fs::write(folder.join("models/sedan.glb"), &sedan).expect("writable");
    assert!(refused(folder, &format!("{with} --skip-broken")).contains("asset_files"));

    let write = |text: &str| fs::write(folder.join("models/assets.toml"), text).expect("writable");
    write(&MANIFEST.replace("class = \"car\"", "clas = \"car\""));
    let said = refused(folder, &with);
    assert!(said.contains("assets.toml:3:1: unknown field `clas`"), "{said}");
    write(&MANIFEST.replace("class = \"car\"", "class = \"ship\""));
    assert!(refused(folder, &with).contains("class = ship"));
    write(&MANIFEST.replace("4.6, 1.8, 1.45", "9.2, 1.8, 1.45"));
    assert!(refused(folder, &with).contains("scaled to a length of 9.20 m"));
    write(&MANIFEST.replace("sedan.glb", "other.glb"));
    assert!(refused(folder, &with).contains("other.glb"));
    write(&MANIFEST.replace("\"seat\"", "\"sedan\""));
    assert!(refused(folder, &with).contains("two assets"));
    write("# nothing\n");
    assert!(refused(folder, &with).contains("names no file"));
}
