//! MOTChallenge: `gt/gt.txt` with `frame,id,left,top,width,height,flag,class,visibility`.

use super::sequence::{folder, place_picture, write_seqinfo, write_seqmaps};
use crate::{
    ExportError, Label, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_annotate::Action;
use endless_world::ObjectClass;

/// Boxes with tracks.
#[derive(Debug)]
pub(crate) struct Mot;

/// MOT16's number of a class.
fn class_number(label: &Label) -> u8 {
    match label.object.class {
        ObjectClass::Pedestrian if label.object.activity.action == Some(Action::Sitting) => 7,
        ObjectClass::Pedestrian => 1,
        ObjectClass::Rider => 2,
        ObjectClass::Car | ObjectClass::Van | ObjectClass::Truck | ObjectClass::Bus => 3,
        ObjectClass::Bicycle => 4,
        ObjectClass::Motorcycle => 5,
    }
}

fn line(place: usize, label: &Label) -> String {
    let [x, y, w, h] = <[u32; 4]>::from(label.object.bbox);
    let (id, class, visibility) = (label.object.id, class_number(label), label.visibility());
    format!("{},{id},{},{},{w},{h},1,{class},{visibility}\n", place + 1, x + 1, y + 1)
}

impl Exporter for Mot {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        for (_, sequence) in video.sequences() {
            write_seqinfo(video, sequence)?;
            let mut gt = video.export.target.create(format!("{}/gt/gt.txt", folder(video.split(), sequence)))?;
            let make = |frame: &LabelledFrame<'_>| {
                place_picture(video, frame)?;
                Ok(frame.labels.iter().map(|label| line(frame.place, label)).collect::<String>())
            };
            video.frames(sequence, make, |lines| Ok(gt.write(lines.as_bytes())?))?;
            gt.finish()?;
        }
        Ok(())
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        write_seqmaps(export)
    }
}
