//! A folder of models: `assets.toml` and the `.glb` files that it names.

use crate::content_hash::content_hash;
use endless_asset::{AssetEntry, AssetManifest, ImportError, ImportedAsset};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

/// Name of the manifest.
const MANIFEST: &str = "assets.toml";
/// Longest file that is read, and longest manifest, bytes.
const MOST_BYTES: u64 = 256 << 20;
const MOST_MANIFEST_BYTES: u64 = 4 << 20;

/// What a folder of models holds.
#[derive(Debug, Clone)]
pub struct AssetFolder {
    pub(crate) assets: Vec<ImportedAsset>,
    /// BLAKE3 of the manifest and of each file that was read, by its name.
    pub files: BTreeMap<String, String>,
    /// What was skipped, and why.
    pub skipped: Vec<String>,
}

/// Why a folder of models cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum AssetFolderError {
    /// There is no manifest.
    #[error("{} has no assets.toml: write one that says what each .glb file is (see docs/assets.md)", folder.display())]
    NoManifest {
        /// The folder.
        folder: PathBuf,
    },
    /// The manifest names nothing.
    #[error("{} names no file: add an [[asset]] for each .glb file (see docs/assets.md)", path.display())]
    Nothing {
        /// The manifest.
        path: PathBuf,
    },
    /// A file cannot be read.
    #[error("cannot read {}: {cause}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        cause: io::Error,
    },
    /// A file is not what the manifest says.
    #[error("{}:{sep}{cause}", path.display(), sep = if matches!(cause, ImportError::Manifest { .. }) { "" } else { " " })]
    Broken {
        /// The file.
        path: PathBuf,
        /// Why.
        cause: ImportError,
    },
    /// Two entries of one name.
    #[error("{}: two assets are called '{name}': give one of them another `name`", path.display())]
    Twice {
        /// The manifest.
        path: PathBuf,
        /// The name.
        name: String,
    },
}

fn read(path: &Path, most: u64) -> Result<Vec<u8>, AssetFolderError> {
    let unreadable = |cause| AssetFolderError::Unreadable { path: path.to_owned(), cause };
    let mut bytes = Vec::new();
    // One byte more than may be, so that what is longer is seen to be.
    fs::File::open(path).and_then(|f| f.take(most + 1).read_to_end(&mut bytes)).map_err(unreadable)?;
    Ok(bytes)
}

impl AssetFolder {
    /// Reads a folder; with `skip_broken`, what cannot be used is left out and told in [`Self::skipped`].
    ///
    /// # Errors
    /// When there is no manifest or it is wrong; without `skip_broken`, also when a file is.
    pub fn read(folder: &Path, skip_broken: bool) -> Result<Self, AssetFolderError> {
        let path = folder.join(MANIFEST);
        if !path.is_file() {
            return Err(AssetFolderError::NoManifest { folder: folder.to_owned() });
        }
        let bytes = read(&path, MOST_MANIFEST_BYTES)?;
        let broken = |cause| AssetFolderError::Broken { path: path.clone(), cause };
        let manifest = AssetManifest::parse(&String::from_utf8_lossy(&bytes)).map_err(broken)?;
        if manifest.assets.is_empty() {
            return Err(AssetFolderError::Nothing { path });
        }
        let mut found = Self { assets: vec![], files: BTreeMap::new(), skipped: vec![] };
        found.files.insert(MANIFEST.to_owned(), content_hash(&bytes));
        let mut names = Vec::new();
        for entry in &manifest.assets {
            let name = entry.asset_name();
            if names.contains(&name) {
                return Err(AssetFolderError::Twice { path, name });
            }
            names.push(name);
            match found.add(folder, entry) {
                Err(error) if skip_broken => found.skipped.push(error.to_string()),
                done => done?,
            }
        }
        Ok(found)
    }

    fn add(&mut self, folder: &Path, entry: &AssetEntry) -> Result<(), AssetFolderError> {
        let path = folder.join(&entry.file);
        let broken = |cause| AssetFolderError::Broken { path: path.clone(), cause };
        // The entry is judged first: it says which file is read.
        entry.check().map_err(broken)?;
        let bytes = read(&path, MOST_BYTES)?;
        let pictures = RefCell::new(BTreeMap::new());
        let beside = |name: &str| {
            let inside = Path::new(name).components().all(|part| matches!(part, Component::Normal(_)));
            let bytes = inside.then(|| read(&folder.join(name), MOST_BYTES).ok()).flatten()?;
            pictures.borrow_mut().insert(name.to_owned(), content_hash(&bytes));
            Some(bytes)
        };
        self.assets.push(entry.import(&bytes, &beside).map_err(broken)?);
        self.files.append(&mut pictures.into_inner());
        self.files.insert(entry.file.clone(), content_hash(&bytes));
        Ok(())
    }
}
