//! CVAT for images 1.1: `train/annotations.xml` beside `train/images/`. Boxes have attributes for the track, what can be seen of
//! the object, and whether it is cut by the picture's edge.

use crate::{
    ExportError, Label, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
    xml::escaped,
};
use endless_dataset::Layer;
use std::fmt::Write as _;

/// Boxes for an annotation tool.
#[derive(Debug)]
pub(crate) struct Cvat;

const IMAGES: &str = "images";

fn shape(label: &Label, class: &str) -> String {
    let [x, y, w, h] = <[u32; 4]>::from(label.object.bbox);
    format!(
        "<box label=\"{}\" source=\"file\" occluded=\"{}\" xtl=\"{x}.00\" ytl=\"{y}.00\" xbr=\"{}.00\" ybr=\"{}.00\" z_order=\"0\">\
         <attribute name=\"track_id\">{}</attribute><attribute name=\"visibility\">{}</attribute>\
         <attribute name=\"truncated\">{}</attribute></box>",
        escaped(class),
        u8::from(label.is_occluded()),
        x + w,
        y + h,
        label.object.id,
        label.visibility(),
        label.object.truncated,
    )
}

/// What the file says of the job: its labels and their attributes.
fn meta(export: &Export<'_>, name: &str) -> String {
    let mut xml = format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<annotations>\n<version>1.1</version>\n<meta><task><name>{}</name>\
         <mode>annotation</mode><labels>",
        escaped(name)
    );
    for class in &export.classes.classes {
        // A string takes whatever is written to it.
        let _ = write!(xml, "<label><name>{}</name><attributes>", escaped(&class.name));
        for (attribute, kind, value) in
            [("track_id", "number", "0"), ("visibility", "number", "1"), ("truncated", "checkbox", "false")]
        {
            let values = if kind == "number" { "0;65535;1" } else { "false" };
            let _ = write!(
                xml,
                "<attribute><name>{attribute}</name><mutable>True</mutable><input_type>{kind}</input_type>\
                 <default_value>{value}</default_value><values>{values}</values></attribute>"
            );
        }
        xml.push_str("</attributes></label>");
    }
    xml + "</labels></task></meta>\n"
}

impl Exporter for Cvat {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let export = video.export;
        let mut images = video.create_part(IMAGES)?;
        for (place, sequence) in video.sequences() {
            let before = export.frames_before(place);
            let size = sequence.output.size;
            let make = |frame: &LabelledFrame<'_>| {
                let file = format!("{}.{}", frame.name(), sequence.extension(Layer::Rgb));
                video.place_image(frame, Layer::Rgb, &format!("{}/images/{file}", video.split()))?;
                let boxes: String =
                    frame.labels.iter().map(|label| shape(label, &export.classes.classes[label.class].name)).collect();
                let id = before + frame.place;
                let name = escaped(&file);
                let (width, height) = (size.width, size.height);
                Ok(format!(
                    "<image id=\"{id}\" name=\"{name}\" width=\"{width}\" height=\"{height}\">{boxes}</image>\n"
                ))
            };
            video.frames(sequence, make, |image| Ok(images.write(image.as_bytes())?))?;
        }
        Ok(images.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        for (split, name) in export.splits.iter().enumerate() {
            let mut file = export.target.create(format!("{name}/annotations.xml"))?;
            file.write(meta(export, name).as_bytes())?;
            for line in export.lines_of(IMAGES, split) {
                file.write((line? + "\n").as_bytes())?;
            }
            file.write(b"</annotations>\n")?;
            file.finish()?;
        }
        Ok(())
    }
}
