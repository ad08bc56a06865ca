//! What an exporter is given: the whole export, and one video of it after another, frame by frame.

use crate::{ClassMapping, ExportError, LabelledFrame, Placing, Sequence, SourceDataset, target::Target};
use endless_annotate::FrameObjects;
use endless_dataset::{AtomicFile, DatasetError, Layer};
use rayon::prelude::*;
use std::{
    fmt,
    fs::File,
    io::{BufRead, BufReader, Lines},
    ops::Range,
    sync::atomic::{AtomicU64, Ordering},
};

/// Instants that are worked on at a time, by all threads together.
const CHUNK: usize = 32;

/// All that exporters know of an export.
pub(crate) struct Export<'a> {
    pub(crate) dataset: &'a SourceDataset,
    /// Names of the parts.
    pub(crate) splits: Vec<String>,
    /// Part of each sequence.
    pub(crate) split_of: Vec<usize>,
    pub(crate) classes: &'a ClassMapping,
    pub(crate) min_visibility: f64,
    pub(crate) placing: Placing,
    pub(crate) target: &'a Target,
    pub(crate) done: AtomicU64,
    /// Told how many frames are done, and of how many.
    pub(crate) progress: Option<&'a (dyn Fn(u64, u64) + Sync)>,
}

impl fmt::Debug for Export<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Export").field("splits", &self.splits).finish_non_exhaustive()
    }
}

impl<'a> Export<'a> {
    /// The videos in order.
    pub(crate) fn videos(&'a self) -> Vec<VideoJob<'a>> {
        let mut start = 0;
        let range = |sequences: &[Sequence]| {
            let range = start..start + sequences.len();
            start = range.end;
            range
        };
        let ranges: Vec<Range<usize>> = self.dataset.videos().map(range).collect();
        ranges.into_iter().enumerate().map(|(number, range)| VideoJob { export: self, number, range }).collect()
    }

    /// The videos of a part.
    pub(crate) fn videos_of(&'a self, split: usize) -> impl Iterator<Item = VideoJob<'a>> {
        self.videos().into_iter().filter(move |video| self.split_of[video.range.start] == split)
    }

    /// The part of a sequence.
    pub(crate) fn split_name(&self, sequence: usize) -> &str {
        &self.splits[self.split_of[sequence]]
    }

    /// Exported frames of the whole dataset before those of a sequence.
    pub(crate) fn frames_before(&self, sequence: usize) -> usize {
        self.dataset.sequences[..sequence].iter().map(Sequence::len).sum()
    }

    /// Exported frames of all cameras.
    pub(crate) fn frames(&self) -> u64 {
        self.dataset.sequences.iter().map(|sequence| sequence.len() as u64).sum()
    }

    /// So many frames more are done.
    pub(crate) fn advance(&self, frames: u64) {
        let done = self.done.fetch_add(frames, Ordering::Relaxed) + frames;
        if let Some(progress) = self.progress {
            progress(done, self.frames());
        }
    }

    /// Joins the parts of the videos of a part of the dataset, line by line.
    pub(crate) fn lines_of(
        &'a self,
        part: &'static str,
        split: usize,
    ) -> impl Iterator<Item = Result<String, ExportError>> + use<'a> {
        self.videos_of(split).flat_map(move |video| match self.target.part_lines(part, video.number) {
            Ok(lines) => Box::new(lines) as Box<dyn Iterator<Item = _>>,
            Err(error) => Box::new(std::iter::once(Err(error))),
        })
    }
}

/// One video of an export.
#[derive(Debug, Clone)]
pub(crate) struct VideoJob<'a> {
    pub(crate) export: &'a Export<'a>,
    /// Place among the videos of the export.
    pub(crate) number: usize,
    /// Its sequences among those of the dataset.
    pub(crate) range: Range<usize>,
}

impl<'a> VideoJob<'a> {
    /// Its sequences, with their places among those of the dataset.
    pub(crate) fn sequences(&self) -> impl Iterator<Item = (usize, &'a Sequence)> + use<'a> {
        let sequences = &self.export.dataset.sequences;
        self.range.clone().map(move |place| (place, &sequences[place]))
    }

    /// The name of its part.
    pub(crate) fn split(&self) -> &'a str {
        self.export.split_name(self.range.start)
    }

    /// Puts an image of a frame below the target.
    pub(crate) fn place_image(&self, frame: &LabelledFrame<'_>, layer: Layer, below: &str) -> Result<(), ExportError> {
        let target = self.export.target.path(below)?;
        self.export.placing.place(&frame.sequence.image(layer, frame.frame), &target)
    }

