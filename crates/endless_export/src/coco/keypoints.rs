//! COCO's person keypoints: `annotations/person_keypoints_train.json`.

use super::{
    annotation::{Masks, annotation, instance_if_labelled},
    document::{CocoImage, Document, image_id, line},
};
use crate::{
    ExportError, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_dataset::Layer;
use endless_world::{KEYPOINT_LIMBS, KEYPOINTS};
use serde_json::json;

/// People and riders with their keypoints, one category.
#[derive(Debug)]
pub(crate) struct CocoKeypoints;

const IMAGES: &str = "images";
const ANNOTATIONS: &str = "keypoints";

impl Exporter for CocoKeypoints {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let (mut images, mut annotations) = (video.create_part(IMAGES)?, video.create_part(ANNOTATIONS)?);
        for (place, sequence) in video.sequences() {
            let before = video.export.frames_before(place);
            let make = |frame: &LabelledFrame<'_>| {
                let file_name = format!("{}.{}", frame.name(), sequence.extension(Layer::Rgb));
                video.place_image(frame, Layer::Rgb, &format!("images/{}/{file_name}", video.split()))?;
                let mut lines = String::new();
                if let Some(instance) = instance_if_labelled(frame)? {
                    let id = image_id(frame, before);
                    for label in frame.labels.iter().filter(|label| label.object.keypoints.is_some()) {
                        let mut entry = annotation(video.export, id, label, &instance, Masks::RunLengths);
                        entry.insert("category_id".into(), json!(1));
                        entry.insert("keypoints".into(), json!(label.object.keypoints));
                        entry.insert("num_keypoints".into(), json!(label.object.num_keypoints));
                        lines.push_str(&line(&entry));
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
        let categories = [json!({
            "id": 1, "name": "person", "supercategory": "person", "keypoints": KEYPOINTS, "skeleton": KEYPOINT_LIMBS,
        })];
        for (split, name) in export.splits.iter().enumerate() {
            let path = format!("annotations/person_keypoints_{name}.json");
            let document =
                Document { path, categories: &categories, images: IMAGES, annotations: ANNOTATIONS, numbered: true };
            document.write(export, split)?;
        }
        Ok(())
    }
}
