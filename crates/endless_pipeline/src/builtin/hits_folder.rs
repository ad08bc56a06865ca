//! Ends of indirect rays in a folder that any number of runs and processes share. Files are named by what they depend on
//! and carry a digest of what they hold: one that is damaged is as good as none.

use super::bake_key::BakeKey;
use crate::SimulatorError;
use endless_render::IndirectHits;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};
use std::{fs, sync::Arc};

const SUFFIX: &str = "hits";
/// Names of files that are being written begin so.
const PREFIX: &str = ".writing-";
/// What a killed process left half-written is removed after this.
const ABANDONED: Duration = Duration::from_secs(3600);
const DIGEST_BYTES: usize = blake3::OUT_LEN;

/// The folder.
#[derive(Debug)]
pub(super) struct HitsFolder {
    path: PathBuf,
}

impl HitsFolder {
    /// Opens it; makes it if it does not exist.
    ///
    /// # Errors
    /// When nothing can be written there.
    pub(super) fn open(path: &Path) -> Result<Self, SimulatorError> {
        let failed = |source| SimulatorError::CacheFolder { path: path.to_owned(), source };
        fs::create_dir_all(path).map_err(failed)?;
        drop(temporary(path).map_err(failed)?);
        let folder = Self { path: path.to_owned() };
        folder.remove_abandoned().map_err(failed)?;
        Ok(folder)
    }

    /// What was kept for a camera, if it is there and whole.
    pub(super) fn read(&self, key: &BakeKey) -> Option<Arc<IndirectHits>> {
        let path = self.file(key);
        let bytes = match fs::read(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return None,
            read => read,
        };
        let hits = bytes.ok().and_then(|bytes| {
            let (digest, hits) = bytes.split_first_chunk::<DIGEST_BYTES>()?;
            (blake3::hash(hits) == *digest).then(|| IndirectHits::from_bytes(hits)).flatten()
        });
        if hits.is_none() {
            tracing::warn!("{} is damaged: it is made again", path.display());
        }
        hits.map(Arc::new)
    }

    /// Keeps this for a camera. A disk that refuses is told of, and costs nothing but time later.
    pub(super) fn write(&self, key: &BakeKey, hits: &IndirectHits) {
        let path = self.file(key);
        if let Err(error) = self.write_file(&path, &hits.to_bytes()) {
            tracing::warn!("cannot write {}, and goes on without: {error}", path.display());
        }
    }

    fn write_file(&self, path: &Path, hits: &[u8]) -> io::Result<()> {
        let mut file = temporary(&self.path)?;
        file.write_all(blake3::hash(hits).as_bytes())?;
        file.write_all(hits)?;
        file.persist(path).map_err(|failed| failed.error)?;
        Ok(())
    }

    fn file(&self, key: &BakeKey) -> PathBuf {
        self.path.join(format!("{}.{SUFFIX}", blake3::Hash::from_bytes(*key).to_hex()))
    }

    fn remove_abandoned(&self) -> io::Result<()> {
        for entry in fs::read_dir(&self.path)? {
            let entry = entry?;
            let name = entry.file_name();
            let ours = name.to_string_lossy().starts_with(PREFIX);
            // Another process may have renamed or removed it since.
            let written = entry.metadata().and_then(|file| file.modified()).unwrap_or(SystemTime::now());
            if ours && written.elapsed().is_ok_and(|age| age > ABANDONED) {
                let _ = fs::remove_file(entry.path());
            }
        }
        Ok(())
    }
}

/// A file that vanishes unless it gets its name, and that others may read then. Unlike those of a dataset, which one process
/// writes, it has a name of its own until then: two processes may keep the same camera at once.
fn temporary(folder: &Path) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_whole_file_is_read_and_a_damaged_one_is_not() {
        let folder = tempfile::tempdir().expect("temp");
        let cache = HitsFolder::open(&folder.path().join("made/when/needed")).expect("writable");
        let (key, hits) = ([7; 32], IndirectHits::default());
        assert!(cache.read(&key).is_none());
        cache.write(&key, &hits);
        assert_eq!(cache.read(&key).as_deref(), Some(&hits));
        let whole = fs::read(cache.file(&key)).expect("there");
        for place in 0..whole.len() {
            let mut damaged = whole.clone();
            damaged[place] ^= 4;
            fs::write(cache.file(&key), &damaged).expect("writable");
            assert!(cache.read(&key).is_none(), "byte {place}");
            fs::write(cache.file(&key), &whole[..place]).expect("writable");
            assert!(cache.read(&key).is_none(), "cut at {place}");
        }
        cache.write(&key, &hits);
        assert_eq!(cache.read(&key).as_deref(), Some(&hits));
        assert_eq!(fs::read_dir(&cache.path).expect("there").count(), 1, "nothing is left half-written");
    }

    #[test]
    fn a_folder_that_cannot_be_is_named() {
        let file = tempfile::NamedTempFile::new().expect("temp");
        let error = HitsFolder::open(&file.path().join("cache")).expect_err("below a file").to_string();
        assert!(error.contains("--cache") && error.contains("cache"), "{error}");
    }
}
