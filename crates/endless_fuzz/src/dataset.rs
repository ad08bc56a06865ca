//! Datasets with one file that is not what was written: `check` tells of it.

use crate::mutate;
use crate::target::FuzzTarget;
use endless_dataset::{CheckOptions, check_with};
use endless_world::Stream;
use std::{
    fs, io,
    path::{Path, PathBuf},
};
use tempfile::TempDir;

/// One file of a dataset in `datasets/`: a line with its path there, and its content.
pub const DATASET: FuzzTarget = FuzzTarget { name: "dataset", judge: dataset, mutate: content };

fn datasets() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("datasets")
}

fn copy(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let to = to.join(entry.file_name());
        if entry.file_type()?.is_dir() { copy(&entry.path(), &to)? } else { fs::write(to, fs::read(entry.path())?)? }
    }
    Ok(())
}

fn dataset(bytes: &[u8]) -> Result<(), String> {
    let Some((path, content)) = bytes.iter().position(|byte| *byte == b'\n').map(|at| bytes.split_at(at)) else {
        return Ok(());
    };
    let Ok(path) = std::str::from_utf8(path) else { return Ok(()) };
    let original = datasets().join(path);
    // Other paths are not asked for: they may lead anywhere.
    if path.contains("..") || path.starts_with('/') || !original.is_file() {
        return Ok(());
    }
    let Some((dataset, file)) = path.split_once('/') else { return Ok(()) };
    let cannot = |error: io::Error| format!("the dataset cannot be copied: {error}");
    let copied = TempDir::new().map_err(cannot)?;
    copy(&datasets().join(dataset), copied.path()).map_err(cannot)?;
    fs::write(copied.path().join(file), &content[1..]).map_err(cannot)?;
    let same = fs::read(original).is_ok_and(|original| original == content[1..]);
    let one_thread = CheckOptions { threads: 1, ..CheckOptions::default() };
    match check_with(copied.path(), &one_thread) {
        Ok(report) if same && !report.findings.is_empty() => {
            Err(format!("found in what is right: {:?}", report.findings))
        }
        Ok(report) => {
            let long = report.findings.iter().map(ToString::to_string).find(|text| text.lines().count() != 1);
            long.map_or(Ok(()), |text| Err(format!("a finding that is not one line: {text:?}")))
        }
        Err(error) => crate::target::one_line(&error),
    }
}

/// The content changed, as text or as bytes; the path stays.
fn content(file: &[u8], stream: &mut Stream) -> Vec<u8> {
    let (path, content) = file.split_at(file.iter().position(|byte| *byte == b'\n').map_or(0, |at| at + 1));
    let is_text = path.ends_with(b".json\n") || path.ends_with(b".jsonl\n");
    let changed = if is_text { mutate::text(content, stream) } else { mutate::binary(content, stream) };
    [path, &changed].concat()
}
