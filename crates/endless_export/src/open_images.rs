//! Open Images: `train-annotations-bbox.csv`, `class-descriptions-boxable.csv`, and the pictures in `train/`.
//!
//! Columns as in V6 and V7; corners are shares of the picture's size. A class is named by its machine id; classes that a mapping
//! chooses have ids of their own, `/endless/NAME`.

use crate::{
    ExportError, Label, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_dataset::Layer;
use endless_world::ObjectClass;

/// Boxes in CSV.
#[derive(Debug)]
pub(crate) struct OpenImages;

const BOXES: &str = "boxes";
const HEADER: &str = "ImageID,Source,LabelName,Confidence,XMin,XMax,YMin,YMax,IsOccluded,IsTruncated,IsGroupOf,IsDepiction,\
                      IsInside,TrackID\n";

/// Machine id and description of a class of the dataset.
fn described(class: ObjectClass) -> [&'static str; 2] {
    match class {
        ObjectClass::Car => ["/m/0k4j", "Car"],
        ObjectClass::Van => ["/m/0h2r6", "Van"],
        ObjectClass::Truck => ["/m/07r04", "Truck"],
        ObjectClass::Bus => ["/m/01bjv", "Bus"],
        ObjectClass::Motorcycle => ["/m/04_sv", "Motorcycle"],
        ObjectClass::Bicycle => ["/m/0199g", "Bicycle"],
        ObjectClass::Rider | ObjectClass::Pedestrian => ["/m/01g317", "Person"],
    }
}

/// As a field of CSV.
fn field(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.into() }
}

/// Machine id and description of a label's class.
fn class(export: &Export<'_>, place: usize) -> [String; 2] {
    let class = &export.classes.classes[place];
    match class.from.first().filter(|_| !export.classes.chosen) {
        Some(&own) => described(own).map(String::from),
        None => [field(&format!("/endless/{}", class.name)), field(&class.name)],
    }
}

fn line(frame: &LabelledFrame<'_>, label: &Label, export: &Export<'_>) -> String {
    let size = frame.sequence.output.size;
    let [x, y, w, h] = <[u32; 4]>::from(label.object.bbox);
    let [across, down] = [size.width, size.height].map(f64::from);
    let [left, right] = [x, x + w].map(|at| f64::from(at) / across);
    let [top, bottom] = [y, y + h].map(|at| f64::from(at) / down);
    let [id, _] = class(export, label.class);
    let (occluded, truncated) = (u8::from(label.is_occluded()), u8::from(label.object.truncated));
    format!(
        "{},endless,{id},1,{left:.6},{right:.6},{top:.6},{bottom:.6},{occluded},{truncated},0,0,0,{}\n",
        field(&frame.name()),
        label.object.id
    )
}

impl Exporter for OpenImages {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let mut boxes = video.create_part(BOXES)?;
        for (_, sequence) in video.sequences() {
            let make = |frame: &LabelledFrame<'_>| {
                let file = format!("{}/{}.{}", video.split(), frame.name(), sequence.extension(Layer::Rgb));
                video.place_image(frame, Layer::Rgb, &file)?;
                Ok(frame.labels.iter().map(|label| line(frame, label, video.export)).collect::<String>())
            };
            video.frames(sequence, make, |lines| Ok(boxes.write(lines.as_bytes())?))?;
        }
        Ok(boxes.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        for (split, name) in export.splits.iter().enumerate() {
            let mut file = export.target.create(format!("{name}-annotations-bbox.csv"))?;
            file.write(HEADER.as_bytes())?;
            for line in export.lines_of(BOXES, split) {
                file.write((line? + "\n").as_bytes())?;
            }
            file.finish()?;
        }
        let mut descriptions: Vec<[String; 2]> =
            (0..export.classes.classes.len()).map(|place| class(export, place)).collect();
        descriptions.dedup();
        let lines: String = descriptions.iter().map(|[id, name]| format!("{id},{name}\n")).collect();
        export.target.write("class-descriptions-boxable.csv", lines.as_bytes())
    }
}
