//! Who is who in all videos.

use crate::{ExportError, Sequence, SourceDataset, job::Export};
use endless_annotate::ActorRecord;
use endless_dataset::{DatasetLayout, read_actors};
use endless_world::{InstanceId, ObjectClass};
use std::{
    collections::{BTreeMap, BTreeSet},
    sync::OnceLock,
};

/// The number of each look.
#[derive(Debug)]
pub(super) struct Identities {
    /// From 1, in the order in which videos and ids come.
    numbers: BTreeMap<String, u32>,
    /// Those of the training part.
    trained: BTreeSet<String>,
}

/// Name of the part that is learnt: `train` where there is one.
pub(super) fn training_split(export: &Export<'_>) -> usize {
    export.splits.iter().position(|name| name == "train").unwrap_or(0)
}

/// Whether each video tells who is who.
pub(super) fn told_by(format: &'static str, dataset: &SourceDataset) -> Result<(), ExportError> {
    let actors = |sequence: &Sequence| dataset.layout.video_named(&sequence.video.name).actors();
    match dataset.sequences.iter().find(|sequence| !actors(sequence).is_file()) {
        None => Ok(()),
        Some(sequence) => Err(ExportError::Unfit {
            format,
            sequence: sequence.name(),
            reason: "it has no actors.json, which tells who is who".into(),
        }),
    }
}

/// The look of each object of a video that is of one of these classes.
pub(super) fn looks(
    export: &Export<'_>,
    video: &str,
    classes: &[ObjectClass],
) -> Result<BTreeMap<InstanceId, ActorRecord>, ExportError> {
    let layout: &DatasetLayout = &export.dataset.layout;
    let actors = read_actors(&layout.video_named(video).actors())?;
    let wanted = actors.into_iter().filter(|actor| classes.contains(&actor.class) && actor.reid.is_some());
    Ok(wanted.map(|actor| (actor.id, actor)).collect())
}

/// The word of a look.
pub(super) fn look(actor: &ActorRecord) -> String {
    actor.reid.as_ref().map(ToString::to_string).unwrap_or_default()
}

/// The same, read for the first video and kept for the others.
#[derive(Debug, Default)]
pub(super) struct KnownIdentities(OnceLock<Identities>);

impl KnownIdentities {
    /// Of all videos.
    pub(super) fn of(&self, export: &Export<'_>, classes: &[ObjectClass]) -> Result<&Identities, ExportError> {
        if let Some(known) = self.0.get() {
            return Ok(known);
        }
        let read = Identities::read(export, classes)?;
        Ok(self.0.get_or_init(|| read))
    }
}

impl Identities {
    /// Of all videos.
    fn read(export: &Export<'_>, classes: &[ObjectClass]) -> Result<Self, ExportError> {
        let (mut numbers, mut trained) = (BTreeMap::new(), BTreeSet::new());
        let training = training_split(export);
        for video in export.videos() {
            let name = &export.dataset.sequences[video.range.start].video.name;
            for actor in looks(export, name, classes)?.values() {
                let (look, next) = (look(actor), numbers.len() as u32 + 1);
                numbers.entry(look.clone()).or_insert(next);
                if export.split_of[video.range.start] == training {
                    trained.insert(look);
                }
            }
        }
        Ok(Self { numbers, trained })
    }

    /// The number of a look in a part; none where another part has it.
    pub(super) fn number(&self, look: &str, training: bool) -> Option<u32> {
        if training || !self.trained.contains(look) { self.numbers.get(look).copied() } else { None }
    }
}
