//! COCO's person keypoints: `annotations/person_keypoints_train.json`.

use super::{
    annotation::{Masks, annotation, instance_if_labelled},
    document::{Document, line, write_parts},
};
use crate::{
    ExportError, Label,
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_world::{KEYPOINT_LIMBS, KEYPOINTS};
use serde_json::json;

/// People and riders with their keypoints, one category.
#[derive(Debug)]
pub(crate) struct CocoKeypoints;

const IMAGES: &str = "images";
const ANNOTATIONS: &str = "keypoints";

impl Exporter for CocoKeypoints {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        write_parts(video, &format!("images/{}", video.split()), [IMAGES, ANNOTATIONS], |frame, id| {
            let Some(instance) = instance_if_labelled(frame)? else { return Ok(String::new()) };
            let people = frame.labels.iter().filter(|label| label.object.keypoints.is_some());
            let entry = |label: &Label| {
                let mut entry = annotation(video.export, id, label, &instance, Masks::RunLengths);
                entry.insert("category_id".into(), json!(1));
                entry.insert("keypoints".into(), json!(label.object.keypoints));
                entry.insert("num_keypoints".into(), json!(label.object.num_keypoints));
                line(&entry)
            };
            Ok(people.map(entry).collect())
        })
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
