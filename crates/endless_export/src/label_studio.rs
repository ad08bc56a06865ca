//! Label Studio: `train.json`, a list of tasks with finished annotations, and the pictures in `train/`.
//!
//! Pictures are named as local files below the folder that Label Studio serves (`LOCAL_FILES_DOCUMENT_ROOT`). Numbers are percent of
//! the picture's size. `config.xml` is the labelling set-up.

use crate::{
    ExportError, Label, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
    xml::escaped,
};
use endless_dataset::Layer;
use serde_json::{Value, json};

/// Boxes for an annotation tool.
#[derive(Debug)]
pub(crate) struct LabelStudio;

const TASKS: &str = "tasks";

fn result(frame: &LabelledFrame<'_>, label: &Label, class: &str) -> Value {
    let size = frame.sequence.output.size;
    let [x, y, w, h] = <[u32; 4]>::from(label.object.bbox).map(f64::from);
    let [across, down] = [size.width, size.height].map(|side| 100.0 / f64::from(side));
    json!({
        "id": label.object.id.to_string(),
        "type": "rectanglelabels",
        "from_name": "label",
        "to_name": "image",
        "original_width": size.width,
        "original_height": size.height,
        "image_rotation": 0,
        "value": {"rotation": 0, "x": x * across, "y": y * down, "width": w * across, "height": h * down,
                  "rectanglelabels": [class]},
        "meta": {"track_id": label.object.id, "visibility": label.visibility(), "truncated": label.object.truncated},
    })
}

impl Exporter for LabelStudio {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let classes = &video.export.classes.classes;
        let mut tasks = video.create_part(TASKS)?;
        for (_, sequence) in video.sequences() {
            let make = |frame: &LabelledFrame<'_>| {
                let file = format!("{}/{}.{}", video.split(), frame.name(), sequence.extension(Layer::Rgb));
                video.place_image(frame, Layer::Rgb, &file)?;
                let results: Vec<Value> =
                    frame.labels.iter().map(|label| result(frame, label, &classes[label.class].name)).collect();
                let task = json!({
                    "data": {
                        "image": format!("/data/local-files/?d={file}"),
                        "video": sequence.video.name,
                        "camera": sequence.camera_name,
                        "frame": frame.frame,
                    },
                    "annotations": [{"result": results, "ground_truth": true}],
                });
                Ok(task.to_string() + "\n")
            };
            video.frames(sequence, make, |task| Ok(tasks.write(task.as_bytes())?))?;
        }
        Ok(tasks.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        for (split, name) in export.splits.iter().enumerate() {
            let mut file = export.target.create(format!("{name}.json"))?;
            file.write(b"[\n")?;
            for (place, line) in export.lines_of(TASKS, split).enumerate() {
                let comma = if place > 0 { ",\n" } else { "" };
                file.write(format!("{comma}{}", line?).as_bytes())?;
            }
            file.write(b"\n]\n")?;
            file.finish()?;
        }
        let labels: String = export
            .classes
            .classes
            .iter()
            .map(|class| format!("    <Label value=\"{}\"/>\n", escaped(&class.name)))
            .collect();
        let config = format!(
            "<View>\n  <Image name=\"image\" value=\"$image\"/>\n  <RectangleLabels name=\"label\" toName=\"image\">\n{labels}  \
             </RectangleLabels>\n</View>\n"
        );
        export.target.write("config.xml", config.as_bytes())
    }
}
