//! An export from its beginning to its end.

use crate::{
    ClassMapping, ExportError, Format, Placing, SourceDataset, SplitBy, SplitShares,
    job::Export,
    parts,
    target::{Opened, Target},
};
use endless_dataset::Layer;
use serde_json::json;
use std::{
    fmt,
    path::{Path, PathBuf},
    sync::atomic::AtomicU64,
};

/// What is asked for.
#[derive(Clone)]
pub struct ExportOptions<'a> {
    /// The format.
    pub format: Format,
    /// The folder to write, which does not exist yet, is empty, or holds the same export unfinished.
    pub to: PathBuf,
    /// Parts; four fifths for training and one for validation where nothing is said and there are two videos.
    pub split: Option<SplitShares>,
    /// What stays together when they are divided.
    pub by: SplitBy,
    /// The classes.
    pub classes: ClassMapping,
    /// Objects of which less can be seen are left out, 0 to 1.
    pub min_visibility: f64,
    /// Of the frames of each camera every so many are exported.
    pub stride: u32,
    /// How images get there.
    pub placing: Placing,
    /// Told how many frames are done, and of how many, by any thread.
    pub progress: Option<&'a (dyn Fn(u64, u64) + Sync)>,
}

impl ExportOptions<'_> {
    /// The usual: all frames and classes, in parts by video, with links to pictures.
    pub fn new(format: Format, to: PathBuf) -> Self {
        Self {
            format,
            to,
            split: None,
            by: SplitBy::Video,
            classes: ClassMapping::default(),
            min_visibility: 0.0,
            stride: 1,
            placing: Placing::Link,
            progress: None,
        }
    }
}

impl fmt::Debug for ExportOptions<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ExportOptions").field("format", &self.format).field("to", &self.to).finish_non_exhaustive()
    }
}

/// What was exported.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExportReport {
    /// Whether it had been there already.
    pub complete_before: bool,
    /// Videos.
    pub videos: usize,
    /// Frames of all cameras.
    pub frames: u64,
    /// Names of the parts, with the videos and the frames of each.
    pub splits: Vec<(String, usize, u64)>,
}

/// Exports the complete videos of a dataset, on the threads of the current pool. An export that was interrupted goes on with
/// the first video that is not done.
///
/// # Errors
/// When the dataset cannot be read or has not what the format needs, when it cannot be split so, or when the target is taken or
/// cannot be written. What is written stays, and the same call goes on with it.
pub fn export(root: &Path, options: &ExportOptions<'_>) -> Result<ExportReport, ExportError> {
    let dataset = SourceDataset::open(root, options.stride)?;
    needs_layers(&dataset, options.format)?;
    let (seed, videos) = (dataset.manifest.seed, dataset.videos().count());
    let (shares, split_of) = parts::divide(&dataset, options.split.as_ref(), options.by)?;
    let exporter = (options.format.entry().exporter)();
    exporter.fits(&dataset)?;
    let asked = json!({
        "tool": "endless export",
        "format": options.format.name(),
        "dataset": {
            "seed": seed,
            "builds": dataset.manifest.builds,
            "recipe": dataset.manifest.recipe,
            "videos": dataset.videos().map(|video| video[0].video.name.clone()).collect::<Vec<_>>(),
        },
        "split": shares,
        "by": options.by,
        "classes": options.classes,
        "min_visibility": options.min_visibility,
        "stride": options.stride,
        "placing": options.placing,
    });
    let counts = |split: usize| {
        let own = || split_of.iter().zip(&dataset.sequences).filter(|(part, _)| **part == split);
        let mut numbers: Vec<u32> = own().map(|(_, sequence)| sequence.video.video).collect();
        numbers.dedup();
        (numbers.len(), own().map(|(_, sequence)| sequence.len() as u64).sum::<u64>())
    };
    let splits = shares.names().into_iter().enumerate().map(|(place, name)| {
        let (videos, frames) = counts(place);
        (name, videos, frames)
    });
    let report = ExportReport {
        complete_before: false,
        videos,
        frames: dataset.sequences.iter().map(|sequence| sequence.len() as u64).sum(),
        splits: splits.collect(),
    };
    let target = match Target::open(&options.to, &asked)? {
        Opened::Open(target) => target,
        Opened::Complete => return Ok(ExportReport { complete_before: true, ..report }),
    };
    let export = Export {
        dataset: &dataset,
        splits: shares.names(),
        split_of,
        classes: &options.classes,
        min_visibility: options.min_visibility,
        placing: options.placing,
        target: &target,
        done: AtomicU64::new(0),
        progress: options.progress,
    };
    // One after another, so that memory holds a few frames only: the frames of each keep all threads busy.
    for video in export.videos() {
        if target.is_done(video.number) {
            export.advance(video.sequences().map(|(_, sequence)| sequence.len() as u64).sum());
        } else {
            exporter.video(&video)?;
            target.set_done(video.number)?;
        }
    }
    exporter.finish(&export)?;
    drop(export);
    target.finish(&asked)?;
    Ok(report)
}

/// Whether every camera has the layers that a format needs.
fn needs_layers(dataset: &SourceDataset, format: Format) -> Result<(), ExportError> {
    for &layer in format.entry().layers {
        if let Some(sequence) = dataset.sequences.iter().find(|s| !s.output.layers.contains(&layer)) {
            let stored = &sequence.output.layers;
            let wanted = Layer::ALL.iter().filter(|l| stored.contains(l) || format.entry().layers.contains(l));
            return Err(ExportError::MissingLayer {
                format: format.name(),
                layer,
                sequence: sequence.name(),
                wanted: wanted.map(|l| l.name()).collect::<Vec<_>>().join(","),
            });
        }
    }
    Ok(())
}
