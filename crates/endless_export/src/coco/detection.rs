//! COCO's instances: `annotations/instances_train.json` beside `images/train/`, or as Roboflow lays it out.

use super::{
    annotation::{Masks, annotation, instance_if_labelled},
    document::{CocoImage, Document, categories, image_id, line},
};
use crate::{
    ExportError, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_dataset::Layer;

/// Boxes and masks.
#[derive(Debug)]
pub(crate) struct CocoDetection {
    masks: Masks,
    /// Each part in a folder of its own, with its annotations beside its images.
    roboflow: bool,
}

const IMAGES: &str = "images";
const ANNOTATIONS: &str = "instances";

impl CocoDetection {
    /// COCO's own layout, with masks as run lengths.
    pub(crate) const RUN_LENGTHS: Self = Self { masks: Masks::RunLengths, roboflow: false };
    /// The same with polygons.
    pub(crate) const POLYGONS: Self = Self { masks: Masks::Polygons, roboflow: false };
    /// What Roboflow imports.
    pub(crate) const ROBOFLOW: Self = Self { masks: Masks::Polygons, roboflow: true };

    /// Folder of a part's pictures. Roboflow calls validation `valid`.
    fn folder(&self, split: &str) -> String {
        match (self.roboflow, split) {
            (true, "val") => "valid".into(),
            (true, other) => other.into(),
            (false, other) => format!("images/{other}"),
        }
    }
}

impl Exporter for CocoDetection {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let (mut images, mut annotations) = (video.create_part(IMAGES)?, video.create_part(ANNOTATIONS)?);
        let folder = self.folder(video.split());
        for (place, sequence) in video.sequences() {
            let before = video.export.frames_before(place);
            let make = |frame: &LabelledFrame<'_>| {
                let file_name = format!("{}.{}", frame.name(), sequence.extension(Layer::Rgb));
                video.place_image(frame, Layer::Rgb, &format!("{folder}/{file_name}"))?;
                let mut lines = String::new();
                if let Some(instance) = instance_if_labelled(frame)? {
                    let id = image_id(frame, before);
                    for label in &frame.labels {
                        lines.push_str(&line(&annotation(video.export, id, label, &instance, self.masks)));
                    }
                }
                Ok((line(&CocoImage::new(frame, before, file_name)), lines))
            };
            video.frames(sequence, make, |(image, lines)| {
                images.write(image.as_bytes())?;
                Ok(annotations.write(lines.as_bytes())?)
            })?;
        }
        images.finish()?;
        Ok(annotations.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        let categories = categories(export);
        for (split, name) in export.splits.iter().enumerate() {
            let path = if self.roboflow {
                format!("{}/_annotations.coco.json", self.folder(name))
            } else {
                format!("annotations/instances_{name}.json")
            };
            let document =
                Document { path, categories: &categories, images: IMAGES, annotations: ANNOTATIONS, numbered: true };
            document.write(export, split)?;
        }
        Ok(())
    }
}
