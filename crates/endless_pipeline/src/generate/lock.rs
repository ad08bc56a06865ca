//! The locks on an output folder.
//!
//! Who makes a whole dataset holds `.lock` alone; those who make shards share it, and each holds the lock of its shard. All
//! take and leave their locks one after another, inside of a gate, so that each sees who else is there.

use super::lock_file::{LockFailure, LockFile, Sharing};
use crate::{GenerateError, Shard};
use endless_dataset::{DatasetError, DatasetLayout};
use std::{
    fs, io,
    path::{Path, PathBuf},
};

/// Keeps other processes out of a dataset, or out of a part of it. Released when the process ends, however it ends; leaves no
/// trace when it is dropped.
#[derive(Debug)]
pub(super) struct DatasetLock {
    layout: DatasetLayout,
    whole: Option<LockFile>,
    shard: Option<LockFile>,
}

impl DatasetLock {
    /// Locks a dataset or a shard of it, and makes its folder if there is none.
    pub(super) fn take(layout: &DatasetLayout, shard: Option<Shard>) -> Result<Self, GenerateError> {
        let root = layout.root();
        fs::create_dir_all(root).map_err(|e| DatasetError::io("cannot make the folder", root, e))?;
        match Self::take_in_gate(layout, shard) {
            // Nobody can keep out or be kept out there.
            Err(LockError::Failure(LockFailure::Unknown)) if shard.is_some() => {
                Ok(Self { layout: layout.clone(), whole: None, shard: None })
            }
            taken => taken.map_err(|error| error.told(root)),
        }
    }

    /// Whether the file system knows locks.
    pub(super) fn holds(&self) -> bool {
        self.whole.is_some()
    }

    fn take_in_gate(layout: &DatasetLayout, shard: Option<Shard>) -> Result<Self, LockError> {
        let _gate = LockFile::wait(&layout.lock_gate())?;
        let sharing = if shard.is_some() { Sharing::Shared } else { Sharing::Exclusive };
        let whole = Some(LockFile::take(&layout.lock(), sharing)?);
        let mut own = None;
        if let Some(shard) = shard {
            for (path, other) in shard_locks(layout)? {
                if other.of() != shard.of() && remove_if_free(&path)? == Free::No {
                    return Err(LockError::OtherShards(other.of()));
                }
            }
            let taken = LockFile::take(&layout.shard_lock(&shard.file_name()), Sharing::Exclusive);
            own = Some(taken.map_err(|failure| match failure {
                LockFailure::Held => LockError::SameShard(shard),
                other => other.into(),
            })?);
        }
        Ok(Self { layout: layout.clone(), whole, shard: own })
    }

    /// Leaves no lock behind that nobody holds.
    fn leave(&mut self) -> Result<(), LockError> {
        let (Some(whole), layout) = (self.whole.take(), &self.layout) else { return Ok(()) };
        let gate = LockFile::wait(&layout.lock_gate())?;
        if let Some(own) = self.shard.take() {
            own.remove();
        }
        for (path, _) in shard_locks(layout)? {
            remove_if_free(&path)?;
        }
        drop(whole);
        if remove_if_free(&layout.lock())? == Free::Yes {
            gate.remove();
        }
        Ok(())
    }
}

impl Drop for DatasetLock {
    fn drop(&mut self) {
        if let Err(error) = self.leave() {
            tracing::debug!(?error, "locks stay behind, which nobody holds");
        }
    }
}

/// Why a dataset cannot be locked.
#[derive(Debug)]
enum LockError {
    Failure(LockFailure),
    Dataset(DatasetError),
    SameShard(Shard),
    OtherShards(u32),
}

impl LockError {
    fn told(self, root: &Path) -> GenerateError {
        let path = root.to_owned();
        match self {
            Self::Failure(LockFailure::Held) => GenerateError::Locked { path },
            Self::Failure(LockFailure::Unknown) => {
                DatasetError::io("cannot lock", root, io::Error::from(io::ErrorKind::Unsupported)).into()
            }
            Self::Failure(LockFailure::Io(e)) => DatasetError::io("cannot lock", root, e).into(),
            Self::Dataset(error) => error.into(),
            Self::SameShard(shard) => GenerateError::ShardLocked { shard, path },
            Self::OtherShards(of) => GenerateError::OtherShards { of, path },
        }
    }
}

