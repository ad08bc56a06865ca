//! The dataset's folder, the only one whose files are read.

use crate::refusal::Refusal;
use endless_dataset::DatasetLayout;
use serde::de::DeserializeOwned;
use std::{
    fs::{self, File, Metadata},
    io::{self, Read},
    path::{Component, Path, PathBuf},
    time::UNIX_EPOCH,
};

/// Largest file that is read as a whole: an image of 4K in 16 bits, or the map of a city.
const MOST_BYTES: u64 = 256 << 20;

/// The folder of a dataset. It opens plain files below itself, whatever links lie there.
#[derive(Debug, Clone)]
pub(crate) struct DatasetFolder {
    /// Without links.
    root: PathBuf,
}

/// Tells apart what a file held at different times: its size and when it was written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Stamp {
    bytes: u64,
    modified_ns: u128,
}

impl Stamp {
    fn of(data: &Metadata) -> Self {
        let modified = data.modified().ok().and_then(|time| time.duration_since(UNIX_EPOCH).ok());
        Self { bytes: data.len(), modified_ns: modified.unwrap_or_default().as_nanos() }
    }

    /// As an entity tag of HTTP.
    pub(crate) fn etag(self) -> String {
        format!("\"{:x}-{:x}\"", self.bytes, self.modified_ns)
    }
}

/// An open file.
#[derive(Debug)]
pub(crate) struct StampedFile {
    pub(crate) file: File,
    pub(crate) bytes: u64,
    pub(crate) stamp: Stamp,
}

impl DatasetFolder {
    /// # Errors
    /// When there is no such folder.
    pub(crate) fn new(root: &Path) -> io::Result<Self> {
        Ok(Self { root: fs::canonicalize(root)? })
    }

    /// The paths of its files.
    pub(crate) fn layout(&self) -> DatasetLayout {
        DatasetLayout::new(&self.root)
    }

    /// Its name, as people know it.
    pub(crate) fn name(&self) -> String {
        self.root.file_name().unwrap_or(self.root.as_os_str()).to_string_lossy().into_owned()
    }

    /// Where a path leads if that is inside of the folder.
    fn inside(&self, path: &Path) -> Result<PathBuf, Refusal> {
        let real = fs::canonicalize(path).map_err(|_not_there| Refusal::missing_file(path))?;
        if real.starts_with(&self.root) { Ok(real) } else { Err(Refusal::missing_file(path)) }
    }

    /// Opens a plain file. Others are not: opening a pipe would wait for whoever writes it.
    pub(crate) fn open(&self, path: &Path) -> Result<StampedFile, Refusal> {
        let missing = |_cause| Refusal::missing_file(path);
        let real = self.inside(path)?;
        if !fs::metadata(&real).map_err(missing)?.is_file() {
            return Err(Refusal::missing_file(path));
        }
        let file = File::open(&real).map_err(missing)?;
        let data = file.metadata().map_err(missing)?;
        Ok(StampedFile { file, bytes: data.len(), stamp: Stamp::of(&data) })
    }

    /// The stamp of a plain file.
    pub(crate) fn stamp(&self, path: &Path) -> Result<Stamp, Refusal> {
        let real = self.inside(path)?;
        let data = fs::metadata(&real).map_err(|_cause| Refusal::missing_file(path))?;
        if data.is_file() { Ok(Stamp::of(&data)) } else { Err(Refusal::missing_file(path)) }
    }

    /// All of a file.
    pub(crate) fn read(&self, path: &Path) -> Result<(Vec<u8>, Stamp), Refusal> {
        let StampedFile { file, bytes, stamp } = self.open(path)?;
        if bytes > MOST_BYTES {
            return Err(Refusal::damaged(path, format!("has {bytes} bytes: too many to show")));
        }
        let mut content = Vec::with_capacity(bytes as usize);
        file.take(MOST_BYTES).read_to_end(&mut content).map_err(|cause| Refusal::damaged(path, cause))?;
        Ok((content, stamp))
    }

    /// A JSON file.
    pub(crate) fn json<T: DeserializeOwned>(&self, path: &Path) -> Result<T, Refusal> {
        let (content, _) = self.read(path)?;
        serde_json::from_slice(&content).map_err(|cause| Refusal::damaged(path, cause))
    }

    /// Names of what lies in a folder and is not hidden; nothing where there is no such folder.
    pub(crate) fn list(&self, path: &Path) -> Vec<String> {
        let Ok(entries) =
            self.inside(path).and_then(|real| fs::read_dir(real).map_err(|_cause| Refusal::missing_file(path)))
        else {
            return Vec::new();
        };
        let names = entries.flatten().filter_map(|entry| entry.file_name().into_string().ok());
        names.filter(|name| !name.starts_with('.')).collect()
    }
}

/// Whether a name that a file of the dataset tells is one part of a path, and leads nowhere else.
pub(crate) fn is_plain_name(name: &str) -> bool {
    let mut parts = Path::new(name).components();
    let plain = matches!((parts.next(), parts.next()), (Some(Component::Normal(part)), None) if part == name);
    plain && !name.contains(['/', '\\', '\0'])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_lead_elsewhere_are_not_plain() {
        for name in ["", ".", "..", "a/b", "../a", "/a", "a/", "a/.", "a\\b", "a\0b"] {
            assert!(!is_plain_name(name), "{name:?}");
        }
        for name in ["0000_Town03_rainy_night", "<script>", "a b", "..a", "č"] {
            assert!(is_plain_name(name), "{name:?}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_inside_and_refused_outside() {
        use std::os::unix::fs::symlink;
        let temporary = tempfile::tempdir().expect("temp");
        let out = temporary.path().join("out");
        fs::create_dir(&out).expect("room");
        fs::write(temporary.path().join("secret"), "s").expect("room");
        fs::write(out.join("own"), "own").expect("room");
        symlink("own", out.join("inside")).expect("room");
        symlink("../secret", out.join("outside")).expect("room");
        symlink("..", out.join("up")).expect("room");
        let folder = DatasetFolder::new(&out).expect("a folder");
        assert_eq!(folder.read(&out.join("inside")).expect("inside").0, b"own");
        for path in ["outside", "up/secret", "../secret", "none", ""] {
            assert!(matches!(folder.read(&out.join(path)), Err(Refusal::Missing(_))), "{path}");
            assert!(folder.stamp(&out.join(path)).is_err(), "{path}");
        }
        assert_eq!(folder.list(&out.join("up")), Vec::<String>::new());
        assert_eq!(folder.list(&out).len(), 4);
    }
}
