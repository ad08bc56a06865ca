//! What identifies a build: every source, wherever it lies, and nothing else.

#[path = "../../build/sources.rs"]
mod sources;

use crate::program::succeed;
use sources::{Sources, commit};
use std::{fs, path::Path, process::Command};

/// A workspace of two crates.
fn workspace(root: &Path) {
    for (file, text) in [
        ("Cargo.toml", "[workspace]\n"),
        ("Cargo.lock", "version = 4\n"),
        (".cargo/config.toml", "[build]\n"),
        ("crates/a/Cargo.toml", "[package]\n"),
        ("crates/a/src/lib.rs", "pub fn a() {}\n"),
        ("crates/a/tests/it.rs", "\n"),
        ("crates/b/Cargo.toml", "[package]\n"),
        ("crates/b/src/main.rs", "fn main() {}\n"),
        ("crates/b/src/deep/er.rs", "\n"),
        ("crates/endless_view/src/lib.rs", "\n"),
        ("README.md", "\n"),
    ] {
        let path = root.join(file);
        fs::create_dir_all(path.parent().expect("a folder")).expect("writable");
        fs::write(path, text).expect("writable");
    }
}

fn hash(root: &Path) -> String {
    Sources::of(&root.join("crates/b")).expect("readable").hash().expect("readable")
}

#[test]
fn every_source_counts_and_nothing_else() {
    let (here, there) = (tempfile::tempdir().expect("temp"), tempfile::tempdir().expect("temp"));
    workspace(here.path());
    workspace(there.path());
    let before = hash(here.path());
    assert_eq!((before.len(), hash(there.path())), (32, before.clone()));
    // What cargo watches must exist: it would build again and again for a file that does not.
    let sources = Sources::of(&here.path().join("crates/b")).expect("readable");
    assert_eq!(sources.inputs().len(), 7);
    assert!(sources.inputs().iter().all(|path| path.exists()));
    let changed = |file: &str, text: &str| {
        let path = here.path().join(file);
        let old = fs::read(&path).ok();
        fs::write(&path, text).expect("writable");
        let changed = hash(here.path()) != before;
        old.map_or_else(|| fs::remove_file(&path), |old| fs::write(&path, old)).expect("writable");
        assert_eq!(hash(here.path()), before, "as it was");
        changed
    };
    for file in
        ["Cargo.lock", ".cargo/config.toml", "crates/a/src/lib.rs", "crates/a/src/new.rs", "crates/b/Cargo.toml"]
    {
        assert!(changed(file, "other"), "{file}");
    }
    assert!(changed("crates/b/src/deep/er.rs", "other"));
    for file in ["README.md", "crates/a/tests/it.rs", "crates/a/notes.txt", "crates/endless_view/src/lib.rs"] {
        assert!(!changed(file, "other"), "{file}");
    }
    assert!(!changed("crates/a/src/lib.rs", "pub fn a() {}\r\n"), "line ends do not count");
}

#[test]
fn a_package_on_its_own_has_a_hash_too() {
    let folder = tempfile::tempdir().expect("temp");
    workspace(folder.path());
    let alone = folder.path().join("crates/a");
    let lonely = tempfile::tempdir().expect("temp");
    let package = lonely.path().join("endless-0.1.0");
    fs::create_dir_all(package.join("src")).expect("writable");
    for file in ["Cargo.toml", "src/lib.rs"] {
        fs::copy(alone.join(file), package.join(file)).expect("copies");
    }
    let hash = || Sources::of(&package).expect("readable").hash().expect("readable");
    let before = hash();
    fs::write(package.join("Cargo.lock"), "version = 4\n").expect("writable");
    assert_ne!(hash(), before);
    assert!(commit(&Sources::of(&package).expect("readable")).is_none(), "no repository");
}

#[test]
fn the_commit_tells_whether_sources_were_changed() {
    let folder = tempfile::tempdir().expect("temp");
    workspace(folder.path());
    let git = |args: &[&str]| {
        let settings = ["-c", "user.name=test", "-c", "user.email=test@example.org", "-c", "commit.gpgsign=false"];
        let mut command = Command::new("git");
        let done = command.arg("-C").arg(folder.path()).args(settings).args(args).output();
        done.is_ok_and(|output| output.status.success())
    };
    if !git(&["init"]) {
        println!("skipped: there is no git");
        return;
    }
    assert!(git(&["add", "."]) && git(&["commit", "-m", "all"]));
    let commit = || commit(&Sources::of(&folder.path().join("crates/b")).expect("readable")).expect("a repository").0;
    let clean = commit();
    assert!(clean.len() == 12 && clean.chars().all(|c| c.is_ascii_hexdigit()), "{clean}");
    fs::write(folder.path().join("README.md"), "other").expect("writable");
    assert_eq!(commit(), clean);
    fs::write(folder.path().join("crates/a/src/lib.rs"), "other").expect("writable");
    assert_eq!(commit(), format!("{clean}-dirty"));
}

#[test]
fn the_version_names_revision_and_format() {
    let folder = tempfile::tempdir().expect("temp");
    let (version, _) = succeed(folder.path(), "--version");
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let sources = Sources::of(package).expect("readable").hash().expect("readable");
    assert!(version.starts_with(&format!("endless {} (", env!("CARGO_PKG_VERSION"))), "{version}");
    assert!(version.contains(&format!("sources {sources})")), "{version} is not of {sources}");
    assert!(version.trim_end().ends_with(&format!("format {}", endless_dataset::Manifest::FORMAT)), "{version}");
    succeed(folder.path(), "generate out --plan-only --videos 1 --maps Town02");
    let manifest = endless_dataset::Manifest::read(&folder.path().join("out/dataset.json")).expect("a manifest");
    assert_eq!(manifest.builds.len(), 1);
    assert_eq!(manifest.builds[0].sources, sources);
}
