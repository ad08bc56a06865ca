//! Pascal VOC: `Annotations/NAME.xml`, `JPEGImages/NAME.jpg` (or `.png`), `ImageSets/Main/train.txt`, and `labelmap.txt` as
//! CVAT and Datumaro read it.
//!
//! Corners of boxes are counted from 1 and belong to the box (Everingham et al. 2010, "VOC2012 Development Kit", section 9).

use crate::{
    ExportClass, ExportError, Label, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
    xml::escaped,
};
use endless_dataset::Layer;
use std::fmt::Write as _;

/// Boxes in XML.
#[derive(Debug)]
pub(crate) struct PascalVoc;

const NAMES: &str = "names";
/// Of what less can be seen is hard to find.
const DIFFICULT: f64 = 0.25;

fn object(label: &Label, export: &Export<'_>) -> String {
    let [x, y, w, h] = <[u32; 4]>::from(label.object.bbox);
    let flag = |set: bool| u8::from(set);
    format!(
        "\t<object>\n\t\t<name>{}</name>\n\t\t<pose>Unspecified</pose>\n\t\t<truncated>{}</truncated>\n\
         \t\t<occluded>{}</occluded>\n\t\t<difficult>{}</difficult>\n\t\t<bndbox>\n\t\t\t<xmin>{}</xmin>\n\
         \t\t\t<ymin>{}</ymin>\n\t\t\t<xmax>{}</xmax>\n\t\t\t<ymax>{}</ymax>\n\t\t</bndbox>\n\t\t<track_id>{}</track_id>\n\
         \t</object>\n",
        escaped(&export.classes.classes[label.class].name),
        flag(label.object.truncated),
        flag(label.is_occluded()),
        flag(label.visibility() < DIFFICULT),
        x + 1,
        y + 1,
        x + w,
        y + h,
        label.object.id,
    )
}

fn annotation(frame: &LabelledFrame<'_>, file: &str, export: &Export<'_>) -> String {
    let size = frame.sequence.output.size;
    let mut xml = String::from("<annotation>\n\t<folder>JPEGImages</folder>\n");
    // A string takes whatever is written to it.
    let _ = write!(
        xml,
        "\t<filename>{}</filename>\n\t<source>\n\t\t<database>endless</database>\n\t</source>\n\t<size>\n\t\t<width>{}</width>\n\
         \t\t<height>{}</height>\n\t\t<depth>3</depth>\n\t</size>\n\t<segmented>0</segmented>\n",
        escaped(file),
        size.width,
        size.height
    );
    xml.extend(frame.labels.iter().map(|label| object(label, export)));
    xml + "</annotation>\n"
}

impl Exporter for PascalVoc {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let mut names = video.create_part(NAMES)?;
        for (_, sequence) in video.sequences() {
            let make = |frame: &LabelledFrame<'_>| {
                let name = frame.name();
                let file = format!("{name}.{}", sequence.extension(Layer::Rgb));
                video.place_image(frame, Layer::Rgb, &format!("JPEGImages/{file}"))?;
                let xml = annotation(frame, &file, video.export);
                video.export.target.write(format!("Annotations/{name}.xml"), xml.as_bytes())?;
                Ok(name + "\n")
            };
            video.frames(sequence, make, |name| Ok(names.write(name.as_bytes())?))?;
        }
        Ok(names.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        for (split, name) in export.splits.iter().enumerate() {
            let mut file = export.target.create(format!("ImageSets/Main/{name}.txt"))?;
            for line in export.lines_of(NAMES, split) {
                file.write((line? + "\n").as_bytes())?;
            }
            file.finish()?;
        }
        let label = |class: &ExportClass| format!("{}:::\n", class.name.replace([':', '\n'], " "));
        let labels: String = export.classes.classes.iter().map(label).collect();
        export.target.write("labelmap.txt", format!("# label:color_rgb:parts:actions\n{labels}").as_bytes())
    }
}