impl From<LockFailure> for LockError {
    fn from(failure: LockFailure) -> Self {
        Self::Failure(failure)
    }
}

/// Whether nobody held a lock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Free {
    Yes,
    No,
}

/// Removes a lock that nobody holds, such as one of a process that was killed.
fn remove_if_free(path: &Path) -> Result<Free, LockError> {
    match LockFile::take(path, Sharing::Exclusive) {
        Ok(lock) => {
            lock.remove();
            Ok(Free::Yes)
        }
        Err(LockFailure::Held) => Ok(Free::No),
        Err(failure) => Err(failure.into()),
    }
}

/// The locks of shards that lie in the folder.
fn shard_locks(layout: &DatasetLayout) -> Result<Vec<(PathBuf, Shard)>, LockError> {
    let failed = |e| LockError::Dataset(DatasetError::io("cannot read the folder", layout.root(), e));
    let mut locks = Vec::new();
    for entry in fs::read_dir(layout.root()).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let name = path.file_name().and_then(|name| name.to_str()).and_then(|name| name.strip_prefix(".lock-"));
        locks.extend(name.and_then(Shard::from_file_name).map(|shard| (path, shard)));
    }
    Ok(locks)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU32, Ordering};

    fn layout() -> (tempfile::TempDir, DatasetLayout) {
        let folder = tempfile::tempdir().expect("temp");
        let layout = DatasetLayout::new(folder.path());
        (folder, layout)
    }

    fn files(layout: &DatasetLayout) -> usize {
        fs::read_dir(layout.root()).expect("there").count()
    }

    #[test]
    fn never_two_hold_the_lock_and_it_leaves_no_trace() {
        let (_folder, layout) = layout();
        let (holders, taken) = (AtomicU32::new(0), AtomicU32::new(0));
        std::thread::scope(|scope| {
            for _ in 0..6 {
                scope.spawn(|| {
                    for _ in 0..300 {
                        let Ok(lock) = DatasetLock::take(&layout, None) else { continue };
                        assert_eq!(holders.fetch_add(1, Ordering::SeqCst), 0, "a second one holds it");
                        taken.fetch_add(1, Ordering::SeqCst);
                        std::thread::yield_now();
                        holders.fetch_sub(1, Ordering::SeqCst);
                        drop(lock);
                    }
                });
            }
        });
        assert!(taken.into_inner() > 0 && files(&layout) <= 1, "at most the gate of one that was refused");
        drop(DatasetLock::take(&layout, None).expect("free"));
        assert_eq!(files(&layout), 0);
    }

    #[test]
    fn shards_of_one_number_hold_it_together_and_nobody_else() {
        let (_folder, layout) = layout();
        let take = |number, of| DatasetLock::take(&layout, Shard::new(number, of));
        let (first, second) = (take(1, 3).expect("free"), take(2, 3).expect("another shard"));
        assert!(first.holds() && second.holds());
        assert!(matches!(take(1, 3), Err(GenerateError::ShardLocked { .. })));
        assert!(matches!(take(1, 2), Err(GenerateError::OtherShards { of: 3, .. })));
        assert!(matches!(DatasetLock::take(&layout, None), Err(GenerateError::Locked { .. })));
        drop(first);
        let first = take(1, 3).expect("free again");
        drop((first, second));
        assert_eq!(files(&layout), 0);
        let whole = DatasetLock::take(&layout, None).expect("free");
        assert!(matches!(take(1, 3), Err(GenerateError::Locked { .. })));
        drop(whole);
        // A file of a process that was killed keeps nobody out.
        fs::write(layout.shard_lock("2-of-5"), "").expect("writable");
        drop(take(1, 3).expect("free"));
        assert_eq!(files(&layout), 0);
    }

    #[test]
    fn shards_that_come_and_go_never_refuse_one_another() {
        let (_folder, layout) = layout();
        std::thread::scope(|scope| {
            for number in 1..=6 {
                let layout = &layout;
                scope.spawn(move || {
                    for _ in 0..100 {
                        drop(DatasetLock::take(layout, Shard::new(number, 6)).expect("its own shard"));
                    }
                });
            }
        });
        assert_eq!(files(&layout), 0);
    }
}