    /// Begins what this video has to say in a file that comes of several.
    pub(crate) fn create_part(&self, name: &str) -> Result<AtomicFile, ExportError> {
        self.export.target.create_part(name, self.number)
    }

    /// Makes something of every frame of a sequence, on all threads, and takes it in order.
    pub(crate) fn frames<T: Send>(
        &self,
        sequence: &Sequence,
        make: impl Fn(&LabelledFrame<'_>) -> Result<T, ExportError> + Sync,
        mut take: impl FnMut(T) -> Result<(), ExportError>,
    ) -> Result<(), ExportError> {
        let make = |frames: &[LabelledFrame<'_>]| frames.iter().map(&make).collect::<Result<Vec<T>, _>>();
        self.instants(&[sequence], make, |made: Vec<T>| made.into_iter().try_for_each(&mut take))
    }

    /// Makes something of every instant, of the frames of all these sequences at it, and takes it in order.
    pub(crate) fn instants<T: Send>(
        &self,
        sequences: &[&Sequence],
        make: impl Fn(&[LabelledFrame<'_>]) -> Result<T, ExportError> + Sync,
        mut take: impl FnMut(T) -> Result<(), ExportError>,
    ) -> Result<(), ExportError> {
        let mut readers = sequences.iter().map(|s| LabelLines::open(s)).collect::<Result<Vec<_>, _>>()?;
        loop {
            let mut chunk: Vec<Vec<FrameLine<'_>>> = Vec::with_capacity(CHUNK);
            while chunk.len() < CHUNK
                && let Some(first) = readers.iter().filter_map(LabelLines::next_frame).min()
            {
                let due = readers.iter_mut().filter(|reader| reader.next_frame() == Some(first));
                chunk.push(due.map(LabelLines::read).collect::<Result<_, _>>()?);
            }
            if chunk.is_empty() {
                return Ok(());
            }
            let frames: u64 = chunk.iter().map(|lines| lines.len() as u64).sum();
            let made: Vec<Result<T, ExportError>> = chunk
                .into_par_iter()
                .map(|lines| {
                    let labelled = lines.into_iter().map(|line| line.parse(self.export));
                    make(&labelled.collect::<Result<Vec<_>, _>>()?)
                })
                .collect();
            made.into_iter().try_for_each(|made| take(made?))?;
            self.export.advance(frames);
        }
    }
}

/// The lines of `objects.jsonl` that are exported, one after another.
struct LabelLines<'s> {
    sequence: &'s Sequence,
    lines: Lines<BufReader<File>>,
    /// Frames that are still to be read, with their places.
    frames: Box<dyn ExactSizeIterator<Item = u32>>,
    place: usize,
    next: Option<u32>,
}

/// A line that is not parsed yet.
struct FrameLine<'s> {
    sequence: &'s Sequence,
    place: usize,
    frame: u32,
    text: String,
}

impl<'s> LabelLines<'s> {
    fn open(sequence: &'s Sequence) -> Result<Self, ExportError> {
        let path = sequence.files.objects();
        let file = File::open(&path).map_err(|e| DatasetError::io("cannot read", &path, e))?;
        let lines = BufReader::with_capacity(1 << 16, file).lines();
        let mut frames: Box<dyn ExactSizeIterator<Item = u32>> = Box::new(sequence.frames());
        let next = frames.next();
        Ok(Self { sequence, lines, frames, place: 0, next })
    }

    fn next_frame(&self) -> Option<u32> {
        self.next
    }

    fn read(&mut self) -> Result<FrameLine<'s>, ExportError> {
        let path = || self.sequence.files.objects();
        let skipped = if self.place == 0 { 0 } else { self.sequence.stride.max(1) as usize - 1 };
        let text = self
            .lines
            .nth(skipped)
            .ok_or_else(|| DatasetError::malformed(path(), "has fewer lines than there are frames"))?
            .map_err(|e| DatasetError::io("cannot read", path(), e))?;
        let frame = self.next.unwrap_or_default();
        let line = FrameLine { sequence: self.sequence, place: self.place, frame, text };
        self.place += 1;
        self.next = self.frames.next();
        Ok(line)
    }
}

impl<'s> FrameLine<'s> {
    fn parse(self, export: &Export<'_>) -> Result<LabelledFrame<'s>, ExportError> {
        let wrong = |reason: String| DatasetError::malformed(self.sequence.files.objects(), reason);
        let line: FrameObjects =
            serde_json::from_str(&self.text).map_err(|e| wrong(format!("the line of frame {}: {e}", self.frame)))?;
        if line.frame != self.frame {
            return Err(wrong(format!("has frame {} in place of frame {}", line.frame, self.frame)).into());
        }
        LabelledFrame::new(self.sequence, self.place, line, export.classes, export.min_visibility)
    }
}
