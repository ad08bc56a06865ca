//! The sources of a build: what they are, their hash, their commit.

use std::{
    fs, io,
    path::{Path, PathBuf},
    process::Command,
};

/// Crates that decide nothing of what is in a dataset: they only read datasets, or bring the program to Python.
const BYSTANDERS: [&str; 4] = ["endless_export", "endless_python", "endless_statistics", "endless_view"];

/// Everything that decides the bytes which a build writes: the sources of the crates that make datasets, and which libraries they
/// use.
pub(crate) struct Sources {
    root: PathBuf,
    /// Files and folders, sorted.
    inputs: Vec<PathBuf>,
}

impl Sources {
    /// Of a package's folder in its workspace or, where it was packed alone, of its own files: then `Cargo.lock` has
    /// the checksums of the other crates.
    pub(crate) fn of(package: &Path) -> io::Result<Self> {
        let workspace = package.ancestors().nth(2).filter(|root| root.join("crates").is_dir());
        let root = workspace.unwrap_or(package).to_owned();
        let mut inputs: Vec<PathBuf> = ["Cargo.toml", "Cargo.lock", ".cargo/config.toml"].map(|f| root.join(f)).into();
        let crates = match workspace {
            Some(root) => list(&root.join("crates"))?,
            None => vec![root.clone()],
        };
        let is_bystander = |folder: &PathBuf| BYSTANDERS.iter().any(|name| folder.ends_with(name));
        for folder in crates.into_iter().filter(|folder| !is_bystander(folder)) {
            inputs.extend(["Cargo.toml", "src", "build"].map(|name| folder.join(name)));
        }
        inputs.retain(|path| path.exists());
        inputs.sort();
        inputs.dedup();
        Ok(Self { root, inputs })
    }

    /// Files and folders that are looked at: a change of anything else leaves the hash as it is.
    pub(crate) fn inputs(&self) -> &[PathBuf] {
        &self.inputs
    }

    /// 32 hexadecimal digits over the names and the text of all files, the same wherever the folder lies and however
    /// lines end.
    pub(crate) fn hash(&self) -> io::Result<String> {
        let mut hasher = blake3::Hasher::new();
        for input in &self.inputs {
            self.add(input, &mut hasher)?;
        }
        Ok(hasher.finalize().to_hex()[..32].to_owned())
    }

    fn add(&self, path: &Path, hasher: &mut blake3::Hasher) -> io::Result<()> {
        if path.is_dir() {
            return list(path)?.iter().try_for_each(|below| self.add(below, hasher));
        }
        let name = path.strip_prefix(&self.root).unwrap_or(path).to_string_lossy().replace('\\', "/");
        let mut bytes = fs::read(path)?;
        bytes.retain(|byte| *byte != b'\r');
        for part in [name.as_bytes(), &bytes] {
            hasher.update(&(part.len() as u64).to_le_bytes());
            hasher.update(part);
        }
        Ok(())
    }
}

/// What lies in a folder, sorted.
fn list(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut paths = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    paths.sort();
    Ok(paths)
}

/// The commit, with `-dirty` where sources were changed since, and the files that change with it. `None` without git, or
/// where the folder is no repository of its own.
pub(crate) fn commit(sources: &Sources) -> Option<(String, Vec<PathBuf>)> {
    let root = &sources.root;
    let top = git(root, &["rev-parse", "--show-toplevel"])?;
    if fs::canonicalize(top).ok()? != fs::canonicalize(root).ok()? {
        return None;
    }
    let commit = git(root, &["rev-parse", "--short=12", "HEAD"])?;
    let mut status = vec!["--no-optional-locks", "status", "--porcelain", "--"];
    let inputs: Vec<_> = sources.inputs.iter().map(|path| path.to_string_lossy()).collect();
    status.extend(inputs.iter().map(AsRef::as_ref));
    let dirty = if git(root, &status)?.is_empty() { "" } else { "-dirty" };
    let changes_with = ["HEAD", "logs/HEAD"]
        .iter()
        .filter_map(|file| git(root, &["rev-parse", "--git-path", file]))
        .map(|file| root.join(file))
        .filter(|path| path.exists());
    Some((format!("{commit}{dirty}"), changes_with.collect()))
}

fn git(root: &Path, args: &[&str]) -> Option<String> {
    let output = Command::new("git").arg("-C").arg(root).args(args).output().ok().filter(|o| o.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim_end().to_owned())
}
