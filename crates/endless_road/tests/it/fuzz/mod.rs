//! Files that nobody meant: every reader must answer with a map or with an error that says where, in good time and
//! within memory.
//!
//! `cargo test` reads the corpus: small files of each kind, and what once broke a reader. `cargo xtask fuzz PARSER
//! --seconds N` goes on from there, changing files at random; what it finds lies in `target/fuzz/PARSER`.
#![expect(clippy::print_stdout, clippy::unwrap_used, reason = "a program for developers")]

mod hunt;
mod mutate;
mod pbf;
mod target;

use std::path::{Path, PathBuf};
use target::Target;

fn corpus(target: Target) -> Vec<(PathBuf, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/fuzz/corpus").join(target.name());
    let mut files = hunt::files(&folder);
    if target == Target::Pbf {
        // The same villages as XML, packed.
        for (path, bytes) in corpus(Target::Osm) {
            if let Ok(extract) = endless_road::osm::read_extract(&bytes) {
                files.push((path.with_extension("pbf"), pbf::file(&extract)));
            }
        }
    }
    files
}

#[test]
fn the_corpus_is_taken_as_it_should() {
    for target in Target::ALL {
        let files = corpus(target);
        assert!(!files.is_empty(), "{}", target.name());
        for (path, bytes) in files {
            if let Err(wrong) = target.run(&bytes) {
                panic!("{}: {wrong}", path.display());
            }
        }
    }
}

#[test]
fn xml_and_pbf_say_the_same() {
    for (path, bytes) in corpus(Target::Osm) {
        let Ok(extract) = endless_road::osm::read_extract(&bytes) else { continue };
        let again = endless_road::osm::read_extract(&pbf::file(&extract)).unwrap();
        assert_eq!(extract.ways, again.ways, "{}", path.display());
        assert_eq!(extract.relations, again.relations);
        assert!(extract.nodes.keys().eq(again.nodes.keys()));
        for (a, b) in extract.nodes.values().zip(again.nodes.values()) {
            assert!((a.lat - b.lat).abs() < 6e-8 && (a.lon - b.lon).abs() < 6e-8 && a.tags == b.tags);
        }
    }
}

#[test]
#[ignore = "as long as asked for; cargo xtask fuzz"]
fn hunt() {
    let name = std::env::var("FUZZ_PARSER").unwrap_or_default();
    let seconds = std::env::var("FUZZ_SECONDS").ok().and_then(|text| text.parse().ok()).unwrap_or(60);
    let seed = std::env::var("FUZZ_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    let target = Target::ALL.into_iter().find(|target| target.name() == name).expect("opendrive, osm or pbf");
    hunt::hunt(target, corpus(target), seconds, seed);
}
