//! Cuts objects out of pictures.

use super::identities::{Identities, look, looks, training_split};
use crate::{
    ExportError, LabelledFrame,
    job::{Export, VideoJob},
};
use endless_annotate::ActorRecord;
use endless_dataset::{DatasetError, Layer, encode_jpg};
use endless_world::{Image, ImageSize, ObjectClass};
use std::collections::BTreeSet;

/// Of what less can be seen is left out.
const MIN_VISIBILITY: f64 = 0.5;
/// What is narrower or lower is left out, pixels.
const MIN_SIDE: u32 = 16;
const MIN_HEIGHT: u32 = 32;

/// What a crop is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Train,
    /// The first of an identity from a camera of a video.
    Query,
    Gallery,
}

/// An object cut out.
pub(super) struct Crop {
    pub(super) identity: u32,
    pub(super) actor: ActorRecord,
    pub(super) frame: u32,
    /// Place of its sequence in the dataset.
    pub(super) sequence: usize,
    pub(super) jpg: Vec<u8>,
}

/// Takes the crops of a video in order.
pub(super) fn crops(
    video: &VideoJob<'_>,
    identities: &Identities,
    classes: &[ObjectClass],
    mut take: impl FnMut(Crop, Role) -> Result<(), ExportError>,
) -> Result<(), ExportError> {
    let export: &Export<'_> = video.export;
    let training = export.split_of[video.range.start] == training_split(export);
    let name = &export.dataset.sequences[video.range.start].video.name;
    let actors = looks(export, name, classes)?;
    let mut queried: BTreeSet<(u32, usize)> = BTreeSet::new();
    for (place, sequence) in video.sequences() {
        let make = |frame: &LabelledFrame<'_>| {
            let fit = |label: &&crate::Label| {
                let b = label.object.bbox;
                !label.object.truncated && label.visibility() >= MIN_VISIBILITY && b.w >= MIN_SIDE && b.h >= MIN_HEIGHT
            };
            let known = |label: &crate::Label| {
                let actor = actors.get(&label.object.id)?;
                Some((identities.number(&look(actor), training)?, actor, label.object.bbox))
            };
            let found: Vec<_> = frame.labels.iter().filter(fit).filter_map(known).collect();
            if found.is_empty() {
                return Ok(Vec::new());
            }
            let wrong = |reason: String| DatasetError::malformed(sequence.image(Layer::Rgb, frame.frame), reason);
            let stored = frame.read(Layer::Rgb)?;
            let image = stored.rgb8().map_err(wrong)?;
            let mut crops = Vec::new();
            for (identity, actor, bbox) in found {
                let row = |y: u32| {
                    let start = (y * image.size.width + bbox.x) as usize;
                    &image.data[start..start + bbox.w as usize]
                };
                let data = (bbox.y..bbox.y + bbox.h).flat_map(row).copied().collect();
                let cut = Image { size: ImageSize { width: bbox.w, height: bbox.h }, data };
                let jpg = encode_jpg(&cut).map_err(wrong)?;
                crops.push(Crop { identity, actor: actor.clone(), frame: frame.frame, sequence: place, jpg });
            }
            Ok(crops)
        };
        video.frames(sequence, make, |crops: Vec<Crop>| {
            for crop in crops {
                let role = if training {
                    Role::Train
                } else if queried.insert((crop.identity, place)) {
                    Role::Query
                } else {
                    Role::Gallery
                };
                take(crop, role)?;
            }
            Ok(())
        })?;
    }
    Ok(())
}
