//! Where a dataset is: in a folder, or in object storage if the program is built with it.

use endless_storage::{AddressError, DatasetAddress};
use std::path::{Path, PathBuf};

#[cfg(feature = "cloud")]
pub(crate) use there::{check_there, generate_there};
#[cfg(not(feature = "cloud"))]
pub(crate) use without::{check_there, generate_there};

/// What an argument names.
pub(crate) fn address(out: &Path) -> Result<DatasetAddress, AddressError> {
    match out.to_str() {
        Some(text) => text.parse(),
        None => Ok(DatasetAddress::Folder(out.to_owned())),
    }
}

/// The folder that an argument names, for commands that read folders alone.
pub(crate) fn folder(out: &Path) -> Result<PathBuf, AddressError> {
    match address(out)? {
        DatasetAddress::Folder(folder) => Ok(folder),
        DatasetAddress::Storage(_) => Err(AddressError::NotAFolder),
    }
}

#[cfg(feature = "cloud")]
mod there {
    use crate::args::GenerateArgs;
    use anyhow::{Result, anyhow};
    use endless_dataset::{CheckOptions, CheckReport, DatasetLayout, Manifest, Recipe, check_with};
    use endless_pipeline::{GenerateError, GenerateOptions, Generated, Progress, Simulator, generate_into};
    use endless_storage::{RemoteDataset, RemoteReader, RemoteSettings, StorageAddress};
    use std::{
        fs,
        path::Path,
        sync::atomic::{AtomicU64, Ordering},
        time::Duration,
    };

    /// How long a check waits for a server.
    const CHECK_PATIENCE: Duration = Duration::from_secs(60);

    /// Makes a dataset in object storage.
    pub(crate) fn generate_there<S: Simulator>(
        simulator: &S,
        recipe: &Recipe,
        address: &StorageAddress,
        args: &GenerateArgs,
        options: &GenerateOptions,
        progress: &dyn Progress,
    ) -> Result<Generated> {
        let part = options.shard.map(|shard| format!("{}of{}", shard.number(), shard.of()));
        let patience = Duration::from_secs_f64(args.reconnect_timeout);
        let settings = RemoteSettings { part: part.as_deref(), work: args.work_dir.as_deref(), patience };
        let store = RemoteDataset::new(address, &settings)?;
        let folder = store.folder();
        let made = generate_into(simulator, recipe, folder.root(), &store, options, progress);
        made.map_err(|error| told_of(error, folder.root(), address))
    }

    /// Errors about the dataset name its address, not the folder in which they were found.
    fn told_of(error: GenerateError, folder: &Path, address: &StorageAddress) -> anyhow::Error {
        match error {
            GenerateError::OtherRecipe { .. }
            | GenerateError::OtherBuild { .. }
            | GenerateError::OtherScene { .. }
            | GenerateError::OlderFormat { .. }
            | GenerateError::UnknownBuild { .. }
            | GenerateError::UnprovenVideo { .. }
            | GenerateError::OutputInUse { .. } => {
                anyhow!(error.to_string().replace(&*folder.to_string_lossy(), &address.to_string()))
            }
            other => other.into(),
        }
    }

    /// Checks a dataset in object storage, a video at a time. What is left in the folder is its index, and the `scene.json` of
    /// each video.
    pub(crate) fn check_there(
        address: &StorageAddress,
        root: &Path,
        threads: usize,
        progress: &(dyn Fn(u64, u64) + Sync),
    ) -> Result<CheckReport> {
        let reader = RemoteReader::open(address, CHECK_PATIENCE)?;
        reader.index(root)?;
        let layout = DatasetLayout::new(root);
        let manifest = Manifest::read(&layout.manifest())?;
        let mut report = CheckReport { videos: manifest.videos.len(), ..CheckReport::default() };
        let done_before = AtomicU64::new(0);
        let latest = AtomicU64::new(0);
        let add = |done: u64, total: u64| {
            let done = done_before.load(Ordering::Relaxed) + done;
            latest.fetch_max(done, Ordering::Relaxed);
            progress(done, total);
        };
        for (number, entry) in manifest.videos.iter().enumerate() {
            let video = layout.video_named(&entry.name);
            reader.video(root, &entry.name)?;
            let options = CheckOptions { threads, progress: Some(&add), only: Some(number) };
            report.merge(check_with(root, &options)?);
            done_before.store(latest.load(Ordering::Relaxed), Ordering::Relaxed);
            let scene = fs::read(video.scene());
            fs::remove_dir_all(video.folder())?;
            fs::create_dir_all(video.folder())?;
            if let Ok(scene) = scene {
                fs::write(video.scene(), scene)?;
            }
        }
        let local = root.to_string_lossy();
        for finding in &mut report.findings {
            finding.path = finding.path.to_string_lossy().replace(&*local, &address.to_string()).into();
        }
        report.findings.sort_by(|a, b| (&a.path, &a.problem).cmp(&(&b.path, &b.problem)));
        // Each video's check also looks at the index.
        report.findings.dedup();
        Ok(report)
    }
}

#[cfg(not(feature = "cloud"))]
mod without {
    use crate::args::GenerateArgs;
    use anyhow::Result;
    use endless_dataset::{CheckReport, Recipe};
    use endless_pipeline::{GenerateOptions, Generated, Progress, Simulator};
    use endless_storage::{AddressError, StorageAddress};
    use std::path::Path;

    /// Says how to get a program that can.
    pub(crate) fn generate_there<S: Simulator>(
        _simulator: &S,
        _recipe: &Recipe,
        _address: &StorageAddress,
        _args: &GenerateArgs,
        _options: &GenerateOptions,
        _progress: &dyn Progress,
    ) -> Result<Generated> {
        Err(AddressError::NotBuilt.into())
    }

    /// Says how to get a program that can.
    pub(crate) fn check_there(
        _address: &StorageAddress,
        _root: &Path,
        _threads: usize,
        _progress: &(dyn Fn(u64, u64) + Sync),
    ) -> Result<CheckReport> {
        Err(AddressError::NotBuilt.into())
    }
}
