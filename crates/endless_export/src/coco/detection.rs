//! COCO's instances: `annotations/instances_train.json` beside `images/train/`, or as Roboflow lays it out.

use super::{
    annotation::{Masks, annotation, instance_if_labelled},
    document::{Document, categories, line, write_parts},
};
use crate::{
    ExportError,
    exporter::Exporter,
    job::{Export, VideoJob},
};

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
        write_parts(video, &self.folder(video.split()), [IMAGES, ANNOTATIONS], |frame, id| {
            let Some(instance) = instance_if_labelled(frame)? else { return Ok(String::new()) };
            let entry = |label| line(&annotation(video.export, id, label, &instance, self.masks));
            Ok(frame.labels.iter().map(entry).collect())
        })
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
