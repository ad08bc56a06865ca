//! The corpus is read as it should, also with a few changes of each file.

use endless_fuzz::{OSM, PBF, TARGETS, pbf_from_extract};
use endless_road::osm::read_extract;
use endless_world::Stream;
use std::collections::BTreeSet;
use std::{fs, path::Path};

/// Changes of each file of the corpus. Fuzzing tries others; these show that targets and changes work.
const CHANGES: u64 = 6;

#[test]
fn the_corpus_is_taken_as_it_should() {
    for target in TARGETS {
        let files = target.corpus().expect("a corpus");
        assert!(!files.is_empty(), "{}", target.name);
        for (path, bytes) in files {
            (target.judge)(&bytes).unwrap_or_else(|wrong| panic!("{}: {wrong}", path.display()));
        }
    }
}

#[test]
fn changed_files_are_taken_as_they_should() {
    for target in TARGETS {
        for (number, (path, bytes)) in (0..).zip(target.corpus().expect("a corpus")) {
            for change in 0..CHANGES {
                let mut stream = Stream::named(change, target.name, &[number]);
                let changed = (target.mutate)(&bytes, &mut stream);
                let judged = (target.judge)(&changed);
                judged.unwrap_or_else(|wrong| panic!("change {change} of {}: {wrong}", path.display()));
            }
        }
    }
}

#[test]
fn every_target_has_its_program() {
    let programs = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/fuzz_targets"));
    let name = |path: &Path| path.file_stem().expect("a name").to_string_lossy().into_owned();
    let programs: BTreeSet<String> = programs.expect("a folder").map(|e| name(&e.expect("a file").path())).collect();
    assert_eq!(programs, TARGETS.iter().map(|target| target.name.to_owned()).collect());
}

#[test]
fn xml_and_pbf_say_the_same() {
    for (path, bytes) in OSM.corpus().expect("a corpus") {
        let Ok(extract) = read_extract(&bytes) else { continue };
        let packed = pbf_from_extract(&extract);
        assert_eq!((PBF.judge)(&packed), Ok(()), "{}", path.display());
        let again = read_extract(&packed).expect("as written");
        assert_eq!(extract.ways, again.ways, "{}", path.display());
        assert_eq!(extract.relations, again.relations);
        assert!(extract.nodes.keys().eq(again.nodes.keys()));
        for (a, b) in extract.nodes.values().zip(again.nodes.values()) {
            assert!((a.lat - b.lat).abs() < 6e-8 && (a.lon - b.lon).abs() < 6e-8 && a.tags == b.tags);
        }
    }
}
