//! Finds out what identifies this build: a hash of everything that decides the bytes, and the commit.

#![expect(clippy::print_stdout, reason = "a build script speaks to cargo so")]

mod sources;

use sources::{Sources, commit};
use std::{env, path::Path};

fn main() -> std::io::Result<()> {
    let package = env::var_os("CARGO_MANIFEST_DIR").expect("cargo names the package's folder");
    let sources = Sources::of(Path::new(&package))?;
    println!("cargo::rustc-env=ENDLESS_SOURCES={}", sources.hash()?);
    let (commit, changes_with) = commit(&sources).unwrap_or_default();
    println!("cargo::rustc-env=ENDLESS_COMMIT={commit}");
    for path in sources.inputs().iter().chain(&changes_with) {
        println!("cargo::rerun-if-changed={}", path.display());
    }
    Ok(())
}
