//! The program as its users run it.

use std::path::Path;
use std::process::{Command, Output};

/// The program in a folder with its own maps.
pub(crate) fn endless(folder: &Path, args: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_endless"));
    command.args(args.split_whitespace()).current_dir(folder).env("ENDLESS_MAPS", folder.join("maps"));
    command.output().expect("starts")
}

/// What it writes to its two streams.
pub(crate) fn succeed(folder: &Path, args: &str) -> (String, String) {
    let output = endless(folder, args);
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let (out, err) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success(), "endless {args}: {err}");
    (out, err)
}

/// What one line says about a refusal.
pub(crate) fn refused(folder: &Path, args: &str) -> String {
    let output = endless(folder, args);
    assert!(!output.status.success(), "endless {args} was to be refused");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(said.lines().count(), 1, "endless {args}: {said}");
    assert!(said.starts_with("error: "), "{said}");
    said
}
