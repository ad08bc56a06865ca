//! Datasets to look at, and a server that shows them.

use endless_view::{Stopper, ViewSettings, Viewer};
use serde_json::Value;
use std::{
    fs,
    net::SocketAddr,
    path::{Path, PathBuf},
    thread::JoinHandle,
};
use tempfile::TempDir;

/// A dataset with all layers: one video of one camera, two frames.
pub(crate) const VIDEO: &str = "0000_Town10HD_cloudy_morning";
pub(crate) const FRAMES: u32 = 2;

/// A dataset in a folder of its own, beside a file that nobody may see.
#[derive(Debug)]
pub(crate) struct Fixture {
    _temporary: TempDir,
    pub(crate) out: PathBuf,
}

/// What stands in files that nobody may see.
pub(crate) const SECRET: &str = "nobody may see this";

impl Fixture {
    pub(crate) fn new() -> Self {
        let temporary = tempfile::tempdir().expect("temp");
        let out = temporary.path().join("out");
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../endless_fuzz/datasets/all_layers");
        copy(&source, &out);
        fs::write(temporary.path().join("secret.txt"), SECRET).expect("room");
        fs::write(out.join("secret.txt"), SECRET).expect("room");
        Self { _temporary: temporary, out }
    }

    pub(crate) fn video(&self) -> PathBuf {
        self.out.join("videos").join(VIDEO)
    }

    /// Changes `dataset.json`.
    pub(crate) fn change(&self, how: impl FnOnce(&mut Value)) {
        let path = self.out.join("dataset.json");
        let mut manifest = serde_json::from_slice(&fs::read(&path).expect("there")).expect("JSON");
        how(&mut manifest);
        // As it is written: under another name, then renamed.
        let temporary = self.out.join(".dataset.json.tmp");
        fs::write(&temporary, serde_json::to_vec_pretty(&manifest).expect("JSON")).expect("room");
        fs::rename(temporary, path).expect("room");
    }

    /// Adds a video that is a copy of the first, in whatever state.
    pub(crate) fn add_video(&self, number: u32, state: &str) -> PathBuf {
        let name = format!("{number:04}_Town10HD_cloudy_morning");
        let folder = self.out.join("videos").join(&name);
        copy(&self.video(), &folder);
        fs::copy(self.out.join("scenes/0000.json"), self.out.join(format!("scenes/{number:04}.json"))).expect("room");
        self.change(|manifest| {
            let mut entry = manifest["videos"][0].clone();
            entry["video"] = number.into();
            entry["name"] = name.into();
            entry["state"] = state.into();
            manifest["videos"].as_array_mut().expect("a list").push(entry);
        });
        folder
    }

    pub(crate) fn serve(&self) -> Served {
        Served::new(&self.out)
    }
}

/// A server that runs until it is dropped.
#[derive(Debug)]
pub(crate) struct Served {
    pub(crate) address: SocketAddr,
    stopper: Stopper,
    thread: Option<JoinHandle<()>>,
}

impl Served {
    pub(crate) fn new(folder: &Path) -> Self {
        let settings = ViewSettings { folder: folder.to_owned(), bind: [127, 0, 0, 1].into(), port: 0 };
        let viewer = Viewer::bind(&settings).expect("a dataset");
        let (address, stopper) = (viewer.address(), viewer.stopper());
        let thread = std::thread::spawn(move || viewer.run().expect("threads"));
        Self { address, stopper, thread: Some(thread) }
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        self.stopper.stop();
        if let Some(thread) = self.thread.take() {
            thread.join().expect("it ends");
        }
    }
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("room");
    for entry in fs::read_dir(from).expect("there") {
        let entry = entry.expect("there");
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), target).expect("room");
        }
    }
}
