//! MOTS: `gt/gt.txt` with `frame id class height width rle`; cars are class 1, people class 2, all else is to be ignored.

use super::sequence::{folder, place_picture, write_seqinfo, write_seqmaps};
use crate::{
    ExportError, Label, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_annotate::visible_mask;
use endless_world::{InstanceId, ObjectClass};
use std::collections::BTreeMap;

/// Masks with tracks.
#[derive(Debug)]
pub(crate) struct Mots;

const CAR: u32 = 1;
const PERSON: u32 = 2;
/// Pixels of this class are neither right nor wrong.
const IGNORED: u32 = 10;
/// Tracks of a class: an id is `1000 class + number`.
const TRACKS: u32 = 1000;
/// Where a sequence has more of them, the others are numbered so that no id is there twice.
const FURTHER_TRACKS: u32 = 100_000;

fn track_id(class: u32, number: u32) -> u32 {
    class * if number < TRACKS { TRACKS } else { FURTHER_TRACKS } + number
}

fn class_number(label: &Label) -> u32 {
    match label.object.class {
        ObjectClass::Car | ObjectClass::Van => CAR,
        ObjectClass::Pedestrian => PERSON,
        _ => IGNORED,
    }
}

/// What a frame shows of a track.
struct Seen {
    id: InstanceId,
    class: u32,
    mask: String,
}

impl Exporter for Mots {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        for (_, sequence) in video.sequences() {
            write_seqinfo(video, sequence)?;
            let mut numbers: BTreeMap<(u32, InstanceId), u32> = BTreeMap::new();
            let mut counts: BTreeMap<u32, u32> = BTreeMap::new();
            let mut gt = video.export.target.create(format!("{}/gt/gt.txt", folder(video.split(), sequence)))?;
            let size = sequence.output.size;
            let make = |frame: &LabelledFrame<'_>| {
                place_picture(video, frame)?;
                if frame.labels.is_empty() {
                    return Ok((frame.place, Vec::new()));
                }
                let instance = frame.instance()?;
                let seen = |label: &Label| {
                    let object = &label.object;
                    let mask = visible_mask(&instance, object.id, object.bbox);
                    Seen { id: object.id, class: class_number(label), mask }
                };
                Ok((frame.place, frame.labels.iter().map(seen).collect()))
            };
            video.frames(sequence, make, |(place, seen): (usize, Vec<Seen>)| {
                for Seen { id, class, mask } in seen {
                    let count = counts.entry(class).or_default();
                    let number = *numbers.entry((class, id)).or_insert_with(|| {
                        *count += 1;
                        *count - 1
                    });
                    let id = track_id(class, number);
                    let line = format!("{} {id} {class} {} {} {mask}\n", place + 1, size.height, size.width);
                    gt.write(line.as_bytes())?;
                }
                Ok(())
            })?;
            gt.finish()?;
        }
        Ok(())
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        write_seqmaps(export)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_tracks_have_one_id() {
        let ids = [CAR, PERSON, IGNORED].map(|class| (0..3000).map(move |number| track_id(class, number)));
        let ids: Vec<u32> = ids.into_iter().flatten().collect();
        let distinct: std::collections::BTreeSet<u32> = ids.iter().copied().collect();
        assert_eq!((distinct.len(), ids[7]), (ids.len(), 1007));
    }
}
